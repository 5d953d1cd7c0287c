#include "geo/gdal.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "base/error.h"

namespace dsphere::geo {
namespace {

template <typename Function>
void load(void* library, const char* name, Function*& function) {
    function = reinterpret_cast<Function*>(dlsym(library, name));
    if (!function) throwInvalid("GDAL lacks the function {}; expected GDAL 3.6 or later", name);
}

void* openNothing(void*, const char*, const char*) {
    return nullptr;
}

/// Every file system of GDAL but those of local files and archives is replaced by one that opens nothing.
void shutNetwork(const Gdal& g) {
    const std::set<std::string> local{"/vsimem/", "/vsisubfile/", "/vsigzip/", "/vsizip/", "/vsitar/", "/vsisparse/"};
    VSIFilesystemPluginCallbacksStruct* nothing = g.VSIAllocFilesystemPluginCallbacksStruct();
    nothing->open = openNothing;
    char** prefixes = g.VSIGetFileSystemsPrefixes();
    for (char** prefix = prefixes; prefix && *prefix; ++prefix)
        if (std::string(*prefix).starts_with("/vsi") && !local.contains(*prefix))
            g.VSIInstallPluginHandler(*prefix, nothing);
    g.CSLDestroy(prefixes);
    g.VSIFreeFilesystemPluginCallbacksStruct(nothing);
}

Gdal loadGdal() {
    // Stays loaded to the end of the process.
    const char* named = std::getenv("DSPHERE_GDAL");
    void* library = dlopen(named && *named ? named : DSPHERE_GDAL_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
    if (!library) {
        const char* reason = dlerror();
        throwInvalid(
            "maps that say where they lie are read with GDAL, which cannot be loaded: {}; Debian's package "
            "libgdal32 has it",
            reason ? reason : "unknown reason");
    }
    Gdal g;
#define DSPHERE_GDAL_LOAD(name) load(library, #name, g.name);
    DSPHERE_GDAL_FORMATS(DSPHERE_GDAL_LOAD)
    DSPHERE_GDAL_FUNCTIONS(DSPHERE_GDAL_LOAD)
#undef DSPHERE_GDAL_LOAD
    g.CPLSetErrorHandler(g.CPLQuietErrorHandler);  // of GDAL's own threads
    g.CPLSetConfigOption("GDAL_VRT_ENABLE_PYTHON", "NO");
#define DSPHERE_GDAL_REGISTER(name) g.name();
    DSPHERE_GDAL_FORMATS(DSPHERE_GDAL_REGISTER)
#undef DSPHERE_GDAL_REGISTER
    shutNetwork(g);
    return g;
}

}  // namespace

const Gdal& gdal() {
    static const Gdal table = loadGdal();
    return table;
}

GdalMessages::GdalMessages() {
    gdal().CPLPushErrorHandlerEx(keep, this);
}

GdalMessages::~GdalMessages() {
    gdal().CPLPopErrorHandler();
}

std::string GdalMessages::reason() const {
    return first_.empty() ? "GDAL gives no reason; the file may be truncated or damaged" : first_;
}

void GdalMessages::keep(CPLErr kind, CPLErrorNum, const char* message) {
    auto* self = static_cast<GdalMessages*>(gdal().CPLGetErrorHandlerUserData());
    if (!self || kind < CE_Failure || !self->first_.empty()) return;
    self->first_ = message;
    std::ranges::replace(self->first_, '\n', ' ');
}

}  // namespace dsphere::geo
