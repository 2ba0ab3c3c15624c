#include "app/bench/results/checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ropelight {
namespace {

// As the renderer's gather has it: a flat disc, and surfaces that face the same way.
constexpr double discThickness = 0.2, sameSide = 0.1;
constexpr double rounding = 1e-4;  // relative; of single precision, with room

double dot(const double (&a)[3], const float (&b)[3]) {
  return a[0] * double(b[0]) + a[1] * double(b[1]) + a[2] * double(b[2]);
}

/// Squared distance in the plane of the query's disc, or −1 where the photon is beside it.
double onDisc(const StreamQuery& query, const StreamPhoton& photon, double radius) {
  double d[3], normal[3];
  for (int a = 0; a < 3; ++a) {
    d[a] = double(photon.position[a]) - double(query.position[a]);
    normal[a] = double(photon.normal[a]);
  }
  double const height = dot(d, query.normal);
  double const distance2 = std::max(0.0, d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - height * height);
  bool const inside = distance2 <= radius * radius && std::abs(height) <= discThickness * radius;
  return inside && dot(normal, query.normal) > sameSide ? distance2 : -1;
}

bool close(double a, double b) { return std::abs(a - b) <= rounding * std::max(std::abs(a), std::abs(b)); }

}  // namespace

bool sameHit(const StreamHit& a, const StreamHit& b, bool anyHit) {
  if (a.found() != b.found()) return false;
  if (!a.found() || anyHit || a.primitive == b.primitive) return true;
  return std::abs(a.t - b.t) <= 4 * std::numeric_limits<float>::epsilon() * std::abs(b.t);
}

std::size_t differentHits(std::span<const StreamHit> hits, std::span<const StreamHit> expected, bool anyHit) {
  if (hits.size() != expected.size()) return std::max(hits.size(), expected.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < hits.size(); ++i) different += sameHit(hits[i], expected[i], anyHit) ? 0 : 1;
  return different;
}

std::vector<std::uint32_t> spreadNumbers(std::size_t count, std::size_t n) {
  std::size_t const taken = std::min(count, std::max<std::size_t>(n, 1));
  std::vector<std::uint32_t> numbers;
  for (std::size_t k = 0; k < taken; ++k) numbers.push_back(std::uint32_t(k * count / taken));
  return numbers;
}

std::size_t differentGathers(std::span<const StreamGather> gathers, std::span<const StreamGather> expected) {
  if (gathers.size() != expected.size()) return std::max(gathers.size(), expected.size());
  std::size_t different = 0;
  for (std::size_t i = 0; i < gathers.size(); ++i) {
    bool same = gathers[i].count == expected[i].count;
    for (int c = 0; c < 3; ++c) same = same && close(double(gathers[i].flux[c]), double(expected[i].flux[c]));
    different += same ? 0 : 1;
  }
  return different;
}

bool rightNearest(const StreamGather& gather, const StreamQuery& query, std::span<const StreamPhoton> photons,
                  float radius, int k) {
  std::vector<double> inner, outer;  // photons at the rim may count or not
  for (const StreamPhoton& photon : photons) {
    double const distance2 = onDisc(query, photon, double(radius) * (1 + rounding));
    if (distance2 < 0) continue;
    outer.push_back(distance2);
    if (onDisc(query, photon, double(radius) * (1 - rounding)) >= 0) inner.push_back(distance2);
  }
  std::size_t const wanted = std::size_t(k);
  if (gather.count < wanted) return gather.count >= inner.size() && gather.count <= outer.size();
  if (gather.count != wanted || outer.size() < wanted) return false;
  std::nth_element(outer.begin(), outer.begin() + (k - 1), outer.end());
  return close(double(gather.radius2), outer[wanted - 1]);
}

}  // namespace ropelight
