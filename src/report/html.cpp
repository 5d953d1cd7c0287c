#include "base/atomicfile.h"
#include "report/columns.h"
#include "report/figures.h"
#include "report/report.h"
#include "report/svg.h"

#include <fmt/format.h>

namespace dsphere::report {

namespace {

constexpr const char* kPageStyle =
    "body{margin:0 auto;max-width:1120px;padding:24px;background:var(--paper);color:var(--ink);"
    "font:15px/1.5 system-ui,sans-serif}"
    "h1{font-size:26px;margin:0 0 4px}h2{font-size:19px;margin:36px 0 8px;border-bottom:1px solid var(--grid)}"
    "h3{font-size:15px;margin:20px 0 4px}p{max-width:80ch;margin:8px 0}"
    "figure{margin:16px 0}figcaption{color:var(--faint);font-size:13px;max-width:95ch}"
    "svg{width:100%;height:auto;display:block}.pair{display:flex;flex-wrap:wrap;gap:24px}"
    ".pair figure{flex:1 1 480px}"
    "dl{display:grid;grid-template-columns:max-content 1fr;gap:2px 16px;margin:12px 0}"
    "dt{color:var(--faint)}dd{margin:0}"
    ".scroll{overflow-x:auto}table{border-collapse:collapse;font-size:11.5px;font-variant-numeric:tabular-nums}"
    "th,td{padding:3px 6px;text-align:right;white-space:nowrap;border-bottom:1px solid var(--grid)}"
    "th{font-weight:600;vertical-align:bottom;white-space:normal}"
    "th:first-child,td:first-child{text-align:left}summary{cursor:pointer;margin:8px 0}\n";

std::string tableRow(const Cells& cells, const char* tag) {
    std::string row = "<tr>";
    for (const std::string& cell : cells) row += fmt::format("<{0}>{1}</{0}>", tag, escapeXml(cell));
    return row + "</tr>\n";
}

std::string tableOf(const Cells& names, const std::vector<Cells>& rows) {
    std::string text = "<div class=\"scroll\"><table><thead>\n" + tableRow(names, "th") + "</thead><tbody>\n";
    for (const Cells& row : rows) text += tableRow(row, "td");
    return text + "</tbody></table></div>\n";
}

std::string figure(const std::string& svg, const std::string& caption) {
    if (svg.empty()) return "";
    return fmt::format("<figure>\n{}<figcaption>{}</figcaption>\n</figure>\n", svg, escapeXml(caption));
}

std::string header(const Results& results) {
    std::string text = "<h1>Speed against error</h1>\n<dl>\n";
    for (const auto& [name, value] : facts(results))
        text += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escapeXml(name), escapeXml(value));
    return text + "</dl>\n";
}

std::string speedFigures(const CaseViews& of) {
    return figure(speedFigure(of, RayKind::Primary),
                  of.name +
                      ": primary rays a second against the error of the hits. Better is up and to the left. Bars "
                      "reach from the slowest to the fastest repeat. A line joins the settings of one method; the "
                      "dashed line is the smooth sphere.") +
           figure(speedFigure(of, RayKind::Shadow), of.name + ": the same of shadow rays.");
}

std::string mainFigures(const Results& results, const std::vector<CaseViews>& cases) {
    std::string text = "<h2>Speed against error</h2>\n" + speedFigures(mainCase(cases));
    if (std::vector<Cells> rows = peerRows(results); !rows.empty())
        text += "<h2>The exact marcher against the full mesh</h2>\n<p>" + escapeXml(kPeerText) + "</p>\n" +
                tableOf(peerColumnNames(), rows);
    if (std::string size = sizeFigure(results); !size.empty())
        text += "<h2>Cost against map size</h2>\n" +
                figure(size, "The finest setting of each method under the least displacement.");
    std::string setup = figure(setupFigure(results), "From the map in memory to the first image.");
    std::string memory = figure(memoryFigure(results), "What a method holds: on the device, or Embree's peak.");
    if (!setup.empty() || !memory.empty())
        text += "<h2>Time to the first image, and memory</h2>\n<div class=\"pair\">\n" + setup + memory + "</div>\n";
    return text;
}

std::string viewTables(const std::vector<CaseViews>& cases) {
    std::string text = "<h2>All figures</h2>\n";
    for (const CaseViews& of : cases) {
        text += fmt::format("<details{}><summary>{}</summary>\n", cases.size() == 1 ? " open" : "", escapeXml(of.name));
        if (&of != &mainCase(cases)) text += speedFigures(of);
        for (const ViewResult* view : of.views) {
            text += fmt::format("<h3>{}: {}x{} pixels, {:.1f} % hit</h3>\n", escapeXml(view->view), view->width,
                                view->height, 100.0 * view->hit_share);
            std::vector<Cells> rows;
            for (const MethodResult& method : view->methods) rows.push_back(cellsOf(method));
            text += tableOf(columnNames(), rows);
        }
        text += "</details>\n";
    }
    return text;
}

}  // namespace

std::string html(const Results& results) {
    std::string text =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width\"/>\n<meta name=\"color-scheme\" content=\"light "
        "dark\"/>\n"
        "<title>dsphere bench</title>\n<style>\n";
    text += plotStyle() + kPageStyle + "</style>\n</head>\n<body>\n" + header(results);
    std::vector<CaseViews> cases = casesOf(results);
    if (!cases.empty()) text += mainFigures(results, cases) + viewTables(cases);
    text += "<h2>What is measured</h2>\n";
    for (const std::string& paragraph : explanations()) text += "<p>" + escapeXml(paragraph) + "</p>\n";
    return text + "</body>\n</html>\n";
}

std::string figureFile(const Results& results) {
    std::vector<CaseViews> cases = casesOf(results);
    if (cases.empty()) return "";
    std::string svg = speedFigure(mainCase(cases), RayKind::Primary);
    std::size_t end = svg.find(">\n");
    if (end == std::string::npos) return "";
    return svg.insert(end + 2, "<style>" + plotStyle() + "svg{background:var(--paper)}</style>\n");
}

void writeText(const std::filesystem::path& path, const std::string& text) {
    AtomicFile file(path);
    file.write(text.data(), text.size());
    file.commit();
}

}  // namespace dsphere::report
