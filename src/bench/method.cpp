#include "bench/method.h"

#include "base/error.h"
#include "bench/contender.h"

#include <fmt/ranges.h>

#include <algorithm>

namespace dsphere::bench {

namespace {

Method march(const char* family, const char* setting, MarchMethod how) {
    return {*setting ? fmt::format("{} {}", family, setting) : family, family, Engine::Device, how, 1};
}

Method mesh(const char* family, Engine engine, double spacing) {
    std::string name = family;
    if (spacing > 1.0) name += fmt::format(" 1/{:.0f}", spacing);
    if (spacing < 1.0) name += fmt::format(" {:.0f}x", 1.0 / spacing);
    return {name, family, engine, {}, spacing};
}

}  // namespace

std::vector<Method> allMethods() {
    std::vector<Method> methods = {
        march("exact", "", Marcher::Exact),
        march("detail", "1/2", {Marcher::Exact, MarchMethod().threshold, 0.5f}),
        march("detail", "1", {Marcher::Exact, MarchMethod().threshold, 1.0f}),
        march("detail", "2", {Marcher::Exact, MarchMethod().threshold, 2.0f}),
        march("naive", "1e-4", {Marcher::Naive, 1e-4f}),
        march("naive", "3e-5", {Marcher::Naive, 3e-5f}),
        march("naive", "3e-6", {Marcher::Naive, 3e-6f}),
        march("lipschitz", "", {Marcher::Lipschitz, 3e-6f}),
        {"smooth", "smooth", Engine::SmoothSphere, {}, 1},
        {"iterated", "iterated", Engine::Iterated, {}, 1},
        {"iterated secant", "iterated", Engine::Secant, {}, 1},
    };
    if (!haveEmbree()) return methods;
    for (double spacing : {0.25, 0.5, 1.0, 2.0, 4.0}) methods.push_back(mesh("grid", Engine::GridMesh, spacing));
    for (double spacing : {1.0, 2.0, 4.0}) methods.push_back(mesh("triangles", Engine::TriangleMesh, spacing));
    return methods;
}

std::vector<Method> chooseMethods(const std::vector<std::string>& words) {
    std::vector<Method> all = allMethods();
    if (words.empty()) return all;
    auto named = [](const Method& method, const std::string& word) {
        return method.name == word || method.family == word;
    };
    for (const std::string& word : words) {
        if (std::ranges::any_of(all, [&](const Method& method) { return named(method, word); })) continue;
        std::vector<std::string> names;
        for (const Method& method : all) names.push_back(method.name);
        throw Error(ExitCode::Usage,
                    fmt::format("--methods: unknown method '{}'; there are {}", word, fmt::join(names, ", ")));
    }
    std::erase_if(all, [&](const Method& method) {
        return std::ranges::none_of(words, [&](const std::string& word) { return named(method, word); });
    });
    return all;
}

}  // namespace dsphere::bench
