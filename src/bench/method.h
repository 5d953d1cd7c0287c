#pragma once

#include "render/renderer.h"

#include <string>
#include <vector>

namespace dsphere::bench {

/// What finds the hits: this program's marchers on the device, photogrammetry's iteration on the host, or a mesh that
/// Embree traces there.
enum class Engine { Device, SmoothSphere, Iterated, Secant, GridMesh, TriangleMesh };

struct Method {
    std::string name;    ///< unique: "naive 1e-4"
    std::string family;  ///< methods that differ by a setting alone share it: "naive"
    Engine engine = Engine::Device;
    MarchMethod march;     ///< Device
    double spacing = 1.0;  ///< meshes: nodes of the map from vertex to vertex; 1/2: twice as fine as the map

    Levels levels() const { return march.detail > 0.0f ? Levels::All : Levels::Finest; }
    bool isIterated() const { return engine == Engine::Iterated || engine == Engine::Secant; }
    bool isMesh() const { return engine == Engine::GridMesh || engine == Engine::TriangleMesh; }
    /// The floor has no error: it is another surface.
    bool hasError() const { return engine != Engine::SmoothSphere; }
};

/// Every method, a family's in the order of their settings. Meshes only where the build has Embree.
std::vector<Method> allMethods();

/// Those whose name or family is among the words, in the order of allMethods(); all without words. Error (Usage) names
/// a word that none has.
std::vector<Method> chooseMethods(const std::vector<std::string>& words);

}  // namespace dsphere::bench
