// The window, as a person uses it: every step is asserted from saved state and pixels.

#include <cmath>
#include <cstring>
#include <fstream>

#include "render/image_files/exr.h"
#include "tests/gui/viewer_run.h"

#ifdef ROPELIGHT_PROGRAM

namespace ropelight {
namespace {

using nlohmann::json;

double vectorDistance(const json& a, const json& b) {
  double sum = 0;
  for (int i = 0; i < 3; ++i) sum += std::pow(a[i].get<double>() - b[i].get<double>(), 2);
  return std::sqrt(sum);
}

/// Largest difference of a channel in 8-bit levels.
double worstLevel(const Image& a, const Image& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      worst = std::max(worst, std::abs(encodeSrgb(double(a.pixels[i][c])) - encodeSrgb(double(b.pixels[i][c]))) * 255);
  return worst;
}

/// FNV-1a of RGBA floats as the program's state reports it.
std::string hashOf(const Image& image) {
  std::uint64_t hash = 14695981039346656037ull;
  auto const add = [&](float v) {
    std::uint32_t bits;
    std::memcpy(&bits, &v, sizeof bits);
    for (int shift = 0; shift < 32; shift += 8) hash = (hash ^ ((bits >> shift) & 0xFF)) * 1099511628211ull;
  };
  for (Rgb p : image.pixels) {
    for (int c = 0; c < 3; ++c) add(p[c]);
    add(1);
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

/// Within a minute.
bool appears(const std::filesystem::path& file) {
  for (int i = 0; i < 3000 && !std::filesystem::exists(file); ++i) usleep(20000);
  return std::filesystem::exists(file);
}

double mean(const Image& image) {
  double sum = 0;
  for (Rgb p : image.pixels) sum += double(p.x + p.y + p.z) / 3;
  return sum / double(image.pixels.size());
}

}  // namespace

TEST_SUITE_BEGIN("gui");

TEST_CASE("window: the pixel buffer holds the bits that a render without a window gives") {
  if (!ViewerRun::possible()) return;
  ViewerRun run;
  run.run("cornell-caustics", "", {"--frames", "5", "--state", "s.json", "--screenshot", "w.png"});
  json const s = run.state("s.json");
  CHECK(s["A"]["shownIterations"] == 5);
  bool const shares = ViewerRun::backend() == "cuda" && std::getenv("ROPELIGHT_TEST_DISPLAY");
  CHECK(s["display"].get<std::string>().starts_with(shares ? "interop: " : "copy: "));
  Program render(ROPELIGHT_PROGRAM,
                 {"render", "cornell-caustics", "--backend", ViewerRun::backend(), "--width", "64", "--height", "48",
                  "--photons", "2000", "--iterations", "5", "-o", "r.exr"},
                 run.folder.path());
  REQUIRE(render.exitCode() == 0);
  CHECK(s["A"]["pixelHash"] == hashOf(readExr(run.folder / "r.exr")));
  Image const window = readPng(run.folder / "w.png");
  CHECK(window.width == 900);
  CHECK(window.height == 700);
  CHECK(mean(window) > 0.02);
}

TEST_CASE("window: what is seen equals the saved picture within a level, and is neither flipped nor mirrored") {
  if (!ViewerRun::possible()) return;
  ViewerRun run;
  // Sixty frames, since the batch of iterations that runs when the pause is asked for is still taken in.
  run.run("cornell-caustics",
          "wait iterations 3\nkey space\nkey tab\nframes 60\nkey s ctrl\nframes 3\nscreenshot w.png\nkey t\nframes 2\n"
          "screenshot reinhard.png\nkey equal\nframes 2\nkey s ctrl\nframes 2\nquit\n",
          {"--window", "160x120", "--width", "160", "--height", "120", "--no-preferences"});
  std::filesystem::path png, exr;
  for (const auto& entry : std::filesystem::directory_iterator(run.folder.path())) {
    if (entry.path().extension() == ".exr") exr = entry.path();
    if (entry.path().extension() == ".png" && entry.path().stem().string().starts_with("cornell")) png = entry.path();
  }
  REQUIRE_FALSE(exr.empty());
  REQUIRE_FALSE(png.empty());
  Image const film = readExr(exr), seen = readPng(run.folder / "w.png");
  REQUIRE(seen.width == film.width);
  REQUIRE(seen.height == film.height);
  TemporaryFolder const other;
  writePng(other / "linear.png", film);
  CHECK(worstLevel(seen, readPng(other / "linear.png")) <= 1.01);
  writePng(other / "reinhard.png", film, {ToneCurve::reinhard, 0});
  CHECK(worstLevel(readPng(run.folder / "reinhard.png"), readPng(other / "reinhard.png")) <= 1.01);
  writePng(other / "brighter.png", film, {ToneCurve::reinhard, 0.25});
  CHECK(worstLevel(readPng(png), readPng(other / "brighter.png")) ==
        0);  // saved a second time, with curve and exposure
}

TEST_CASE("window: orbit, mode, sliders, compare, overlays and help answer the mouse and the keys") {
  if (!ViewerRun::possible()) return;
  ViewerRun run;
  run.run(
      "cornell-caustics",
      "wait iterations 3\nstate start.json\ndrag 250 350 330 320\nwait ready\nstate orbit.json\n"
      "drag 250 350 300 350 right\nwheel 2\nwait ready\nstate moved.json\nkey r\nwait ready\nstate home.json\n"
      "click view\nclick view/path\nwait ready\nwait iterations 2\nstate path.json\nkey 3\nwait ready\n"
      "set A/photons 777\nwait ready\nwait iterations 2\nstate photons.json\n"
      "key equal\nkey equal\nkey t\nkey c\nwait ready\nwait seconds 1\nstate compare.json\nscreenshot compare.png\n"
      "key p\nkey k\nkey i\nmove 200 300\nwait iterations 2\nframes 5\nstate overlays.json\nscreenshot overlays.png\n"
      "key f1\nframes 3\nstate help.json\nscreenshot help.png\nkey escape\nkey space\nframes 10\nstate paused.json\n"
      "key period\nwait seconds 0.5\nstate stepped.json\nquit\n");
  json const start = run.state("start.json"), orbit = run.state("orbit.json"), moved = run.state("moved.json");
  CHECK(vectorDistance(start["camera"]["position"], orbit["camera"]["position"]) > 0.1);
  CHECK(vectorDistance(start["camera"]["target"], orbit["camera"]["target"]) < 1e-9);
  CHECK(orbit["A"]["pixelHash"] != start["A"]["pixelHash"]);
  CHECK(vectorDistance(orbit["camera"]["target"], moved["camera"]["target"]) > 0.05);
  CHECK(run.state("home.json")["camera"] == start["camera"]);
  CHECK(run.state("path.json")["A"]["settings"]["mode"] == "path");
  json const photons = run.state("photons.json");
  CHECK(photons["A"]["settings"]["mode"] == "sppm");
  CHECK(photons["A"]["settings"]["photons"] == 777);
  json const compare = run.state("compare.json");
  CHECK(compare["view"]["compare"] == true);
  CHECK(compare["view"]["layout"] == "split");
  CHECK(compare["view"]["exposure"] == doctest::Approx(0.5));
  CHECK(compare["view"]["curve"] == "reinhard");
  CHECK(compare["B"]["ready"] == true);
  CHECK(compare["B"]["iterations"] >= 1);
  json const overlays = run.state("overlays.json");
  CHECK(overlays["A"]["photons"] > 100);
  CHECK(overlays["view"]["inspectorShown"] == true);
  CHECK(run.state("help.json")["view"]["helpShown"] == true);
  CHECK(mean(readPng(run.folder / "help.png")) != mean(readPng(run.folder / "overlays.png")));
  json const paused = run.state("paused.json");
  CHECK(paused["view"]["paused"] == true);
  CHECK(paused["view"]["helpShown"] == false);
  CHECK(run.state("stepped.json")["A"]["iterations"] == paused["A"]["iterations"].get<int>() + 1);
  for (const json& s : {start, orbit, compare, overlays}) {
    CHECK(s["problem"] == "");
    CHECK(s["A"]["nonFinitePixels"] == 0);
  }
}

TEST_CASE("window: a dropped scene takes over, a broken one leaves what is there and says what is wrong") {
  if (!ViewerRun::possible()) return;
  ViewerRun run;
  putBytes(run.folder / "broken.json", "{\"shapes\": [{\"type\": \"cube\"}]}");
  run.run("cornell",
          "wait iterations 2\nstate a.json\ndrop broken.json\nwait ready\nwait seconds 0.5\nstate broken.json.out\n"
          "drop missing.json\nwait ready\nwait seconds 0.3\nstate missing.out\n"
          "drop " ROPELIGHT_ASSETS
          "/six-lights.json\nwait seconds 1\nwait ready\nwait iterations 1\nstate six.out\nquit\n");
  json const broken = run.state("broken.json.out");
  CHECK(broken["scene"] == run.state("a.json")["scene"]);
  CHECK(broken["problem"].get<std::string>().find("broken.json") != std::string::npos);
  CHECK(broken["A"]["iterations"] > run.state("a.json")["A"]["iterations"]);
  CHECK(run.state("missing.out")["problem"].get<std::string>().find("missing.json") != std::string::npos);
  json const six = run.state("six.out");
  CHECK(six["scene"].get<std::string>().find("six-lights") != std::string::npos);
  CHECK(six["problem"] == "");
  CHECK(six["scenesLoaded"] == 2);
  CHECK(six["camera"] != broken["camera"]);
}

TEST_CASE("window: 1 x 1 pixels and back, and tiny windows, harm nothing") {
  if (!ViewerRun::possible()) return;
  ViewerRun run;
  run.run("cornell",
          "wait iterations 2\nresize 1 1\nframes 10\nstate small.json\nscreenshot small.png\nresize 300 200\nframes 5\n"
          "resize 1000 800\nframes 10\nwait iterations 5\nstate back.json\nscreenshot back.png\nquit\n");
  CHECK(run.state("small.json")["window"] == json::array({1, 1}));
  CHECK(run.state("back.json")["window"] == json::array({1000, 800}));
  CHECK(run.state("back.json")["problem"] == "");
  CHECK(mean(readPng(run.folder / "back.png")) > 0.02);
}

TEST_CASE("window: a scene file that changes is loaded again, keeps the camera, and survives being broken") {
  if (!ViewerRun::possible()) return;
  ViewerRun run;
  std::string const good = fileBytes(ROPELIGHT_ASSETS "/cornell.json");
  putBytes(run.folder / "scene.json", good);
  Program program("/usr/bin/env",
                  run.arguments("scene.json",
                                "wait iterations 2\ndrag 250 350 330 320\nwait ready\nstate one.json\nwait seconds 3\n"
                                "state two.json\nwait seconds 3\nwait ready\nstate three.json\nquit\n",
                                {"--watch"}),
                  run.folder.path());
  REQUIRE(appears(run.folder / "one.json"));
  putBytes(run.folder / "scene.json", "{ \"camera\": ");
  REQUIRE(appears(run.folder / "two.json"));
  putBytes(run.folder / "scene.json", good);
  INFO(program.err());
  REQUIRE(program.exitCode(400) == 0);
  json const one = run.state("one.json"), two = run.state("two.json"), three = run.state("three.json");
  CHECK(two["problem"].get<std::string>().find("scene.json") != std::string::npos);
  CHECK(two["scenesLoaded"] == 1);
  CHECK(three["scenesLoaded"] == 2);
  CHECK(three["problem"] == "");
  CHECK(vectorDistance(three["camera"]["position"], one["camera"]["position"]) < 1e-12);
}

TEST_CASE("window: errors against a reference fall for both estimates, which share the time") {
  if (!ViewerRun::possible()) return;
  ViewerRun run;
  Program render(ROPELIGHT_PROGRAM,
                 {"render", "cornell", "--backend", ViewerRun::backend(), "--mode", "path", "--width", "64", "--height",
                  "48", "--iterations", "400", "-o", "truth.exr"},
                 run.folder.path());
  REQUIRE(render.exitCode() == 0);
  run.run("cornell",
          "wait iterations 1\nkey c\nclick edit/B\nclick view\nclick view/path\nwait ready\nwait seconds 6\n"
          "state s.json\nscreenshot s.png\nquit\n",
          {"--reference", "truth.exr"});
  json const s = run.state("s.json");
  CHECK(s["A"]["settings"]["mode"] == "sppm");
  CHECK(s["B"]["settings"]["mode"] == "path");
  CHECK(s["A"]["errors"] >= 4);
  CHECK(s["B"]["errors"] >= 4);
  CHECK(s["B"]["latestError"] < 0.5);
  if (ViewerRun::backend() == "cpu") CHECK(s["B"]["slope"] < -0.3);  // a GPU comes to the reference's own noise
}

TEST_CASE("window: preferences last from one run to the next") {
  if (!ViewerRun::possible()) return;
  ViewerRun run;
  run.run("cornell", "wait iterations 1\nkey equal\nkey t\nkey i\nframes 2\nquit\n");
  run.run("cornell", "wait iterations 1\nstate s.json\nquit\n");
  json const s = run.state("s.json");
  CHECK(s["view"]["exposure"] == doctest::Approx(0.25));
  CHECK(s["view"]["curve"] == "reinhard");
  CHECK(s["view"]["inspectorShown"] == true);
  putBytes(run.folder / "config" / "ropelight" / "viewer.json", "{ damaged");
  run.run("cornell", "wait iterations 1\nstate t.json\nquit\n");
  CHECK(run.state("t.json")["view"]["exposure"] == 0);
  CHECK(run.state("t.json")["problem"].get<std::string>().find("viewer.json") != std::string::npos);
}

TEST_CASE("window: real X events reach the same code") {
  if (!ViewerRun::possible()) return;
  if (std::system("command -v xdotool > /dev/null") != 0) {
    MESSAGE("skipped: no xdotool");
    return;
  }
  ViewerRun run;
  Program program("/usr/bin/env", run.arguments("cornell", "", {"--state", "end.json"}), run.folder.path());
  std::string const x = "DISPLAY=" + VirtualDisplay::name() + " timeout 60 xdotool ";
  auto const send = [&](const std::string& command) {
    return std::system((x + command + " > /dev/null 2>&1").c_str());
  };
  REQUIRE(send("search --sync --onlyvisible --name 'cornell.json - sppm - [1-9]'") == 0);
  REQUIRE(send("search --name ropelight windowfocus --sync windowmove 0 0") == 0);
  send(
      "mousemove 250 350 sleep 0.3 mousedown 1 sleep 0.2 mousemove 300 340 sleep 0.2 mousemove 350 330 sleep 0.2 "
      "mouseup 1");
  send("sleep 0.3 key p sleep 0.3 key F1 sleep 0.3");
  // Without a window manager the focus may be lost on the way; a window that is gone takes no more keys.
  for (int i = 0; i < 10 && !std::filesystem::exists(run.folder / "end.json"); ++i)
    send("search --name ropelight windowfocus key ctrl+q sleep 3");
  INFO(program.err());
  REQUIRE(program.exitCode(400) == 0);
  json const s = run.state("end.json");
  CHECK(s["view"]["photonsShown"] == true);
  CHECK(s["view"]["helpShown"] == true);
  CHECK(vectorDistance(s["camera"]["position"], json::array({0, 1, 3.9})) > 0.1);
}

TEST_CASE("window: without a display the program says what to do instead, and exits with 4") {
  TemporaryFolder const folder;
  Program program("/usr/bin/env", {"-u", "DISPLAY", "-u", "WAYLAND_DISPLAY", ROPELIGHT_PROGRAM, "cornell"},
                  folder.path());
  CHECK(program.exitCode() == 4);
  CHECK(program.err().find("ropelight render") != std::string::npos);
  CHECK(program.err().find("DISPLAY") != std::string::npos);
}

TEST_CASE("window: an old GL is refused with what was found and what is needed") {
  if (!ViewerRun::possible()) return;
  if (!VirtualDisplay::givenName().empty()) {
    MESSAGE("skipped: Mesa alone can be told to be old, and the display is another's");
    return;
  }
  ViewerRun run;
  std::vector<std::string> arguments = run.arguments("cornell", "", {"--frames", "1"});
  arguments.insert(arguments.begin(), {"MESA_GL_VERSION_OVERRIDE=2.1"});
  Program program("/usr/bin/env", arguments, run.folder.path());
  CHECK(program.exitCode() == 4);
  CHECK(program.err().find("2.1") != std::string::npos);
  CHECK(program.err().find("3.3") != std::string::npos);
  CHECK(program.err().find("ropelight render") != std::string::npos);
}

TEST_CASE("window: a script that cannot go on ends the program with its place") {
  if (!ViewerRun::possible()) return;
  ViewerRun run;
  Program program("/usr/bin/env", run.arguments("cornell", "wait iterations 1\nclick no/such/widget\n"),
                  run.folder.path());
  CHECK(program.exitCode() == 1);
  CHECK(program.err().find("script.txt:2: ") != std::string::npos);
}

TEST_SUITE_END();

}  // namespace ropelight

#endif
