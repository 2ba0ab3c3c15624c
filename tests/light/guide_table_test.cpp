// Picking by weight in constant time.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "render/light/guide_table.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

struct Table {
  std::vector<Real> cdf;
  std::vector<std::uint32_t> guide;

  explicit Table(const std::vector<double>& weights) {
    double sum = 0, total = 0;
    for (double w : weights) total += w;
    for (double w : weights) cdf.push_back(Real((sum += w) / total));
    cdf.back() = 1;
    guide = makeGuideTable(cdf);
  }
  std::uint32_t find(Real u) const {
    return findByGuide({cdf.data(), std::uint32_t(cdf.size())}, {guide.data(), std::uint32_t(guide.size())}, u);
  }
};

std::vector<std::vector<double>> cases() {
  std::vector<std::vector<double>> weights = {
      {1}, {1, 1}, {1, 3}, {1e-12, 1, 1e12}, {1e12, 1, 1e-12}, {5, 4, 3, 2, 1, 0.5, 1e-3}};
  weights.emplace_back(1000, 1.0);
  weights.emplace_back();
  for (int i = 0; i < 500; ++i) weights.back().push_back(std::exp(0.05 * i));
  return weights;
}

}  // namespace

TEST_CASE("a guide table picks what bisection of the sums picks") {
  for (const std::vector<double>& weights : cases()) {
    CAPTURE(weights.size());
    Table const table(weights);
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
      Real const u = minOf(Real((i + 0.37) / 20000), 1 - machineEpsilon);
      wrong +=
          std::ptrdiff_t(table.find(u)) != std::upper_bound(table.cdf.begin(), table.cdf.end(), u) - table.cdf.begin();
    }
    CHECK(wrong == 0);
  }
}

TEST_CASE("a guide table is right at every border") {
  for (const std::vector<double>& weights : cases()) {
    CAPTURE(weights.size());
    Table const table(weights);
    for (std::size_t k = 0; k + 1 < table.cdf.size(); ++k) {
      Real const border = table.cdf[k];
      if (!(border > 0 && border < 1)) continue;
      CHECK(table.find(std::nextafter(border, Real(0))) <= k);
      CHECK(table.find(border) > k);
    }
  }
}
