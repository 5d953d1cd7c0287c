#pragma once

#include "viewer/ui.h"

#include <functional>
#include <string>
#include <variant>
#include <vector>

namespace dsphere::viewer {

/// A number with a range that a slider moves through; others can be typed.
struct NumberRow {
    double low, high;
    const char* format;  ///< printf's, with the unit
    std::function<double(const Subject&)> get;
    std::function<void(Subject&, double)> set;
    bool logarithmic = false;
    const char* directions = nullptr;  ///< degrees.h's, of degrees that are shown and typed with them
};

/// One of a few names.
struct ChoiceRow {
    std::function<std::vector<std::string>(const Subject&)> names;
    std::function<int(const Subject&)> get;
    std::function<void(Subject&, int)> set;
};

struct SwitchRow {
    std::function<bool(const Subject&)> get;
    std::function<void(Subject&, bool)> set;
};

struct ColourRow {
    std::function<dvec3(const Subject&)> get;
    std::function<void(Subject&, const dvec3&)> set;
};

/// A row of the panel. Double clicks on its label, or on a slider, bring back what it was when the file was opened.
struct Row {
    const char* section;
    const char* label;
    const char* tip;
    std::variant<NumberRow, ChoiceRow, SwitchRow, ColourRow> control;
    std::function<bool(const Subject&)> applies = [](const Subject&) { return true; };
};

/// All rows, section by section, in the panel's order.
const std::vector<Row>& panelRows();

}  // namespace dsphere::viewer
