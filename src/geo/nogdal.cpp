#include "base/error.h"
#include "geo/import.h"
#include "geo/readmap.h"

namespace dsphere::geo {

RawMap readPlacedMap(const PlacedFile& file, std::optional<int>, const std::string& reason) {
    throwInvalid(
        "{}: {}, which is read with GDAL; this dsphere was built without it (install libgdal-dev and build it anew)",
        file.path.string(), reason);
}

ImportResult importMaps(const ImportOptions& options) {
    throwInvalid("{}: import needs GDAL, which this dsphere was built without (install libgdal-dev and build it anew)",
                 options.output.string());
}

}  // namespace dsphere::geo
