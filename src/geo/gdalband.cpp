#include "geo/gdalband.h"

#include <cstdlib>

#include "base/error.h"
#include "geo/gdalreference.h"

namespace dsphere::geo {

SampleType sampleTypeOf(const OpenMap& map, GDALRasterBandH band) {
    const Gdal& g = gdal();
    SampleType sample;
    sample.type = g.GDALGetRasterDataType(band);
    sample.bits = g.GDALGetDataTypeSizeBits(sample.type);
    sample.is_float = sample.type == GDT_Float32 || sample.type == GDT_Float64;
    sample.is_signed = sample.type == GDT_Int16 || sample.type == GDT_Int32 || sample.type == GDT_Int64;
    const bool is_unsigned =
        sample.type == GDT_Byte || sample.type == GDT_UInt16 || sample.type == GDT_UInt32 || sample.type == GDT_UInt64;
    if (!sample.is_float && !sample.is_signed && !is_unsigned)
        throwInvalid("{}: {}: samples of type {}, expected real integers or floats", map.name(),
                     nameOf(map.file.format), g.GDALGetDataTypeName(sample.type));
    const char* bits = g.GDALGetMetadataItem(band, "NBITS", "IMAGE_STRUCTURE");
    if (bits && std::atoi(bits) > 0 && std::atoi(bits) < sample.bits) sample.bits = std::atoi(bits);
    const char* pixel = g.GDALGetMetadataItem(band, "PIXELTYPE", "IMAGE_STRUCTURE");
    if (pixel && std::string(pixel) == "SIGNEDBYTE") sample.is_signed = sample.signed_bytes = true;
    return sample;
}

Unknown unknownOf(const OpenMap& map, GDALRasterBandH band, const SampleType& sample) {
    using Format = PlacedFile::Format;
    const Gdal& g = gdal();
    Unknown unknown;
    int has = 0;
    const double value = g.GDALGetRasterNoDataValue(band, &has);
    if (map.label) {  // for which GDAL makes a value up
        if (const auto missing = map.label->missing()) unknown.value = missing->second;
    } else if (has) {
        unknown.value = sample.type == GDT_Float32 ? double(float(value)) : value;
    }
    const Format format = map.file.format;
    unknown.special_floats = sample.is_float && (format == Format::Pds3 || format == Format::Isis);
    const int flags = g.GDALGetMaskFlags(band);
    if (!(flags & (GMF_ALL_VALID | GMF_NODATA))) unknown.mask = g.GDALGetMaskBand(band);
    return unknown;
}

Units unitsOf(const OpenMap& map, GDALRasterBandH band, const SampleType& sample, bool knows_radius) {
    const Gdal& g = gdal();
    const double scale = g.GDALGetRasterScale(band, nullptr), offset = g.GDALGetRasterOffset(band, nullptr);
    const bool meant = scale != 1.0 || offset != 0.0;
    std::string unit = g.GDALGetRasterUnitType(band);
    if (map.label && unit.empty()) unit = map.label->text("UNIT");
    Units units;
    units.unit_source = unit.empty() ? "default" : map.source();
    if (unit.empty() && map.label && sample.is_float) unit = "km";
    if (unit.empty() && (knows_radius || meant) && sample.bits > 8) unit = "m";
    const std::optional<double> metres = metresIn(unit);
    units.unit = metres ? "m" : unit;
    if (!meant && metres.value_or(1.0) == 1.0) return units;
    units.scale = scale * metres.value_or(1.0);
    units.offset = offset * metres.value_or(1.0);
    return units;
}

}  // namespace dsphere::geo
