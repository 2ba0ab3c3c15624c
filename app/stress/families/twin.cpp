// Floats against the same renderer in double precision, with the same random numbers.

#include <fmt/format.h>

#include <cmath>

#include "app/stress/families/families.h"
#include "measure/scenes/scene_kit.h"

namespace ropelight::families {
namespace {

BackendChoice inDouble(const Probe& probe) {
  if (probe.backend().backend == BackendKind::cpu64) throw LeftOut{"this backend is the twin itself"};
  return {BackendKind::cpu64, -1, probe.backend().threads, false};
}

Image renderOn(Probe& probe, const BackendChoice& backend, const Scene& scene, const Settings& settings,
               int iterations) {
  probe.tick();
  auto const integrator = makeIntegrator(scene, settings, backend);
  integrator->advance(iterations);
  return integrator->film();
}

Image renderTwin(Probe& probe, const Scene& scene, const Settings& settings, int iterations) {
  return renderOn(probe, inDouble(probe), scene, settings, iterations);
}

/// Relative to the second, floor 10⁻⁶.
double apart(Rgb a, Rgb b) {
  double const x = double(mean(a)), y = double(mean(b));
  return std::abs(x - y) / std::max(std::abs(y), 1e-6);
}

struct Setting {
  const char* name;
  Scene scene;
  Settings settings;
};

/// Scenes in which no float decides between light and darkness but at edges.
std::vector<Setting> settings() {
  std::vector<Setting> out;
  for (Mode mode : {Mode::ray, Mode::path, Mode::sppm}) {
    const char* const name = mode == Mode::ray ? "ray" : (mode == Mode::path ? "path" : "sppm");
    Settings s = probeSettings(mode, 64, 16384);
    s.radius = 0.1;
    s.maxDepth = 6;  // a path that has met an edge differently is another path: few bounces keep such paths few
    out.push_back({name, mixedRoom(), s});
  }
  return out;
}

/// Follows a pixel whose values differ: the fewest edges of its paths after which they do.
int edgesUntilApart(Probe& probe, const Setting& s, std::size_t pixel, double relative) {
  Settings cut = s.settings;
  for (cut.maxDepth = 1; cut.maxDepth < s.settings.maxDepth; ++cut.maxDepth) {
    Image const floats = probe.render(s.scene, cut, 1).image, doubles = renderTwin(probe, s.scene, cut, 1);
    if (apart(floats.pixels[pixel], doubles.pixels[pixel]) > relative) break;
  }
  return cut.maxDepth;
}

std::vector<Measurement> oneIteration(Probe& probe) {
  double const relative = 1e-3;
  std::vector<Measurement> out;
  for (const Setting& s : settings()) {
    Image const floats = probe.render(s.scene, s.settings, 1).image,
                doubles = renderTwin(probe, s.scene, s.settings, 1);
    double far = 0, worst = 0;
    std::size_t at = 0;
    for (std::size_t i = 0; i < floats.pixels.size(); ++i) {
      double const off = apart(floats.pixels[i], doubles.pixels[i]);
      far += off > relative;
      if (off > worst) worst = off, at = i;
    }
    auto const width = std::size_t(floats.width);
    std::string text = fmt::format("{}, worst pixel ({}, {}): {:.2g}", s.name, at % width, at / width, worst);
    if (worst > relative) text += fmt::format(", apart from edge {}", edgesUntilApart(probe, s, at, relative));
    out.push_back({text, 0, far / double(floats.pixels.size()), 0, 0, 0.01});
  }
  return out;
}

/// The same seeds here and by another way: what is left is far below the noise, which the standard errors hold.
std::vector<Measurement> sameSeeds(Probe& probe, const BackendChoice& other) {
  std::vector<Measurement> out;
  int const iterations = probe.choose(16, 64), seeds = 8;
  for (const Setting& s : settings()) {
    std::vector<Image> const here = probe.seeds(s.scene, s.settings, iterations, seeds);
    std::vector<Image> there;
    Settings settings = s.settings;
    for (int i = 0; i < seeds; ++i) {
      settings.seed = probe.seed() + std::uint64_t(i);
      there.push_back(renderOn(probe, other, s.scene, settings, iterations));
    }
    out.push_back({s.name, 0, largestZ(here, there, 8, 1e-4), 0, 0, 3});
  }
  return out;
}

std::vector<Measurement> manyIterations(Probe& probe) { return sameSeeds(probe, inDouble(probe)); }

/// The GPU against the CPU: nvcc fuses products and sums, and nothing else may differ.
std::vector<Measurement> otherBackend(Probe& probe) {
  if (!probe.isGpu()) throw LeftOut{"this is the CPU: run it with --backend cuda"};
  return sameSeeds(probe, {BackendKind::cpu, -1, probe.backend().threads, false});
}

}  // namespace

StressFamily twin() {
  return {"twin",
          "floats against double precision, with the same random numbers",
          {{"one iteration", "a float that decides another way at an edge", "", "share of pixels more than 1e-3 apart",
            "the renderer in double precision", "1%", true, oneIteration},
           {"many iterations", "a bias of rounding that noise hides", "", "largest |z| of the tiles",
            "the renderer in double precision, same seeds", "3 standard errors", true, manyIterations},
           {"other backend", "a GPU fuses products and sums", "", "largest |z| of the tiles", "the CPU, same seeds",
            "3 standard errors", true, otherBackend}}};
}

}  // namespace ropelight::families
