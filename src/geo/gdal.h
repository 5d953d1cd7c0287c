#pragma once

// The part of GDAL that this program calls. The library is loaded when a map first needs it, so that no other start
// waits for it and for the hundred libraries that it brings.

#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <gdal_frmts.h>
#include <gdal_utils.h>
#include <ogr_srs_api.h>

#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace dsphere::geo {

// clang-format off
// Formats that are not among these are never registered: GDAL can open no others, from a VRT either.
#define DSPHERE_GDAL_FORMATS(use) \
    use(GDALRegister_GTiff) use(GDALRegister_VRT) use(GDALRegister_PDS) use(GDALRegister_PDS4) \
    use(GDALRegister_ISIS2) use(GDALRegister_ISIS3) use(GDALRegister_VICAR) use(GDALRegister_netCDF) \
    use(GDALRegister_ENVI) use(GDALRegister_FITS) use(GDALRegister_SRTMHGT) use(GDALRegister_AAIGrid) \
    use(GDALRegister_JP2OpenJPEG)

#define DSPHERE_GDAL_FUNCTIONS(use) \
    use(GDALOpenEx) use(GDALClose) use(GDALGetDriverByName) use(GDALCreateCopy) use(GDALBuildOverviews) \
    use(GDALSetCacheMax64) use(GDALGetFileList) use(GDALGetRasterXSize) use(GDALGetRasterYSize) \
    use(GDALGetRasterCount) use(GDALGetBlockSize) \
    use(GDALGetRasterBand) use(GDALGetMetadata) use(GDALGetMetadataItem) use(GDALGetGeoTransform) \
    use(GDALGetGCPCount) use(GDALGetSpatialRef) use(GDALGetRasterDataType) use(GDALGetDataTypeName) \
    use(GDALGetDataTypeSizeBits) use(GDALGetRasterNoDataValue) use(GDALGetRasterScale) use(GDALGetRasterOffset) \
    use(GDALGetRasterUnitType) use(GDALGetMaskFlags) use(GDALGetMaskBand) use(GDALGetRasterColorInterpretation) \
    use(GDALGetRasterColorTable) use(GDALRasterIO) use(GDALWarp) use(GDALWarpAppOptionsNew) \
    use(GDALWarpAppOptionsFree) use(CPLSetConfigOption) use(CPLPushErrorHandlerEx) use(CPLPopErrorHandler) \
    use(CPLSetErrorHandler) use(CPLGetErrorHandlerUserData) use(CPLQuietErrorHandler) use(CSLDestroy) \
    use(VSIFree) use(VSIUnlink) use(VSIFileFromMemBuffer) use(VSIFCloseL) use(VSIGetFileSystemsPrefixes) \
    use(VSIInstallPluginHandler) use(VSIAllocFilesystemPluginCallbacksStruct) \
    use(VSIFreeFilesystemPluginCallbacksStruct) use(OSRIsGeographic) use(OSRIsProjected) use(OSRGetAttrValue) use(OSRGetName) \
    use(OSRGetNormProjParm) use(OSRGetSemiMajor) use(OSRGetSemiMinor) use(OSRGetLinearUnits) \
    use(OSRGetAngularUnits) use(OSRGetPrimeMeridian) use(OSRNewSpatialReference) use(OSRDestroySpatialReference) \
    use(OSRSetGeogCS) use(OSRCloneGeogCS) use(OSRSetAxisMappingStrategy) use(OSRExportToWkt) use(GDALCreate) \
    use(GDALSetGeoTransform) use(GDALSetProjection) use(GDALSetDescription) use(GDALSetRasterUnitType) \
    use(GDALSetRasterNoDataValue) use(GDALSetRasterScale) use(GDALSetRasterOffset)
// clang-format on

/// GDAL's functions under their own names; see GDAL's manual for what they do.
struct Gdal {
#define DSPHERE_GDAL_MEMBER(name) decltype(&::name) name = nullptr;
    DSPHERE_GDAL_FORMATS(DSPHERE_GDAL_MEMBER)
    DSPHERE_GDAL_FUNCTIONS(DSPHERE_GDAL_MEMBER)
#undef DSPHERE_GDAL_MEMBER
};

/// Loads GDAL on the first call: registers the formats above, and shuts its network file systems. Throws Error
/// (InvalidInput) when it cannot be loaded; the message says how it is installed.
const Gdal& gdal();

/// While it lives, GDAL's messages of this thread are kept here, and none is printed.
class GdalMessages {
  public:
    GdalMessages();
    ~GdalMessages();
    GdalMessages(const GdalMessages&) = delete;
    GdalMessages& operator=(const GdalMessages&) = delete;

    /// The first error, or that there was none.
    std::string reason() const;
    bool failed() const { return !first_.empty(); }

  private:
    static void CPL_STDCALL keep(CPLErr kind, CPLErrorNum number, const char* message);

    std::string first_;
};

/// GDAL's list of strings.
class Strings {
  public:
    Strings(std::initializer_list<std::string> words) : words_(words) {
        for (std::string& word : words_) pointers_.push_back(word.data());
        pointers_.push_back(nullptr);
    }
    Strings(const Strings&) = delete;
    Strings& operator=(const Strings&) = delete;

    char** list() { return pointers_.data(); }

  private:
    std::vector<std::string> words_;
    std::vector<char*> pointers_;
};

struct CloseDataset {
    void operator()(void* dataset) const { gdal().GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;  ///< of GDALDatasetH

}  // namespace dsphere::geo
