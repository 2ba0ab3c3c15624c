// The report of a study: HTML that holds the figures and needs no network, CSV, plots.

#include <doctest/doctest.h>

#include <cmath>

#include "app/converge/analysis/report.h"
#include "tests/support/fake_report.h"

namespace ropelight {
namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

/// RFC 4180.
std::vector<std::vector<std::string>> readCsv(const std::string& text) {
  std::vector<std::vector<std::string>> lines(1, {""});
  bool inside = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = lines.back().back();
    if (text[i] == '"' && inside && i + 1 < text.size() && text[i + 1] == '"')
      cell += text[i++];
    else if (text[i] == '"')
      inside = !inside;
    else if (text[i] == ',' && !inside)
      lines.back().emplace_back();
    else if (text[i] == '\n' && !inside)
      lines.push_back({""});
    else
      cell += text[i];
  }
  lines.pop_back();
  return lines;
}

/// Every reference of the page stays within it.
bool standsAlone(const std::string& html) {
  for (const char* link : {"http", "href=", "url(", "<script", "@import", "src=\"/", "srcset"})
    if (has(html, link)) return false;
  return count(html, "src=\"") == count(html, "src=\"data:");
}

/// Tags close in the order that they open in.
bool nests(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    std::size_t const end = html.find_first_of(" >", at);
    std::string const tag = html.substr(at + 1, end - at - 1);
    if (tag == "!DOCTYPE" || tag == "meta" || tag == "img" || tag == "br" || tag == "wbr") continue;
    if (tag[0] != '/')
      open.push_back(tag);
    else if (open.empty() || open.back() != tag.substr(1))
      return false;
    else
      open.pop_back();
  }
  return open.empty();
}

/// Base64 may spell any word.
std::string withoutPictures(std::string html) {
  static const std::string start = ";base64,";
  for (std::size_t at = 0; (at = html.find(start, at)) != std::string::npos; at += start.size())
    html.erase(at + start.size(), html.find('"', at) - at - start.size());
  return html;
}

Study smallStudy(int seeds = 3) { return fakeStudy({fakeScene("cornell", 24, seeds)}, seeds); }

}  // namespace

TEST_CASE("the page holds the figures of a study and needs no network") {
  std::string const html = toHtml(smallStudy());
  CHECK(standsAlone(html));
  CHECK(nests(html));
  for (const char* part : {"NVIDIA H100 80GB HBM3, 2 CPU threads",
                           "0.1.0+1a2b3c4",
                           "--time 16",
                           "assets/cornell.json",
                           "After 16 s of run time sppm has the lowest relMSE",
                           "4.2·10⁻⁵",
                           "4.87·10⁻⁴",
                           "not trimmed",
                           "<dt>Every run</dt><dd>16 s</dd>",
                           "95% interval of its mean",
                           "not reached",
                           "1,024 iterations",
                           "below what 3 seeds can show",
                           "29.4%",
                           "Near edges",
                           "<td>35%</td><td>2.15</td>",
                           "87.1 ms",
                           "31.2 ms",
                           "mean FLIP 0.11",
                           "<code>alpha=0.5</code>",
                           "diffuse, specular",
                           "path, 80 s on this device"}) {
    CAPTURE(std::string(part));
    CHECK(has(html, part));
  }
  CHECK(count(html, "<img") == 2 + 1 + 2 * 3);  // plots, the reference, pictures with their error maps
  CHECK(count(html, "data:image/png;base64,iVBORw0KGgo") == 7);
  CHECK(count(html, "data:image/svg+xml;base64,PHN2Zy") == 2);
  CHECK_FALSE(has(withoutPictures(html), "nan"));
  CHECK_FALSE(has(html, "All scenes"));
}

TEST_CASE("what is best stands in bold, where bands allow it") {
  std::string const html = toHtml(smallStudy());
  CHECK(has(html, "</small></b></td>"));
  Study twins = smallStudy();
  twins.scenes[0].modes[0].runs = twins.scenes[0].modes[2].runs = twins.scenes[0].modes[1].runs;
  CHECK(has(toHtml(twins), "No mode is called best"));
  CHECK_FALSE(has(toHtml(twins), "</small></b>"));
}

TEST_CASE("several scenes have a table of all") {
  StudyScene other = fakeScene("glass", 24, 3);
  other.modes.pop_back();
  std::string const html = toHtml(fakeStudy({fakeScene("cornell", 24, 3), other}, 3));
  CHECK(has(html, "All scenes"));
  CHECK(count(html, "class=\"group\"") == 3);
  CHECK(has(html, "glass<small class=\"quiet\"> at 16 s</small>"));
  CHECK(nests(html));
}

TEST_CASE("text from outside is escaped wherever it stands") {
  std::string const name = "<a&b>\"c\"", escaped = "&lt;a&amp;b&gt;&quot;c&quot;";
  Study study = smallStudy();
  study.command = study.version = study.device = name;
  StudyScene& scene = study.scenes[0];
  scene.name = scene.file = scene.device = scene.reference.origin = name;
  for (StudyMode& mode : scene.modes) mode.label = mode.accel = mode.kernels = mode.referenceWarning = name;
  study.scenes.push_back(study.scenes[0]);
  std::string const html = toHtml(study);
  CHECK_FALSE(has(html, name));
  CHECK_FALSE(has(html, "<a&"));
  CHECK(count(html, escaped) > 40);
  CHECK(nests(html));
  CHECK_FALSE(has(toSvg(errorPlot(study, study.scenes[0], CurveAxis::seconds)), name));
}

TEST_CASE("a study of one sample can be shown") {
  Study study = smallStudy(1);
  for (StudyMode& mode : study.scenes[0].modes) {
    mode.runs[0].samples.resize(1);
    mode.split = {.mse = 0.1};
    mode.pictureFlip = unknown;
  }
  study.scenes[0].reference.noise = unknown;
  std::string const html = toHtml(study);
  CHECK(has(html, "Reference, of unknown noise of its own"));
  CHECK(has(html, "One seed says nothing of chance"));
  CHECK(has(html, "mean FLIP –"));
  CHECK_FALSE(has(withoutPictures(html), "nan"));
  CHECK(nests(html));
}

TEST_CASE("an incomplete study shows what there is") {
  Study study = smallStudy();
  study.complete = false;
  study.trimmed = true;
  StudyScene& scene = study.scenes[0];
  scene.modes[0].runs.clear();
  scene.modes[0].picture = {};
  scene.modes[1].runs[2].samples.clear();
  scene.modes[2].picture = Image(5, 5);  // not the reference's size
  std::string const html = toHtml(study);
  CHECK(has(html, "Stopped before the end"));
  CHECK(has(html, "path has no samples."));
  CHECK(has(html, "trimmed relMSE"));
  CHECK(has(html, "0.1% of pixels (trimmed)"));
  CHECK(count(html, "data:image/png") == 1 + 2 + 1);
  CHECK(nests(html));
  scene.reference = {};
  scene.modes.clear();
  CHECK(has(toHtml(study), "Nothing was measured."));
  study.scenes.push_back({});
  CHECK(nests(toHtml(study)));
  CHECK(has(toHtml(Study{}), "Nothing was measured."));
}

TEST_CASE("times that some seeds reached say how many") {
  Study study = smallStudy();
  for (ErrorSample& s : study.scenes[0].modes[1].runs[0].samples) s.metrics.relMse = 0.02;
  CHECK(has(toHtml(study), "reached by 2 of 3 seeds"));
}

TEST_CASE("CSV has a line a sample and its fields in place") {
  Study study = smallStudy();
  study.scenes[0].name = "a \"b\", c";
  Metrics& metrics = study.scenes[0].modes[0].runs[0].samples[0].metrics;
  metrics.relMse = unknown;
  metrics.psnr = 12.5;
  metrics.meanError = -0.25;
  metrics.maxError = 7;
  metrics.nonFinite = 3;
  std::string const csv = toCsv(study);
  auto const lines = readCsv(csv);
  REQUIRE(lines.size() == 1 + 3 * 3 * 11);
  for (auto const& line : lines) CHECK(line.size() == 15);
  CHECK(csv.substr(0, csv.find('\n')) ==
        "scene,mode,seed,seconds,iterations,relmse,relmse_trimmed,mse,rmse,psnr,mean_error,max_error,non_finite,device,"
        "threads");
  CHECK(has(csv, "\n\"a \"\"b\"\", c\",path,1,0.015625,1,,"));
  CHECK(lines[1][0] == "a \"b\", c");
  CHECK(lines[1][9] == "12.5");
  CHECK(lines[1][10] == "-0.25");
  CHECK(lines[1][11] == "7");
  CHECK(lines[1][12] == "3");
  CHECK(lines[1][13] == "NVIDIA H100 80GB HBM3");
  CHECK(lines[1][14] == "2");
  CHECK(lines.back()[1] == "sppm:alpha=0.5");
  CHECK(lines.back()[2] == "3");
  CHECK(lines.back()[4] == "1024");
  CHECK(readCsv(toCsv(Study{})).size() == 1);
}

TEST_CASE("plots have a curve a mode, its slope in the name, and bands over several seeds") {
  Study study = smallStudy();
  study.scenes[0].modes.push_back({});
  study.scenes[0].modes.back().label = "ray";
  study.scenes[0].modes[0].runs = {powerRun(1, 1, -1), powerRun(2, 2, -1)};
  study.scenes[0].modes[0].runs[0].samples[3].metrics.relMse = 0;  // has no place on a logarithmic axis
  LinePlot const plot = errorPlot(study, study.scenes[0], CurveAxis::iterations);
  REQUIRE(plot.curves.size() == 4);
  CHECK(plot.x.logarithmic);
  CHECK(plot.y.logarithmic);
  CHECK(plot.curves[0].name == "path, slope −1.00");
  CHECK(plot.curves[0].points.size() == 10);
  CHECK(plot.curves[0].points.back().x == 1024);
  CHECK(plot.curves[0].points.back().high == doctest::Approx(2.0 / 16));
  CHECK(plot.curves[3].name == "ray, no error known");
  CHECK(errorPlot(study, study.scenes[0], CurveAxis::seconds).curves[0].points.back().x == 16);
  Study const single = smallStudy(1);
  CHECK(std::isnan(errorPlot(single, single.scenes[0], CurveAxis::seconds).curves[0].points[0].low));
}

TEST_CASE("a long name in the legend widens the plot") {
  Study study = smallStudy();
  CHECK(has(toSvg(errorPlot(study, study.scenes[0], CurveAxis::seconds)), "width=\"914\""));
  study.scenes[0].modes.resize(2);
  CHECK(has(toSvg(errorPlot(study, study.scenes[0], CurveAxis::seconds)), "width=\"860\""));
}

}  // namespace ropelight
