#include "app/run/accumulate.h"

#include <doctest/doctest.h>

#include "render/import/load.h"
#include "tests/support/rendering.h"

using namespace ropelight;

TEST_CASE("accumulating ends at its goal, and at once where the integrator is interrupted") {
  Scene const scene = loadScene(std::string(ROPELIGHT_ASSETS) + "/cornell.json");
  auto const integrator =
      makeIntegrator(scene, testing::settingsFor(Mode::path, 16, 12), {BackendKind::cpu, 0, 0, false});
  StopOnSignal const stop;
  Accumulated const whole = accumulate(*integrator, {.iterations = 5}, stop, true);
  CHECK_FALSE(whole.interrupted);
  CHECK(integrator->stats().iterations == 5);

  integrator->reset();
  integrator->interrupt();
  Accumulated const cut = accumulate(*integrator, {.iterations = 1000000}, stop, true);
  CHECK(cut.interrupted);
  CHECK(cut.seconds < 10);
}
