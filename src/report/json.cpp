#include "report/json.h"

#include "base/error.h"

#include <nlohmann/json.hpp>

#include <fstream>

namespace dsphere::report {

using Json = nlohmann::ordered_json;

namespace {

constexpr int kFormat = 1;  ///< raised when a field changes its meaning

// Each struct's fields are named once, for both ways. Writer and Reader visit them.
template <typename Visitor, typename Of>
void visitSpread(Visitor& visit, Of& of) {
    visit("median", of.median);
    visit("min", of.least);
    visit("max", of.greatest);
    visit("count", of.count);
}

template <typename Visitor, typename Of>
void visitAccuracy(Visitor& visit, Of& of) {
    visit("rays", of.rays);
    visit("hits", of.hits);
    visit("wrong_verdicts", of.wrong_verdicts);
    visit("later_roots", of.later_roots);
    visit("tangent", of.tangent);
    visit("shadow_rays", of.shadow_rays);
    visit("wrong_shadows", of.wrong_shadows);
    visit("tangent_shadows", of.tangent_shadows);
    visit("runaways", of.runaways);
    visit("distance_median", of.distance_median);
    visit("distance_999", of.distance_999);
    visit("distance_greatest", of.distance_greatest);
    visit("pixels_median", of.pixels_median);
    visit("pixels_999", of.pixels_999);
    visit("pixels_greatest", of.pixels_greatest);
}

template <typename Visitor, typename Of>
void visitMethod(Visitor& visit, Of& of) {
    visit("method", of.method);
    visit("family", of.family);
    visit("skipped", of.skipped);
    visit("primary_rays_per_second", of.primary.device);
    visit("primary_rays_per_second_wall", of.primary.wall);
    visit("shadow_rays_per_second", of.shadow.device);
    visit("shadow_rays_per_second_wall", of.shadow.wall);
    visit("shadow_rays", of.shadow_rays);
    visit("fetches_per_hit", of.fetches_per_hit);
    visit("setup_seconds", of.setup_seconds);
    visit("memory_bytes", of.memory_bytes);
    visit("accuracy", of.accuracy);
}

template <typename Visitor, typename Of>
void visitView(Visitor& visit, Of& of) {
    visit("map", of.map);
    visit("map_width", of.map_width);
    visit("map_height", of.map_height);
    visit("displacement_percent", of.percent);
    visit("view", of.view);
    visit("width", of.width);
    visit("height", of.height);
    visit("hit_share", of.hit_share);
    visit("methods", of.methods);
}

template <typename Visitor, typename Of>
void visitEnvironment(Visitor& visit, Of& of) {
    visit("version", of.version);
    visit("commit", of.commit);
    visit("date", of.date);
    visit("cpu", of.cpu);
    visit("cores", of.cores);
    visit("load", of.load);
    visit("device", of.device);
    visit("driver", of.driver);
    visit("device_open_seconds", of.device_open_seconds);
    visit("embree", of.embree);
}

template <typename Visitor, typename Of>
void visitResults(Visitor& visit, Of& of) {
    visit("environment", of.environment);
    visit("quick", of.quick);
    visit("repeats", of.repeats);
    visit("samples", of.samples);
    visit("views", of.views);
}

template <typename Visitor, typename Of>
void visitFields(Visitor& visit, Of& of) {
    using Plain = std::remove_const_t<Of>;
    if constexpr (std::is_same_v<Plain, Spread>) visitSpread(visit, of);
    if constexpr (std::is_same_v<Plain, Accuracy>) visitAccuracy(visit, of);
    if constexpr (std::is_same_v<Plain, MethodResult>) visitMethod(visit, of);
    if constexpr (std::is_same_v<Plain, ViewResult>) visitView(visit, of);
    if constexpr (std::is_same_v<Plain, Environment>) visitEnvironment(visit, of);
    if constexpr (std::is_same_v<Plain, Results>) visitResults(visit, of);
}

template <typename T>
constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_same_v<T, std::string>;

struct Writer {
    Json json = Json::object();

    template <typename T>
    static Json value(const T& of) {
        if constexpr (kIsPlain<T>) {
            return of;
        } else {
            Writer writer;
            visitFields(writer, of);
            return writer.json;
        }
    }
    template <typename T>
    static Json value(const std::vector<T>& items) {
        Json list = Json::array();
        for (const T& item : items) list.push_back(value(item));
        return list;
    }
    template <typename T>
    static Json value(const std::optional<T>& item) {
        return item ? value(*item) : Json(nullptr);
    }
    template <typename T>
    void operator()(const char* name, const T& of) {
        json[name] = value(of);
    }
};

struct Reader {
    const Json& json;

    template <typename T>
    static void value(const Json& from, T& of) {
        if constexpr (kIsPlain<T>) {
            from.get_to(of);
        } else {
            Reader reader{from};
            visitFields(reader, of);
        }
    }
    template <typename T>
    static void value(const Json& from, std::vector<T>& items) {
        if (!from.is_array()) throw Json::type_error::create(302, "not a list", &from);
        for (const Json& item : from) value(item, items.emplace_back());
    }
    template <typename T>
    static void value(const Json& from, std::optional<T>& item) {
        if (!from.is_null()) value(from, item.emplace());
    }
    template <typename T>
    void operator()(const char* name, T& of) {
        value(json.at(name), of);
    }
};

}  // namespace

Json toJson(const Results& results) {
    Json json = {{"dsphere_bench", kFormat}};
    json.update(Writer::value(results));
    return json;
}

Results fromJson(const Json& json, const std::string& name) {
    Results results;
    try {
        if (!json.is_object() || !json.contains("dsphere_bench"))
            throwInvalid("{}: is not what dsphere bench --json-file writes", name);
        if (int format = json.at("dsphere_bench").get<int>(); format != kFormat)
            throwInvalid("{}: has format {}; this version reads {}", name, format, kFormat);
        Reader::value(json, results);
    } catch (const Json::exception& error) {
        // "[json.exception.out_of_range.403] key 'views' not found": the library's own name is no one's concern.
        const std::string_view what = error.what();
        throwInvalid("{}: {}", name, what.substr(what.find(']') + 2));
    }
    return results;
}

Results readResults(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throwInvalid("{}: cannot be read: {}", path.string(), lastSystemError());
    Json json = Json::parse(file, nullptr, false);
    if (json.is_discarded()) throwInvalid("{}: is not JSON", path.string());
    return fromJson(json, path.string());
}

}  // namespace dsphere::report
