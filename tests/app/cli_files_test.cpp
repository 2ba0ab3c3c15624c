// What the command line does to files and streams that it cannot or must not write.

#include "tests/support/command_line.h"

#ifdef ROPELIGHT_PROGRAM

namespace ropelight {
namespace {

namespace fs = std::filesystem;

const std::string scene = R"({"camera": {"position": [0, 0, 3], "target": [0, 0, 0], "up": [0, 1, 0], "fov": 40},
 "film": {"width": 16, "height": 12},
 "materials": {"m": {"type": "diffuse", "albedo": 0.5}},
 "shapes": [{"type": "mesh", "file": "m.obj", "material": "m"},
            {"type": "quad", "corner": [-1, 1, -1], "edge1": [2, 0, 0], "edge2": [0, 0, 2], "material": "m",
             "emission": {"radiance": 1, "side": "both"}}]})";

/// A folder with s.json, its mesh m.obj, and other names for both.
class SceneFolder : public TemporaryFolder {
 public:
  SceneFolder() {
    putBytes(*this / "s.json", scene);
    putBytes(*this / "m.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nf 1 2 3\n");
    fs::create_directory(*this / "sub");
    fs::create_symlink("../s.json", *this / "sub/soft.json");
    fs::create_hard_link(*this / "m.obj", *this / "sub/hard.exr");
  }
};

const Arguments quick = {"--backend", "cpu", "--photons", "64", "--iterations", "1"};

/// Refused with 2, and every file is as it was.
void checkKept(const SceneFolder& folder, const Arguments& arguments, const std::string& part) {
  Result const result = run(folder, arguments);
  CAPTURE(arguments.back());
  CAPTURE(result.err);
  CHECK(result.code == 2);
  CHECK(contains(result.err, part));
  CHECK(fileBytes(folder / "s.json") == scene);
  CHECK(fileBytes(folder / "m.obj").starts_with("v -1 -1 0"));
  CHECK(folder.entries() == 5);  // the streams, and what there was
}

/// A run whose stream 1 or 2 is /dev/full.
Result runFull(const TemporaryFolder& folder, int stream, const Arguments& arguments) {
  std::string const command = "exec \"$@\" " + std::to_string(stream) + ">/dev/full";
  return run(folder, Arguments{"-c", command, "sh", ROPELIGHT_PROGRAM} + arguments, "/bin/sh");
}

}  // namespace

TEST_CASE("a scene for these tests renders") {
  SceneFolder const folder;
  Result const result = run(folder, Arguments{"render", "s.json"} + quick);
  CAPTURE(result.err);
  CHECK(result.code == 0);
}

TEST_CASE("an output that is an input is refused, whatever its name") {
  SceneFolder const folder;
  Arguments const render = Arguments{"render", "s.json"} + quick;
  checkKept(folder, render + Arguments{"--json", "s.json"}, "s.json: is read");
  checkKept(folder, render + Arguments{"--json", "sub/../s.json"}, "(as s.json)");
  checkKept(folder, render + Arguments{"--json", "sub/soft.json"}, "sub/soft.json: is read");
  checkKept(folder, render + Arguments{"--json", "m.obj"}, "m.obj: is read");
  checkKept(folder, render + Arguments{"-o", "sub/hard.exr"}, "sub/hard.exr: is read (as ");
  checkKept(folder, Arguments{"info", "s.json", "--json", "s.json"}, "s.json: is read");
  checkKept(folder, Arguments{"info", "m.obj", "--json", "m.obj"}, "m.obj: is read");
  checkKept(folder, Arguments{"stress", "--mesh", "m.obj", "--json", "./m.obj"}, "./m.obj: is read (as m.obj)");
  checkKept(folder, Arguments{"bench", "traversal", "--mesh", "m.obj", "--csv", "m.obj"}, "m.obj: is read");
  checkKept(folder, Arguments{"bench", "iteration", "--scene", "s.json", "--json", "m.obj"}, "m.obj: is read");
  checkKept(folder, Arguments{"view", "s.json", "--state", "m.obj"}, "m.obj: is read");
  checkKept(folder, Arguments{"view", "s.json", "--script", "m.obj", "--state", "m.obj"}, "m.obj: is read");
  checkKept(folder, Arguments{"converge", "s.json", "--time", "1", "--out", "sub", "--json", "m.obj"},
            "m.obj: is read");
}

TEST_CASE("a window's script may not write what is read") {
  SceneFolder const folder;
  putBytes(folder / "sub/script.txt", "wait iterations 1\nscreenshot m.obj\nquit\n");
  checkKept(folder, {"view", "s.json", "--no-preferences", "--script", "sub/script.txt"}, "m.obj: is read");
}

TEST_CASE("two outputs that are one file are refused") {
  SceneFolder const folder;
  Arguments const render = Arguments{"render", "s.json"} + quick;
  checkKept(folder, render + Arguments{"-o", "a.png", "--json", "a.png"}, "a.png: two outputs are this file; ");
  checkKept(folder, render + Arguments{"-o", "a.png", "-o", "sub/../a.png"}, "two outputs are this file (as a.png)");
  checkKept(folder, Arguments{"view", "s.json", "--state", "a", "--screenshot", "./a"}, "two outputs");
  checkKept(folder, Arguments{"bench", "split", "--csv", "a", "--json", "a"}, "two outputs");
  checkKept(folder, Arguments{"converge", "s.json", "--time", "1", "--out", "sub", "--json", "sub/report.html"},
            "two outputs");
}

TEST_CASE("compare leaves the images that it reads") {
  SceneFolder const folder;
  REQUIRE(run(folder, Arguments{"render", "s.json", "-o", "sub/a.exr"} + quick).code == 0);
  std::string const before = fileBytes(folder / "sub/a.exr");
  for (const char* option : {"--error-image", "--flip-image", "--json"})
    checkKept(folder, {"compare", "sub/a.exr", "sub/a.exr", option, "sub/../sub/a.exr"}, "is read (as sub/a.exr)");
  checkKept(folder, {"compare", "sub/a.exr", "sub/a.exr", "--error-image", "b.exr", "--flip-image", "b.exr"}, "b.exr");
  CHECK(fileBytes(folder / "sub/a.exr") == before);
}

TEST_CASE("names that are too long and links that go in circles are refused before rendering") {
  SceneFolder const folder;
  fs::create_symlink("circle.png", folder / "circle.png");
  for (const std::string& name :
       {std::string(260, 'n') + ".png", std::string(5000, 'n') + ".png", std::string("circle.png")}) {
    Result const result = run(folder, Arguments{"render", "s.json", "--iterations", "1000000000", "-o", name});
    CHECK(result.code == 3);
    CHECK(contains(result.err, "cannot be used: "));
  }
}

TEST_CASE("a folder that vanishes while rendering costs its file alone") {
  SceneFolder const folder;
  fs::create_directory(folder / "gone");
  Program program(ROPELIGHT_PROGRAM,
                  {"render", "s.json", "--backend", "cpu", "--time", "100", "-o", "gone/a.png", "-o", "b.exr", "--json",
                   "s-out.json"},
                  folder.path());
  REQUIRE(program.waitForError("it/s"));
  fs::remove(folder / "gone");
  program.send(SIGINT);
  CHECK(program.exitCode() == 1);
  CHECK(contains(program.err(), "gone/a.png: there is no folder"));
  CHECK(fs::exists(folder / "b.exr"));
  CHECK(readJson(folder / "s-out.json")["interrupted"] == true);
}

TEST_CASE("standard output without room is a failure that is told, and costs no picture") {
  if (!fs::exists("/dev/full")) return;
  for (const Arguments& arguments : {Arguments{"--help"},
                                     {"render", "--help"},
                                     {"devices"},
                                     {"devices", "--json", "-"},
                                     Arguments{"info", "s.json"} + Arguments(quick.begin(), quick.end() - 2),
                                     Arguments{"render", "s.json", "-o", "o.png", "--json", "-"} + quick,
                                     Arguments{"render", "s.json", "-o", "o.png"} + quick}) {
    SceneFolder const folder;
    Result const result = runFull(folder, 1, arguments);
    CAPTURE(result.err);
    CHECK(result.code == 1);
    CHECK(contains(result.err, "ropelight: standard output: cannot write: No space left on device"));
    CHECK(fs::exists(folder / "o.png") == (arguments[0] == "render" && arguments.size() > 2));
  }
}

TEST_CASE("standard error without room costs nothing") {
  if (!fs::exists("/dev/full")) return;
  SceneFolder const folder;
  CHECK(runFull(folder, 2, {"render", "s.json", "--time", "1.5", "--radius", "1e-12"}).code == 0);
  CHECK(fs::exists(folder / "out.png"));
}

TEST_CASE("a reader that goes away ends the program by SIGPIPE, after its files are written") {
  SceneFolder const folder;
  std::string const program = ROPELIGHT_PROGRAM;
  auto const piped = [&](const std::string& arguments) {
    run(folder, {"-c", "(sleep 0.3; " + program + " " + arguments + "; echo $? >code) 2>errors | true"}, "/bin/sh");
    return fileBytes(folder / "code");
  };
  CHECK(piped("devices") == "141\n");  // 128 + SIGPIPE, as the shell tells it
  CHECK(piped("render s.json --backend cpu --iterations 1 -o p.png --json -") == "141\n");
  CHECK(fs::exists(folder / "p.png"));
  CHECK(!contains(fileBytes(folder / "errors"), "ropelight:"));
}

TEST_CASE("streams that are closed take no file's place") {
  SceneFolder const folder;
  std::string const program = ROPELIGHT_PROGRAM;
  Result const result =
      run(folder, {"-c", program + " render s.json --backend cpu --iterations 1 -o c.png <&- >&- 2>&-; echo $? >code"},
          "/bin/sh");
  CHECK(fileBytes(folder / "code") == "1\n");  // the summary could not be written
  CHECK(fileBytes(folder / "c.png").starts_with("\x89PNG"));
  CHECK(fileBytes(folder / "s.json") == scene);
}

TEST_CASE("a SIGHUP that is ignored stays ignored") {
  SceneFolder const folder;
  Program program("/bin/sh",
                  {"-c", std::string("trap '' HUP; exec ") + ROPELIGHT_PROGRAM +
                             " render s.json --backend cpu --time 3 --json j.json"},
                  folder.path());
  REQUIRE(program.waitForError("it/s"));
  program.send(SIGHUP);
  CHECK(program.exitCode() == 0);
  CHECK(readJson(folder / "j.json")["interrupted"] == false);
}

TEST_CASE("notes are not for --quiet, and what makes the picture wrong is") {
  SceneFolder const folder;
  putBytes(folder / "white.json", R"({"camera": {"position": [0, 0, 0.5], "target": [0, 0, 0], "up": [0, 1, 0],
    "fov": 40}, "film": {"width": 16, "height": 12}, "materials": {"m": {"type": "diffuse", "albedo": 0.9}},
    "shapes": [{"type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "m",
                "emission": {"radiance": 1, "side": "in"}}]})");
  Arguments const render = {"render", "white.json", "--backend", "cpu", "--iterations", "1", "--photons", "20000"};
  Result const loud = run(folder, render);
  CAPTURE(loud.err);
  CHECK(contains(loud.err, "note: photons were traced again"));
  Result const quiet = run(folder, render + Arguments{"--quiet"});
  CHECK(quiet.code == 0);
  CHECK(quiet.err.empty());
  CHECK(quiet.out.empty());
  Result const warned = run(folder, render + Arguments{"--quiet", "--radius", "1e-12"});
  CHECK(contains(warned.err, "warning: --radius 1e-12"));
}

TEST_CASE("radii that make no sense are warned of with those that would, once") {
  SceneFolder const folder;
  Arguments const render = Arguments{"render", "s.json", "--quiet"} + quick;
  for (const char* radius : {"1e-12", "1e30"}) {
    Result const result = run(folder, render + Arguments{"--radius", radius});
    CHECK(result.code == 0);
    CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
    CHECK(contains(result.err, "make sense here"));
  }
  for (const char* radius : {"0.01", "1"}) CHECK(run(folder, render + Arguments{"--radius", radius}).err.empty());
  Result const few = run(folder, render + Arguments{"--gather", "nearest", "--nearest", "100"});
  CHECK(contains(few.err, "--nearest 100 asks for more photons than --photons 64"));
}

TEST_CASE("a film that needs more memory than there is is refused with the bytes") {
#if defined(__SANITIZE_ADDRESS__)
  MESSAGE("skipped: the address sanitizer needs more address space than the limit leaves");
  return;
#endif
  SceneFolder const folder;
  std::string const program = ROPELIGHT_PROGRAM;
  Result const result = run(folder,
                            {"-c", "ulimit -v 4000000; exec " + program +
                                       " render s.json --backend cpu --width 16384 --height 16384 --iterations 1"},
                            "/bin/sh");
  CAPTURE(result.err);
  CHECK(result.code == 5);
  CHECK(contains(result.err, "16384 x 16384 pixels and 262144 photons need "));
  CHECK(contains(result.err, "are free; lower --width, --height"));
}

}  // namespace ropelight

#endif
