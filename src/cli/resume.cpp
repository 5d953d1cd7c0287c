#include "cli/resume.h"

#include "base/error.h"
#include "cli/parts.h"

namespace dsphere::cli {

namespace {

/// The attribute of that name; Error (InvalidInput) when there is none of that type.
template <typename T>
T attribute(const Metadata& metadata, const char* name) {
    const auto found = metadata.find(name);
    const T* value = found == metadata.end() ? nullptr : std::get_if<T>(&found->second);
    if (!value) throwInvalid("it is no picture of render's: its header lacks {}", name);
    return *value;
}

template <typename T>
void requireSame(const Metadata& metadata, const char* name, const T& now, const char* what) {
    const T then = attribute<T>(metadata, name);
    if (then != now) throwInvalid("{} is another: {}, now {}", what, then, now);
}

void requireOrigin(const Metadata& metadata, const Image& picture, const Origin& origin) {
    if (picture.data != origin.data || picture.display != origin.display)
        throwInvalid("it has other pixels: {}x{} of {}x{}, now {}x{} of {}x{}", picture.data.width(),
                     picture.data.height(), picture.display.width(), picture.display.height(), origin.data.width(),
                     origin.data.height(), origin.display.width(), origin.display.height());
    requireSame(metadata, "software", origin.software, "the program");
    requireSame(metadata, "seed", origin.seed, "the seed");
    if (attribute<std::string>(metadata, "fingerprint") != origin.fingerprint)
        throwInvalid("it is of another scene, other maps or images, or other options ({})",
                     "--exaggeration, --lookat-latlon, --marcher, --detail, --clamp, --alpha");
    if (!metadata.contains("device"))
        throwInvalid("it was written with --reproducible, which leaves out what going on needs");
    requireSame(metadata, "device", origin.device, "the device");
    requireSame(metadata, "driver", origin.driver, "the driver");
}

}  // namespace

Earlier readEarlier(const std::filesystem::path& path, const Origin& origin, int first, int last) {
    const Image picture = readExr(path);
    const Metadata metadata = readExrMetadata(path);
    Earlier earlier;
    try {
        requireOrigin(metadata, picture, origin);
        const int before = attribute<int>(metadata, "samplesPerPixel");
        if (before < 1) throwInvalid("it has no samples");
        if (const int begins = firstSampleOf(metadata); begins != first)
            throwInvalid("it begins with sample {}, now {}", begins, first);
        if (before >= last - first)
            throw Error(ExitCode::Usage, fmt::format("it has {} samples already; give --spp more than that", before));
        earlier.sums = sumsOf(picture, first, first + before);
        earlier.device_seconds = double(attribute<float>(metadata, "renderTimeSeconds"));
    } catch (const Error& error) {
        throw Error(error.code(), fmt::format("--resume {}: {}", path.string(), error.what()));
    }
    return earlier;
}

}  // namespace dsphere::cli
