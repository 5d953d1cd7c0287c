#pragma once

// One map as the world's archives publish it: label files and samples, byte by byte.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace dsphere::test {

inline constexpr int kTwinWidth = 64, kTwinHeight = 32;
inline constexpr double kTwinStep = 5.625;

/// First row northmost, first column at longitude 0; no two texels are alike by chance alone.
inline std::vector<std::int16_t> twinHeights() {
    std::vector<std::int16_t> heights;
    for (int j = 0; j < kTwinHeight; ++j)
        for (int i = 0; i < kTwinWidth; ++i)
            heights.push_back(std::int16_t(9000.0 * std::sin(0.1 * i + 0.37 * j) + 13 * i - 29 * j));
    return heights;
}

/// Two bytes a sample; the most significant first or last.
inline std::string bytesOf(const std::vector<std::int16_t>& heights, bool big) {
    std::string bytes;
    for (const std::int16_t height : heights) {
        const char low = char(height & 0xff), high = char((height >> 8) & 0xff);
        bytes += big ? std::string{high, low} : std::string{low, high};
    }
    return bytes;
}

inline std::vector<std::int16_t> fromTheSouth(const std::vector<std::int16_t>& heights) {
    std::vector<std::int16_t> turned;
    for (int j = kTwinHeight - 1; j >= 0; --j)
        turned.insert(turned.end(), heights.begin() + j * kTwinWidth, heights.begin() + (j + 1) * kTwinWidth);
    return turned;
}

struct Pds3Form {
    std::string image = {}, sample_type = "LSB_INTEGER", more = {};
    int bits = 16, width = kTwinWidth, height = kTwinHeight;
    double radius_km = 1737.4, resolution = 1.0 / kTwinStep, west = 0.0, east = 360.0, north = 90.0, south = -90.0;
    double centre = 180.0, half = -0.5;  ///< half: what the archive adds to its offsets
};

/// A detached label as LOLA's and MOLA's, lines ended as theirs.
inline std::string pds3Label(const Pds3Form& form) {
    const auto line = [](const std::string& key, const std::string& value) { return key + " = " + value + "\r\n"; };
    const auto number = [&](const std::string& key, double value) { return line(key, fmt::format("{}", value)); };
    std::string text = line("PDS_VERSION_ID", "\"PDS3\"") + line("RECORD_TYPE", "FIXED_LENGTH") +
                       number("RECORD_BYTES", form.width * form.bits / 8) + number("FILE_RECORDS", form.height) +
                       line("^IMAGE", "\"" + form.image + "\"") + line("OBJECT", "IMAGE") +
                       number("LINES", form.height) + number("LINE_SAMPLES", form.width) +
                       line("SAMPLE_TYPE", form.sample_type) + number("SAMPLE_BITS", form.bits) + form.more +
                       line("END_OBJECT", "IMAGE");
    text +=
        line("OBJECT", "IMAGE_MAP_PROJECTION") + line("MAP_PROJECTION_TYPE", "\"SIMPLE CYLINDRICAL\"") +
        line("MAP_RESOLUTION", fmt::format("{} <PIX/DEG>", form.resolution)) +
        line("MAP_SCALE", fmt::format("{} <KM/PIXEL>", form.radius_km * std::numbers::pi / 180.0 / form.resolution));
    for (const char* axis : {"A", "B", "C"})
        text += line(fmt::format("{}_AXIS_RADIUS", axis), fmt::format("{} <KM>", form.radius_km));
    text += line("POSITIVE_LONGITUDE_DIRECTION", "EAST") + number("CENTER_LATITUDE", 0.0) +
            number("CENTER_LONGITUDE", form.centre) + number("MAXIMUM_LATITUDE", form.north) +
            number("MINIMUM_LATITUDE", form.south) + number("WESTERNMOST_LONGITUDE", form.west) +
            number("EASTERNMOST_LONGITUDE", form.east) +
            number("LINE_PROJECTION_OFFSET", form.north * form.resolution + form.half) +
            number("SAMPLE_PROJECTION_OFFSET", (form.centre - form.west) * form.resolution + form.half) +
            line("END_OBJECT", "IMAGE_MAP_PROJECTION") + "END\r\n";
    return text;
}

inline std::string isisCube(const std::string& samples) {
    constexpr double kRadius = 3396190.0, kMetres = kRadius * std::numbers::pi / 180.0 * kTwinStep;
    std::string label = fmt::format(
        "Object = IsisCube\n  Object = Core\n    StartByte = 4097\n    Format = BandSequential\n"
        "    Group = Dimensions\n      Samples = {}\n      Lines = {}\n      Bands = 1\n    End_Group\n"
        "    Group = Pixels\n      Type = SignedWord\n      ByteOrder = Lsb\n      Base = 0.0\n      Multiplier = 1.0\n"
        "    End_Group\n  End_Object\n  Group = Mapping\n    ProjectionName = SimpleCylindrical\n"
        "    CenterLongitude = 180.0\n    TargetName = Mars\n    EquatorialRadius = {} <meters>\n"
        "    PolarRadius = {} <meters>\n    LatitudeType = Planetocentric\n    LongitudeDirection = PositiveEast\n"
        "    LongitudeDomain = 360\n    MinimumLatitude = -90.0\n    MaximumLatitude = 90.0\n    MinimumLongitude = "
        "0.0\n"
        "    MaximumLongitude = 360.0\n    UpperLeftCornerX = {:.10f} <meters>\n    UpperLeftCornerY = {:.10f} "
        "<meters>\n"
        "    PixelResolution = {:.10f} <meters/pixel>\n    Scale = {:.12f} <pixels/degree>\n  "
        "End_Group\nEnd_Object\nEnd\n",
        kTwinWidth, kTwinHeight, kRadius, kRadius, -32.0 * kMetres, 16.0 * kMetres, kMetres, 1.0 / kTwinStep);
    label.resize(4096, '\0');
    return label + samples;
}

/// NetCDF's classic format: coordinates of texels' centres, latitudes from the south.
inline std::string netCdf(const std::string& samples) {
    const auto word = [](std::uint32_t x) { return std::string{char(x >> 24), char(x >> 16), char(x >> 8), char(x)}; };
    const auto name = [&](std::string text) {
        const auto length = std::uint32_t(text.size());
        text.resize((text.size() + 3) / 4 * 4, '\0');
        return word(length) + text;
    };
    const auto doubles = [&](double first, int count) {
        std::string bytes;
        for (int k = 0; k < count; ++k) {
            const double value = first + k * kTwinStep;
            std::uint64_t bits;
            std::memcpy(&bits, &value, 8);
            bytes += word(std::uint32_t(bits >> 32)) + word(std::uint32_t(bits));
        }
        return bytes;
    };
    constexpr std::uint32_t kDimension = 10, kVariable = 11, kAttribute = 12, kChar = 2, kShort = 3, kDouble = 6;
    const auto units = [&](const std::string& unit) {
        return word(kAttribute) + word(1) + name("units") + word(kChar) + name(unit);
    };
    const auto header = [&](std::uint32_t latitudes, std::uint32_t longitudes, std::uint32_t heights) {
        std::string text = "CDF\x01" + word(0) + word(kDimension) + word(2) + name("lat") + word(kTwinHeight) +
                           name("lon") + word(kTwinWidth) + word(0) + word(0) + word(kVariable) + word(3);
        text += name("lat") + word(1) + word(0) + units("degrees_north") + word(kDouble) + word(8 * kTwinHeight) +
                word(latitudes);
        text += name("lon") + word(1) + word(1) + units("degrees_east") + word(kDouble) + word(8 * kTwinWidth) +
                word(longitudes);
        return text + name("z") + word(2) + word(0) + word(1) + units("m") + word(kShort) +
               word(2 * kTwinWidth * kTwinHeight) + word(heights);
    };
    const auto start = std::uint32_t(header(0, 0, 0).size());
    const std::uint32_t longitudes = start + 8 * kTwinHeight, heights = longitudes + 8 * kTwinWidth;
    return header(start, longitudes, heights) + doubles(-90.0 + kTwinStep / 2.0, kTwinHeight) +
           doubles(kTwinStep / 2.0, kTwinWidth) + samples;
}

inline std::string enviHeader() {
    return fmt::format(
        "ENVI\nsamples = {}\nlines = {}\nbands = 1\nheader offset = 0\nfile type = ENVI Standard\ndata type = 2\n"
        "interleave = bsq\nbyte order = 0\nmap info = {{Geographic Lat/Lon, 1, 1, 0, 90, {}, {}, WGS-84}}\n",
        kTwinWidth, kTwinHeight, kTwinStep, kTwinStep);
}

inline std::string asciiGrid(const std::vector<std::int16_t>& heights) {
    std::string text = fmt::format("ncols {}\nnrows {}\nxllcorner 0\nyllcorner -90\ncellsize {}\nNODATA_value -9999\n",
                                   kTwinWidth, kTwinHeight, kTwinStep);
    for (std::size_t k = 0; k < heights.size(); ++k)
        text += std::to_string(heights[k]) + ((k + 1) % kTwinWidth == 0 ? "\n" : " ");
    return text;
}

inline std::string fits(std::string samples) {
    std::string header;
    const auto card = [&](const std::string& key, const std::string& value) {
        header += fmt::format("{:<80}", fmt::format("{:<8}= {:>20}", key, value));
    };
    card("SIMPLE", "T");
    card("BITPIX", "16");
    card("NAXIS", "2");
    card("NAXIS1", std::to_string(kTwinWidth));
    card("NAXIS2", std::to_string(kTwinHeight));
    header += fmt::format("{:<80}", "END");
    header.resize(2880, ' ');
    samples.resize((samples.size() + 2879) / 2880 * 2880, '\0');
    return header + samples;
}

}  // namespace dsphere::test
