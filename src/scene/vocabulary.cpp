#include "scene/vocabulary.h"

#include <algorithm>

namespace dsphere {

namespace {

constexpr Directive kDirectives[] = {
    {"Include", Place::Anywhere, include},
    {"LookAt", Place::Anywhere, lookAt},
    {"Translate", Place::Anywhere, translate},
    {"Scale", Place::Anywhere, scale},
    {"Rotate", Place::Anywhere, rotate},
    {"Identity", Place::Anywhere, identity},
    {"Transform", Place::Anywhere, transform},
    {"ConcatTransform", Place::Anywhere, concatTransform},
    {"CoordinateSystem", Place::Anywhere, coordinateSystem},
    {"CoordSysTransform", Place::Anywhere, coordSysTransform},
    {"ActiveTransform", Place::Anywhere, activeTransform},
    {"TransformTimes", Place::Anywhere, transformTimes},
    {"Camera", Place::BeforeWorld, camera},
    {"Film", Place::BeforeWorld, film},
    {"Sampler", Place::BeforeWorld, sampler},
    {"Integrator", Place::BeforeWorld, integrator},
    {"PixelFilter", Place::BeforeWorld, pixelFilter},
    {"Accelerator", Place::BeforeWorld, accelerator},
    {"ColorSpace", Place::Anywhere, colorSpace},
    {"Option", Place::Anywhere, option},
    {"WorldBegin", Place::BeforeWorld, worldBegin},
    {"WorldEnd", Place::InWorld, worldEnd},
    {"AttributeBegin", Place::InWorld, attributeBegin},
    {"AttributeEnd", Place::InWorld, attributeEnd},
    {"TransformBegin", Place::InWorld, transformBegin},
    {"TransformEnd", Place::InWorld, transformEnd},
    {"Attribute", Place::Anywhere, attribute},
    {"ReverseOrientation", Place::InWorld, reverseOrientation},
    {"Material", Place::InWorld, material},
    {"MakeNamedMaterial", Place::InWorld, makeNamedMaterial},
    {"NamedMaterial", Place::InWorld, namedMaterial},
    {"Texture", Place::InWorld, texture},
    {"LightSource", Place::InWorld, lightSource},
    {"AreaLightSource", Place::InWorld, areaLightSource},
    {"Shape", Place::InWorld, shape},
    {"MediumInterface", Place::Anywhere, mediumInterface},
    {"MakeNamedMedium", Place::Anywhere, makeNamedMedium, false},
    {"ObjectBegin", Place::Anywhere, objectBegin, false},
    {"ObjectEnd", Place::Anywhere, objectEnd, false},
    {"ObjectInstance", Place::Anywhere, objectInstance, false},
    {"Import", Place::Anywhere, import, false},
};

}  // namespace

const Directive* findDirective(std::string_view word) {
    const Directive* found = std::ranges::find(kDirectives, word, &Directive::word);
    return found == std::end(kDirectives) ? nullptr : found;
}

bool isDirective(std::string_view word) {
    return findDirective(word) != nullptr;
}

Words supportedDirectives() {
    Words words;
    for (const Directive& directive : kDirectives)
        if (directive.supported) words.push_back(directive.word);
    return words;
}

}  // namespace dsphere
