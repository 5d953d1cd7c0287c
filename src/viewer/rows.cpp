#include "viewer/rows.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scene/ramps.h"

namespace dsphere::viewer {

namespace {

constexpr float kDetailPixels[] = {0.0f, 0.5f, 1.0f, 2.0f};

const DisplacedSphere* reliefOf(const Subject& s) {
    return s.original ? std::get_if<DisplacedSphere>(&s.shape().geometry) : nullptr;
}

bool hasRelief(const Subject& s) {
    return reliefOf(s) != nullptr;
}

bool hasFilter(const Subject& s) {
    return hasRelief(s) && !reliefOf(s)->ripples;
}

bool hasSun(const Subject& s) {
    return s.original && sunOf(*s.original);
}

SunAngles sunAngles(const Subject& s) {
    return anglesOf(*s.globe, s.state.edits.sun_direction.value_or(sunOf(*s.original)->direction));
}

void setSun(Subject& s, const SunAngles& angles) {
    s.state.edits.sun_direction = directionOf(*s.globe, angles);
}

const Texture* textureOf(const Subject& s) {
    if (!s.original) return nullptr;
    const Texture* own = dsphere::textureOf(s.shape().material);
    return own && s.edits().texture ? &*s.edits().texture : own;
}

bool hasTexture(const Subject& s) {
    return textureOf(s) != nullptr;
}

bool hasOneColour(const Subject& s) {
    return hasTexture(s) && std::holds_alternative<ConstantColour>(*textureOf(s));
}

/// What a shape may be coloured with: one colour, the file's image or checkerboard, the ramps of a relief.
std::vector<std::pair<std::string, Texture>> texturesFor(const Subject& s) {
    std::vector<std::pair<std::string, Texture>> textures = {{"One colour", ConstantColour{}}};
    const Texture& own = *dsphere::textureOf(s.shape().material);
    if (std::holds_alternative<ConstantColour>(own)) textures[0].second = own;
    if (std::holds_alternative<ImageMap>(own)) textures.emplace_back("Image", own);
    if (std::holds_alternative<Checkerboard>(own)) textures.emplace_back("Checkerboard", own);
    if (!hasRelief(s)) return textures;
    for (const Ramp& ramp : ramps()) {
        HeightRamp texture{.ramp = std::string(ramp.name)};
        if (const auto* ramped = std::get_if<HeightRamp>(&own); ramped && ramped->ramp == texture.ramp)
            texture = *ramped;
        textures.emplace_back("Heights: " + texture.ramp, texture);
    }
    return textures;
}

bool sameKind(const Texture& a, const Texture& b) {
    const auto *one = std::get_if<HeightRamp>(&a), *other = std::get_if<HeightRamp>(&b);
    return a.index() == b.index() && (!one || one->ramp == other->ramp);
}

void setTexture(Subject& s, const Texture& texture) {
    if (texture == *dsphere::textureOf(s.shape().material))
        s.edits().texture.reset();
    else
        s.edits().texture = texture;
}

std::function<std::vector<std::string>(const Subject&)> names(std::vector<std::string> list) {
    return [list = std::move(list)](const Subject&) { return list; };
}

void addRelief(std::vector<Row>& rows) {
    rows.push_back(
        {"Relief", "Exaggeration",
         "How many times as high as the file says the relief is. A saved scene holds the heights as they are "
         "shown: it begins at 1 again.",
         NumberRow{0.0, 10.0, "%.4g x file", [](const Subject& s) { return s.edits().exaggeration; },
                   [](Subject& s, double x) { s.edits().exaggeration = x; }},
         hasRelief});
    rows.push_back(
        {"Relief", "Zero level",
         "The height that lies on the sphere itself, as a share of the map's range (midlevel): 0 raises all "
         "of the map, 1 lowers it.",
         NumberRow{-100.0, 100.0, "%.1f %%",
                   [](const Subject& s) { return 100.0 * s.edits().midlevel.value_or(reliefOf(s)->midlevel); },
                   [](Subject& s, double x) { s.edits().midlevel = 0.01 * x; }},
         hasRelief});
    rows.push_back({"Relief", "Surface",
                    "Bilinear goes through the map's values, with creases between its texels; the B-spline is smooth, "
                    "and a little lower on peaks.",
                    ChoiceRow{names({"Bilinear", "B-spline"}),
                              [](const Subject& s) { return int(s.edits().filter.value_or(reliefOf(s)->filter)); },
                              [](Subject& s, int k) { s.edits().filter = Filter(k); }},
                    hasFilter});
}

void addLight(std::vector<Row>& rows) {
    rows.push_back({"Light", "Sun longitude",
                    "The meridian of the object above which the sun stands: 20, 20 W or -20. L + drag moves it.",
                    NumberRow{-180.0, 180.0, "%.1f°", [](const Subject& s) { return sunAngles(s).longitude; },
                              [](Subject& s, double x) {
                                  setSun(s, {sunAngles(s).latitude, x});
                              },
                              false, "EW"},
                    hasSun});
    rows.push_back({"Light", "Sun latitude", "How far north or south of the equator the sun stands: 20, 20 S or -20.",
                    NumberRow{-89.9, 89.9, "%.1f°", [](const Subject& s) { return sunAngles(s).latitude; },
                              [](Subject& s, double x) {
                                  setSun(s, {x, sunAngles(s).longitude});
                              },
                              false, "NS"},
                    hasSun});
    rows.push_back(
        {"Light", "Sun brightness",
         "How many times as bright as the file says the sun is. A saved scene holds the light as it is shown: it "
         "begins at 1 again.",
         NumberRow{0.0, 10.0, "%.4g x file", [](const Subject& s) { return s.state.edits.sun_brightness; },
                   [](Subject& s, double x) { s.state.edits.sun_brightness = std::max(x, 0.0); }},
         hasSun});
    rows.push_back(
        {"Light", "Night side",
         "Light from opposite the sun, as a share of the sun's: shows the relief of the night side. Saved with the "
         "scene as a second distant light.",
         NumberRow{0.0, 100.0, "%.0f %%", [](const Subject& s) { return 100.0 * s.state.edits.night_light; },
                   [](Subject& s, double x) { s.state.edits.night_light = std::clamp(0.01 * x, 0.0, 1.0); }},
         hasSun});
    rows.push_back({"Light", "Exposure", "Brightens the picture, not the scene: each stop doubles it.",
                    NumberRow{-6.0, 6.0, "%+.2f stops", [](const Subject& s) { return double(s.state.tone.exposure); },
                              [](Subject& s, double x) { s.state.tone.exposure = float(x); }}});
}

void addColour(std::vector<Row>& rows) {
    rows.push_back({"Colour", "Coloured by", "One colour, the file's image, or a scale of colours by height.",
                    ChoiceRow{[](const Subject& s) {
                                  std::vector<std::string> list;
                                  for (const auto& [name, texture] : texturesFor(s)) list.push_back(name);
                                  return list;
                              },
                              [](const Subject& s) {
                                  const auto textures = texturesFor(s);
                                  const auto found = std::ranges::find_if(
                                      textures, [&](const auto& one) { return sameKind(one.second, *textureOf(s)); });
                                  return int(found - textures.begin());
                              },
                              [](Subject& s, int k) { setTexture(s, texturesFor(s)[std::size_t(k)].second); }},
                    hasTexture});
    rows.push_back({"Colour", "Colour", "The share of red, green and blue light that the ground reflects.",
                    ColourRow{[](const Subject& s) { return std::get<ConstantColour>(*textureOf(s)).rgb; },
                              [](Subject& s, const dvec3& rgb) { setTexture(s, ConstantColour{rgb}); }},
                    hasOneColour});
}

void addView(std::vector<Row>& rows) {
    rows.push_back({"View", "Show", "The picture, or a value of what each ray meets in its place. V goes through them.",
                    ChoiceRow{names({kShowNames, kShowNames + kShowCount}),
                              [](const Subject& s) { return int(s.state.view.show); },
                              [](Subject& s, int k) { s.state.view.show = Show(k); }}});
    rows.push_back(
        {"View", "Red at", "The number of steps that is shown as red.",
         NumberRow{5.0, 5000.0, "%.0f steps", [](const Subject& s) { return double(s.state.tone.most_steps); },
                   [](Subject& s, double x) { s.state.tone.most_steps = std::max(float(x), 1.0f); }, true},
         [](const Subject& s) { return s.state.view.show == Show::Steps; }});
    rows.push_back({"View", "Red at", "The slope that is shown as red.",
                    NumberRow{1.0, 90.0, "%.0f°", [](const Subject& s) { return double(s.state.tone.most_slope); },
                              [](Subject& s, double x) { s.state.tone.most_slope = std::max(float(x), 0.1f); }},
                    [](const Subject& s) { return s.state.view.show == Show::Slope; }});
}

void addAdvanced(std::vector<Row>& rows) {
    rows.push_back({"Advanced", "Marcher",
                    "How rays find the ground: exact, or one of the simple ways that it is compared with. M goes "
                    "through them.",
                    ChoiceRow{names({std::begin(kMarcherNames), std::end(kMarcherNames)}),
                              [](const Subject& s) { return int(s.state.view.method.marcher); },
                              [](Subject& s, int k) { s.state.view.method.marcher = Marcher(k); }}});
    rows.push_back({"Advanced", "Detail",
                    "Where texels are smaller than pixels, coarser maps are faster: how far, in pixels, the ground may "
                    "be off then.",
                    ChoiceRow{names({"Exact", "Half a pixel", "One pixel", "Two pixels"}),
                              [](const Subject& s) {
                                  return int(std::ranges::lower_bound(kDetailPixels, s.state.view.method.detail) -
                                             std::begin(kDetailPixels));
                              },
                              [](Subject& s, int k) { s.state.view.method.detail = kDetailPixels[k]; }},
                    [](const Subject& s) { return s.state.view.method.marcher == Marcher::Exact; }});
    rows.push_back({"Advanced", "Split view",
                    "The naive marcher on the left of a line, this one on its right. X does it.",
                    SwitchRow{[](const Subject& s) { return s.state.view.split; },
                              [](Subject& s, bool on) { s.state.view.split = on; }}});
}

}  // namespace

SunAngles anglesOf(const Globe& globe, const dvec3& direction) {
    return {glm::degrees(std::asin(std::clamp(glm::dot(direction, globe.north()), -1.0, 1.0))),
            glm::degrees(std::atan2(glm::dot(direction, globe.east()), glm::dot(direction, globe.origin())))};
}

dvec3 directionOf(const Globe& globe, const SunAngles& angles) {
    const double lat = glm::radians(std::clamp(angles.latitude, -90.0, 90.0)), lon = glm::radians(angles.longitude);
    return glm::normalize(std::cos(lat) * (std::cos(lon) * globe.origin() + std::sin(lon) * globe.east()) +
                          std::sin(lat) * globe.north());
}

const std::vector<Row>& panelRows() {
    static const std::vector<Row> rows = [] {
        std::vector<Row> all;
        addRelief(all);
        addLight(all);
        addColour(all);
        addView(all);
        addAdvanced(all);
        return all;
    }();
    return rows;
}

}  // namespace dsphere::viewer
