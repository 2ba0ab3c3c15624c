// Long runs and large counters.

#include <algorithm>
#include <cmath>
#include <set>

#include "app/stress/families/families.h"
#include "measure/scenes/scene_kit.h"
#include "render/kernels/frame_view.h"

namespace ropelight::families {
namespace {

/// A tiny image for a long time: the mean must neither stall nor drift. Pixels are independent estimates of one value.
std::vector<Measurement> longRun(Probe& probe) {
  std::vector<Measurement> out;
  int const most = probe.choose(10000, 1000000);
  for (Mode mode : {Mode::path, Mode::sppm}) {
    Settings settings = probeSettings(mode, 4, 16);
    settings.radius = 0.3;
    settings.alpha = 1;
    settings.direct = DirectLight::photons;
    double const expected = mode == Mode::sppm ? 1 + discGain(0.3) : 2;
    auto const integrator = probe.make(sphereFurnace(Rgb(0.5f), 1), settings);
    for (int done = 0; done < most;) {
      int const next = done == 0 ? most / 100 : most - done;
      for (int i = 0; i < next; i += 1000) {
        probe.tick();
        integrator->advance(std::min(1000, next - i));
      }
      done += next;
      std::vector<double> values;
      for (Rgb p : integrator->film().pixels) values.push_back(double(p.x) / expected);
      Estimate const e = estimateOf(values);
      // Photons are shared by all pixels: what is common to them is not in the spread, 16 photons an iteration.
      double const common = mode == Mode::sppm ? 0.6 / std::sqrt(16.0 * done) : 0;
      double const bound = std::max(0.001, 0.5 / std::sqrt(double(done)));
      out.push_back(
          {mode == Mode::path ? "path" : "sppm", double(done), e.mean, std::hypot(e.error, common), 1, bound});
    }
  }
  return out;
}

/// How uneven 4096 points are: the largest count of a cell of 64 × 64 of which each should hold one, less 1.
double unevenness(const std::vector<cpu::Vec2>& points) {
  std::vector<int> count(64 * 64);
  for (cpu::Vec2 p : points) ++count[std::size_t(p.x * 64) * 64 + std::size_t(p.y * 64)];
  return double(*std::max_element(count.begin(), count.end()) - 1);
}

/// Photon numbers below and beyond 2³², 2⁴⁰ and 2⁶³: each aligned block of points fills its cells, and no block is
/// another's.
std::vector<Measurement> photonNumbers(Probe&) {
  std::vector<Measurement> out;
  std::set<std::pair<float, float>> firsts;
  for (int exponent : {0, 31, 32, 33, 40, 63}) {
    std::uint64_t const start = exponent == 0 ? 0 : std::uint64_t(1) << exponent;
    std::vector<cpu::Vec2> points;
    for (std::uint64_t path = start; path < start + 4096; ++path) {
      cpu::Sampler sampler(cpu::Samplers::indexOf<cpu::SobolSampler>(), 1, cpu::Stream::photon,
                           std::uint32_t(path >> 32), std::uint32_t(path));
      points.push_back(sampler.next2());
    }
    out.push_back({"points too many in a cell", double(exponent), unevenness(points)});
    bool const isNew = firsts.insert({points[0].x, points[0].y}).second;
    out.push_back({"repeats an earlier block", double(exponent), isNew ? 0.0 : 1.0});
  }
  return out;
}

/// Iterations of one pixel across 2³² and beyond: no block of them has the numbers of another.
std::vector<Measurement> cameraNumbers(Probe&) {
  std::vector<Measurement> out;
  std::set<std::pair<float, float>> firsts;
  for (int exponent : {0, 31, 32, 33, 40, 63}) {
    std::uint64_t const start = exponent == 0 ? 0 : std::uint64_t(1) << exponent;
    std::vector<cpu::Vec2> points;
    for (std::uint64_t i = start; i < start + 4096; ++i) {
      cpu::Sampler sampler(cpu::Samplers::indexOf<cpu::SobolSampler>(), cpu::cameraSeedOf(1, i), cpu::Stream::camera, 5,
                           std::uint32_t(i));
      points.push_back(sampler.next2());
    }
    out.push_back({"points too many in a cell", double(exponent), unevenness(points)});
    bool const isNew = firsts.insert({points[0].x, points[0].y}).second;
    out.push_back({"repeats an earlier block", double(exponent), isNew ? 0.0 : 1.0});
  }
  return out;
}

}  // namespace

StressFamily length() {
  return {"length",
          "long runs and large counters",
          {{"long run", "a million iterations of one tiny image", "iterations", "radiance / closed form",
            "1/(1 - albedo); by photons 1 + the area within the disc over pi r^2", "0.5/sqrt(n), at least 0.1%", true,
            longRun},
           {"photon numbers", "Sobol' points of photons beyond 2^32", "log2 of the first photon's number",
            "4096 points in 64 x 64 cells", "one a cell, and other points in every block", "0", true, photonNumbers},
           {"camera numbers", "iterations beyond 2^32", "log2 of the first iteration", "4096 points in 64 x 64 cells",
            "one a cell, and other points in every block", "0", true, cameraNumbers}}};
}

}  // namespace ropelight::families
