#include "app/run/report.h"

#include <fmt/format.h>

#include <limits>

#include "app/arguments/values.h"
#include "app/run/version.h"
#include "render/core/features.h"

namespace ropelight {
namespace {

double rate(std::uint64_t count, double seconds) { return seconds > 0 ? double(count) / seconds : 0; }

MetadataValue metadataValue(double value) { return value; }
template <ChoiceEnum E>
MetadataValue metadataValue(E value) {
  return std::string(nameOf(value));
}
MetadataValue metadataValue(bool value) { return formatValue(value); }
MetadataValue metadataValue(int value) { return std::int64_t(value); }
MetadataValue metadataValue(std::uint64_t value) {
  if (value > std::uint64_t(std::numeric_limits<std::int64_t>::max())) return formatValue(value);
  return std::int64_t(value);
}

}  // namespace

nlohmann::ordered_json toJson(Settings settings) {
  nlohmann::ordered_json json;
  settings.params([&](const char* name, const auto& value, const ParamInfo&) { json[name] = written(value); });
  return json;
}

nlohmann::ordered_json toJson(const Stats& s) {
  nlohmann::ordered_json json{
      {"iterations", s.iterations},
      {"seconds", s.seconds},
      {"rays", s.rays},
      {"shadowRays", s.shadowRays},
      {"photonPaths", s.photonPaths},
      {"photonsStored", s.photonsStored},
      {"nonFinite", s.nonFinite},
      {"nonFiniteBy", s.nonFiniteBy},
      {"regrown", s.regrown},
      {"chunks", s.chunks},
      {"truncatedPaths", s.truncatedPaths},
      {"firstRadius", s.firstRadius},
      {"radius", s.radius},
      {"firstCausticRadius", s.firstCausticRadius},
      {"causticRadius", s.causticRadius},
      {"advice", s.advice},
      {"accel", s.accel},
      {"treeNodes", s.treeNodes},
      {"treeLeaves", s.treeLeaves},
      {"treeDepth", s.treeDepth},
      {"treeSeconds", s.treeSeconds},
      {"treeCost", s.treeCost},
      {"kernelRow", s.kernelRow},
      {"device", s.device},
  };
  auto features = nlohmann::ordered_json::array();
  for (const FeatureName& f : featureNames)
    if (s.features & f.bit) features.push_back(f.name);
  json["features"] = features;
  json["bytes"] = s.bytes;
  json["launches"] = s.launches;
  json["stageSeconds"] = s.stageSeconds;
  return json;
}

double iterationRate(const Stats& stats) { return rate(stats.iterations, stats.seconds); }
double megaRays(const Stats& stats) { return rate(stats.rays + stats.shadowRays, stats.seconds) / 1e6; }
double megaPhotons(const Stats& stats) { return rate(stats.photonPaths, stats.seconds) / 1e6; }

Metadata imageMetadata(Settings resolvedSettings, const Scene& scene, const Stats& stats) {
  Metadata data;
  resolvedSettings.params(
      [&](const char* name, const auto& value, const ParamInfo&) { data.emplace_back(name, metadataValue(value)); });
  data.emplace_back("iterations", metadataValue(stats.iterations));
  data.emplace_back("seconds", stats.seconds);
  data.emplace_back("device", stats.device);
  data.emplace_back("version", version);
  data.emplace_back("scene", scene.file);
  return data;
}

}  // namespace ropelight
