#pragma once

// The directives of the scene language; each reads what follows its word. Internal to the parser.

#include "scene/parameters.h"
#include "scene/state.h"

namespace dsphere {

/// A directive at work: `word` has been taken, what follows it is next in the source.
struct Statement {
    ParseState& state;
    Source& source;
    const Token& word;
};

/// `Shape "sphere"`: the quoted name after a directive, and the parameters after that.
struct NamedParameters {
    Token name;
    Parameters parameters;
};

/// Reads both; `what` names the kind in errors ("camera"), and an empty `supported` admits any name. `defaults` are
/// Attribute's.
NamedParameters readNamed(Statement s, std::string_view what, const Words& supported,
                          const Defaults::List& defaults = nullptr);
/// The path of a file that the scene names: beside the file that names it, else beside the scene's first file. Where it
/// is in neither, Scene::missing tells what to say.
std::string resolvePath(Statement s, const std::string& name);
/// Fails beyond limits::kDefinitions names.
void requireRoomForName(Statement s);

// parser.cpp
void include(Statement s);

// transform_directives.cpp
void lookAt(Statement s);
void translate(Statement s);
void scale(Statement s);
void rotate(Statement s);
void identity(Statement s);
void transform(Statement s);
void concatTransform(Statement s);
void coordinateSystem(Statement s);
void coordSysTransform(Statement s);
void activeTransform(Statement s);
void transformTimes(Statement s);

// option_directives.cpp and filter_directive.cpp
void camera(Statement s);
void film(Statement s);
void sampler(Statement s);
void integrator(Statement s);
void accelerator(Statement s);
void colorSpace(Statement s);
void option(Statement s);
void pixelFilter(Statement s);
/// Fails where the directive stands a second time.
void requireOnce(Statement s);

// block_directives.cpp
void worldBegin(Statement s);
void worldEnd(Statement s);
void attributeBegin(Statement s);
void attributeEnd(Statement s);
void transformBegin(Statement s);
void transformEnd(Statement s);
void attribute(Statement s);
void reverseOrientation(Statement s);
/// Fails at the innermost block that is still open; `before` says what came instead of its end.
void requireNoOpenBlock(const ParseState& state, std::string_view before);

// refused_directives.cpp: what pbrt has and dsphere has not
void mediumInterface(Statement s);
void makeNamedMedium(Statement s);
void objectBegin(Statement s);
void objectEnd(Statement s);
void objectInstance(Statement s);
void import(Statement s);

// material_directives.cpp and texture_directives.cpp
void material(Statement s);
void makeNamedMaterial(Statement s);
void namedMaterial(Statement s);
void texture(Statement s);
/// The texture of a parameter of type rgb or texture, cut to [0, 1] if it is constant. Fails for an undefined name.
Texture textureValue(Statement s, const Parameter& parameter);
/// The colour of a parameter of type rgb, float or texture, within `range`. Fails for a texture that varies.
dvec3 constantValue(Statement s, const Parameter& parameter, const Range& range);

// light_directives.cpp, shape_directives.cpp and trianglemesh.cpp
void lightSource(Statement s);
void areaLightSource(Statement s);
TriangleMesh triangleMesh(Statement s, Parameters& p);
TriangleMesh bilinearMesh(Statement s, Parameters& p);
void shape(Statement s);
/// Fails where the scene comes to have so many shapes and lights and that is too many.
void requireRoom(Statement s, std::size_t shapes, std::size_t lights);

}  // namespace dsphere
