#include "app/plot/svg_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "app/plot/svg_axis.h"
#include "app/run/text.h"

namespace ropelight {
namespace {

constexpr double narrowest = 860, legendLeft = 52, legendLetter = 8.2;  // a letter's width is a guess on the safe side
constexpr std::size_t captionColumns = 132;
constexpr double captionLine = 15, captionTop = 490, legendLine = 22;

constexpr const char* colours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#333333"};
constexpr std::size_t markerKinds = 6;

constexpr const char* style =
    "text{font-family:'DejaVu Sans',Verdana,Helvetica,Arial,sans-serif;fill:#333}"
    ".title{font-size:17px;font-weight:bold}.axis{font-size:14px}.tick{font-size:12px;fill:#555}"
    ".legend{font-size:13px}.caption{font-size:10.5px;fill:#777}"
    ".major{stroke:#dcdcdc;stroke-width:1}.minor{stroke:#f0f0f0;stroke-width:1}"
    ".frame{fill:none;stroke:#888;stroke-width:1}.line{fill:none;stroke-width:2;stroke-linejoin:round}"
    ".dashed{stroke-dasharray:6 5}.band{stroke:none;fill-opacity:0.16}.mark{stroke-width:1.8}";

/// Broken at spaces; a word longer than a line has one to itself.
std::vector<std::string> wrapped(const std::string& text) {
  std::vector<std::string> lines(1);
  std::string word;
  auto const endWord = [&] {
    std::string& line = lines.back();
    if (word.empty()) return;
    if (line.empty())
      line = word;
    else if (line.size() + 1 + word.size() <= captionColumns)
      line += " " + word;
    else
      lines.push_back(word);
    word.clear();
  };
  for (char const c : text) {
    if (c != ' ' && c != '\n') {
      word += c;
      continue;
    }
    endWord();
    if (c == '\n') lines.emplace_back();
  }
  endWord();
  return lines;
}

struct Pixel {
  double x, y;
};

std::string path(const std::vector<Pixel>& points) {
  std::string d;
  for (const Pixel& p : points) d += fmt::format("{}{:.2f} {:.2f}", d.empty() ? "M" : " L", p.x, p.y);
  return d;
}

std::string textAt(double x, double y, const char* kind, const char* anchor, const std::string& text) {
  return fmt::format("<text class=\"{}\" x=\"{:.2f}\" y=\"{:.2f}\" text-anchor=\"{}\">{}</text>\n", kind, x, y, anchor,
                     escapeMarkup(text));
}

/// Filled in the curve's colour, or hollow.
std::string marker(Pixel p, std::size_t kind, const char* colour, bool hollow) {
  auto const look = fmt::format("class=\"mark\" stroke=\"{}\" fill=\"{}\"", colour, hollow ? "#ffffff" : colour);
  auto const shape = [&](std::vector<Pixel> points) {
    for (Pixel& q : points) q = {p.x + q.x, p.y + q.y};
    return fmt::format("<path {} d=\"{} Z\"/>\n", look, path(points));
  };
  switch (kind % markerKinds) {
    case 0:
      return fmt::format("<circle {} cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3.5\"/>\n", look, p.x, p.y);
    case 1:
      return shape({{-3.2, -3.2}, {3.2, -3.2}, {3.2, 3.2}, {-3.2, 3.2}});
    case 2:
      return shape({{0, -4.4}, {4, 2.8}, {-4, 2.8}});
    case 3:
      return shape({{0, -4.8}, {4.8, 0}, {0, 4.8}, {-4.8, 0}});
    case 4:
      return shape({{0, 4.4}, {4, -2.8}, {-4, -2.8}});
    default:
      return shape({{-4.2, 0}, {-2.1, -3.7}, {2.1, -3.7}, {4.2, 0}, {2.1, 3.7}, {-2.1, 3.7}});
  }
}

std::vector<double> valuesOf(const LinePlot& plot, bool vertical) {
  std::vector<double> values;
  for (const Curve& curve : plot.curves)
    for (const CurvePoint& p : curve.points) {
      values.push_back(vertical ? p.y : p.x);
      if (vertical) values.insert(values.end(), {p.low, p.high});
    }
  return values;
}

class Drawing {
 public:
  explicit Drawing(const LinePlot& plot)
      : plot_(plot), x_(plot.x, valuesOf(plot, false)), y_(plot.y, valuesOf(plot, true)) {}

  std::string text() {
    auto const caption = wrapped(plot_.caption);
    double const width = fittingWidth();
    double const height = captionTop + captionLine * double(caption.size());
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
        "{1:.0f}\">\n"
        "<style>{2}</style>\n<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#ffffff\"/>\n",
        width, height, style);
    out_ += textAt(area_.left, 30, "title", "start", plot_.title);
    axes();
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) band(plot_.curves[i], curveColour(i));
    for (std::size_t i = 0; i < plot_.curves.size(); ++i) curve(plot_.curves[i], i);
    legend();
    for (std::size_t i = 0; i < caption.size(); ++i)
      out_ += textAt(area_.left, captionTop + captionLine * double(i), "caption", "start", caption[i]);
    return out_ + "</svg>\n";
  }

 private:
  /// Wide enough for the names in the legend.
  double fittingWidth() const {
    std::size_t letters = 0;
    for (const Curve& curve : plot_.curves) letters = std::max(letters, letterCount(curve.name));
    return std::max(narrowest, std::ceil(area_.right + legendLeft + legendLetter * double(letters)));
  }

  double pixelX(double x) const { return area_.left + x_.position(x) * (area_.right - area_.left); }
  double pixelY(double y) const { return area_.bottom - y_.position(y) * (area_.bottom - area_.top); }

  std::optional<Pixel> place(double x, double y) const {
    if (!x_.hasPlace(x) || !y_.hasPlace(y)) return std::nullopt;
    return Pixel{pixelX(x), pixelY(y)};
  }

  void gridLine(const char* kind, Pixel from, Pixel to) {
    out_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", kind, path({from, to}));
  }

  void axes() {
    for (bool const major : {false, true}) {
      for (const PlotTick& t : x_.ticks())
        if (t.label.empty() != major)
          gridLine(major ? "major" : "minor", {pixelX(t.value), area_.top}, {pixelX(t.value), area_.bottom});
      for (const PlotTick& t : y_.ticks())
        if (t.label.empty() != major)
          gridLine(major ? "major" : "minor", {area_.left, pixelY(t.value)}, {area_.right, pixelY(t.value)});
    }
    out_ += fmt::format("<rect class=\"frame\" x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>\n",
                        area_.left, area_.top, area_.right - area_.left, area_.bottom - area_.top);
    for (const PlotTick& t : x_.ticks()) out_ += textAt(pixelX(t.value), area_.bottom + 18, "tick", "middle", t.label);
    for (const PlotTick& t : y_.ticks()) out_ += textAt(area_.left - 8, pixelY(t.value) + 4, "tick", "end", t.label);
    out_ += textAt((area_.left + area_.right) / 2, area_.bottom + 42, "axis", "middle", plot_.x.label);
    out_ += fmt::format(
        "<text class=\"axis\" transform=\"translate(24 {:.2f}) rotate(-90)\" "
        "text-anchor=\"middle\">{}</text>\n",
        (area_.top + area_.bottom) / 2, escapeMarkup(plot_.y.label));
  }

  void band(const Curve& curve, const char* colour) {
    std::vector<Pixel> upper, lower;
    for (const CurvePoint& p : curve.points) {
      auto const high = place(p.x, p.high), low = place(p.x, p.low);
      if (high && low) upper.push_back(*high), lower.push_back(*low);
    }
    if (upper.size() < 2 || !curve.connected) return;
    upper.insert(upper.end(), lower.rbegin(), lower.rend());
    out_ += fmt::format("<path class=\"band\" fill=\"{}\" d=\"{} Z\"/>\n", colour, path(upper));
  }

  /// Stretches of solid and dashed line, then the markers over them.
  void curve(const Curve& curve, std::size_t index) {
    const char* const colour = curveColour(index);
    std::vector<Pixel> stretch;
    std::string marks;
    bool dashed = false, before = false;
    auto const flush = [&] {
      if (stretch.size() > 1)
        out_ += fmt::format("<path class=\"line{}\" stroke=\"{}\" d=\"{}\"/>\n", dashed ? " dashed" : "", colour,
                            path(stretch));
      stretch.assign(stretch.empty() ? 0 : 1, stretch.empty() ? Pixel{} : stretch.back());
    };
    for (const CurvePoint& p : curve.points) {
      auto const pixel = place(p.x, p.y);
      if (!pixel) continue;
      bool const estimated = before || p.estimated;
      if (curve.connected && !stretch.empty() && estimated != dashed) flush();
      dashed = stretch.empty() ? dashed : estimated;
      if (curve.connected) stretch.push_back(*pixel);
      before = p.estimated;
      if (!curve.connected) marks += whisker(p, colour);
      marks += marker(*pixel, index, colour, p.estimated);
    }
    flush();
    out_ += marks;
  }

  std::string whisker(const CurvePoint& p, const char* colour) const {
    auto const high = place(p.x, p.high), low = place(p.x, p.low);
    if (!high || !low) return "";
    return fmt::format("<path class=\"line\" stroke=\"{}\" d=\"{}\"/>\n", colour, path({*low, *high}));
  }

  void legend() {
    double y = area_.top + 10;
    for (std::size_t i = 0; i < plot_.curves.size(); ++i, y += legendLine) {
      const char* const colour = curveColour(i);
      double const x = area_.right + 16;
      if (plot_.curves[i].connected)
        out_ += fmt::format("<path class=\"line\" stroke=\"{}\" d=\"{}\"/>\n", colour, path({{x, y}, {x + 28, y}}));
      out_ += marker({x + 14, y}, i, colour, false);
      out_ += textAt(area_.right + legendLeft, y + 4.5, "legend", "start", plot_.curves[i].name);
    }
  }

  const LinePlot& plot_;
  AxisScale x_, y_;
  PlotArea area_;
  std::string out_;
};

}  // namespace

const char* curveColour(std::size_t index) { return colours[index % std::size(colours)]; }

std::string toSvg(const LinePlot& plot) { return Drawing(plot).text(); }

}  // namespace ropelight
