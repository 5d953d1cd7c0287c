#include "geo/vrt.h"

#include <atomic>

#include "base/error.h"

namespace dsphere::geo {
namespace {

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) switch (c) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += c;
        }
    return result;
}

std::string textOf(const VrtPart& part) {
    std::string text = fmt::format(
        "<ComplexSource><SourceFilename relativeToVRT=\"0\">{}</SourceFilename><SourceBand>{}</SourceBand>"
        "<SrcRect xOff=\"{}\" yOff=\"{}\" xSize=\"{}\" ySize=\"{}\"/><DstRect xOff=\"{}\" yOff=\"{}\" xSize=\"{}\" "
        "ySize=\"{}\"/>",
        escaped(part.source), part.band, part.from_column, part.from_row, part.columns, part.rows, part.to_column,
        part.to_row, part.columns, part.rows);
    if (part.scale != 1.0 || part.offset != 0.0)
        text +=
            fmt::format("<ScaleOffset>{:.17g}</ScaleOffset><ScaleRatio>{:.17g}</ScaleRatio>", part.offset, part.scale);
    if (!part.nodata.empty()) text += "<NODATA>" + part.nodata + "</NODATA>";
    return text + "</ComplexSource>\n";
}

std::string maskOf(const Vrt& vrt) {
    std::string text = "<MaskBand><VRTRasterBand dataType=\"Byte\">";
    for (const VrtPart& part : vrt.parts)
        text += fmt::format(
            "<SimpleSource><SourceFilename relativeToVRT=\"0\">{}</SourceFilename><SourceBand>mask,{}</SourceBand>"
            "<SrcRect xOff=\"{}\" yOff=\"{}\" xSize=\"{}\" ySize=\"{}\"/><DstRect xOff=\"{}\" yOff=\"{}\" xSize=\"{}\" "
            "ySize=\"{}\"/></SimpleSource>",
            escaped(part.source), part.band, part.from_column, part.from_row, part.columns, part.rows, part.to_column,
            part.to_row, part.columns, part.rows);
    return text + "</VRTRasterBand></MaskBand>";
}

}  // namespace

std::string Vrt::text() const {
    const auto& t = transform;
    std::string text = fmt::format(
        "<VRTDataset rasterXSize=\"{}\" rasterYSize=\"{}\"><SRS>{}</SRS>"
        "<GeoTransform>{:.17g}, {:.17g}, {:.17g}, {:.17g}, {:.17g}, {:.17g}</GeoTransform>\n"
        "<VRTRasterBand dataType=\"{}\" band=\"1\">",
        width, height, escaped(crs), t[0], t[1], t[2], t[3], t[4], t[5], type);
    if (!masked) text += "<NoDataValue>" + nodata + "</NoDataValue>";
    if (!unit.empty()) text += "<UnitType>" + escaped(unit) + "</UnitType>";
    if (scale != 1.0 || offset != 0.0)
        text += fmt::format("<Offset>{:.17g}</Offset><Scale>{:.17g}</Scale>", offset, scale);
    text += "\n";
    for (const VrtPart& part : parts) text += textOf(part);
    text += "</VRTRasterBand>";
    if (masked) text += maskOf(*this);
    return text + "</VRTDataset>\n";
}

MemoryFile::MemoryFile() {
    static std::atomic<int> count = 0;
    name_ = fmt::format("/vsimem/dsphere/{}.vrt", ++count);
}

MemoryFile::MemoryFile(std::string text) : MemoryFile() {
    text_ = std::make_unique<std::string>(std::move(text));
    auto* bytes = reinterpret_cast<GByte*>(text_->data());
    gdal().VSIFCloseL(gdal().VSIFileFromMemBuffer(name_.c_str(), bytes, text_->size(), FALSE));
}

MemoryFile::~MemoryFile() {
    if (!name_.empty()) gdal().VSIUnlink(name_.c_str());
}

}  // namespace dsphere::geo
