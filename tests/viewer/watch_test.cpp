// Files written again are noticed once, and not before they are whole.

#include <doctest/doctest.h>

#include "app/viewer/watch.h"
#include "tests/support/scene_files.h"

using namespace ropelight;
using namespace ropelight::view;

namespace {

/// A scene with one mesh, whose files get times a second apart, so that no file system is too coarse for them.
struct Files {
  TemporaryFolder folder;
  Scene scene;
  Watch watch;
  int writes = 0;

  Files() {
    scene.file = put("scene.json", "{}");
    scene.meshes.resize(1);
    scene.meshes[0].file = put("meshes/ball.obj", "v 0 0 0");
    watch.start(scene);
  }
  std::string put(const std::string& name, const std::string& text) {
    std::string const path = writeFile(folder, name, text);
    std::filesystem::last_write_time(path, std::filesystem::last_write_time(path) + std::chrono::seconds(++writes));
    return path;
  }
  /// Times at which a change is reported, looking 100 times a second.
  std::vector<double> reports(double from, double to) {
    std::vector<double> times;
    for (int i = int(from * 100); i < int(to * 100); ++i)
      if (watch.changed(i / 100.0)) times.push_back(i / 100.0);
    return times;
  }
};

}  // namespace

TEST_CASE("a quiet scene has not changed") {
  Files files;
  CHECK(files.reports(0, 5).empty());
}

TEST_CASE("a change is reported once, soon, for scene and mesh alike") {
  for (const char* name : {"scene.json", "meshes/ball.obj"}) {
    CAPTURE(name);
    Files files;
    CHECK(files.reports(0, 1).empty());
    files.put(name, "longer than before");
    std::vector<double> const times = files.reports(1, 3);
    REQUIRE(times.size() == 1);
    CHECK(times[0] <= 1.36);
  }
}

TEST_CASE("a new time of the same size, and a new size at the same time, are changes") {
  Files files;
  files.put("scene.json", "[]");
  CHECK(files.reports(0, 1).size() == 1);
  auto const time = std::filesystem::last_write_time(files.scene.file);
  putBytes(files.scene.file, "[   ]");
  std::filesystem::last_write_time(files.scene.file, time);
  CHECK(files.reports(1, 2).size() == 1);
}

TEST_CASE("a file that is still growing is waited for") {
  Files files;
  std::string text = "{";
  for (double t = 0; t < 2; t += 0.1) {
    files.put("scene.json", text += " ");
    CHECK(files.reports(t, t + 0.1).empty());
  }
  CHECK(files.reports(2, 3).size() == 1);
}

TEST_CASE("a missing file is no change; one that comes back is, if it is another") {
  Files files;
  std::filesystem::path const aside = files.folder / "aside";
  std::filesystem::rename(files.scene.file, aside);
  CHECK(files.reports(0, 1).empty());
  std::filesystem::rename(aside, files.scene.file);
  CHECK(files.reports(1, 2).empty());
  std::filesystem::remove(files.scene.file);
  CHECK(files.reports(2, 3).empty());
  files.put("scene.json", "{ }");
  CHECK(files.reports(3, 4).size() == 1);
}

TEST_CASE("looks are rare, and another scene starts anew") {
  Files files;
  CHECK_FALSE(files.watch.changed(1));
  files.put("scene.json", "{  }");
  CHECK_FALSE(files.watch.changed(1.24));
  CHECK_FALSE(files.watch.changed(1.25));  // seen
  CHECK_FALSE(files.watch.changed(1.34));
  CHECK(files.watch.changed(1.36));  // settled
  files.put("scene.json", "{   }");
  files.watch.start(files.scene);
  CHECK(files.reports(0, 2).empty());
}

TEST_CASE("a scene without files, and one of files that are not there, are watched in peace") {
  Watch watch;
  CHECK_FALSE(watch.changed(0));
  Scene scene;
  watch.start(scene);
  CHECK_FALSE(watch.changed(1));
  scene.file = "/nowhere/at/all.json";
  watch.start(scene);
  CHECK_FALSE(watch.changed(2));
}
