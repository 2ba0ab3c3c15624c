#include "render/polygon/grid_plane.h"

namespace ropelight {
namespace {

struct Edge {
  GridPoint a, b;
};

bool crosses(const Edge& e, const Edge& f, double tolerance) {
  auto apart = [tolerance](const Edge& line, const Edge& other) {
    double const one = turn(line.a, line.b, other.a), two = turn(line.a, line.b, other.b);
    double const least = tolerance * distance(line.a, line.b);
    return (one > least && two < -least) || (one < -least && two > least);
  };
  return apart(e, f) && apart(f, e);
}

}  // namespace

bool crossesItself(const std::vector<GridPoint>& outline, double tolerance) {
  // Edges by their lower end along the axis on which they overlap less.
  double along = 0, across = 0;
  std::vector<Edge> edges;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    Edge const e{outline[i], outline[(i + 1) % outline.size()]};
    along += std::abs(double(e.b.x - e.a.x));
    across += std::abs(double(e.b.y - e.a.y));
    edges.push_back(e);
  }
  bool const turned = across < along;
  for (Edge& e : edges) {
    if (turned) e = {{e.a.y, e.a.x}, {e.b.y, e.b.x}};
    if (e.b.x < e.a.x) std::swap(e.a, e.b);
  }
  std::sort(edges.begin(), edges.end(), [](const Edge& e, const Edge& f) { return e.a.x < f.a.x; });
  std::uint64_t left = 100'000'000;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = i + 1; k < edges.size() && edges[k].a.x <= edges[i].b.x; ++k) {
      if (left-- == 0) return false;
      auto const [low, high] = std::minmax(edges[i].a.y, edges[i].b.y);
      if (std::max(edges[k].a.y, edges[k].b.y) < low || std::min(edges[k].a.y, edges[k].b.y) > high) continue;
      if (crosses(edges[i], edges[k], tolerance)) return true;
    }
  }
  return false;
}

}  // namespace ropelight
