#include "app/converge/study/edges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ropelight {
namespace {

constexpr double leastCosine = 0.9, depthJump = 0.1;

/// Pixels as they lie in the image.
struct Grid {
  int width, height;
  std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
};

bool turns(Vec3d a, Vec3d b) {
  double const lengths = glm::length(a) * glm::length(b);
  return !(glm::dot(a, b) >= leastCosine * lengths);
}

/// Depths that are not positive and finite are of no surface.
bool jumps(double a, double b) {
  auto const surface = [](double d) { return d > 0 && std::isfinite(d); };
  if (surface(a) != surface(b)) return true;
  return surface(a) && std::abs(a - b) > depthJump * std::min(a, b);
}

std::vector<double> edges(const Image& normal, const Image& depth) {
  Grid const grid{normal.width, normal.height};
  std::vector<double> distance(normal.pixels.size(), std::numeric_limits<double>::infinity());
  auto const compare = [&](std::size_t i, std::size_t j) {
    if (turns(Vec3d(normal.pixels[i]), Vec3d(normal.pixels[j])) ||
        jumps(double(depth.pixels[i].x), double(depth.pixels[j].x)))
      distance[i] = distance[j] = 0;
  };
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) {
      if (x + 1 < grid.width) compare(grid.at(x, y), grid.at(x + 1, y));
      if (y + 1 < grid.height) compare(grid.at(x, y), grid.at(x, y + 1));
    }
  return distance;
}

/// Distances in pixels from the zeros, to 8%: steps of 1 and √2 (Borgefors 1986, "Distance transformations in digital
/// images").
void spread(std::vector<double>& distance, Grid grid) {
  auto const relax = [&](int x, int y, int dx, int dy) {
    int const u = x + dx, v = y + dy;
    if (u < 0 || v < 0 || u >= grid.width || v >= grid.height) return;
    double const step = dx != 0 && dy != 0 ? std::sqrt(2.0) : 1.0;
    distance[grid.at(x, y)] = std::min(distance[grid.at(x, y)], distance[grid.at(u, v)] + step);
  };
  for (int sign : {-1, 1})
    for (int j = 0; j < grid.height; ++j)
      for (int i = 0; i < grid.width; ++i) {
        int const x = sign < 0 ? i : grid.width - 1 - i, y = sign < 0 ? j : grid.height - 1 - j;
        relax(x, y, sign, 0);
        for (int dx : {-1, 0, 1}) relax(x, y, dx, sign);
      }
}

}  // namespace

std::vector<bool> nearEdges(const Image& normal, const Image& depth, const CameraDesc& camera, double radius) {
  std::vector<double> distance = edges(normal, depth);
  spread(distance, {normal.width, normal.height});
  double const pixelAtOne = 2 * std::tan(glm::radians(camera.verticalFov) / 2) / normal.height;
  std::vector<bool> mask(distance.size());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    double const d = double(depth.pixels[i].x);
    mask[i] = d > 0 && distance[i] <= std::max(1.0, radius / (d * pixelAtOne));
  }
  return mask;
}

EdgeShare edgeShare(const Image& image, const StudyReference& reference, const std::vector<bool>& mask) {
  double all = 0, inside = 0, pixels = 0;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    double error = 0;
    for (int c = 0; c < 3; ++c) {
      double const b = double(reference.image.pixels[i][c]), d = double(image.pixels[i][c]) - b;
      if (d != 0) error += d * d / (b * b + reference.epsilon);
    }
    if (!std::isfinite(error)) continue;
    all += error;
    if (mask[i]) inside += error, ++pixels;
  }
  if (mask.empty() || all == 0) return {};
  return {pixels / double(mask.size()), inside / all};
}

}  // namespace ropelight
