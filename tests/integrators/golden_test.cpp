// The films of the assets, bit for bit: work that is meant to change nothing changes no bit.
//
// Bits depend on the C library's sine, on the compiler and on the device, so that each list of hashes names what made
// it and is skipped, with a word, elsewhere. To renew a list, after saying in docs/decisions.md why bits had to change:
//     ROPELIGHT_RENEW_GOLDEN=tests/golden scripts/test.sh --test-case='golden*'

#include <doctest/doctest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>

#include "render/import/load.h"
#include "tests/support/rendering.h"

using namespace ropelight;
using namespace ropelight::testing;
namespace fs = std::filesystem;

namespace {

/// FNV-1a over bytes.
struct Hash {
  std::uint64_t value = 14695981039346656037ull;

  void add(const void* data, std::size_t bytes) {
    const auto* p = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < bytes; ++i) value = (value ^ p[i]) * 1099511628211ull;
  }
  std::string text() const {
    std::ostringstream out;
    out << std::hex << value;
    return out.str();
  }
};

std::string hashOf(const Image& image) {
  Hash hash;
  for (const Rgb& pixel : image.pixels) hash.add(&pixel, sizeof pixel);
  return hash.text();
}

/// Of what the C library and the compiler make of the functions that sampling uses.
std::string mathLibrary() {
  Hash hash;
  for (int i = 0; i < 4096; ++i) {
    volatile float x = float(i) * 0.00153f;
    float const values[] = {std::sin(x), std::cos(x), std::sqrt(x), std::tan(x * 0.2f)};
    hash.add(values, sizeof values);
  }
  return "libm-" + hash.text();
}

std::string makerOf(const BackendChoice& backend) {
  if (backend.backend == BackendKind::cpu) return mathLibrary();
  for (const DeviceInfo& device : listDevices())
    if (device.backend == backend.backend && device.usable) return device.name;
  return "";
}

std::map<std::string, std::string> films(const BackendChoice& backend) {
  std::map<std::string, std::string> found;
  for (const auto& entry : fs::directory_iterator(ROPELIGHT_ASSETS)) {
    if (entry.path().extension() != ".json") continue;
    if (entry.path().stem() == "bumpy" && !fs::exists(fs::path(ROPELIGHT_ASSETS) / "generated/bumpy100k.obj")) continue;
    Scene const scene = loadScene(entry.path());
    for (Mode const mode : {Mode::ray, Mode::path, Mode::sppm})
      found[entry.path().stem().string() + " " + nameOf(mode)] =
          hashOf(renderImage(scene, settingsFor(mode, 128, 128), 8, nullptr, backend));
  }
  return found;
}

/// First line: what made the films. Then a line each: scene, mode, hash.
void write(const fs::path& path, const std::string& maker, const std::map<std::string, std::string>& hashes) {
  std::ofstream out(path);
  out << maker << '\n';
  for (const auto& [film, hash] : hashes) out << film << ' ' << hash << '\n';
}

void compare(const fs::path& path, const std::string& maker, const BackendChoice& backend) {
  std::ifstream in(path);
  REQUIRE(in.good());
  std::string first, scene, mode, hash;
  std::getline(in, first);
  if (first != maker) {
    MESSAGE("skipped: " << path.filename().string() << " was made with '" << first << "', and this is '" << maker
                        << "'");
    return;
  }
  std::map<std::string, std::string> const now = films(backend);
  int compared = 0;
  while (in >> scene >> mode >> hash) {
    auto const found = now.find(scene + " " + mode);
    if (found == now.end()) continue;  // a mesh that was not made
    CAPTURE(scene);
    CAPTURE(mode);
    CHECK(found->second == hash);
    ++compared;
  }
  CHECK(compared >= 18);
}

}  // namespace

TEST_SUITE("slow") {
  TEST_CASE("golden: films of the assets have the bits that they had") {
    for (const BackendChoice& backend : everyBackend()) {
      CAPTURE(nameOf(backend.backend));
      std::string const maker = makerOf(backend), file = std::string(nameOf(backend.backend)) + ".txt";
      if (const char* folder = std::getenv("ROPELIGHT_RENEW_GOLDEN"))
        write(fs::path(folder) / file, maker, films(backend));
      else
        compare(fs::path(ROPELIGHT_GOLDEN) / file, maker, backend);
    }
  }
}
