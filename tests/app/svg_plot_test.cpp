// Plots as SVG text, against pixel positions worked out by hand.

#include <doctest/doctest.h>

#include <cmath>

#include "app/plot/svg_axis.h"
#include "app/plot/svg_plot.h"
#include "tests/support/outside_tool.h"
#include "tests/support/temporary_folder.h"

namespace ropelight {
namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

LinePlot plotOf(std::vector<CurvePoint> points, bool logarithmic) {
  LinePlot plot;
  plot.title = "title";
  plot.caption = "caption";
  plot.x = {"x label", logarithmic, {}};
  plot.y = {"y label", logarithmic, {}};
  plot.curves = {{"curve", std::move(points), true}};
  return plot;
}

std::vector<std::string> labels(const AxisScale& scale) {
  std::vector<std::string> found;
  for (const PlotTick& t : scale.ticks())
    if (!t.label.empty()) found.push_back(t.label);
  return found;
}

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

// The area is 84…640 by 52…424: 556 × 372 pixels, y down.

TEST_CASE("points on linear axes lie where they belong") {
  std::string const svg = toSvg(plotOf({{0, 0}, {5, 25}, {10, 100}}, false));
  CHECK(has(svg, "M84.00 424.00 L362.00 331.00 L640.00 52.00"));
  CHECK(has(svg, "cx=\"362.00\" cy=\"331.00\""));
  CHECK(has(svg, ">title</text>"));
  CHECK(has(svg, ">x label</text>"));
  CHECK(has(svg, ">y label</text>"));
  CHECK(has(svg, ">caption</text>"));
  CHECK(has(svg, ">curve</text>"));
}

TEST_CASE("points on logarithmic axes lie where they belong") {
  // Two decades with 5% of them at either end: 1 is 0.1 of 2.2 decades from the low end.
  std::string const svg = toSvg(plotOf({{1, 1}, {10, 10}, {100, 100}}, true));
  CHECK(has(svg, "M109.27 407.09 L362.00 238.00 L614.73 68.91"));
}

TEST_CASE("points without a place are left out and the line goes on") {
  std::string const svg =
      toSvg(plotOf({{1, 1}, {0, 10}, {10, -1}, {notANumber, 10}, {10, infinite}, {100, 100, 0, notANumber}}, true));
  CHECK(has(svg, "M109.27 407.09 L614.73 68.91"));
  CHECK(count(svg, "<circle") == 3);  // two points and the legend
  CHECK(!has(svg, "nan"));
  CHECK(!has(svg, "inf"));
  CHECK(!has(svg, "class=\"band\""));
  std::string const nothing = toSvg(plotOf({{0, 0}}, true));
  CHECK(count(nothing, "<circle") == 1);
  CHECK(!has(nothing, "nan"));
  CHECK(has(toSvg(LinePlot{}), "</svg>"));
}

TEST_CASE("zero and negative values have a place on linear axes") {
  std::string const svg = toSvg(plotOf({{-5, -5}, {5, 5}}, false));
  CHECK(has(svg, "M130.33 393.00 L593.67 83.00"));  // the axes run from −6 to 6: −5 is 1/12 from the end
}

TEST_CASE("a band runs along the upper ends and back along the lower ones") {
  std::string const svg = toSvg(plotOf({{0, 50, 25, 75}, {10, 50, 0, 100}}, false));
  CHECK(has(svg, "class=\"band\" fill=\"#0072b2\" d=\"M84.00 145.00 L640.00 52.00 L640.00 424.00 L84.00 331.00 Z\""));
}

TEST_CASE("estimated points are hollow and their lines dashed") {
  std::string const svg = toSvg(plotOf({{0, 0}, {5, 0}, {10, 100, notANumber, notANumber, true}}, false));
  CHECK(has(svg, "class=\"line\" stroke=\"#0072b2\" d=\"M84.00 424.00 L362.00 424.00\""));
  CHECK(has(svg, "class=\"line dashed\" stroke=\"#0072b2\" d=\"M362.00 424.00 L640.00 52.00\""));
  CHECK(count(svg, "fill=\"#ffffff\" cx") == 1);
  std::string const middle = toSvg(plotOf({{0, 0}, {5, 0, 0, 0, true}, {10, 100}}, false));
  CHECK(has(middle, "class=\"line dashed\" stroke=\"#0072b2\" d=\"M84.00 424.00 L362.00 424.00 L640.00 52.00\""));
}

TEST_CASE("named places stand side by side, markers alone") {
  LinePlot plot = plotOf({{0, 0}, {1, 10}}, false);
  plot.x.names = {"one", "two"};
  plot.curves[0].connected = false;
  std::string const svg = toSvg(plot);
  CHECK(has(svg, "x=\"223.00\" y=\"442.00\" text-anchor=\"middle\">one</text>"));  // a quarter of the width
  CHECK(has(svg, "cx=\"501.00\" cy=\"52.00\""));
  CHECK(!has(svg, "class=\"line\""));
}

TEST_CASE("text is escaped and a long caption wrapped") {
  LinePlot plot = plotOf({{0, 0}, {1, 1}}, false);
  plot.title = "a<b & \"c\">\x01";
  plot.caption = std::string(100, 'x') + " " + std::string(100, 'y') + "\nz";
  std::string const svg = toSvg(plot);
  CHECK(has(svg, ">a&lt;b &amp; &quot;c&quot;&gt;</text>"));
  CHECK(count(svg, "class=\"caption\"") == 3);
}

TEST_CASE("the same plot is the same text, and an XML parser reads it") {
  LinePlot plot = plotOf({{1, 2, 1, 3}, {10, 20, 10, 30, true}}, true);
  for (int i = 0; i < 8; ++i) plot.curves.push_back({"µ & λ", {{double(i + 1), double(i + 1)}}, true});
  CHECK(toSvg(plot) == toSvg(plot));
  if (!toolOnPath("python3")) {
    MESSAGE("skipped: there is no python3 to parse it");
    return;
  }
  TemporaryFolder const folder;
  putBytes(folder / "plot.svg", toSvg(plot));
  std::string const said = toolOutput(
      "python3 -c \"import sys, xml.dom.minidom as m; print(m.parse(sys.argv[1])"
      ".documentElement.tagName)\" " +
      (folder / "plot.svg").string());
  CHECK(said == "svg\n");
}

TEST_CASE("ticks are round numbers") {
  using Texts = std::vector<std::string>;
  CHECK(labels(AxisScale({"", false, {}}, {0, 9.3})) == Texts{"0", "2", "4", "6", "8", "10"});
  CHECK(labels(AxisScale({"", false, {}}, {60, 100})) == Texts{"60", "70", "80", "90", "100"});
  CHECK(labels(AxisScale({"", false, {}}, {7, 7})).size() >= 2);
  CHECK(labels(AxisScale({"", true, {}}, {1e-3, 1e5})) ==
        Texts{"10⁻³", "0.01", "0.1", "1", "10", "100", "1000", "10⁴", "10⁵"});
  CHECK(labels(AxisScale({"", true, {}}, {2e5, 4e5})) == Texts{"2·10⁵"});
  CHECK(tickLabel(0) == "0");
  CHECK(tickLabel(-2e6) == "-2·10⁶");
}

}  // namespace ropelight
