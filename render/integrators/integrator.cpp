#include "render/integrators/integrator.h"

#include <fmt/format.h>

#include <algorithm>

#include "render/backend/devices.h"
#include "render/core/error.h"
#include "render/integrators/factory.h"

namespace ropelight {
namespace {

struct MakerRow {
  IntegratorKind kind;
  FeatureBits covers;
  Maker cpu;
  Maker cuda;
};

#if ROPELIGHT_CUDA
#define RL_MAKER(mode, name) \
  MakerRow{IntegratorKind::mode, row::name, cpu::make_##mode##_##name, cuda::make_##mode##_##name},
#else
#define RL_MAKER(mode, name) MakerRow{IntegratorKind::mode, row::name, cpu::make_##mode##_##name, nullptr},
#endif
#define RL_MAKER_ROWS(mode) RL_MAKER(mode, basic) RL_MAKER(mode, mesh) RL_MAKER(mode, full) RL_MAKER(mode, coincident)

const MakerRow makers[] = {RL_MODES(RL_MAKER_ROWS)};

const MakerRow& makerFor(IntegratorKind kind, const KernelRow& row) {
  return *std::find_if(std::begin(makers), std::end(makers),
                       [&](const MakerRow& m) { return kind == m.kind && row.covers == m.covers; });
}

}  // namespace

std::unique_ptr<Integrator> makeIntegrator(const Scene& scene, const Settings& settings, const BackendChoice& choice,
                                           std::string* why, std::shared_ptr<SceneCache> cache) {
  ChosenBackend const chosen = chooseBackend(choice);
  if (why) *why = chosen.why;
  BackendChoice resolvedChoice = choice;
  resolvedChoice.gpu = chosen.gpu;
  if (!cache) cache = makeSceneCache(scene);
  Prepared const prepared = prepare(scene, settings, resolvedChoice, chosen.cuda, *cache);
  const MakerRow& maker = makerFor(integratorOf(prepared.settings), rowFor(prepared.features));
  return (chosen.cuda ? maker.cuda : maker.cpu)(prepared);
}

}  // namespace ropelight
