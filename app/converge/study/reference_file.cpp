#include "app/converge/study/reference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "render/core/error.h"
#include "render/image_files/exr.h"

namespace ropelight {
namespace {

constexpr int largestTile = 32, tilesAcross = 16;
constexpr double farOff = 0.08;  // in our scenes, the same scene is within 2%, another one is 8 to 36% off

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

/// Metadata that ropelight wrote must fit; a file of another program has none.
void requireMetadata(const std::string& file, const Metadata& metadata, const Scene& scene, const Settings& resolved) {
  if (auto const of = find(metadata, "scene"); of && stemOf(*of) != stemOf(scene.file))
    throw Error(fmt::format("{}: it was rendered of the scene '{}', not of '{}'; render one of this scene", file,
                            stemOf(*of), stemOf(scene.file)));
  Settings settings = resolved;
  settings.params([&](const std::string& name, const auto& value, const ParamInfo&) {
    bool const matters = name == "aov" || name == "max-depth" || name == "indirect-only";
    auto const found = matters ? find(metadata, name) : std::nullopt;
    std::string const wanted = fmt::format("{}", written(value));
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

double numberOf(const Metadata& metadata, const std::string& key) {
  for (const auto& [name, value] : metadata)
    if (auto const* number = std::get_if<double>(&value); number && name == key) return *number;
  return unknown;
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

double relativeEpsilon(const Image& reference, std::optional<double> asked) {
  return compareImages(reference, reference, {.epsilon = asked}).epsilon;
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
  reference.epsilon = relativeEpsilon(reference.image, options.epsilon);
  reference.noise = options.noise.value_or(numberOf(metadata, "reference-noise"));
  reference.variance = numberOf(metadata, "reference-variance");
  reference.mode = findChoice<Mode>(find(metadata, "mode").value_or(""));
  return reference;
}

void requireSameScene(const Image& glimpse, const StudyReference& reference) {
  if (glimpse.width != reference.image.width || glimpse.height != reference.image.height)
    throw Error(fmt::format("{}: it is not of the runs' size", reference.origin));
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
