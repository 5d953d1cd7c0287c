#include "geo/mapwriter.h"

#include <algorithm>

#include "base/error.h"
#include "base/temporaryfile.h"

namespace dsphere::geo {
namespace {

namespace fs = std::filesystem;

using Tell = std::function<bool(double)>;

/// Progress of one of GDAL's calls, as a share of the whole.
struct Progress {
    const std::function<bool(double)>& tell;
    double from, to;
    bool stopped = false;

    static int CPL_STDCALL call(double share, const char*, void* self) {
        auto& progress = *static_cast<Progress*>(self);
        if (progress.tell && !progress.tell(progress.from + share * (progress.to - progress.from)))
            progress.stopped = true;
        return !progress.stopped;
    }
};

void require(bool done, const Progress& progress, const fs::path& output, const GdalMessages& messages) {
    if (progress.stopped) throw Error(ExitCode::Interrupted, output.string() + ": interrupted, nothing was written");
    if (!done || messages.failed()) throwFailure("{}: cannot be written: {}", output.string(), messages.reason());
}

constexpr double kCopied = 0.85;  // the share of the time, overviews taking the rest

void writeMap(const Vrt& mosaic, const fs::path& file, const fs::path& output, const Tell& tell) {
    const Gdal& g = gdal();
    const MemoryFile description(mosaic.text());
    GdalMessages messages;
    Progress progress{tell, 0.0, kCopied};
    const char* formats[] = {"VRT", nullptr};
    const Dataset source(g.GDALOpenEx(description.name().c_str(), GDAL_OF_RASTER, formats, nullptr, nullptr));
    Strings creation{"TILED=YES",
                     "BLOCKXSIZE=512",
                     "BLOCKYSIZE=512",
                     "COMPRESS=DEFLATE",
                     "BIGTIFF=IF_SAFER",
                     "NUM_THREADS=ALL_CPUS",
                     mosaic.type == "Float32" ? "PREDICTOR=3" : "PREDICTOR=2"};
    Dataset made(source ? g.GDALCreateCopy(g.GDALGetDriverByName("GTiff"), file.c_str(), source.get(), FALSE,
                                           creation.list(), Progress::call, &progress)
                        : nullptr);
    const bool copied = made != nullptr;
    made.reset();  // what the cache still holds is written here
    require(copied, progress, output, messages);
}

void addOverviews(const Vrt& mosaic, const fs::path& file, const fs::path& output, const Tell& tell) {
    const Gdal& g = gdal();
    constexpr int kLeastSide = 256;
    std::vector<int> levels;
    for (int level = 2; std::min(mosaic.width, mosaic.height) / level >= kLeastSide; level *= 2)
        levels.push_back(level);
    if (levels.empty()) return;
    GdalMessages messages;
    Progress progress{tell, kCopied, 1.0};
    const char* formats[] = {"GTiff", nullptr};
    Dataset made(g.GDALOpenEx(file.c_str(), GDAL_OF_RASTER | GDAL_OF_UPDATE, formats, nullptr, nullptr));
    const bool done = made && g.GDALBuildOverviews(made.get(), "AVERAGE", int(levels.size()), levels.data(), 0, nullptr,
                                                   Progress::call, &progress) == CE_None;
    made.reset();
    require(done, progress, output, messages);
}

}  // namespace

void writeGeoTiff(const Vrt& raster, const fs::path& output, const Tell& tell) {
    TemporaryFile temporary(output);
    writeMap(raster, temporary.name().string(), output, tell);
    addOverviews(raster, temporary.name().string(), output, tell);
    temporary.commit();
}

}  // namespace dsphere::geo
