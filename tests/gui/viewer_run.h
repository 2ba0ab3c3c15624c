#pragma once
// The real program in a real window, its input a script, its state as JSON.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>

#include "render/image_files/png.h"
#include "tests/gui/virtual_display.h"
#include "tests/support/program.h"

namespace ropelight {

class ViewerRun {
 public:
  TemporaryFolder const folder;

  /// The CPU, unless ROPELIGHT_TEST_BACKEND says otherwise.
  static std::string backend() {
    const char* const name = std::getenv("ROPELIGHT_TEST_BACKEND");
    return name ? name : "cpu";
  }

  /// False, with a message, where no window can be opened here.
  static bool possible() {
    if (!VirtualDisplay::name().empty()) return true;
    MESSAGE("skipped: no Xvfb; install the Debian packages xvfb and libgl1-mesa-dri");
    return false;
  }

  /// The program's arguments for a small, quick film on the CPU; `script` goes to a file.
  std::vector<std::string> arguments(const std::string& scene, const std::string& script,
                                     std::vector<std::string> more = {}) {
    std::vector<std::string> all{"DISPLAY=" + VirtualDisplay::name(),
                                 VirtualDisplay::givenName().empty() ? "LIBGL_ALWAYS_SOFTWARE=1" : "GL=given",
                                 "ASAN_OPTIONS=detect_leaks=0",  // GL drivers leave some, in modules long unloaded
                                 "XDG_CONFIG_HOME=" + (folder / "config").string(),
                                 ROPELIGHT_PROGRAM,
                                 "view",
                                 scene,
                                 "--backend",
                                 backend(),
                                 "--width",
                                 "64",
                                 "--height",
                                 "48",
                                 "--photons",
                                 "2000",
                                 "--window",
                                 "900x700"};
    if (!script.empty()) {
      putBytes(folder / "script.txt", script);
      all.insert(all.end(), {"--script", "script.txt"});
    }
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }

  /// Runs to the end; the exit code is 0, or the test fails with what the program said.
  void run(const std::string& scene, const std::string& script, const std::vector<std::string>& more = {}) {
    Program program("/usr/bin/env", arguments(scene, script, more), folder.path());
    int const code = program.exitCode(400);
    INFO(program.err());
    REQUIRE(code == 0);
  }

  nlohmann::json state(const std::string& name) const {
    std::string const text = fileBytes(folder / name);
    INFO("state file " << name);
    REQUIRE_FALSE(text.empty());
    return nlohmann::json::parse(text);
  }
};

}  // namespace ropelight
