// Picking by weight in constant time.

#include <doctest/doctest.h>

#include <cmath>

#include "render/light/alias_table.h"

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

/// The share of [0, 1) that leads to each number, from the bins themselves.
std::vector<double> sharesOf(const std::vector<AliasBin>& bins) {
  std::vector<double> shares(bins.size());
  for (std::size_t i = 0; i < bins.size(); ++i) {
    shares[i] += double(bins[i].keep) / double(bins.size());
    shares[bins[i].other] += (1 - double(bins[i].keep)) / double(bins.size());
  }
  return shares;
}

}  // namespace

TEST_CASE("an alias table gives every number the share of its weight") {
  std::vector<std::vector<double>> const cases = {
      {1}, {1, 1}, {1, 3}, {0, 1}, {1, 0, 0, 5}, {1e-12, 1, 1e12}, {5, 4, 3, 2, 1, 0.5, 1e-3}};
  for (const std::vector<double>& weights : cases) {
    CAPTURE(weights.size());
    double sum = 0;
    for (double w : weights) sum += w;
    std::vector<double> const shares = sharesOf(makeAliasTable(weights));
    for (std::size_t i = 0; i < weights.size(); ++i) CHECK(std::abs(shares[i] - weights[i] / sum) < 1e-6);
  }
}

TEST_CASE("what a pick leaves of its random number is uniform again") {
  std::vector<double> const weights = {1, 5, 2, 0.25};
  std::vector<AliasBin> const bins = makeAliasTable(weights);
  int const n = 1 << 16;
  std::vector<double> count(weights.size()), mean(weights.size()), square(weights.size());
  for (int i = 0; i < n; ++i) {
    Real u = Real((i + 0.5) / n);
    std::uint32_t const k = pickByAlias({bins.data(), std::uint32_t(bins.size())}, u);
    REQUIRE((u >= 0 && u < 1));
    count[k] += 1;
    mean[k] += double(u);
    square[k] += double(u) * double(u);
  }
  for (std::size_t k = 0; k < weights.size(); ++k) {
    CHECK(count[k] / n == doctest::Approx(weights[k] / 8.25).epsilon(1e-3));
    CHECK(mean[k] / count[k] == doctest::Approx(0.5).epsilon(2e-3));
    CHECK(square[k] / count[k] == doctest::Approx(1 / 3.0).epsilon(4e-3));
  }
}

TEST_CASE("a single light takes the whole number and changes none of its bits") {
  std::vector<AliasBin> const bins = makeAliasTable({3.7});
  for (float u : {0.0f, 0.1f, 0.33333334f, 0.99999994f}) {
    Real rest = u;
    CHECK(pickByAlias({bins.data(), 1}, rest) == 0);
    CHECK(rest == u);
  }
}
