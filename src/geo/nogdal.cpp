#include "base/error.h"
#include "geo/readmap.h"

namespace dsphere::geo {

RawMap readPlacedMap(const PlacedFile& file, std::optional<int>, const std::string& reason) {
    throwInvalid(
        "{}: {}, which is read with GDAL; this dsphere was built without it (install libgdal-dev and build it anew)",
        file.path.string(), reason);
}

}  // namespace dsphere::geo
