// What an integrator is said to need against what it takes, and how much memory there is.

#include "render/prepare/memory_need.h"

#include <doctest/doctest.h>

#include "render/backend/available_memory.h"
#include "render/backend/devices.h"
#include "render/core/error.h"
#include "tests/support/rendering.h"
#include "tests/support/temporary_folder.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

namespace fs = std::filesystem;

Scene litQuad() {
  Scene scene = emptyScene(0.5f);
  addQuad(scene, {-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
  addQuad(scene, {-1, -1, 2}, {0, 2, 0}, {2, 0, 0}).emission = Emission{Rgb(1.0f), Side::both};
  return scene;
}

void putFile(const fs::path& path, const std::string& text) {
  fs::create_directories(path.parent_path());
  putBytes(path, text);
}

constexpr std::uint64_t mib = 1 << 20;

}  // namespace

TEST_CASE("what an integrator is said to need is what its ledger has") {
  for (Mode const mode : {Mode::ray, Mode::path, Mode::sppm})
    for (const auto& [width, height] : {std::pair(64, 48), std::pair(13, 7), std::pair(512, 300), std::pair(300, 1)}) {
      Settings settings = settingsFor(mode, width, height);
      settings.photons = std::uint64_t(width) * 100;
      CAPTURE(nameOf(mode));
      CAPTURE(width);
      Stats const stats = makeIntegrator(litQuad(), settings, {BackendKind::cpu, 0, 0, false})->stats();
      auto const need = memoryNeed(stats.settings, stats.features, cpuDevice(0).memory);
      for (const auto& [purpose, bytes] : need) CHECK_MESSAGE(stats.bytes.at(purpose) == bytes, purpose);
      for (const char* purpose : {"film", "gather points", "photons", "photon paths", "grid"})
        CHECK(need.count(purpose) == stats.bytes.count(purpose));
    }
}

TEST_CASE("the photons' budget bounds what they are said to need") {
  Settings settings = settingsFor(Mode::sppm, 16, 16);
  settings.photons = 1u << 28;
  settings.photonMemory = 100;
  auto const need = memoryNeed(settings, feature::photons, 1ull << 40);
  CHECK(need.at("photons") + need.at("photon paths") + need.at("grid") <= 100 * mib + 1024);
}

TEST_CASE("more than there is is refused before it is taken") {
  Settings settings = settingsFor(Mode::path, 16, 16);
  settings.photons = 1;
  CHECK(imageBytes(settings) == 16 * 16 * 12);
  auto const integrator = makeIntegrator(litQuad(), settings, {BackendKind::cpu, 0, 0, false});
  Settings huge = settings;
  huge.width = huge.height = 16384;
  if (availableMemory() > 12 * 1024 * mib) return;  // there is that much
  CHECK_THROWS_AS(makeIntegrator(litQuad(), huge, {BackendKind::cpu, 0, 0, false}), Error);
  CHECK_THROWS_AS(integrator->restart(litQuad().camera, huge), Error);
  CHECK(integrator->advance(1));
}

TEST_CASE("available memory is the least of the machine's and of every control group's") {
  TemporaryFolder const root;
  CHECK(availableMemory(root.path()) > 0);
  putFile(root / "proc/meminfo", "MemTotal: 9000000 kB\nMemAvailable:  2097152 kB\nSwapFree: 1048576 kB\n");
  std::uint64_t const machine = availableMemory(root.path());
  CHECK(machine <= 3072 * mib);

  putFile(root / "proc/self/cgroup", "0::/user/shell\n");
  putFile(root / "sys/fs/cgroup/user/shell/memory.max", "max\n");
  putFile(root / "sys/fs/cgroup/user/shell/memory.current", "1000\n");
  CHECK(availableMemory(root.path()) == machine);
  CHECK(groupMemoryLimit(root.path()) == unknownMemory);

  putFile(root / "sys/fs/cgroup/user/memory.max", std::to_string(512 * mib));
  putFile(root / "sys/fs/cgroup/user/memory.current", std::to_string(200 * mib));
  putFile(root / "sys/fs/cgroup/user/memory.stat", "anon 5\ninactive_file " + std::to_string(50 * mib) + "\n");
  CHECK(availableMemory(root.path()) == 362 * mib);
  CHECK(groupMemoryLimit(root.path()) == 512 * mib);

  putFile(root / "proc/self/cgroup", "5:cpu,memory:/job\n0::/\n");
  putFile(root / "sys/fs/cgroup/memory/job/memory.limit_in_bytes", std::to_string(64 * mib));
  putFile(root / "sys/fs/cgroup/memory/job/memory.usage_in_bytes", std::to_string(70 * mib));
  CHECK(availableMemory(root.path()) == 0);
}
