#include "app/viewer/state_report.h"

#include <fmt/format.h>
#include <imgui.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <fstream>

#include "app/run/report.h"
#include "app/viewer/widgets/widgets.h"

namespace ropelight::view {
namespace {

using Json = nlohmann::ordered_json;

const char* const layoutNames[] = {"single", "split", "sideBySide", "flicker", "difference"};
const char* const curveNames[] = {"linear", "reinhard", "aces", "falseColour"};

std::uint64_t residentBytes() {
  std::ifstream in("/proc/self/statm");
  std::uint64_t size = 0, resident = 0;
  in >> size >> resident;
  return resident * std::uint64_t(sysconf(_SC_PAGESIZE));
}

/// FNV-1a, 64 bits: equal buffers have equal ones.
std::string hashOf(const std::vector<float>& values) {
  std::uint64_t hash = 14695981039346656037ull;
  for (float v : values) {
    std::uint32_t bits;
    std::memcpy(&bits, &v, sizeof bits);
    for (int shift = 0; shift < 32; shift += 8) hash = (hash ^ ((bits >> shift) & 0xFF)) * 1099511628211ull;
  }
  return fmt::format("{:016x}", hash);
}

Json describe(const EstimateStatus& e, int which, Picture& picture) {
  std::vector<float> const pixels = which == reference ? std::vector<float>{} : picture.pixelBuffer(which);
  std::uint64_t nonFinite = 0;
  for (float v : pixels) nonFinite += std::isfinite(v) ? 0 : 1;
  std::uint64_t bytes = 0;
  for (const auto& entry : e.stats.bytes) bytes += entry.second;
  return {{"ready", e.ready},
          {"building", e.building},
          {"draft", e.draft},
          {"problem", e.problem},
          {"width", e.width},
          {"height", e.height},
          {"iterations", e.stats.iterations},
          {"shownIterations", which == reference ? 0 : picture.iterations(which)},
          {"seconds", e.stats.seconds},
          {"photons", e.photonCount},
          {"nonFiniteSamples", e.stats.nonFinite},
          {"nonFinitePixels", nonFinite},
          {"pixelHash", hashOf(pixels)},
          {"deviceBytes", bytes},
          {"treeNodes", e.stats.treeNodes},
          {"errors", e.errors.size()},
          {"latestError", e.errors.empty() ? 0.0 : e.errors.back().relMse},
          {"slope", std::isfinite(e.slope) ? Json(e.slope) : Json()},
          {"settings", toJson(e.stats.settings)}};
}

Json vector(Vec3d v) { return {v.x, v.y, v.z}; }

Json describe(const CameraDesc& c) {
  return {{"position", vector(c.position)}, {"target", vector(c.target)},   {"up", vector(c.up)},
          {"fov", c.verticalFov},           {"aperture", c.apertureRadius}, {"focus", c.focusDistance}};
}

Json widgets() {
  Json all = Json::object();
  for (const auto& [name, place] : widgetPlaces())
    if (place.frame >= ImGui::GetFrameCount() - 1 && place.visible)
      all[name] = {place.left, place.top, place.right, place.bottom};
  return all;
}

Json describe(const ViewState& s) {
  return {{"curve", curveNames[int(s.tone.curve)]},
          {"exposure", s.tone.exposure},
          {"compare", s.compare.enabled},
          {"layout", layoutNames[int(s.compare.layout)]},
          {"split", s.compare.split},
          {"photonsShown", s.photons.shown},
          {"treeShown", s.tree.shown},
          {"paused", s.paused},
          {"panelShown", s.panelShown},
          {"helpShown", s.helpShown},
          {"inspectorShown", s.inspectorShown},
          {"plotShown", s.plotShown},
          {"recent", s.recent}};
}

}  // namespace

Json stateReport(const PanelContext& context, Picture& picture, const Window& window, const FrameCounts& counts,
                 int selection) {
  Size const size = window.windowSize(), pixels = window.framebufferSize();
  Rect const shown = picture.pictureRect(0);
  return {{"scene", context.sceneName},
          {"sceneNotes", context.sceneNotes},
          {"scenesLoaded", counts.scenes},
          {"problem", context.problem},
          {"notice", context.notice},
          {"backend", context.backend},
          {"display", context.displayPath},
          {"displayMs",
           {{"upload", context.displayTimes.upload},
            {"draw", context.displayTimes.draw},
            {"cpu", context.displayTimes.cpu}}},
          {"gl", window.glVersion()},
          {"glRenderer", window.glRenderer()},
          {"window", {size.width, size.height}},
          {"framebuffer", {pixels.width, pixels.height}},
          {"picture", {shown.x, shown.y, shown.width, shown.height}},
          {"frames", counts.frames},
          {"seconds", counts.seconds},
          {"frameMs", {{"median", counts.medianMs}, {"slowest", counts.slowestMs}}},
          {"residentBytes", residentBytes()},
          {"camera", describe(context.camera.camera())},
          {"selection", selection},
          {"view", describe(context.state)},
          {"A", describe(context.estimates[estimateA], estimateA, picture)},
          {"B", describe(context.estimates[estimateB], estimateB, picture)},
          {"reference",
           {{"present", context.reference.present},
            {"name", context.reference.name},
            {"iterations", context.reference.iterations},
            {"problem", context.reference.problem}}},
          {"widgets", widgets()}};
}

}  // namespace ropelight::view
