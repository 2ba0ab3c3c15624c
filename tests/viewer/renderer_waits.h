#pragma once
// Small scenes for the window's renderer, and waiting for what it shows.

#include <doctest/doctest.h>

#include <chrono>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/viewer/session/renderer.h"
#include "render/import/load.h"
#include "tests/support/rendering.h"

namespace ropelight::view {

inline std::shared_ptr<const Scene> asset(const char* name) {
  return std::make_shared<const Scene>(loadScene(std::string(ROPELIGHT_ASSETS) + "/" + name + ".json"));
}

inline Settings settingsOf(Mode mode, int width = 48) {
  Settings s = testing::settingsFor(mode, width, 32);
  s.photons = 2000;
  return s;
}

/// False where it does not become true within a minute.
template <class Condition>
inline bool waitFor(Condition&& condition) {
  auto const end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

inline bool iterated(const Renderer& r, int which, std::uint64_t n) {
  EstimateStatus const s = r.status(which);
  return s.ready && !s.draft && s.pixelIterations >= n;
}

inline const BackendChoice onCpu{BackendKind::cpu, -1, 0, false};

struct Shown {
  int width = 0, height = 0;
  std::uint64_t iterations = 0;
  std::vector<float> pixels;
};

inline Shown shownBy(Renderer& r, int which) {
  Shown s;
  s.pixels.resize(1 << 20);
  REQUIRE(r.copyPixels(which, s.pixels.data(), s.pixels.size() * sizeof(float), s.width, s.height, s.iterations));
  s.pixels.resize(std::size_t(s.width) * std::size_t(s.height) * 4);
  return s;
}

inline bool equals(const Shown& shown, const Image& image) {
  if (shown.width != image.width || shown.height != image.height) return false;
  for (std::size_t i = 0; i < image.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      if (shown.pixels[4 * i + std::size_t(c)] != image.pixels[i][c]) return false;
  return true;
}

}  // namespace ropelight::view
