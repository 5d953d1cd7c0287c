#include "base/error.h"
#include "geo/import.h"
#include "geo/largemap.h"
#include "geo/layerwriter.h"
#include "geo/readmap.h"

namespace dsphere::geo {

RawMap readPlacedMap(const FileForGdal& found, std::optional<int>) {
    throwInvalid(
        "{}: {}, which is read with GDAL; this dsphere was built without it (install libgdal-dev and build it anew)",
        found.file.path.string(), found.reason);
}

std::shared_ptr<const LargeMap> openLargeMap(const std::filesystem::path&, std::optional<int>, std::uint64_t) {
    return nullptr;
}

ImportResult importMaps(const ImportOptions& options) {
    throwInvalid("{}: import needs GDAL, which this dsphere was built without (install libgdal-dev and build it anew)",
                 options.output.string());
}

struct LayerWriter::Parts {};

LayerWriter::LayerWriter(const std::filesystem::path& output, const LayerPlace&, const std::vector<LayerInfo>&) {
    throwInvalid("{}: GeoTIFFs need GDAL, which this dsphere was built without (install libgdal-dev and build it anew)",
                 output.string());
}

LayerWriter::~LayerWriter() = default;
void LayerWriter::write(std::span<const float>) {}
void LayerWriter::commit() {}

}  // namespace dsphere::geo
