#include "render/packmaterial.h"

#include "base/overloads.h"
#include "render/tovec4.h"
#include "render/traits.h"
#include "scene/ramps.h"

namespace dsphere {

namespace {

using layout::MaterialData;
using layout::ObjectData;

static_assert(std::variant_size_v<Material> == MATERIAL_COUNT, "layout.h and the scene know the same materials");

// 2 int F c dc, by midpoints.
double meanFresnel(double eta, double k) {
    constexpr int kSteps = 256;
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double cosine = (i + 0.5) / kSteps;
        sum += 2.0 * fresnelOf(cosine, eta, k) * cosine / kSteps;
    }
    return sum;
}

void packConductor(MaterialData& data, const Conductor& conductor, const PathTables& tables) {
    const PathTables::Loss& loss = tables.losses.at(conductor.alpha);
    data.table = loss.place;
    data.alpha = float(conductor.alpha);
    data.eta = toVec4(conductor.eta, 0.0);
    data.k = toVec4(conductor.k, 0.0);
    if (loss.mean < 1e-9) return;
    for (int c = 0; c < 3; ++c) {
        const double fresnel = meanFresnel(conductor.eta[c], conductor.k[c]);
        const double of_bounced = fresnel * fresnel * (1.0 - loss.mean) / (1.0 - fresnel * loss.mean);
        data.bounced[c] = float(of_bounced / (kPi * loss.mean));
    }
}

void packMatte(MaterialData& data, const Matte& matte) {
    const double sigma = glm::radians(matte.sigma), variance = sigma * sigma;
    data.rough_a = float(1.0 - variance / (2.0 * (variance + 0.33)));
    data.rough_b = float(0.45 * variance / (variance + 0.09));
}

MaterialData packMaterial(const Material& material, const PathTables& tables) {
    MaterialData data = {};
    data.light = -1;
    data.kind = materialKind(material);
    const auto pack = Overloads{[&](const Matte& matte) { packMatte(data, matte); },
                                [&](const Conductor& metal) { packConductor(data, metal, tables); },
                                [&](const Mirror& mirror) { data.specular = toVec4(mirror.reflectance, 0.0); },
                                [&](const Plastic& plastic) {
                                    data.specular = toVec4(plastic.specular, 0.0);
                                    data.alpha = float(plastic.alpha);
                                }};
    std::visit(pack, material);
    if (const auto* board = textureAs<Checkerboard>(material)) {
        data.odd = toVec4(board->odd, 0.0);
        data.checkerboard = 1;
        data.u_scale = float(board->u_scale);
        data.v_scale = float(board->v_scale);
    }
    return data;
}

void packTexture(ObjectData& object, const Texture& texture) {
    std::visit(Overloads{[&](const ConstantColour& constant) { object.albedo = toVec4(constant.rgb, 1.0); },
                         [&](const HeightRamp& ramp) {
                             object.ramp = findRamp(ramp.ramp);
                             object.texture_scale = toVec4(ramp.scale, 1.0);
                         },
                         [&](const ImageMap& image) { object.texture_scale = toVec4(image.scale, 1.0); },
                         [&](const Checkerboard& board) { object.albedo = toVec4(board.even, 1.0); }},
               texture);
}

}  // namespace

int materialKind(const Material& material) {
    return std::visit(
        Overloads{[](const Matte&) { return MATERIAL_MATTE; }, [](const Conductor&) { return MATERIAL_CONDUCTOR; },
                  [](const Mirror&) { return MATERIAL_MIRROR; }, [](const Plastic&) { return MATERIAL_PLASTIC; }},
        material);
}

void packColour(ObjectData& object, const Shape& shape, const Relief& relief) {
    object.ramp = -1;
    object.ramp_offset = float(relief.h_offset);
    object.ramp_scale = float(relief.h_scale);
    std::visit(Overloads{[&](const Matte& matte) { packTexture(object, matte.reflectance); },
                         [&](const Conductor& metal) {
                             for (int c = 0; c < 3; ++c)
                                 object.albedo[c] = float(fresnelOf(1.0, metal.eta[c], metal.k[c]));
                         },
                         [&](const Mirror& mirror) { object.albedo = toVec4(mirror.reflectance, 1.0); },
                         [&](const Plastic& plastic) { packTexture(object, plastic.diffuse); }},
               shape.material);
}

std::vector<MaterialData> packMaterials(const Scene& scene, const PathTables& tables) {
    std::vector<MaterialData> materials;
    for (const Shape& shape : scene.shapes) materials.push_back(packMaterial(shape.material, tables));
    for (std::size_t k = 0; k < scene.lights.size(); ++k)
        if (const auto* area = std::get_if<AreaLight>(&scene.lights[k]))
            materials[std::size_t(area->shape)].light = int(k);
    if (!scene.integrator.regularize) return materials;
    materials.resize(MAX_OBJECTS);
    for (const Shape& shape : scene.shapes) materials.push_back(packMaterial(regularized(shape.material), tables));
    return materials;
}

}  // namespace dsphere
