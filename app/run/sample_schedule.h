#pragma once
// When to look at a run: at places spread evenly over the logarithm of its time.

#include <cmath>

namespace ropelight {

/// Due at the powers of `spacing`, the same ones for every run, so that the samples of many runs lie close together.
class SampleSchedule {
 public:
  explicit SampleSchedule(double spacing) : logSpacing_(std::log(spacing)) {}

  /// Whether a look is due at this time; always so before the first one. Times of zero or less come before every power.
  bool due(double time) const { return time >= next_; }
  double next() const { return next_; }
  void restart() { next_ = 0; }
  /// A look was taken at this time.
  void taken(double time) {
    next_ = time > 0 ? std::exp(logSpacing_ * (std::floor(std::log(time) / logSpacing_ + 1e-9) + 1)) : next_;
  }

 private:
  double logSpacing_;
  double next_ = 0;
};

}  // namespace ropelight
