// What every benchmark begins with.

#include "app/bench/bench.h"
#include "app/bench/results/result.h"
#include "render/backend/devices.h"

namespace ropelight {

bool fullSizes(const BenchOptions& options) { return options.full || chooseBackend(options.scene.backend).cuda; }

BenchResult startResult(const char* bench, const std::string& device, const BenchOptions& options,
                        const std::string& settings) {
  BenchResult result;
  result.bench = bench;
  result.device = device;
  result.threads = options.scene.backend.threads;
  result.seed = options.scene.settings.seed;
  result.settings = settings;
  result.repeat = options.repeat;
  return result;
}

}  // namespace ropelight
