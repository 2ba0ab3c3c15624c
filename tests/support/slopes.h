#pragma once
// Slopes of convergence: films after several numbers of iterations, and a slope over them with its interval.

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "tests/support/rendering.h"

namespace ropelight::testing {

using Counts = std::vector<int>;  ///< numbers of iterations, ascending

/// from, 2·from, … up to `to`.
inline Counts doublings(int from, int to) {
  Counts counts;
  for (int n = from; n <= to; n *= 2) counts.push_back(n);
  return counts;
}

/// Pixels (red) after counts[c] iterations from each seed: at(seed, c)[pixel].
struct Courses {
  Counts counts;
  std::vector<std::vector<std::vector<double>>> films;

  int seeds() const { return int(films.size()); }
  std::size_t pixels() const { return films[0][0].size(); }
  const std::vector<double>& at(int seed, std::size_t c) const { return films[std::size_t(seed)][c]; }
};

inline std::vector<std::vector<double>> runCourse(const Scene& scene, const Settings& settings, const Counts& counts) {
  auto const integrator = makeIntegrator(scene, settings, {BackendKind::cpu, 0, 1, false});
  std::vector<std::vector<double>> films;
  int done = 0;
  for (int count : counts) {
    integrator->advance(count - std::exchange(done, count));
    Image const image = integrator->film();
    std::vector<double>& film = films.emplace_back();
    for (Rgb p : image.pixels) film.push_back(double(p.x));
  }
  return films;
}

/// Seeds of every interval, and a quantile of Student's t with one degree of freedom less: 5·10⁻⁶ lie outside. So wide,
/// all checks together fail by chance in less than one of a thousand choices of seeds, although finite numbers of
/// iterations leave some slopes one and a half standard errors from their limits.
inline constexpr int slopeSeeds = 32;
inline constexpr double slopeStudent = 5.5;

/// Each seed on one thread: small iterations leave nothing to share.
inline Courses runCourses(const Scene& scene, const Settings& settings, const Counts& counts) {
  Courses courses{counts, {}};
  courses.films.resize(slopeSeeds);
  oneapi::tbb::parallel_for(0, slopeSeeds, [&](int s) {
    Settings mine = settings;
    mine.seed = std::uint64_t(s) + 1;
    courses.films[std::size_t(s)] = runCourse(scene, mine, counts);
  });
  return courses;
}

/// Slope of the line through (ln count, ln |value|) by least squares.
inline double logSlope(const Counts& counts, const std::vector<double>& values) {
  double const n = double(counts.size());
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    double const x = std::log(double(counts[i])), y = std::log(std::abs(values[i]));
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

struct Interval {
  double value = 0, half = 0;

  bool contains(double x) const { return std::abs(x - value) <= half; }
};

/// statistic(left out) of all seeds but one, −1 for none. The jackknife (Tukey 1958) carries the correlation between
/// the points of a slope, which are prefixes of the same runs.
template <class Statistic>
Interval jackknife(Statistic&& statistic) {
  std::vector<double> values;
  double mean = 0, squares = 0;
  for (int s = 0; s < slopeSeeds; ++s) mean += values.emplace_back(statistic(s)) / slopeSeeds;
  for (double v : values) squares += (v - mean) * (v - mean);
  return {statistic(-1), slopeStudent * std::sqrt(squares * (slopeSeeds - 1) / slopeSeeds)};
}

/// Means of a pixel's value and of its square over all seeds but one.
struct Moments {
  double mean = 0, square = 0, count = 0;
};

inline Moments momentsOf(const Courses& courses, std::size_t c, std::size_t pixel, int without, double origin) {
  Moments m;
  for (int s = 0; s < courses.seeds(); ++s) {
    if (s == without) continue;
    double const v = courses.at(s, c)[pixel] - origin;
    m.mean += v, m.square += v * v, m.count += 1;
  }
  m.mean /= m.count, m.square /= m.count;
  return m;
}

/// The jackknifed slope of the mean over pixels of measure(moments about the pixel's truth).
template <class Measure>
Interval slopeOf(const Courses& courses, const std::vector<double>& truth, Measure&& measure) {
  return jackknife([&](int without) {
    std::vector<double> values(courses.counts.size());
    for (std::size_t c = 0; c < values.size(); ++c)
      for (std::size_t p = 0; p < courses.pixels(); ++p)
        values[c] += measure(momentsOf(courses, c, p, without, truth[p]));
    return logSlope(courses.counts, values);
  });
}

/// The jackknifed mean error of all pixels after the last count.
inline Interval meanErrorOf(const Courses& courses, const std::vector<double>& truth) {
  return jackknife([&](int without) {
    double sum = 0;
    for (std::size_t p = 0; p < courses.pixels(); ++p)
      sum += momentsOf(courses, courses.counts.size() - 1, p, without, truth[p]).mean;
    return sum / double(courses.pixels());
  });
}

inline double squaredError(const Moments& m) { return m.square; }
inline double variance(const Moments& m) { return (m.square - m.mean * m.mean) * m.count / (m.count - 1); }
inline double bias(const Moments& m) { return m.mean; }

/// What Knaus and Zwicker's sums (2011) come to, in units of the first iteration's variance or bias, with
/// r²ᵢ = r²ᵢ₋₁ (i − 1 + α)/i.
struct Expected {
  std::vector<double> variance;  ///< (1/N²) Σ r₁²/rᵢ², tends to N^−α
  std::vector<double> bias;      ///< (1/N) Σ rᵢ²/r₁², tends to N^(α−1)
};

inline Expected expectedOf(double alpha, const Counts& counts) {
  Expected e;
  double square = 1, inverses = 0, squares = 0;
  for (int i = 1; i <= counts.back(); ++i) {
    if (i > 1) square *= (i - 1 + alpha) / i;
    inverses += 1 / square;
    squares += square;
    if (std::find(counts.begin(), counts.end(), i) == counts.end()) continue;
    e.variance.push_back(inverses / (double(i) * i));
    e.bias.push_back(squares / i);
  }
  return e;
}

}  // namespace ropelight::testing
