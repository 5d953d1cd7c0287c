#include "cli/describe.h"

namespace dsphere::cli {

namespace {

Json vectorJson(const dvec3& v) {
    return {v.x, v.y, v.z};
}

struct DescribeTexture {
    int image;  // the shape's, in the scene's list

    Json operator()(const ConstantColour& constant) const { return vectorJson(constant.rgb); }
    Json operator()(const HeightRamp& ramp) const { return {{"ramp", ramp.ramp}, {"scale", vectorJson(ramp.scale)}}; }
    Json operator()(const ImageMap& map) const {
        return {{"image", image}, {"scale", vectorJson(map.scale)}, {"longitude_origin", map.longitude_origin}};
    }
    Json operator()(const Checkerboard& board) const {
        return {{"even", vectorJson(board.even)},
                {"odd", vectorJson(board.odd)},
                {"scale", {board.u_scale, board.v_scale}}};
    }
};

struct DescribeMaterial {
    DescribeTexture texture;

    Json operator()(const Matte& matte) const {
        return {{"type", "matte"}, {"Kd", std::visit(texture, matte.reflectance)}, {"sigma", matte.sigma}};
    }
    Json operator()(const Conductor& metal) const {
        return {
            {"type", "conductor"}, {"eta", vectorJson(metal.eta)}, {"k", vectorJson(metal.k)}, {"alpha", metal.alpha}};
    }
    Json operator()(const Mirror& mirror) const { return {{"type", "mirror"}, {"Kr", vectorJson(mirror.reflectance)}}; }
    Json operator()(const Plastic& plastic) const {
        return {{"type", "plastic"},
                {"Kd", std::visit(texture, plastic.diffuse)},
                {"Ks", vectorJson(plastic.specular)},
                {"alpha", plastic.alpha}};
    }
};

struct DescribeGeometry {
    const SceneMaps& maps;
    std::size_t index;

    Json operator()(const DisplacedSphere& sphere) const {
        const Relief& relief = maps.reliefs[index];
        return {{"type", "displacedsphere"},
                {"radius", sphere.radius},
                {"displacement", {relief.least_radius - sphere.radius, relief.greatest_radius - sphere.radius}},
                {"greatest_radius", relief.greatest_radius},
                {"map", maps.map_of_shape[index]}};
    }
    Json operator()(const Sphere& sphere) const { return {{"type", "sphere"}, {"radius", sphere.radius}}; }
    Json operator()(const Disk& disk) const { return {{"type", "disk"}, {"radius", disk.radius}}; }
    Json operator()(const TriangleMesh& mesh) const {
        return {{"type", "trianglemesh"}, {"points", mesh.points.size()}, {"triangles", mesh.triangles.size()}};
    }
};

struct DescribeLight {
    const SceneMaps& maps;

    Json operator()(const DistantLight& sun) const {
        return {{"type", "distant"}, {"towards", vectorJson(sun.direction)}, {"L", vectorJson(sun.radiance)}};
    }
    Json operator()(const PointLight& point) const {
        return {{"type", "point"}, {"from", vectorJson(point.position)}, {"I", vectorJson(point.intensity)}};
    }
    Json operator()(const InfiniteLight& light) const {
        return {{"type", "infinite"},
                {"L", vectorJson(light.radiance)},
                {"image", light.map_path.empty() ? Json(nullptr) : Json(maps.light_image)}};
    }
    Json operator()(const AreaLight& light) const {
        return {{"type", "area"},
                {"shape", light.shape},
                {"L", vectorJson(light.radiance)},
                {"two_sided", light.two_sided}};
    }
};

}  // namespace

Json describeIntegrator(const Integrator& integrator) {
    const bool path = integrator.kind == Integrator::Kind::Path;
    return {{"type", path ? "path" : "directlighting"},
            {"max_depth", integrator.max_depth},
            {"regularize", integrator.regularize}};
}

Json describePixelFilter(const PixelFilter& filter) {
    using Kind = PixelFilter::Kind;
    Json json = {{"type", nameOf(filter.kind)}, {"radius", {filter.radius.x, filter.radius.y}}};
    if (filter.kind == Kind::Gaussian) json["falloff"] = filter.falloff;
    if (filter.kind == Kind::Mitchell) json["B"] = filter.b, json["C"] = filter.c;
    if (filter.kind == Kind::Sinc) json["tau"] = filter.tau;
    return json;
}

Json describeCamera(const Camera& camera) {
    dmat4 world_from_camera = glm::inverse(camera.camera_from_world);
    Json json = {{"position", vectorJson(transformPoint(world_from_camera, dvec3(0.0)))},
                 {"direction", vectorJson(glm::normalize(transformVector(world_from_camera, {0.0, 0.0, 1.0})))}};
    if (camera.projection == Projection::Perspective)
        json["fov_degrees"] = camera.fov_degrees;
    else
        json["projection"] = "orthographic";
    return json;
}

Json describeShape(const Scene& scene, const SceneMaps& maps, std::size_t index) {
    const Shape& shape = scene.shapes[index];
    Json json = {{"where", shape.where.text()}};
    json.update(std::visit(DescribeGeometry{maps, index}, shape.geometry));
    json["centre"] = vectorJson(transformPoint(shape.world_from_object, dvec3(0.0)));
    json["material"] = std::visit(DescribeMaterial{{maps.image_of_shape[index]}}, shape.material);
    return json;
}

Json describeLight(const Light& light, const SceneMaps& maps) {
    return std::visit(DescribeLight{maps}, light);
}

}  // namespace dsphere::cli
