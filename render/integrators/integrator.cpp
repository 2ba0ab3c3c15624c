#include "render/integrators/integrator.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/backend/devices.h"
#include "render/core/error.h"
#include "render/integrators/factory.h"

namespace ropelight {
namespace {

struct MakerRow {
  const char* mode;
  const char* row;
  Maker cpu;
  Maker cuda;
};

#if ROPELIGHT_CUDA
#define RL_MAKER(mode, row) MakerRow{#mode, #row, cpu::make_##mode##_##row, cuda::make_##mode##_##row},
#else
#define RL_MAKER(mode, row) MakerRow{#mode, #row, cpu::make_##mode##_##row, nullptr},
#endif
#define RL_MAKER_ROWS(mode) RL_MAKER(mode, basic) RL_MAKER(mode, mesh) RL_MAKER(mode, full) RL_MAKER(mode, coincident)

const MakerRow makers[] = {RL_MODES(RL_MAKER_ROWS)};

const MakerRow& makerFor(const std::string& mode, const std::string& row) {
  return *std::find_if(std::begin(makers), std::end(makers),
                       [&](const MakerRow& m) { return mode == m.mode && row == m.row; });
}

}  // namespace

std::vector<std::string> modeNames() {
  std::vector<std::string> names;
  Settings().params([&](const std::string& name, const auto&, const ParamInfo& info) {
    if (name == "mode") names = choicesOf(info);
  });
  return names;
}

std::unique_ptr<Integrator> makeIntegrator(const Scene& scene, const Settings& settings, const BackendChoice& choice,
                                           std::string* why, std::shared_ptr<SceneCache> cache) {
  ChosenBackend const chosen = chooseBackend(choice);
  if (why) *why = chosen.why;
  BackendChoice resolvedChoice = choice;
  resolvedChoice.gpu = chosen.gpu;
  if (!cache) cache = makeSceneCache(scene);
  Prepared const prepared = prepare(scene, settings, resolvedChoice, chosen.cuda, *cache);
  const MakerRow& maker = makerFor(integratorName(prepared.settings), rowFor(prepared.features).name);
  return (chosen.cuda ? maker.cuda : maker.cpu)(prepared);
}

}  // namespace ropelight
