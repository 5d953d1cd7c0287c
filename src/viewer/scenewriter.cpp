#include "viewer/scenewriter.h"

#include "base/overloads.h"
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

std::string inQuotes(const std::string& text) {
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

std::string relativeTo(const std::filesystem::path& folder, const std::string& path) {
    std::error_code error;
    std::filesystem::path relative = std::filesystem::proximate(path, folder, error);
    return inQuotes(error ? path : relative.string());
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
    if (sphere.band) text += fmt::format(" \"integer band\" {}", *sphere.band);
    if (sphere.filter == Filter::BSpline) text += " \"string filter\" \"bspline\"";
    if (sphere.smooth_normals) text += " \"bool smoothnormals\" true";
    return text + "\n";
}

std::string meshText(const TriangleMesh& mesh) {
    std::string points, indices, uvs;
    for (const dvec3& p : mesh.points) points += fmt::format(" {} {} {}", number(p.x), number(p.y), number(p.z));
    for (const auto& [i, j, k] : mesh.triangles) indices += fmt::format(" {} {} {}", i, j, k);
    for (const dvec2& uv : mesh.uvs) uvs += fmt::format(" {} {}", number(uv.x), number(uv.y));
    std::string text =
        fmt::format("Shape \"trianglemesh\" \"point3 P\" [{} ]\n    \"integer indices\" [{} ]", points, indices);
    if (!mesh.uvs.empty()) text += fmt::format("\n    \"point2 uv\" [{} ]", uvs);
    return text + "\n";
}

std::string geometryText(const Shape& shape, const std::filesystem::path& folder) {
    return std::visit(
        Overloads{[&](const DisplacedSphere& sphere) { return displacedText(sphere, folder); },
                  [](const Sphere& sphere) {
                      return fmt::format("Shape \"sphere\" \"float radius\" {}\n", number(sphere.radius));
                  },
                  [](const Disk& disk) {
                      return fmt::format(
                          "Shape \"disk\" \"float height\" {} \"float radius\" {} \"float innerradius\" {}\n",
                          number(disk.height), number(disk.radius), number(disk.inner_radius));
                  },
                  [](const TriangleMesh& mesh) { return meshText(mesh); }},
        shape.geometry);
}

/// A colour as a parameter, and the Texture directives that go before whoever has it.
struct ColourText {
    std::string textures, parameter;
};

// What a texture's own directive cannot say of its scale another texture does.
ColourText scaledTexture(const std::string& name, const std::string& words, const dvec3& scale, const char* parameter) {
    ColourText text{fmt::format("Texture {} \"spectrum\" {}\n", inQuotes(name), words), name};
    if (scale != dvec3(1.0)) {
        text.parameter = name + " scaled";
        text.textures += fmt::format("Texture {} \"spectrum\" \"scale\" \"texture tex\" {} \"rgb scale\" {}\n",
                                     inQuotes(text.parameter), inQuotes(name), triple(scale));
    }
    text.parameter = fmt::format(" \"texture {}\" {}", parameter, inQuotes(text.parameter));
    return text;
}

ColourText colourText(const Texture& texture, const char* parameter, const std::string& name,
                      const std::filesystem::path& folder) {
    const auto constantText = [&](const ConstantColour& constant) -> ColourText {
        return {"", fmt::format(" \"rgb {}\" {}", parameter, triple(constant.rgb))};
    };
    const auto rampText = [&](const HeightRamp& ramp) {
        return scaledTexture(name, fmt::format("\"heightramp\" \"string ramp\" {}", inQuotes(ramp.ramp)), ramp.scale,
                             parameter);
    };
    const auto imageText = [&](const ImageMap& image) {
        std::string words = fmt::format("\"imagemap\" \"string filename\" {}", relativeTo(folder, image.path));
        if (image.longitude_origin != -180.0) appendNumber(words, "lonorigin", image.longitude_origin);
        const bool grey = image.scale == dvec3(image.scale.r);
        if (grey) words += fmt::format(" \"float scale\" {}", number(image.scale.r));
        return scaledTexture(name, words, grey ? dvec3(1.0) : image.scale, parameter);
    };
    const auto boardText = [&](const Checkerboard& board) {
        return scaledTexture(
            name,
            fmt::format("\"checkerboard\" \"rgb tex1\" {} \"rgb tex2\" {} \"float uscale\" {} "
                        "\"float vscale\" {}",
                        triple(board.even), triple(board.odd), number(board.u_scale), number(board.v_scale)),
            dvec3(1.0), parameter);
    };
    return std::visit(Overloads{constantText, rampText, imageText, boardText}, texture);
}

std::string roughness(double alpha) {
    return fmt::format(" \"float roughness\" {} \"bool remaproughness\" false\n", number(alpha));
}

std::string materialText(const Material& material, std::size_t index, const std::filesystem::path& folder) {
    ColourText colour;
    if (const Texture* texture = textureOf(material))
        colour = colourText(*texture, "Kd", fmt::format("kd{}", index), folder);
    const auto words = Overloads{
        [&](const Matte& matte) {
            std::string text = "\"matte\"" + colour.parameter;
            if (matte.sigma != 0.0) appendNumber(text, "sigma", matte.sigma);
            return text + "\n";
        },
        [](const Conductor& metal) {
            return fmt::format("\"conductor\" \"rgb eta\" {} \"rgb k\" {}", triple(metal.eta), triple(metal.k)) +
                   roughness(metal.alpha);
        },
        [](const Mirror& mirror) { return fmt::format("\"mirror\" \"rgb Kr\" {}\n", triple(mirror.reflectance)); },
        [&](const Plastic& plastic) {
            return fmt::format("\"plastic\"{} \"rgb Ks\" {}", colour.parameter, triple(plastic.specular)) +
                   roughness(plastic.alpha);
        }};
    return colour.textures + "Material " + std::visit(words, material);
}

std::string shapeText(const Shape& shape, std::size_t index, const AreaLight* light,
                      const std::filesystem::path& folder) {
    std::string text = "AttributeBegin\n" + materialText(shape.material, index, folder);
    if (light)
        text += fmt::format("AreaLightSource \"diffuse\" \"rgb L\" {} \"bool twosided\" {}\n", triple(light->radiance),
                            light->two_sided);
    return text + transformText(shape.world_from_object) + geometryText(shape, folder) + "AttributeEnd\n";
}

std::string infiniteText(const InfiniteLight& light, const std::filesystem::path& folder) {
    std::string text = "AttributeBegin\n" + transformText(dmat4(light.world_from_light)) +
                       fmt::format("LightSource \"infinite\" \"rgb L\" {}", triple(light.radiance));
    if (!light.map_path.empty()) text += " \"string filename\" " + relativeTo(folder, light.map_path);
    return text + "\nAttributeEnd\n";
}

std::string distantText(const DistantLight& light) {
    return fmt::format("LightSource \"distant\" \"point3 from\" {} \"point3 to\" [0 0 0] \"rgb L\" {}\n",
                       triple(survivingMultiple(light.direction)), triple(light.radiance));
}

std::string pointText(const PointLight& light) {
    return fmt::format("LightSource \"point\" \"point3 from\" {} \"rgb I\" {}\n", triple(light.position),
                       triple(light.intensity));
}

// A shape that shines is a light where it stands: shapes go between the lights so that both keep their order.
std::string worldText(const Scene& scene, const std::filesystem::path& folder) {
    std::string text;
    std::size_t next = 0;
    auto shapesBefore = [&](std::size_t end) {
        for (; next < end; ++next) text += shapeText(scene.shapes[next], next, nullptr, folder);
    };
    const auto append = Overloads{[&](const DistantLight& light) { text += distantText(light); },
                                  [&](const PointLight& light) { text += pointText(light); },
                                  [&](const InfiniteLight& light) { text += infiniteText(light, folder); },
                                  [&](const AreaLight& light) {
                                      shapesBefore(std::size_t(light.shape));
                                      text += shapeText(scene.shapes[next], next, &light, folder);
                                      ++next;
                                  }};
    for (const Light& light : scene.lights) std::visit(append, light);
    shapesBefore(scene.shapes.size());
    return text;
}

std::string optionsText(const Scene& scene) {
    const Film& film = scene.film;
    std::string text =
        fmt::format("Film \"rgb\" \"string filename\" {} \"integer xresolution\" {} \"integer yresolution\" {}",
                    inQuotes(film.filename), film.width, film.height);
    if (film.crop != Film{}.crop)
        text += fmt::format(" \"float cropwindow\" [{} {} {} {}]", number(film.crop[0]), number(film.crop[1]),
                            number(film.crop[2]), number(film.crop[3]));
    text += fmt::format("\nSampler \"independent\" \"integer pixelsamples\" {} \"integer seed\" {}\n",
                        scene.sampler.pixel_samples, scene.sampler.seed);
    const bool path = scene.integrator.kind == Integrator::Kind::Path;
    text += fmt::format("Integrator \"{}\" \"integer maxdepth\" {}{}\n", path ? "path" : "directlighting",
                        scene.integrator.max_depth, scene.integrator.regularize ? " \"bool regularize\" true" : "");
    // v3's spelling: its alpha is the falloff itself.
    const PixelFilter& filter = scene.pixel_filter;
    text += fmt::format("PixelFilter \"{}\" \"float xwidth\" {} \"float ywidth\" {}", nameOf(filter.kind),
                        number(filter.radius.x), number(filter.radius.y));
    using Kind = PixelFilter::Kind;
    if (filter.kind == Kind::Gaussian) appendNumber(text, "alpha", filter.falloff);
    if (filter.kind == Kind::Mitchell) appendNumber(text, "B", filter.b), appendNumber(text, "C", filter.c);
    if (filter.kind == Kind::Sinc) appendNumber(text, "tau", filter.tau);
    return text + "\n";
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
    return cameraText(scene.camera) + optionsText(scene) + "WorldBegin\n" + worldText(scene, folder);
}

}  // namespace dsphere::viewer
