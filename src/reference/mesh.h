#pragma once

// Triangle meshes, object space: hits by the rules of analytic.h, and what a point on a mesh is told by its nearest
// triangle.

#include "reference/ray.h"
#include "scene/scene.h"

namespace dsphere::reference {

/// From either side, edges included; a mesh has no inside. A root at t_min counts unless may_start_inside is false.
FirstHit hitMesh(const TriangleMesh& mesh, const Ray& ray);

struct MeshPoint {
    int triangle = -1;
    double distance = 0.0;   ///< from the triangle
    dvec3 barycentric{0.0};  ///< of its nearest point
};
/// The triangle nearest to p, the first of several.
MeshPoint nearestOnMesh(const TriangleMesh& mesh, const dvec3& p);
dvec3 meshNormal(const TriangleMesh& mesh, int triangle);  ///< unit; (0, 0, 1) of a triangle without area
dvec2 meshUv(const TriangleMesh& mesh, const MeshPoint& point);

}  // namespace dsphere::reference
