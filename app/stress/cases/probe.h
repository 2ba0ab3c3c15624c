#pragma once
// What a case renders with: a backend, a seed, and how much work it may take. It counts what went wrong on the way.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/integrators/integrator.h"

namespace ropelight {

/// A mean over independent renderings with its standard error.
struct Estimate {
  double mean = 0, error = 0;
};

struct Rendered {
  Image image;
  Stats stats;
};

/// Thrown by a case that cannot run on this backend; the text says why.
struct LeftOut {
  std::string why;
};

class Probe {
 public:
  Probe(const BackendChoice& backend, std::uint64_t seed, bool isShort, std::function<void()> tick)
      : backend_(backend), seed_(seed), short_(isShort), tick_(std::move(tick)) {}

  /// What makes integrators; makeIntegrator unless a test has others.
  using Maker = std::function<std::unique_ptr<Integrator>(const Scene&, const Settings&, const BackendChoice&)>;
  void useMaker(Maker maker) { maker_ = std::move(maker); }
  std::unique_ptr<Integrator> make(const Scene& scene, const Settings& settings) const;

  const BackendChoice& backend() const { return backend_; }
  bool isGpu() const;
  bool isShort() const { return short_; }
  std::uint64_t seed() const { return seed_; }
  /// Called between steps: shows progress, and throws where the user has interrupted.
  void tick() const { tick_(); }
  /// `whole` in the whole catalogue, `part` in the short one.
  int choose(int part, int whole) const { return short_ ? part : whole; }

  Rendered render(const Scene& scene, const Settings& settings, int iterations);
  /// `count` renderings that differ by seed alone; another `first` gives other ones.
  std::vector<Image> seeds(const Scene& scene, Settings settings, int iterations, int count, std::uint64_t first = 0);
  /// Of quantity(image) over `count` seeds. quantity: a mean over pixels, whose number may be raised while that of the
  /// iterations falls.
  Estimate estimate(const Scene& scene, Settings settings, int iterations, int count,
                    const std::function<double(const Image&)>& quantity);

  std::uint64_t nonFinite() const { return nonFinite_; }

 private:
  BackendChoice backend_;
  std::uint64_t seed_;
  bool short_;
  std::function<void()> tick_;
  Maker maker_;
  std::uint64_t nonFinite_ = 0;
};

/// Settings of a square image in a mode.
Settings probeSettings(Mode mode, int size, std::uint64_t photons = 65536);

/// Mean of a channel over all pixels, or of the three channels.
double meanOfChannel(const Image& image, int channel);
double meanOfAll(const Image& image);

/// Mean and standard error of independent values.
Estimate estimateOf(const std::vector<double>& values);

/// The largest |z| over the square tiles of two sets of renderings; tiles whose means agree within `relative` count 0.
double largestZ(const std::vector<Image>& a, const std::vector<Image>& b, int tile, double relative);

}  // namespace ropelight
