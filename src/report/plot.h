#pragma once

#include "report/svg.h"

namespace dsphere::report {

struct PlotPoint {
    double x = 0.0, y = 0.0;
    double y_low = 0.0, y_high = 0.0;  ///< of the repeats; a bar if they differ
    std::string label;                 ///< beside the mark where there is room; may be empty
    std::string tooltip;
};

/// One method or family: points of one mark, joined in their order if more than one.
struct PlotSeries {
    std::string name;
    int style = 0;
    std::vector<PlotPoint> points;
};

struct Panel {
    std::string title;
    std::vector<PlotSeries> series;
    double floor = 0.0;  ///< a dashed line at this y, 0: none
    std::string floor_label;
};

/// Panels side by side that share logarithmic axes, and a legend above them.
struct PanelRow {
    std::string title;  ///< for screen readers
    std::string x_label, y_label;
    std::vector<Panel> panels;
    std::vector<double> x_ticks;  ///< empty: decades
};

std::string drawPanels(const PanelRow& row);

/// Names down the left, a logarithmic axis below, one mark a name and column.
struct DotPlot {
    std::string title, x_label;
    struct Row {
        std::string name;
        std::vector<double> values;  ///< one a column; 0: none
    };
    std::vector<std::string> columns;
    std::vector<Row> rows;
};

std::string drawDots(const DotPlot& plot);

}  // namespace dsphere::report
