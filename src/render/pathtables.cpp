#include "render/pathtables.h"

#include "render/filtertable.h"

#include "base/math.h"
#include "base/parallel.h"
#include "shaders/layout.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace dsphere {

namespace {

double luminance(const dvec3& rgb) {
    return 0.2126 * rgb.r + 0.7152 * rgb.g + 0.0722 * rgb.b;
}

/// Cumulative shares of the weights, from 0 to 1; equal ones if all are 0.
void appendDistribution(std::vector<float>& table, std::span<const double> weights, double sum) {
    double below = 0.0;
    table.push_back(0.0f);
    for (std::size_t i = 0; i < weights.size(); ++i) {
        below += weights[i];
        table.push_back(float(sum > 0.0 ? below / sum : double(i + 1) / double(weights.size())));
    }
    table.back() = 1.0f;
}

// Of the bilinear image over each texel of a row: a texel's own value alone would leave out black ones beside bright
// ones.
std::vector<double> texelMeans(const ColourMap& image, int row) {
    const int width = image.width(), last = image.height() - 1;
    std::vector<double> down, means;
    const int rows[] = {std::max(row - 1, 0), row, std::min(row + 1, last)};
    auto light = [&](int i, int k) { return std::max(0.0, luminance(image.texel(i, rows[k]))); };
    for (int i = 0; i < width; ++i) down.push_back(0.125 * light(i, 0) + 0.75 * light(i, 1) + 0.125 * light(i, 2));
    auto column = [&](int i) { return down[std::size_t((i + width) % width)]; };
    for (int i = 0; i < width; ++i) means.push_back(0.125 * column(i - 1) + 0.75 * column(i) + 0.125 * column(i + 1));
    return means;
}

// Smith's Lambda of GGX.
double hidden(double cosine, double alpha) {
    const double tan2 = (1.0 - cosine * cosine) / (cosine * cosine);
    return 0.5 * (std::sqrt(1.0 + alpha * alpha * tan2) - 1.0);
}

// One minus the mean of G2 / G1 over the visible facets (Heitz 2018), by midpoints of their sample numbers. Smooth
// facets lose light at the rim of the disk that they are drawn from alone, so the radii crowd there.
double lossAt(double cosine, double alpha) {
    constexpr int kRadii = 4096, kAngles = 24;  // of one half, which mirrors the other
    std::array<double, kAngles> cosines, sines;
    for (int j = 0; j < kAngles; ++j) {
        const double angle = kPi * ((j + 0.5) / kAngles - 0.5);
        cosines[std::size_t(j)] = std::cos(angle);
        sines[std::size_t(j)] = std::sin(angle);
    }
    // Views and the axis of the stretched facets lie in the plane y = 0. `across` is the disk's axis there.
    const double c = std::max(cosine, 1e-5);
    const dvec2 view(std::sqrt(1.0 - c * c), c), axis = glm::normalize(dvec2(alpha * view.x, view.y));
    const dvec2 across(-axis.y, axis.x);
    const double own = hidden(c, alpha), s = 0.5 * (1.0 + axis.y);
    double sum = 0.0;
    for (int i = 0; i < kRadii; ++i) {
        const double from_rim = 1.0 - (i + 0.5) / kRadii;
        const double radius = std::sqrt(1.0 - from_rim * from_rim * from_rim), weight = 3.0 * from_rim * from_rim;
        for (std::size_t j = 0; j < kAngles; ++j) {
            const double a = radius * cosines[j];
            const double b = (1.0 - s) * std::sqrt(1.0 - a * a) + s * radius * sines[j];
            const dvec2 facet = b * across + std::sqrt(std::max(0.0, 1.0 - a * a - b * b)) * axis;
            const dvec2 h(alpha * facet.x, std::max(facet.y, 0.0));  // with y = alpha a; of any length
            const double square = glm::dot(h, h) + alpha * alpha * a * a;
            const double light = 2.0 * glm::dot(view, h) * h.y / square - view.y;
            const double in_light = light > 0.0 ? hidden(std::min(light, 1.0), alpha) : 0.0;
            sum += weight * (light > 0.0 ? in_light / (1.0 + own + in_light) : 1.0);
        }
    }
    return sum / (kRadii * kAngles);
}

// Over all directions.
double meanLuminance(const ColourMap& image) {
    double sum = 0.0, weights = 0.0;
    for (int j = 0; j < image.height(); ++j) {
        const double weight = std::sin(kPi * (j + 0.5) / image.height());
        for (int i = 0; i < image.width(); ++i) sum += weight * luminance(image.texel(i, j));
        weights += weight * image.width();
    }
    return sum / weights;
}

}  // namespace

FacetLoss facetLoss(double alpha) {
    std::vector<double> values(LOSS_INTERVALS + 1);
    auto cosineAt = [](double place) { return place * place / (double(LOSS_INTERVALS) * LOSS_INTERVALS); };
    parallelFor(values.size(), [&](std::size_t i) { values[i] = lossAt(cosineAt(double(i)), alpha); });
    FacetLoss loss;
    loss.by_cosine.push_back(float(3.0 * values[0] - 3.0 * values[1] + values[2]));
    for (double value : values) loss.by_cosine.push_back(float(value));
    const std::size_t n = values.size();
    loss.by_cosine.push_back(float(3.0 * values[n - 1] - 3.0 * values[n - 2] + values[n - 3]));
    // With c = t^2: int loss 4 t^3 dt, by Simpson's rule.
    for (std::size_t i = 0; i < n; ++i) {
        const double t = double(i) / LOSS_INTERVALS;
        const double weight = i == 0 || i + 1 == n ? 1.0 : (i % 2 ? 4.0 : 2.0);
        loss.mean += weight * values[i] * 4.0 * t * t * t / (3.0 * LOSS_INTERVALS);
    }
    return loss;
}

double fresnelOf(double cosine, double eta, double k) {
    const double c2 = cosine * cosine, s2 = 1.0 - c2, difference = eta * eta - k * k - s2;
    const double sum = std::sqrt(difference * difference + 4.0 * eta * eta * k * k);
    const double a = 2.0 * cosine * std::sqrt(std::max(0.0, 0.5 * (sum + difference)));
    const double across = (sum + c2 - a) / (sum + c2 + a);
    return 0.5 * across * (1.0 + (c2 * sum + s2 * s2 - a * s2) / (c2 * sum + s2 * s2 + a * s2));
}

std::vector<float> imageDistribution(const ColourMap& image) {
    const std::size_t height = std::size_t(image.height());
    std::vector<float> rows, columns, densities;
    std::vector<double> sums(height);
    double total = 0.0;
    for (std::size_t j = 0; j < height; ++j) {
        const std::vector<double> of_row = texelMeans(image, int(j));
        double sum = 0.0;
        for (double value : of_row) sum += value;
        const double sine = std::sin(kPi * (double(j) + 0.5) / double(height));
        for (double value : of_row) densities.push_back(float(value * sine));
        sums[j] = sum * sine;
        total += sums[j];
        appendDistribution(columns, of_row, sum);
    }
    appendDistribution(rows, sums, total);
    const double texels = double(densities.size());
    for (float& density : densities) density = total > 0.0 ? float(double(density) * texels / total) : 1.0f;
    rows.insert(rows.end(), columns.begin(), columns.end());
    rows.insert(rows.end(), densities.begin(), densities.end());
    return rows;
}

PathTables makePathTables(const Scene& scene, const SceneMaps& maps) {
    PathTables tables;
    auto append = [&](const std::vector<float>& values) {
        const int place = int(tables.values.size());
        tables.values.insert(tables.values.end(), values.begin(), values.end());
        return place;
    };
    const PixelFilter& filter = scene.pixel_filter;
    if (filterKind(filter) != FILTER_BOX) {
        const FilterTable x = filterTable(filter, filter.radius.x), y = filterTable(filter, filter.radius.y);
        for (const auto* values : {&x.places, &y.places, &x.weights, &y.weights}) append(*values);
    }
    auto appendLoss = [&](const Material& material) {
        const auto* conductor = std::get_if<Conductor>(&material);
        if (!conductor || tables.losses.contains(conductor->alpha)) return;
        const FacetLoss loss = facetLoss(conductor->alpha);
        tables.losses[conductor->alpha] = {append(loss.by_cosine), loss.mean};
    };
    for (const Shape& shape : scene.shapes) {
        appendLoss(shape.material);
        if (scene.integrator.regularize) appendLoss(regularized(shape.material));
    }
    if (maps.light_image >= 0) {
        const ColourMap& image = *maps.images[std::size_t(maps.light_image)];
        tables.light_image = append(imageDistribution(image));
        tables.light_luminance = meanLuminance(image);
    }
    return tables;
}

}  // namespace dsphere
