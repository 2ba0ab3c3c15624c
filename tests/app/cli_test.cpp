// The command line itself: exit codes, messages, and the files that a run writes or leaves alone.

#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "render/image_files/exr.h"
#include "render/image_files/png.h"
#include "tests/support/command_line.h"

#ifdef ROPELIGHT_PROGRAM

namespace ropelight {
TEST_CASE("help and version go to standard output and exit with 0") {
  TemporaryFolder const folder;
  for (const Arguments& arguments : {Arguments{"--help"}, {"-h"}, {"--version"}, {"render", "--help"}}) {
    Result const result = run(folder, arguments);
    CHECK(result.code == 0);
    CHECK(contains(result.out, "ropelight"));
    CHECK(result.err.empty());
  }
  CHECK(contains(run(folder, {"render", "--help"}).out, "--cell-size"));
}

TEST_CASE("what the command line gets wrong exits with 2 and is named") {
  checkRefused({}, 2, {"--help"});
  checkRefused({"render"}, 2, {"SCENE"});
  checkRefused({"render", "cornell", "--no-such-option"}, 2, {"--no-such-option"});
  checkRefused(smallRender + Arguments{"-o", "out.jpg"}, 2, {"out.jpg", ".png", ".exr"});
  checkRefused(smallRender + Arguments{"--alpha", "nan"}, 2, {"--alpha", "nan"});
  checkRefused(smallRender + Arguments{"--radius", "-1"}, 2, {"--radius", "-1", "scene units"});
  checkRefused(smallRender + Arguments{"--width", "70000"}, 2, {"--width", "65536"});
  checkRefused(smallRender + Arguments{"--seed", "1.5"}, 2, {"--seed", "1.5"});
  checkRefused(smallRender + Arguments{"--iterations", "0"}, 2, {"--iterations"});
  checkRefused(smallRender + Arguments{"--mode", "radiosity"}, 2, {"radiosity", "sppm"});
  checkRefused(smallRender + Arguments{"--backend", "abacus"}, 2, {"abacus", "cuda"});
  checkRefused({"bench", "nothing"}, 2, {"nothing", "iteration"});
}

TEST_CASE("-D with an unknown key lists the known ones") {
  checkRefused(smallRender + Arguments{"-D", "alhpa=0.5"}, 2, {"alhpa", "alpha", "cell-size", "leaf-size"});
  checkRefused(smallRender + Arguments{"-D", "alpha"}, 2, {"key=value"});
  checkRefused(smallRender + Arguments{"-D", "alpha=2"}, 2, {"alpha", "2"});
}

TEST_CASE("a scene that cannot be read exits with 3, before anything is written") {
  checkRefused({"render", "no-such-scene"}, 3, {"no-such-scene", "cornell", "box-spheres-diffuse"});
  checkRefused({"render", "no/such/scene.json"}, 3, {"no/such/scene.json"});
  checkRefused({"info", "no-such-scene"}, 3, {"no-such-scene"});
  TemporaryFolder const folder;
  putBytes(folder / "broken.json", "{ \"camera\": ");
  putBytes(folder / "out.png", "old");
  Result const result = run(folder, {"render", "broken.json"});
  CHECK(result.code == 3);
  CHECK(contains(result.err, "broken.json"));
  CHECK(fileBytes(folder / "out.png") == "old");
}

TEST_CASE("an output that cannot be written exits with 3 and costs no other file") {
  TemporaryFolder const folder;
  putBytes(folder / "out.png", "old");
  for (const Arguments& last : {Arguments{"-o", "missing/out.exr"},
                                {"-o", folder.path().string() + ".png/x.png"},
                                {"--json", "missing/stats.json"}}) {
    Result const result = run(folder, smallRender + Arguments{"-o", "out.png"} + last);
    CHECK(result.code == 3);
    CHECK(contains(result.err, last.back()));
    CHECK(fileBytes(folder / "out.png") == "old");
    CHECK(folder.entries() == 3);
  }
}

TEST_CASE("a device that is not there exits with 4") {
  checkRefused({"render", "cornell", "--backend", "cuda", "--gpu", "1023"}, 4, {});
}

TEST_CASE("a render writes every file that it was asked for") {
  TemporaryFolder const folder;
  Arguments const rest = {"-o", "a.png", "-o", "b.EXR", "--json", "s.json", "--iterations", "3", "-D", "seed=7"};
  Result const result = run(folder, smallRender + rest);
  CAPTURE(result.err);
  REQUIRE(result.code == 0);
  CHECK(contains(result.out, "3 iterations"));
  CHECK(contains(result.out, "b.EXR"));
  CHECK(folder.entries() == 5);

  Image const png = readPng(folder / "a.png");
  Image const exr = readExr(folder / "b.EXR");
  CHECK(png.width == 16);
  CHECK(png.height == 12);
  CHECK(exr.width == 16);
  CHECK(exr.height == 12);

  auto const json = readJson(folder / "s.json");
  CHECK(json["stats"]["iterations"] == 3);
  CHECK(json["settings"]["seed"] == 7);
  CHECK(json["settings"]["photons"] == 64);
  CHECK(json["settings"]["radius"] > 0);
  CHECK(json["interrupted"] == false);
}

TEST_CASE("an EXR names the resolved settings, what was done, and by what") {
  TemporaryFolder const folder;
  REQUIRE(run(folder, smallRender + Arguments{"-o", "a.exr", "--iterations", "2", "--seed", "5"}).code == 0);
  std::map<std::string, MetadataValue> metadata;
  for (const auto& [key, value] : readExrMetadata(folder / "a.exr")) metadata[key] = value;
  CHECK(metadata.at("seed") == MetadataValue(std::int64_t(5)));
  CHECK(metadata.at("iterations") == MetadataValue(std::int64_t(2)));
  CHECK(metadata.at("width") == MetadataValue(std::int64_t(16)));
  CHECK(std::get<double>(metadata.at("radius")) > 0);
  CHECK(std::get<double>(metadata.at("seconds")) > 0);
  CHECK(std::get<std::string>(metadata.at("accel")) != "auto");
  CHECK(contains(std::get<std::string>(metadata.at("scene")), "cornell"));
  for (const char* key : {"device", "version"}) CHECK(!std::get<std::string>(metadata.at(key)).empty());
}

TEST_CASE("JSON on standard output is all that is there") {
  TemporaryFolder const folder;
  Result const result = run(folder, smallRender + Arguments{"--iterations", "2", "--json", "-"});
  REQUIRE(result.code == 0);
  CHECK(nlohmann::json::parse(result.out)["stats"]["iterations"] == 2);
  CHECK(std::filesystem::exists(folder / "out.png"));
}

TEST_CASE("--quiet says nothing") {
  TemporaryFolder const folder;
  Result const result = run(folder, smallRender + Arguments{"--iterations", "2", "--quiet"});
  CHECK(result.code == 0);
  CHECK(result.out.empty());
  CHECK(result.err.empty());
}

TEST_CASE("--time ends a run after that time") {
  TemporaryFolder const folder;
  REQUIRE(run(folder, smallRender + Arguments{"--time", "0.5", "--json", "s.json"}).code == 0);
  auto const json = readJson(folder / "s.json");
  CHECK(json["wallSeconds"] >= 0.5);
  CHECK(json["wallSeconds"] < 1.5);
  CHECK(json["stats"]["iterations"] >= 1);
  REQUIRE(run(folder, smallRender + Arguments{"--time", "100", "--iterations", "3", "--json", "s.json"}).code == 0);
  CHECK(readJson(folder / "s.json")["stats"]["iterations"] == 3);
}

TEST_CASE("Ctrl-C, SIGTERM and SIGHUP write the image and exit with 0") {
  for (int const signal : {SIGINT, SIGTERM, SIGHUP}) {
    TemporaryFolder const folder;
    Program program(ROPELIGHT_PROGRAM, smallRender + Arguments{"--time", "100", "--json", "s.json"}, folder.path());
    REQUIRE(program.waitForError("it/s"));
    program.send(signal);
    if (signal == SIGHUP) program.send(signal);  // as a terminal that closes does
    CHECK(program.exitCode() == 0);
    CHECK(contains(program.err(), "stopped early"));
    CHECK(readPng(folder / "out.png").width == 16);
    auto const json = readJson(folder / "s.json");
    CHECK(json["interrupted"] == true);
    CHECK(json["wallSeconds"] < 50);
  }
}

TEST_CASE("compare exits with 0 within the threshold and with 6 beyond it") {
  TemporaryFolder const folder;
  REQUIRE(run(folder, smallRender + Arguments{"-o", "a.exr", "--iterations", "1"}).code == 0);
  REQUIRE(run(folder, smallRender + Arguments{"-o", "b.exr", "--iterations", "1", "--seed", "2"}).code == 0);
  CHECK(run(folder, {"compare", "a.exr", "a.exr", "--threshold", "0"}).code == 0);
  Result const apart = run(folder, {"compare", "a.exr", "b.exr", "--threshold", "0", "--json", "c.json"});
  CHECK(apart.code == 6);
  CHECK(readJson(folder / "c.json")["passed"] == false);
  CHECK(run(folder, {"compare", "a.exr", "missing.exr"}).code == 3);
}

TEST_CASE("devices lists the CPU as usable") {
  TemporaryFolder const folder;
  Result const table = run(folder, {"devices"});
  CHECK(table.code == 0);
  CHECK(contains(table.out, "cpu"));
  auto const json = nlohmann::json::parse(run(folder, {"devices", "--json", "-"}).out);
  REQUIRE(!json["devices"].empty());
  CHECK(json["devices"][0]["backend"] == "cpu");
  CHECK(json["devices"][0]["usable"] == true);
}

TEST_CASE("info names what is present and what was left out") {
  TemporaryFolder const folder;
  Arguments const info = {"info", "cornell", "--backend", "cpu", "--width", "16", "--height", "12"};
  Result const text = run(folder, info);
  REQUIRE(text.code == 0);
  CHECK(contains(text.out, "left out"));
  auto const json = nlohmann::json::parse(run(folder, info + Arguments{"--json", "-"}).out);
  auto const has = [](const nlohmann::json& list, const char* name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  CHECK(has(json["features"]["present"], "photons"));
  CHECK(has(json["features"]["leftOut"], "lens"));
  CHECK(json["settings"]["radius"] > 0);
  CHECK(!json["stats"]["bytes"].empty());
}

TEST_CASE("converge writes a page, a table and plots, and says which mode was best") {
  TemporaryFolder const folder;
  Arguments const study = {"converge", "cornell",  "--backend", "cpu",       "--width",
                           "24",       "--height", "24",        "--photons", "512"};
  Result const made = run(folder, study + Arguments{"--modes", "ray,path,sppm:alpha=0.5", "--iterations", "12",
                                                    "--seeds", "2", "--reference-time", "0.4", "--save-reference",
                                                    "{scene}.exr", "--out", "study", "--json", "study.json"});
  CAPTURE(made.err);
  CHECK(made.code == 0);
  CHECK(contains(made.out, "sppm:alpha=0.5"));
  // On a busy machine a mode may end before another has begun, and nothing is compared.
  CHECK((contains(made.out, "relMSE") || contains(made.out, "No run time that all modes have an error at")));
  for (const char* file : {"report.html", "samples.csv", "cornell-seconds.svg", "cornell-iterations.svg"})
    CHECK(std::filesystem::file_size(folder / "study" / file) > 1000);
  auto const json = readJson(folder / "study.json");
  CHECK(json["scenes"][0]["modes"].size() == 3);
  CHECK(json["scenes"][0]["modes"][1]["runs"].size() == 2);
  CHECK(contains(json["command"], "--save-reference '{scene}.exr'"));

  Result const again = run(folder, study + Arguments{"--modes", "path", "--time", "0.1", "--seeds", "1", "--reference",
                                                     "{scene}.exr", "--quiet"});
  CHECK(again.code == 0);
  CHECK(again.err.empty());
  Result const other = run(folder, {"converge", "bumpy", "--backend", "cpu", "--width", "24", "--height", "24",
                                    "--time", "0.1", "--reference", "cornell.exr"});
  CHECK(other.code == 3);
  CHECK(contains(other.err, "cornell.exr: it was rendered of the scene 'cornell', not of 'bumpy'"));
}

TEST_CASE("converge refuses what it cannot compare before it starts") {
  checkRefused({"converge"}, 2, {"no scene"});
  checkRefused({"converge", "cornell", "--modes", "path,sppn"}, 2, {"'sppn'", "did you mean"});
  checkRefused({"converge", "cornell", "--iterations", "5"}, 2, {"--reference-time"});
  checkRefused({"converge", "cornell", "--reference", "a.exr", "--reference-time", "5"}, 2, {"exclude"});
  checkRefused({"converge", "cornell", "bumpy", "--reference", "a.exr"}, 2, {"{scene}"});
  checkRefused({"converge", "cornell", "cornell.json"}, 2, {"'cornell'"});
  checkRefused({"converge", "nowhere", "--time", "1"}, 3, {"nowhere"});
  checkRefused({"converge", "cornell", "--time", "1", "--reference", "none.exr"}, 3, {"none.exr"});
}

TEST_CASE("bench prints a row and writes CSV") {
  TemporaryFolder const folder;
  Result const result = run(folder, {"bench", "iteration", "--scene", "cornell", "--backend", "cpu", "--width", "16",
                                     "--height", "12", "--photons", "64", "--repeat", "3", "--csv", "b.csv"});
  REQUIRE(result.code == 0);
  CHECK(contains(result.out, "median"));
  std::string const csv = fileBytes(folder / "b.csv");
  CHECK(std::count(csv.begin(), csv.end(), '\n') == 2);
}

}  // namespace ropelight

#else

TEST_CASE("the command line") { MESSAGE("skipped: the program was not built beside the tests"); }

#endif
