#pragma once
// Pearson's χ² test of a histogram against expected counts.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace ropelight {

/// Regularised upper incomplete gamma function Q(a, x) for a > 0, x ≥ 0: the power series of P below a + 1 (DLMF
/// 8.11.4), the continued fraction above (DLMF 8.9.2, evaluated by Lentz's method).
inline double upperGamma(double a, double x) {
  if (!(x > 0)) return 1;
  double const front = std::exp(a * std::log(x) - x - std::lgamma(a));
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (double k = a + 1; term > 1e-17 * sum; ++k) sum += term *= x / k;
    return 1 - front * sum;
  }
  double b = x + 1 - a, c = std::numeric_limits<double>::max(), d = 1 / b, h = d;
  for (int k = 1; k < 100000; ++k) {
    double const numerator = -k * (k - a);
    b += 2;
    d = 1 / (numerator * d + b);
    c = b + numerator / c;
    h *= d * c;
    if (std::abs(d * c - 1) < 1e-16) break;
  }
  return front * h;
}

/// Probability of a worse fit by chance. Cells that expect fewer than 5 are put together.
inline double chiSquareP(const std::vector<std::uint64_t>& observed, const std::vector<double>& expected) {
  double statistic = 0, smallObserved = 0, smallExpected = 0;
  int cells = 0;
  auto const add = [&](double o, double e) {
    statistic += (o - e) * (o - e) / e;
    ++cells;
  };
  for (std::size_t i = 0; i < observed.size(); ++i) {
    double const o = double(observed[i]), e = expected[i];
    if (e >= 5) {
      add(o, e);
      continue;
    }
    smallObserved += o;
    smallExpected += e;
    if (smallExpected < 5) continue;
    add(smallObserved, smallExpected);
    smallObserved = smallExpected = 0;
  }
  if (smallObserved + smallExpected > 0) add(smallObserved, std::max(smallExpected, 1.0));
  return cells > 1 ? upperGamma(0.5 * (cells - 1), 0.5 * statistic) : 0;
}

/// The level at which each of n tests must be run so that by chance one in a hundred suites fails (Šidák 1967).
inline double significance(int tests) { return 1 - std::pow(1 - 0.01, 1.0 / tests); }

/// A histogram over the rectangle [0, 1)² in `columns` × `rows` bins.
class Histogram2 {
 public:
  Histogram2(int columns, int rows)
      : counts(std::size_t(columns) * std::size_t(rows), 0), columns_(columns), rows_(rows) {}

  /// Values at 1 or beyond its rounding fall into the last bin.
  void add(double x, double y) {
    int const i = std::clamp(int(x * columns_), 0, columns_ - 1), j = std::clamp(int(y * rows_), 0, rows_ - 1);
    ++counts[std::size_t(j) * std::size_t(columns_) + std::size_t(i)];
    ++total;
  }

  /// Expected counts for a density over the rectangle, by `steps`² midpoints a bin.
  template <class Density>
  std::vector<double> expected(int steps, Density&& density) const {
    std::vector<double> sums;
    double const dx = 1.0 / (columns_ * steps), dy = 1.0 / (rows_ * steps);
    for (int j = 0; j < rows_; ++j)
      for (int i = 0; i < columns_; ++i) {
        double sum = 0;
        for (int b = 0; b < steps; ++b)
          for (int a = 0; a < steps; ++a) sum += density((i * steps + a + 0.5) * dx, (j * steps + b + 0.5) * dy);
        sums.push_back(sum * dx * dy * double(total));
      }
    return sums;
  }

  double uniformP() const {
    return chiSquareP(counts, std::vector<double>(counts.size(), double(total) / double(counts.size())));
  }

  std::vector<std::uint64_t> counts;
  std::uint64_t total = 0;

 private:
  int columns_, rows_;
};

inline double sum(const std::vector<double>& values) {
  double s = 0;
  for (double v : values) s += v;
  return s;
}

}  // namespace ropelight
