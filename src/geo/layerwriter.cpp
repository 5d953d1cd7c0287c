#include "geo/layerwriter.h"

#include <array>
#include <cassert>
#include <cmath>

#include "base/error.h"
#include "base/temporaryfile.h"
#include "geo/gdal.h"
#include "geo/gdalreference.h"

namespace dsphere::geo {
namespace {

void require(bool done, const std::filesystem::path& output, const GdalMessages& messages) {
    if (!done || messages.failed()) throwFailure("{}: cannot be written: {}", output.string(), messages.reason());
}

void place(GDALDatasetH dataset, const LayerPlace& where) {
    std::array<double, 6> transform{where.west, (where.east - where.west) / where.width,   0.0, where.north,
                                    0.0,        (where.south - where.north) / where.height};
    gdal().GDALSetGeoTransform(dataset, transform.data());
    const OGRSpatialReferenceH sphere = newSphere(where.radius);
    gdal().GDALSetProjection(dataset, wktOf(sphere).c_str());
    gdal().OSRDestroySpatialReference(sphere);
}

void describe(GDALRasterBandH band, const LayerInfo& layer) {
    const Gdal& g = gdal();
    g.GDALSetDescription(band, layer.name.c_str());
    g.GDALSetRasterNoDataValue(band, std::nan(""));
    if (!layer.unit.empty()) g.GDALSetRasterUnitType(band, layer.unit.c_str());
    if (layer.scale == 1.0 && layer.offset == 0.0) return;
    g.GDALSetRasterScale(band, layer.scale);
    g.GDALSetRasterOffset(band, layer.offset);
}

}  // namespace

struct LayerWriter::Parts {
    std::filesystem::path output;
    LayerPlace place;
    int count, written = 0;
    TemporaryFile temporary;
    Dataset dataset = {};
};

LayerWriter::LayerWriter(const std::filesystem::path& output, const LayerPlace& where,
                         const std::vector<LayerInfo>& layers) {
    const Gdal& g = gdal();
    parts_.reset(new Parts{output, where, int(layers.size()), 0, TemporaryFile(output)});
    GdalMessages messages;
    Strings creation{"TILED=YES",       "COMPRESS=DEFLATE", "PREDICTOR=3",
                     "INTERLEAVE=BAND", "BIGTIFF=IF_SAFER", "NUM_THREADS=ALL_CPUS"};
    parts_->dataset.reset(g.GDALCreate(g.GDALGetDriverByName("GTiff"), parts_->temporary.name().c_str(), where.width,
                                       where.height, parts_->count, GDT_Float32, creation.list()));
    require(parts_->dataset != nullptr, output, messages);
    place(parts_->dataset.get(), where);
    for (int k = 0; k < parts_->count; ++k)
        describe(g.GDALGetRasterBand(parts_->dataset.get(), k + 1), layers[std::size_t(k)]);
    require(true, output, messages);
}

LayerWriter::~LayerWriter() = default;

void LayerWriter::write(std::span<const float> values) {
    const LayerPlace& place = parts_->place;
    assert(parts_->written < parts_->count && values.size() == std::size_t(place.width) * std::size_t(place.height));
    GdalMessages messages;
    const GDALRasterBandH band = gdal().GDALGetRasterBand(parts_->dataset.get(), ++parts_->written);
    const CPLErr error =
        gdal().GDALRasterIO(band, GF_Write, 0, 0, place.width, place.height, const_cast<float*>(values.data()),
                            place.width, place.height, GDT_Float32, 0, 0);
    require(error == CE_None, parts_->output, messages);
}

void LayerWriter::commit() {
    assert(parts_->written == parts_->count);
    GdalMessages messages;
    parts_->dataset.reset();  // what the cache still holds is written here
    require(true, parts_->output, messages);
    parts_->temporary.commit();
}

}  // namespace dsphere::geo
