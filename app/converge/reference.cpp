#include "app/converge/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/report.h"
#include "render/core/error.h"
#include "render/core/features.h"
#include "render/film/exr.h"

namespace ropelight {
namespace {

constexpr int largestTile = 32, tilesAcross = 16;
constexpr double farOff = 0.08;  // of the scenes at hand one's glimpse is within 2%, another's 8 to 36% off
constexpr std::uint64_t seedStep = 0x9E3779B97F4A7C15u;  // the halves' seeds: far from those that people choose

std::string textOf(const MetadataValue& value) {
  if (auto const* text = std::get_if<std::string>(&value)) return *text;
  if (auto const* number = std::get_if<double>(&value)) return fmt::format("{}", *number);
  return fmt::format("{}", std::get<std::int64_t>(value));
}

std::optional<std::string> find(const Metadata& metadata, const std::string& key) {
  for (const auto& [name, value] : metadata)
    if (name == key) return textOf(value);
  return std::nullopt;
}

std::string stemOf(const std::string& file) { return std::filesystem::path(file).stem().string(); }

void requireSize(const std::string& file, const Image& image, const Settings& resolved) {
  if (image.width != resolved.width || image.height != resolved.height)
    throw Error(
        fmt::format("{}: it has {} x {} pixels and the runs have {} x {}; give --width {} --height {}, or a "
                    "reference of that size",
                    file, image.width, image.height, resolved.width, resolved.height, image.width, image.height));
  if (!std::all_of(image.pixels.begin(), image.pixels.end(), isFinitePixel))
    throw Error(fmt::format("{}: it has pixels that are not finite; render it again", file));
}

void requireColours(const std::string& file) {
  if (std::string const colours = foreignColours(file); !colours.empty())
    throw Error(fmt::format("{}: its colours are not linear Rec. 709's but have {}; convert it first", file, colours));
}

/// What ropelight wrote of the rendering must fit; a file of another program says nothing.
void requireMetadata(const std::string& file, const Metadata& metadata, const Scene& scene, const Settings& resolved) {
  if (auto const of = find(metadata, "scene"); of && stemOf(*of) != stemOf(scene.file))
    throw Error(fmt::format("{}: it was rendered of the scene '{}', not of '{}'; render one of this scene", file,
                            stemOf(*of), stemOf(scene.file)));
  Settings settings = resolved;
  settings.params([&](const std::string& name, const auto& value, const ParamInfo&) {
    bool const matters = name == "aov" || name == "max-depth" || name == "indirect-only";
    auto const found = matters ? find(metadata, name) : std::nullopt;
    std::string const wanted = fmt::format("{}", value);
    if (found && *found != wanted)
      throw Error(fmt::format("{}: it was rendered with {} {}, and the runs have {}; give --{} {} or another reference",
                              file, name, *found, wanted, name, *found));
  });
}

std::string originOf(const std::string& file, const Metadata& metadata) {
  auto const mode = find(metadata, "mode");
  if (!mode) return file;
  std::string const made =
      find(metadata, "reference-origin")
          .value_or(fmt::format("{}, {} iterations", *mode, find(metadata, "iterations").value_or("?")));
  return fmt::format("{} ({})", file, made);
}

std::optional<double> noiseOf(const ReferenceOptions& options, const Metadata& metadata) {
  if (options.noise) return options.noise;
  auto const stated = find(metadata, "reference-noise");
  return stated ? std::optional(std::stod(*stated)) : std::nullopt;
}

double epsilonOf(const ReferenceOptions& options, const Image& image) {
  return compareImages(image, image, {.epsilon = options.epsilon}).epsilon;
}

/// One half of a reference, and what the whole is told by.
struct Half {
  Image film;
  Stats stats;
};

Half renderHalf(Integrator& integrator, const ReferenceOptions& options) {
  double const seconds = options.seconds / 2;
  std::uint64_t const iterations = std::max<std::uint64_t>(1, options.iterations / 2);
  do {
    Stats const so = integrator.stats();
    std::uint64_t batch = 1;
    if (options.seconds > 0 && so.seconds > 0)
      batch = std::uint64_t(std::clamp((seconds - so.seconds) / so.seconds * double(so.iterations), 1.0,
                                       std::min(4096.0, double(so.iterations))));
    if (options.seconds == 0) batch = std::min<std::uint64_t>(64, iterations - so.iterations);
    integrator.advance(int(batch));
  } while (options.seconds > 0 ? integrator.stats().seconds < seconds : integrator.stats().iterations < iterations);
  return {integrator.film(), integrator.stats()};
}

/// The mean of two halves of m and n iterations; ((a − b)²·m·n)/(m + n)² estimates the square of its own error.
Image meanOf(const Half& a, const Half& b) {
  double const m = double(a.stats.iterations), n = double(b.stats.iterations);
  Image mean(a.film.width, a.film.height);
  for (std::size_t i = 0; i < mean.pixels.size(); ++i)
    mean.pixels[i] = Rgb((Vec3d(a.film.pixels[i]) * m + Vec3d(b.film.pixels[i]) * n) / (m + n));
  return mean;
}

void measureNoise(const Half& a, const Half& b, StudyReference& reference) {
  double const m = double(a.stats.iterations), n = double(b.stats.iterations), share = m * n / ((m + n) * (m + n));
  double relative = 0, squares = 0;
  for (std::size_t i = 0; i < reference.image.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      double const d = double(a.film.pixels[i][c]) - double(b.film.pixels[i][c]);
      double const mean = double(reference.image.pixels[i][c]);
      squares += d * d * share;
      if (d != 0) relative += d * d * share / (mean * mean + reference.epsilon);
    }
  double const values = 3.0 * double(reference.image.pixels.size());
  reference.noise = relative / values;
  reference.variance = squares / values;
}

Settings settingsOf(const ReferenceOptions& options, const Scene& scene, const Settings& base) {
  bool const specular = std::any_of(scene.materials.begin(), scene.materials.end(), [](const NamedMaterial& m) {
    return !std::holds_alternative<DiffuseParams>(m.desc);
  });
  std::string const label = !options.mode.empty() ? options.mode : (specular ? "sppm" : "path");
  std::vector<ModeSpec> const specs = parseModes(label, base);
  if (specs.size() != 1) throw Error(fmt::format("--reference-mode {}: name one mode", options.mode), ExitCode::usage);
  return specs[0].settings;
}

}  // namespace

std::string forScene(const std::string& pattern, const Scene& scene) {
  static const std::string place = "{scene}";
  std::string text = pattern;
  for (std::size_t at = 0; (at = text.find(place, at)) != std::string::npos;) {
    std::string const name = stemOf(scene.file);
    text.replace(at, place.size(), name);
    at += name.size();
  }
  return text;
}

StudyReference readReference(const ReferenceOptions& options, const Scene& scene, const Settings& resolved) {
  std::string const file = forScene(options.file, scene);
  StudyReference reference;
  reference.image = readExr(file);
  Metadata const metadata = readExrMetadata(file);
  requireColours(file);
  requireSize(file, reference.image, resolved);
  requireMetadata(file, metadata, scene, resolved);
  reference.origin = originOf(file, metadata);
  reference.epsilon = epsilonOf(options, reference.image);
  reference.noise = noiseOf(options, metadata).value_or(unknown);
  if (auto const variance = find(metadata, "reference-variance")) reference.variance = std::stod(*variance);
  reference.knownScene = find(metadata, "scene").has_value();
  return reference;
}

StudyReference makeReference(const ReferenceOptions& options, const Scene& scene, const Settings& base,
                             const BackendChoice& backend, std::shared_ptr<SceneCache> cache) {
  Settings settings = settingsOf(options, scene, base);
  settings.seed = base.seed ^ seedStep;
  auto const integrator = makeIntegrator(scene, settings, backend, nullptr, std::move(cache));
  Half const first = renderHalf(*integrator, options);
  settings.seed += seedStep;
  if (!integrator->restart(scene.camera, settings))
    throw Error("the reference's second half needs another integrator", ExitCode::internal);
  Half const second = renderHalf(*integrator, options);

  StudyReference reference;
  reference.image = meanOf(first, second);
  reference.epsilon = epsilonOf(options, reference.image);
  measureNoise(first, second, reference);
  reference.origin =
      fmt::format("{}, two halves of {} and {} iterations in {:.1f} s on {}", settings.mode, first.stats.iterations,
                  second.stats.iterations, first.stats.seconds + second.stats.seconds, second.stats.device);
  reference.stats = second.stats;
  reference.stats.iterations += first.stats.iterations;
  reference.stats.seconds += first.stats.seconds;
  reference.knownScene = true;
  return reference;
}

void saveReference(const ReferenceOptions& options, const StudyReference& reference, const Scene& scene) {
  Metadata metadata = imageMetadata(reference.stats.settings, scene, reference.stats);
  metadata.emplace_back("reference-origin", reference.origin);
  metadata.emplace_back("reference-noise", reference.noise);
  metadata.emplace_back("reference-variance", reference.variance);
  writeExr(forScene(options.save, scene), reference.image, metadata);
}

void requireSameScene(const Image& glimpse, const StudyReference& reference) {
  int const tile = std::clamp(glimpse.width / tilesAcross, 1, largestTile);
  Image const seen = tileMeans(glimpse, tile), wanted = tileMeans(reference.image, tile);
  auto const grey = [](Rgb c) { return (double(c.x) + double(c.y) + double(c.z)) / 3; };
  double all = 0;
  for (const Rgb& c : wanted.pixels) all += grey(c) / double(wanted.pixels.size());
  std::size_t off = 0;
  for (std::size_t i = 0; i < seen.pixels.size(); ++i) {
    double const expected = grey(wanted.pixels[i]);
    off += !(std::abs(grey(seen.pixels[i]) - expected) <= farOff * std::max(expected, all));
  }
  if (2 * off > seen.pixels.size())
    throw Error(
        fmt::format("{}: it does not show this scene: {} of {} tiles of {} x {} pixels are off by more than "
                    "{:.0f}%; give a reference of this scene, camera and exposure",
                    reference.origin, off, seen.pixels.size(), tile, tile, 100 * farOff));
}

}  // namespace ropelight
