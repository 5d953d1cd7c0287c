#pragma once

// Drawing plots as SVG. Colours are CSS classes, so that the page around them may be light or dark.

#include "base/math.h"

#include <string>
#include <vector>

namespace dsphere::report {

/// A logarithmic axis from data to places on the drawing.
struct LogScale {
    double low = 1.0, high = 10.0;  ///< data
    double from = 0.0, to = 1.0;    ///< drawing

    double at(double value) const;
};

/// Widened to hold all positive values with some room; a decade at least, so that one value has an axis too.
LogScale logScale(const std::vector<double>& values, double from, double to);

/// 1, 10, 100...; over less than three decades 2 and 5 as well.
std::vector<double> logTicks(const LogScale& scale);

/// "0.01", "5", "2,000"; far from 1 as a power of ten: "10<tspan ...>-6</tspan>".
std::string tickLabel(double value);

/// & < > " as XML wants them, in text and attributes.
std::string escapeXml(const std::string& text);

/// A rectangle that something fills on the drawing.
struct Extent {
    double x0, y0, x1, y1;

    bool overlaps(const Extent& other) const {
        return x0 < other.x1 && other.x0 < x1 && y0 < other.y1 && other.y0 < y1;
    }
    bool within(const Extent& other) const {
        return x0 >= other.x0 && x1 <= other.x1 && y0 >= other.y0 && y1 <= other.y1;
    }
};

/// Collects elements.
class Svg {
  public:
    enum class Anchor { Start, Middle, End };

    Svg(double width, double height, const std::string& title);

    void line(dvec2 a, dvec2 b, const std::string& css);
    void polyline(const std::vector<dvec2>& points, const std::string& css);
    void rectangle(const Extent& extent, const std::string& css);
    /// `markup` is text whose special characters are escaped, or markup.
    void text(dvec2 at, Anchor anchor, const std::string& css, const std::string& markup, bool upward = false);
    /// The mark of a style, 0 to kStyles - 1, with a tooltip.
    void mark(dvec2 at, int style, const std::string& tooltip, double size = 5.0);

    std::string finish() const { return text_ + "</svg>\n"; }

    static constexpr int kStyles = 8;

  private:
    std::string text_;
};

/// The CSS of the classes that plots use, light and dark.
std::string plotStyle();

/// Width of a line of small text, on average.
double textWidth(const std::string& text);

}  // namespace dsphere::report
