// CSV, JSON, HTML, Markdown and the table: well-formed, complete, and they survive odd names.

#include "report/report.h"
#include "base/error.h"
#include "report/csv.h"
#include "report/json.h"
#include "report/table.h"
#include "tests/report/examples.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace dsphere::report {
namespace {

using test::exampleResults;

/// What is wrong with the tags of an XML text ("" if nothing): each one closed, in order, no stray < or &.
std::string tagFault(const std::string& text) {
    std::vector<std::string> open;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '&') {
            std::size_t end = text.find(';', k);
            if (end == std::string::npos || end - k > 6) return "a stray & at " + text.substr(k, 20);
        }
        if (text[k] == '>') return "a stray > at " + text.substr(k, 20);
        if (text[k] != '<') continue;
        std::size_t end = text.find('>', k);
        if (end == std::string::npos) return "an open tag at " + text.substr(k, 20);
        std::string tag = text.substr(k + 1, end - k - 1);
        k = end;
        if (tag.find('<') != std::string::npos) return "a stray < in " + tag;
        if (tag[0] == '!' || tag.back() == '/') continue;
        std::string name = tag.substr(tag[0] == '/', tag.find(' ') - (tag[0] == '/'));
        if (tag[0] != '/')
            open.push_back(name);
        else if (open.empty() || open.back() != name)
            return "</" + name + "> closes " + (open.empty() ? "nothing" : open.back());
        else
            open.pop_back();
    }
    return open.empty() ? "" : "<" + open.back() + "> is never closed";
}

std::size_t countOf(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t k = text.find(part); k != std::string::npos; k = text.find(part, k + 1)) ++count;
    return count;
}

TEST(TagFault, SeesFaults) {
    EXPECT_EQ(tagFault("<a><b x=\"1\"/>t &amp; t</a>"), "");
    for (const char* text : {"<a>", "<a></b>", "<a>&</a>", "<a> > </a>", "</a>"}) EXPECT_NE(tagFault(text), "") << text;
}

TEST(Json, ReadsWhatItWrote) {
    nlohmann::ordered_json json = toJson(exampleResults());
    EXPECT_EQ(toJson(fromJson(json, "x")), json);
    Results back = fromJson(nlohmann::ordered_json::parse(json.dump()), "x");
    ASSERT_EQ(back.views.size(), 2u);
    EXPECT_EQ(back.views[1].view, "limb");
    EXPECT_EQ(back.views[0].methods[0].primary.device.median, 1e7);
    EXPECT_EQ(back.views[0].methods[0].accuracy->distance_999, 4e-8);
    EXPECT_FALSE(back.views[0].methods[3].accuracy);
    EXPECT_EQ(back.environment.cpu, "A \"CPU\" & more");
}

/// In words of our own: the library's begin with "[json.exception".
void expectRefused(const nlohmann::ordered_json& json) {
    const std::string message = test::messageOf(ExitCode::InvalidInput, [&] { fromJson(json, "old.json"); });
    EXPECT_EQ(message.rfind("old.json: ", 0), 0u) << message;
    EXPECT_EQ(message.find("json.exception"), std::string::npos) << message;
}

TEST(Json, RefusesWhatIsSomethingElse) {
    for (const char* text :
         {"[]", "3", "{}", "{\"dsphere_bench\": 1}", "{\"dsphere_bench\": 99}", "{\"dsphere_bench\": \"x\"}"})
        expectRefused(nlohmann::ordered_json::parse(text));
    nlohmann::ordered_json json = toJson(exampleResults());
    json["views"][0]["methods"][0]["family"] = 7;
    expectRefused(json);
    json = toJson(exampleResults());
    json["views"] = 7;
    expectRefused(json);
}

TEST(Json, FilesThatCannotBeRead) {
    test::TempFolder folder;
    test::expectError(ExitCode::InvalidInput, "none.json", [&] { readResults(folder.path() / "none.json"); });
    folder.write("text.json", "not { json");
    test::expectError(ExitCode::InvalidInput, "not JSON", [&] { readResults(folder.path() / "text.json"); });
    folder.write("good.json", toJson(exampleResults()).dump());
    EXPECT_EQ(readResults(folder.path() / "good.json").views.size(), 2u);
}

TEST(Csv, EveryLineHasAllColumns) {
    std::string text = csv(exampleResults());
    EXPECT_EQ(countOf(text, "\r\n"), 1u + 2u * 5u);
    std::vector<std::size_t> separators = {0};
    bool quoted = false;
    for (char c : text) {
        if (c == '"') quoted = !quoted;
        if (c == ',' && !quoted) ++separators.back();
        if (c == '\n' && !quoted) separators.push_back(0);
    }
    separators.pop_back();
    for (std::size_t count : separators) EXPECT_EQ(count, separators[0]);
    EXPECT_NE(text.find("\"map, \"\"one\"\" <1>\",1024,512,5,"), std::string::npos) << text;
}

TEST(Html, IsWellFormedAndAlone) {
    std::string page = html(exampleResults());
    std::string body = page.substr(page.find("</style>") + 8);
    EXPECT_EQ(tagFault("<html><head>" + body), "");
    EXPECT_EQ(page.rfind("<!DOCTYPE html>", 0), 0u);
    for (const char* part : {"<script", "href=", "src=", "@import", "url("})
        EXPECT_EQ(countOf(page, part), 0u) << part << ": the page must need nothing beside it";
    EXPECT_EQ(countOf(page, "http"), countOf(page, "xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_EQ(countOf(page, "nan"), 0u);
    EXPECT_EQ(countOf(page, "\"inf"), 0u);
}

TEST(Html, SaysWhatWasMeasuredWhere) {
    std::string page = html(exampleResults());
    for (const char* part : {"A &quot;CPU&quot; &amp; more, 2 cores, load 1.5", "commit abc&lt;def", "device (driver)",
                             "2026-01-02T03:04:05Z", "without Embree", "needs some 7.5 GB", "prefers-color-scheme:dark",
                             "smooth sphere 50.0", "units of the radius R"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
    EXPECT_EQ(countOf(page, "<svg"), 4u) << "primary, shadow, set-up, memory; one map width has no plot of its size";
}

TEST(Html, TwoMapWidthsShowTheCostOfSize) {
    Results results = exampleResults();
    for (ViewResult view : exampleResults().views) {
        view.map = "larger";
        view.map_width = 4096;
        results.views.push_back(view);
    }
    std::string page = html(results);
    EXPECT_EQ(countOf(page, "Cost against map size"), 1u);
    EXPECT_EQ(countOf(page, "<svg"), 2u + 1u + 2u + 2u);
}

TEST(Html, NothingMeasuredIsStillAPage) {
    std::string page = html({});
    EXPECT_EQ(tagFault("<html><head>" + page.substr(page.find("</style>") + 8)), "");
    EXPECT_EQ(countOf(page, "<svg"), 0u);
    EXPECT_EQ(figureFile({}), "");
}

TEST(Figure, StandsAlone) {
    std::string svg = figureFile(exampleResults());
    EXPECT_EQ(svg.rfind("<svg ", 0), 0u);
    std::size_t style = svg.find("<style>"), end = svg.find("</style>");
    ASSERT_NE(end, std::string::npos);
    EXPECT_EQ(tagFault(svg.substr(0, style) + svg.substr(end + 8)), "");
}

TEST(Markdown, RowsHaveTheirHeadersColumns) {
    std::string text = markdown(exampleResults(), "figure.svg");
    EXPECT_NE(text.find("](figure.svg)"), std::string::npos);
    std::size_t bars = 0, begin = 0;
    for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
        std::string line = text.substr(begin, end - begin);
        if (line.empty() || line[0] != '|') {
            bars = 0;
            continue;
        }
        std::size_t count = std::size_t(std::ranges::count(line, '|')) - countOf(line, "\\|");
        if (bars == 0) bars = count;
        EXPECT_EQ(count, bars) << line;
    }
}

TEST(Table, NamesEveryMethodAndWhyOneDidNotRun) {
    std::string text = table(exampleResults());
    for (const char* part : {"exact", "grid 1/2", "smooth", "not run: needs some 7.5 GB", "limb: 64x48 pixels"})
        EXPECT_NE(text.find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace dsphere::report
