#include "report/columns.h"
#include "report/figures.h"
#include "report/report.h"

#include <fmt/format.h>

namespace dsphere::report {

namespace {

std::string escapePipes(const std::string& text) {
    std::string result;
    for (char c : text) result += c == '|' ? std::string("\\|") : std::string(1, c);
    return result;
}

std::string row(const Cells& cells) {
    std::string text = "|";
    for (const std::string& cell : cells) text += " " + escapePipes(cell) + " |";
    return text + "\n";
}

std::string markdownTable(const Cells& names, const std::vector<Cells>& rows) {
    std::string rule = "| --- |";
    for (std::size_t k = 1; k < names.size(); ++k) rule += " ---: |";
    std::string text = row(names) + rule + "\n";
    for (const Cells& cells : rows) text += row(cells);
    return text + "\n";
}

}  // namespace

std::string markdown(const Results& results, const std::string& figure) {
    std::string text = "# Speed against error\n\nMade by `dsphere bench --markdown`; do not edit.\n\n";
    for (const auto& [name, value] : facts(results)) text += fmt::format("- {}: {}\n", name, value);
    text += "\n";
    std::vector<CaseViews> cases = casesOf(results);
    if (!figure.empty() && !cases.empty())
        text += fmt::format(
            "![Primary rays a second against error]({})\n\n*{}: primary rays a second against the error "
            "of the hits. Better is up and to the left.*\n\n",
            figure, mainCase(cases).name);
    if (std::vector<Cells> rows = peerRows(results); !rows.empty())
        text += std::string("## The exact marcher against the full mesh\n\n") + kPeerText + "\n\n" +
                markdownTable(peerColumnNames(), rows);
    for (const CaseViews& of : cases) {
        text += fmt::format("## {}\n\n", of.name);
        for (const ViewResult* view : of.views) {
            text += fmt::format("{}: {}x{} pixels, {:.1f} % hit.\n\n", view->view, view->width, view->height,
                                100.0 * view->hit_share);
            std::vector<Cells> rows;
            for (const MethodResult& method : view->methods) rows.push_back(cellsOf(method));
            text += markdownTable(columnNames(), rows);
        }
    }
    text += "## What is measured\n\n";
    for (const std::string& paragraph : explanations()) text += escapePipes(paragraph) + "\n\n";
    text.pop_back();
    return text;
}

}  // namespace dsphere::report
