// The gather radius: its closed form, its limits and its floor.

#include <doctest/doctest.h>

#include <cmath>

#include "render/prepare/prepare.h"

using namespace ropelight;

TEST_CASE("the gather radius is the product of Knaus and Zwicker's recurrence") {
  for (double alpha : {0.5, 2.0 / 3.0, 0.75, 1.0}) {
    CAPTURE(alpha);
    long double square = 0.09L;  // r₁² for r₁ = 0.3
    double worst = 0;
    for (std::uint64_t i = 1; i <= 10000; ++i) {
      double const expected = double(std::sqrt(square));
      worst = std::max(worst, std::abs(gatherRadius(0.3, alpha, i, 0) / expected - 1));
      square *= (static_cast<long double>(i) + static_cast<long double>(alpha)) / static_cast<long double>(i + 1);
    }
    CHECK(worst < 1e-10);
  }
}

TEST_CASE("the first radius is the one that was asked for, and alpha = 1 keeps it") {
  CHECK(gatherRadius(0.3, 0.5, 1, 0) == doctest::Approx(0.3).epsilon(1e-15));
  for (std::uint64_t i : {1ull, 10ull, 100000ull}) CHECK(gatherRadius(0.3, 1, i, 0) == doctest::Approx(0.3));
}

TEST_CASE("after a thousand million iterations the radius is small, finite and right") {
  for (double alpha : {0.5, 2.0 / 3.0, 0.75}) {
    // Γ(i + α)/Γ(i + 1) tends to i^(α−1).
    double const expected = std::sqrt(std::pow(1e9, alpha - 1) / std::tgamma(1 + alpha));
    CHECK(gatherRadius(1, alpha, 1000000000ull, 0) / expected == doctest::Approx(1).epsilon(1e-5));
  }
}

TEST_CASE("the radius never falls below its floor") {
  CHECK(gatherRadius(1, 0.5, 1000000, 0.25) == 0.25);
  CHECK(gatherRadius(1, 0.5, 2, 0.25) > 0.25);
  CHECK(gatherRadius(1e-30, 0.5, 1, 1e-20) == 1e-20);
}

TEST_CASE("the radius never grows") {
  double last = gatherRadius(1, 0.5, 1, 0);
  for (std::uint64_t i = 2; i < 1000; ++i) {
    double const r = gatherRadius(1, 0.5, i, 0);
    if (!(r < last)) FAIL(i);
    last = r;
  }
}
