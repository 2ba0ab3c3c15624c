#include "app/converge/report/json.h"

#include "app/run/report.h"

namespace ropelight {
namespace {

using Json = nlohmann::ordered_json;

Json toJson(const StudyRun& run) {
  Json samples = Json::array();
  for (const ErrorSample& s : run.samples)
    samples.push_back({{"seconds", s.seconds},
                       {"iterations", s.iterations},
                       {"relmse", s.metrics.relMse},
                       {"relmse-trimmed", s.metrics.relMseTrimmed},
                       {"mse", s.metrics.mse},
                       {"mean", s.metrics.meanError},
                       {"non-finite", s.metrics.nonFinite}});
  return {{"seed", run.seed}, {"samples", samples}};
}

Json toJson(const StudyMode& mode) {
  Json runs = Json::array();
  for (const StudyRun& run : mode.runs) runs.push_back(toJson(run));
  return {{"mode", mode.label},
          {"accel", mode.accel},
          {"kernels", mode.kernels},
          {"setupSeconds", mode.setupSeconds},
          {"treeSeconds", mode.treeSeconds},
          {"firstIterationSeconds", mode.firstIterationSeconds},
          {"mse", mode.split.mse},
          {"bias2", mode.split.bias2},
          {"variance", mode.split.variance},
          {"flip", mode.pictureFlip},
          {"edgePixels", mode.pictureEdges.pixels},
          {"edgeError", mode.pictureEdges.error},
          {"warning", mode.referenceWarning},
          {"settings", ropelight::toJson(mode.settings)},
          {"runs", runs}};
}

Json toJson(const StudyScene& scene) {
  Json modes = Json::array();
  for (const StudyMode& mode : scene.modes) modes.push_back(toJson(mode));
  return {{"scene", scene.name},
          {"file", scene.file},
          {"device", scene.device},
          {"loadSeconds", scene.loadSeconds},
          {"reference", scene.reference.origin},
          {"referenceNoise", scene.reference.noise},
          {"epsilon", scene.reference.epsilon},
          {"modes", modes}};
}

}  // namespace

nlohmann::ordered_json toJson(const Study& study) {
  Json scenes = Json::array();
  for (const StudyScene& scene : study.scenes) scenes.push_back(toJson(scene));
  return {{"command", study.command},   {"version", study.version},
          {"threads", study.threads},   {"startSeconds", study.startSeconds},
          {"seconds", study.seconds},   {"iterations", study.iterations},
          {"seeds", study.seeds},       {"trimmed", study.trimmed},
          {"complete", study.complete}, {"scenes", scenes}};
}

}  // namespace ropelight
