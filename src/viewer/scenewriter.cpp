#include "viewer/scenewriter.h"

#include "scene/transforms.h"

#include <fmt/format.h>

namespace dsphere::viewer {

namespace {

// The shortest text that reads back as the same double.
std::string number(double value) {
    return fmt::format("{}", value);
}

std::string triple(const dvec3& v) {
    return fmt::format("[{} {} {}]", number(v.x), number(v.y), number(v.z));
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + '"';
}

std::string transformText(const dmat4& m) {
    std::string text = "Transform [";
    for (int i = 0; i < 16; ++i)
        text += fmt::format("{}{}", i % 4 == 0 ? (i ? "   " : "") : " ", number(m[i / 4][i % 4]));
    return text + "]\n";
}

// The parser makes directions unit once more, which may change their last bit: a multiple that survives is looked for.
dvec3 survivingMultiple(const dvec3& direction) {
    for (int k = 1; k <= 64; ++k)
        if (unitVector(double(k) * direction - dvec3(0.0)) == direction) return double(k) * direction;
    return direction;
}

std::string lightText(const Light& light) {
    if (const auto* distant = std::get_if<DistantLight>(&light))
        return fmt::format("LightSource \"distant\" \"point3 from\" {} \"point3 to\" [0 0 0] \"rgb L\" {}\n",
                           triple(survivingMultiple(distant->direction)), triple(distant->radiance));
    const auto& point = std::get<PointLight>(light);
    return fmt::format("LightSource \"point\" \"point3 from\" {} \"rgb I\" {}\n", triple(point.position),
                       triple(point.intensity));
}

std::string relativeTo(const std::filesystem::path& folder, const std::string& path) {
    std::error_code error;
    std::filesystem::path relative = std::filesystem::proximate(path, folder, error);
    return quoted(error ? path : relative.string());
}

void appendNumber(std::string& text, const char* name, const std::optional<double>& value) {
    if (value) text += fmt::format(" \"float {}\" {}", name, number(*value));
}

std::string displacedText(const DisplacedSphere& sphere, const std::filesystem::path& folder) {
    std::string text = fmt::format("Shape \"displacedsphere\" \"float radius\" {}", number(sphere.radius));
    if (!sphere.map_path.empty())
        text += fmt::format("\n    \"string displacementmap\" {}", relativeTo(folder, sphere.map_path));
    if (sphere.ripples)
        text += fmt::format(
            "\n    \"string displacementfunction\" \"ripples\" \"integer ufrequency\" {} "
            "\"integer vfrequency\" {}",
            sphere.ripples->u_frequency, sphere.ripples->v_frequency);
    if (!sphere.height_scale) appendNumber(text, "maxdispl", sphere.max_displacement);
    appendNumber(text, "heightscale", sphere.height_scale);
    appendNumber(text, "midlevel", sphere.midlevel);
    appendNumber(text, "heightmin", sphere.height_min);
    appendNumber(text, "heightmax", sphere.height_max);
    if (sphere.registration)
        text += fmt::format(" \"string registration\" \"{}\"",
                            *sphere.registration == Registration::Texel ? "texel" : "gridline");
    appendNumber(text, "lonorigin", sphere.longitude_origin);
    if (sphere.blur != 0.0) appendNumber(text, "blur", sphere.blur);
    appendNumber(text, "nodata", sphere.nodata);
    if (sphere.filter == Filter::BSpline) text += " \"string filter\" \"bspline\"";
    if (sphere.smooth_normals) text += " \"bool smoothnormals\" true";
    return text + "\n";
}

std::string geometryText(const Shape& shape, const std::filesystem::path& folder) {
    if (const auto* sphere = std::get_if<Sphere>(&shape.geometry))
        return fmt::format("Shape \"sphere\" \"float radius\" {}\n", number(sphere->radius));
    if (const auto* disk = std::get_if<Disk>(&shape.geometry))
        return fmt::format("Shape \"disk\" \"float height\" {} \"float radius\" {} \"float innerradius\" {}\n",
                           number(disk->height), number(disk->radius), number(disk->inner_radius));
    return displacedText(std::get<DisplacedSphere>(shape.geometry), folder);
}

std::string shapeText(const Shape& shape, std::size_t index, const std::filesystem::path& folder) {
    std::string text = "AttributeBegin\n";
    const Texture& texture = *textureOf(shape.material);
    if (const auto* constant = std::get_if<ConstantColour>(&texture)) {
        text += fmt::format("Material \"matte\" \"rgb Kd\" {}\n", triple(constant->rgb));
    } else {
        if (const auto* ramp = std::get_if<HeightRamp>(&texture))
            text += fmt::format("Texture \"kd{}\" \"spectrum\" \"heightramp\" \"string ramp\" {}\n", index,
                                quoted(ramp->ramp));
        if (const auto* image = std::get_if<ImageMap>(&texture))
            text +=
                fmt::format("Texture \"kd{}\" \"spectrum\" \"imagemap\" \"string filename\" {} \"float scale\" {}\n",
                            index, relativeTo(folder, image->path), number(image->scale.r));
        text += fmt::format("Material \"matte\" \"texture Kd\" \"kd{}\"\n", index);
    }
    return text + transformText(shape.world_from_object) + geometryText(shape, folder) + "AttributeEnd\n";
}

}  // namespace

std::string cameraText(const Camera& camera) {
    std::string text = transformText(camera.camera_from_world);
    if (camera.projection == Projection::Perspective)
        text += fmt::format("Camera \"perspective\" \"float fov\" {}", number(camera.fov_degrees));
    else
        text += "Camera \"orthographic\"";
    if (const auto& window = camera.screen_window)
        text += fmt::format(" \"float screenwindow\" [{} {} {} {}]", number((*window)[0]), number((*window)[1]),
                            number((*window)[2]), number((*window)[3]));
    appendNumber(text, "frameaspectratio", camera.frame_aspect_ratio);
    return text + "\n";
}

std::string sceneText(const Scene& scene, const std::filesystem::path& folder) {
    std::string text = cameraText(scene.camera);
    text += fmt::format("Film \"rgb\" \"string filename\" {} \"integer xresolution\" {} \"integer yresolution\" {}\n",
                        quoted(scene.film.filename), scene.film.width, scene.film.height);
    text += fmt::format("Sampler \"independent\" \"integer pixelsamples\" {} \"integer seed\" {}\nWorldBegin\n",
                        scene.sampler.pixel_samples, scene.sampler.seed);
    for (const Light& light : scene.lights) text += lightText(light);
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) text += shapeText(scene.shapes[i], i, folder);
    return text;
}

}  // namespace dsphere::viewer
