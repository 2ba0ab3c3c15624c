#include "app/viewer/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>

#include "app/run/report.h"
#include "app/viewer/session/background.h"
#include "render/core/error.h"
#include "render/image_files/image_file.h"
#include "render/import/load.h"

namespace ropelight::view {
namespace {

LoadedScene load(const std::string& file, bool again) {
  giveWay();
  LoadedScene loaded;
  loaded.again = again;
  try {
    loaded.scene = std::make_shared<const Scene>(loadScene(file));
  } catch (const std::bad_alloc&) {
    loaded.problem = fmt::format("{}: out of memory while loading", file);
  } catch (const std::exception& error) {
    loaded.problem = error.what();
  }
  return loaded;
}

/// False colour is for the screen; a picture of it is saved with the curve that the film would otherwise have.
Tonemap tonemapOf(const ToneSettings& tone) {
  ToneCurve const curves[] = {ToneCurve::linear, ToneCurve::reinhard, ToneCurve::aces, ToneCurve::linear};
  return {curves[int(tone.curve)], double(tone.exposure)};
}

}  // namespace

SceneLoader::~SceneLoader() {
  if (loading_.valid()) loading_.wait();
}

void SceneLoader::start(const std::string& file, bool again) {
  if (busy())
    next_ = file;
  else
    loading_ = std::async(std::launch::async, load, file, again);
}

std::optional<LoadedScene> SceneLoader::take() {
  if (!busy() || loading_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return {};
  LoadedScene loaded = loading_.get();
  if (next_.empty()) return loaded;
  start(std::exchange(next_, {}), false);
  return {};
}

bool isImageFile(const std::string& file) {
  try {
    imageFormatOf(file);
    return true;
  } catch (const Error&) {
    return false;
  }
}

std::string pictureName(const Scene& scene, const Stats& stats, const char* extension) {
  std::string const stem = std::filesystem::path(scene.file).stem().string();
  return fmt::format("{}-{}-{}{}", stem.empty() ? "scene" : stem, nameOf(stats.settings.mode), stats.iterations,
                     extension);
}

void savePicture(const std::string& file, Renderer& renderer, int which, const ToneSettings& tone) {
  auto const [film, stats] = renderer.film(which);
  auto const scene = renderer.scene();
  if (!scene || film.pixels.empty() || stats.iterations == 0)
    throw Error(fmt::format("{}: there is no finished iteration to save yet; try again in a moment", file));
  writeImage(file, film, tonemapOf(tone), imageMetadata(stats.settings, *scene, stats));
}

bool fitRange(ToneSettings& tone, const Image& film) {
  std::vector<float> values;
  for (Rgb p : film.pixels)
    if (float const v = mean(p); std::isfinite(v) && (v > 0 || !tone.falseLogarithmic)) values.push_back(v);
  if (values.empty()) return false;
  auto const at = [&](double share) {
    auto const nth = values.begin() + std::ptrdiff_t(share * double(values.size() - 1));
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
  };
  tone.falseLow = at(0.01);
  tone.falseHigh = std::max(at(0.99), tone.falseLow + 1e-6f * std::abs(tone.falseLow) + 1e-30f);
  return true;
}

}  // namespace ropelight::view
