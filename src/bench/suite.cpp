#include "bench/suite.h"

#include "base/error.h"
#include "bench/views.h"

#include <algorithm>

namespace dsphere::bench {

namespace {

std::vector<StandardView> chooseViews(const std::vector<std::string>& words) {
    std::vector<StandardView> chosen;
    for (const std::string& word : words)
        if (std::ranges::none_of(standardViews(), [&](const StandardView& view) { return view.word == word; }))
            throw Error(ExitCode::Usage,
                        fmt::format("--views: unknown view '{}'; there are whole, limb, horizon", word));
    for (const StandardView& view : standardViews())
        if (words.empty() || std::ranges::find(words, view.word) != words.end()) chosen.push_back(view);
    return chosen;
}

/// Displacements of one map follow each other: it is made once.
struct MapMemory {
    RawMap map;

    const RawMap& of(int width) {
        if (map.width != width) map = suiteMap(width);
        return map;
    }
};

}  // namespace

std::vector<Source> suiteSources(const Suite& suite) {
    std::vector<StandardView> views = chooseViews(suite.views);
    for (int width : suite.widths)
        if (width < 2 || width > 16384 || width % 2)
            throw Error(ExitCode::Usage, fmt::format("--maps: {} is not an even width of 2 to 16384", width));
    Film film;
    film.width = suite.width;
    film.height = suite.height;
    auto memory = std::make_shared<MapMemory>();
    std::vector<Source> sources;
    for (int width : suite.widths)
        for (double percent : suite.percents) {
            auto make = [=] {
                Workload workload = suiteWorkload(memory->of(width), percent);
                for (const StandardView& view : views)
                    workload.views.push_back(
                        {view.name, cameraOf(view, workload.maps.reliefs[0].greatest_radius), film});
                return workload;
            };
            sources.push_back({make, int(views.size())});
        }
    return sources;
}

}  // namespace dsphere::bench
