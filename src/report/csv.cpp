#include "report/csv.h"

#include <fmt/format.h>

namespace dsphere::report {

namespace {

constexpr const char* kColumns =
    "map,map_width,map_height,displacement_percent,view,width,height,hit_share,method,family,skipped,"
    "primary_median,primary_min,primary_max,primary_wall_median,primary_wall_min,primary_wall_max,"
    "shadow_median,shadow_min,shadow_max,shadow_wall_median,shadow_wall_min,shadow_wall_max,shadow_rays,"
    "fetches_per_hit,setup_median,setup_min,setup_max,memory_bytes,"
    "compared,hits,wrong_verdicts,later_roots,tangent,shadows_compared,wrong_shadows,tangent_shadows,runaways,"
    "distance_median,distance_999,distance_greatest,pixels_median,pixels_999,pixels_greatest\r\n";

class Line {
  public:
    void add(const std::string& text) {
        separate();
        if (text.find_first_of(",\"\r\n") == std::string::npos) {
            text_ += text;
            return;
        }
        text_ += '"';
        for (char c : text) text_ += c == '"' ? std::string("\"\"") : std::string(1, c);
        text_ += '"';
    }
    template <typename Number>
    requires std::is_arithmetic_v<Number>
    void add(Number value) {
        separate();
        text_ += fmt::format("{:.9g}", double(value));
    }
    void add(const Spread& spread) {
        for (double value : {spread.median, spread.least, spread.greatest}) {
            if (spread.measured())
                add(value);
            else
                add(std::string());
        }
    }
    std::string end() { return text_ + "\r\n"; }

  private:
    void separate() {
        if (!first_) text_ += ',';
        first_ = false;
    }
    bool first_ = true;
    std::string text_;
};

void addAccuracy(Line& line, const std::optional<Accuracy>& accuracy) {
    constexpr int kFields = 15;
    if (!accuracy) {
        for (int k = 0; k < kFields; ++k) line.add(std::string());
        return;
    }
    for (std::uint64_t count :
         {accuracy->rays, accuracy->hits, accuracy->wrong_verdicts, accuracy->later_roots, accuracy->tangent,
          accuracy->shadow_rays, accuracy->wrong_shadows, accuracy->tangent_shadows, accuracy->runaways})
        line.add(count);
    for (double value : {accuracy->distance_median, accuracy->distance_999, accuracy->distance_greatest,
                         accuracy->pixels_median, accuracy->pixels_999, accuracy->pixels_greatest})
        line.add(value);
}

std::string lineOf(const ViewResult& view, const MethodResult& method) {
    Line line;
    line.add(view.map);
    line.add(view.map_width);
    line.add(view.map_height);
    line.add(view.percent);
    line.add(view.view);
    line.add(view.width);
    line.add(view.height);
    line.add(view.hit_share);
    line.add(method.method);
    line.add(method.family);
    line.add(method.skipped);
    for (const Spread* spread :
         {&method.primary.device, &method.primary.wall, &method.shadow.device, &method.shadow.wall})
        line.add(*spread);
    line.add(method.shadow_rays);
    line.add(method.fetches_per_hit);
    line.add(method.setup_seconds);
    line.add(method.memory_bytes);
    addAccuracy(line, method.accuracy);
    return line.end();
}

}  // namespace

std::string csv(const Results& results) {
    std::string text = kColumns;
    for (const ViewResult& view : results.views)
        for (const MethodResult& method : view.methods) text += lineOf(view, method);
    return text;
}

}  // namespace dsphere::report
