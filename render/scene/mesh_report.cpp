#include "render/scene/mesh_report.h"

#include <fmt/format.h>

namespace ropelight {

std::string describe(const std::string& file, const MeshReport& report) {
  std::string text;
  auto add = [&](std::uint64_t count, const char* one, const char* many) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? file + ": " : ", ", count, count == 1 ? one : many);
  };
  auto addPolygons = [&](std::uint64_t count, const std::string& one, const std::string& many) {
    std::string const of = fmt::format("of {} {} ", report.polygons, report.polygons == 1 ? "polygon" : "polygons");
    add(count, (of + one).c_str(), (of + many).c_str());
  };
  std::string const by = fmt::format(" not planar (by up to {:.2g}% of the size)", 100 * report.departure);
  addPolygons(report.notPlanar, "is" + by, "are" + by);
  addPolygons(report.crossing, "crosses itself", "cross themselves");
  add(report.degenerate, "face without an area was dropped", "faces without an area were dropped");
  add(report.merged, "triangle is too small or thin for single precision",
      "triangles are too small or thin for single precision");
  add(report.leftOut, "point, line, curve or surface was left out", "points, lines, curves or surfaces were left out");
  add(report.unused, "vertex belongs to no face", "vertices belong to no face");
  return text;
}

}  // namespace ropelight
