#pragma once
// A study as a renderer might have made it, for the report: pictures, noise, some figures unknown.

#include "tests/support/fake_study.h"
#include "tests/support/test_random.h"

namespace ropelight {

/// A sphere over a floor, `grain` the deviation of its noise in units of the radiance, `gain` its bias.
inline Image fakePicture(int width, std::uint64_t seed, double grain, double gain) {
  TestRandom random{std::uint32_t(seed)};
  Image image(width, width * 3 / 4);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < width; ++x) {
      double const u = (x + 0.5) / width * 4 - 2, v = 1.5 - (y + 0.5) / image.height * 3;
      double const z = 1 - u * u - v * v;
      double const light = z > 0 ? 0.08 + 0.6 * std::max(0.0, (0.6 * v - 0.5 * u + 0.62 * std::sqrt(z)))
                                 : (v < -0.6 ? 0.25 / (1 + u * u) : 0.12 + 0.05 * v);
      double const noise = grain * (random.unit() + random.unit() + random.unit() - 1.5) * 2;
      double const radiance = std::max(0.0, light * gain * (1 + noise));
      image.at(x, y) =
          Rgb(float(radiance), float(radiance * (z > 0 ? 0.55 : 0.95)), float(radiance * (z > 0 ? 0.3 : 0.9)));
    }
  return image;
}

/// Its runs fall as seconds^exponent down to a floor, each with a wobble of its own.
inline StudyMode fakeMode(const std::string& label, double factor, double exponent, double floor, int seeds) {
  StudyMode mode;
  mode.label = label;
  mode.settings.mode = findChoice<Mode>(label.substr(0, label.find(':'))).value();
  mode.accel = "bvh";
  mode.kernels = "diffuse, specular";
  mode.setupSeconds = 0.0421;
  mode.treeSeconds = 0.0312;
  mode.firstIterationSeconds = 0.0187;
  mode.pictureSeconds = 16.02;
  mode.pictureIterations = 1024;
  for (int k = 1; k <= seeds; ++k)
    mode.runs.push_back(runOf(std::uint64_t(k), 11, [=](double t) {
      return (factor * std::pow(t, exponent) + floor) * (1 + 0.04 * std::sin(3.7 * k + std::log(t)));
    }));
  return mode;
}

inline StudyScene fakeScene(const std::string& name, int width, int seeds) {
  StudyScene scene;
  scene.name = name;
  scene.file = "assets/" + name + ".json";
  scene.loadSeconds = 0.0123;
  scene.reference = {.image = fakePicture(width, 1, 0, 1),
                     .origin = "path, 80 s on this device, 12,288 iterations, seed 1001",
                     .noise = 4.2e-5,
                     .variance = 1.1e-6,
                     .epsilon = 4.87e-4,
                     .mode = Mode::path,
                     .stats = {}};
  scene.modes = {fakeMode("path", 0.08, -1, 0, seeds), fakeMode("sppm", 0.02, -0.67, 0, seeds),
                 fakeMode("sppm:alpha=0.5", 0.022, -0.5, 0.002, seeds)};
  scene.modes[0].picture = fakePicture(width, 2, 0.35, 1);
  scene.modes[1].picture = fakePicture(width, 3, 0.1, 1.02);
  scene.modes[2].picture = fakePicture(width, 4, 0.05, 0.93);
  scene.modes[2].settings.alpha = 0.5;
  scene.modes[0].split = {.mse = 1.2e-4, .bias2 = -3e-7, .variance = 1.19e-4, .referenceVariance = 1.1e-6};
  scene.modes[1].split = {.mse = 3.1e-5, .bias2 = 9.1e-6, .variance = 2.08e-5, .referenceVariance = 1.1e-6};
  scene.modes[2].split = {.mse = 5.4e-5, .bias2 = 4.4e-5, .variance = 8.9e-6, .referenceVariance = 1.1e-6};
  scene.edgeRadius = 0.0123;
  for (std::size_t i = 0; i < 3; ++i) scene.modes[i].pictureEdges = {0.2, 0.1 + 0.25 * double(i)};
  for (std::size_t i = 0; i < 3; ++i) scene.modes[i].pictureFlip = 0.06 + 0.05 * double(i == 0);
  return scene;
}

inline Study fakeStudy(std::vector<StudyScene> scenes, int seeds) {
  Study study;
  study.command = "ropelight converge cornell glass --mode path --mode sppm --mode sppm:alpha=0.5 --time 16 --seeds 3";
  study.version = "0.1.0+1a2b3c4";
  study.device = "NVIDIA H100 80GB HBM3";
  study.threads = 2;
  study.startSeconds = 0.0871;
  study.seconds = 16;
  study.seeds = seeds;
  study.scenes = std::move(scenes);
  return study;
}

}  // namespace ropelight
