// A study of error against run time: what it compares, what it measures against, how it takes turns.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "app/converge/analysis/curves.h"
#include "app/converge/study/edges.h"
#include "app/converge/study/runner.h"
#include "app/run/sample_schedule.h"
#include "render/core/error.h"
#include "render/image_files/exr.h"
#include "render/import/load.h"
#include "tests/support/temporary_folder.h"

using namespace ropelight;

namespace {

constexpr int size = 24;

Settings small() {
  Settings s;
  s.width = s.height = size;
  s.photons = 2000;
  return s;
}

Scene cornell() { return loadScene(std::string(ROPELIGHT_ASSETS) + "/cornell.json"); }
Scene spheres() { return loadScene(std::string(ROPELIGHT_ASSETS) + "/box-spheres-diffuse.json"); }

BackendChoice onCpu() {
  BackendChoice choice;
  choice.backend = BackendKind::cpu;
  return choice;
}

std::string messageOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

StudyReference made(const Scene& scene, std::uint64_t iterations, const std::string& mode, std::uint64_t seed = 1) {
  ReferenceOptions options;
  options.iterations = iterations;
  options.mode = mode;
  Settings base = small();
  base.seed = seed;
  return makeReference(options, scene, base, onCpu(), makeSceneCache(scene));
}

RunnerOptions runner(const std::string& modes, std::uint64_t iterations, int seeds) {
  RunnerOptions options;
  options.modes = parseModes(modes, small());
  options.limits.iterations = iterations;
  options.seeds = seeds;
  options.backend = onCpu();
  options.reference.iterations = 200;
  return options;
}

}  // namespace

TEST_CASE("modes are read with settings of their own over the shared ones") {
  Settings base = small();
  base.alpha = 0.9;
  auto const specs = parseModes("path,sppm:alpha=0.5:gather=knn,sppm:seed=7", base);
  REQUIRE(specs.size() == 3);
  CHECK(specs[0].settings.mode == Mode::path);
  CHECK(specs[0].settings.alpha == 0.9);
  CHECK(specs[1].label == "sppm:alpha=0.5:gather=knn");
  CHECK(specs[1].settings.alpha == 0.5);
  CHECK(specs[1].settings.gather == GatherBy::nearest);
  CHECK(specs[2].settings.seed == 7);
  CHECK(specs[2].settings.width == size);
}

TEST_CASE("modes that cannot be are refused by name") {
  auto const refusal = [](const std::string& text) { return messageOf([&] { parseModes(text, small()); }); };
  CHECK(contains(refusal("sppn"), "'sppn'"));
  CHECK(contains(refusal("path,"), "''"));
  CHECK(contains(refusal("sppm:alpah=1"), "alpah"));
  CHECK(contains(refusal("sppm:alpha=2"), "alpha"));
  CHECK(contains(refusal("sppm:alpha"), "KEY=VALUE"));
  CHECK(contains(refusal("path:mode=sppm"), "mode"));
  CHECK(contains(refusal("path,path"), "twice"));
  CHECK(contains(refusal("path:width=8"), "same for all"));
}

TEST_CASE("samples are due at the same places for every run") {
  SampleSchedule schedule(2);
  CHECK(schedule.due(0));
  schedule.taken(0.3);
  CHECK(schedule.next() == doctest::Approx(0.5));
  CHECK_FALSE(schedule.due(0.49));
  schedule.taken(7);
  CHECK(schedule.next() == doctest::Approx(8));
  schedule.taken(8);
  CHECK(schedule.next() == doctest::Approx(16));
  schedule.taken(0);
  CHECK(schedule.next() == doctest::Approx(16));
  schedule.restart();
  CHECK(schedule.due(0));
}

TEST_CASE("a reference of another size, scene, depth or colour space is refused") {
  TemporaryFolder const folder;
  Scene const scene = cornell();
  ReferenceOptions options;
  options.file = (folder.path() / "{scene}.exr").string();
  std::filesystem::path const file = folder.path() / "cornell.exr";
  auto const refusal = [&] { return messageOf([&] { readReference(options, scene, small()); }); };
  CHECK(contains(refusal(), "cornell.exr"));  // missing
  writeExr(file, Image(size, size + 1));
  CHECK(contains(refusal(), "24 x 25"));
  writeExr(file, Image(size, size), {{"scene", std::string("/x/bumpy.json")}});
  CHECK(contains(refusal(), "'bumpy'"));
  writeExr(file, Image(size, size), {{"scene", std::string("cornell.json")}, {"max-depth", std::int64_t(3)}});
  CHECK(contains(refusal(), "max-depth"));
  Image dark(size, size);
  dark.pixels[5] = Rgb(std::nanf(""));
  writeExr(file, dark);
  CHECK(contains(refusal(), "not finite"));
  writeExr(file, Image(size, size), {{"scene", std::string("cornell.json")}, {"max-depth", std::int64_t(0)}});
  CHECK(refusal().empty());
}

TEST_CASE("a reference of an unknown scene must look like a glimpse of this one") {
  auto const picture = [](const Scene& scene, int iterations) {
    Settings settings = small();
    settings.width = settings.height = 64;
    settings.photons = 30000;
    auto const integrator = makeIntegrator(scene, settings, onCpu());
    integrator->advance(iterations);
    return integrator->film();
  };
  Image const glimpse = picture(cornell(), 4);
  StudyReference reference;
  reference.image = picture(cornell(), 40);
  CHECK_NOTHROW(requireSameScene(glimpse, reference));
  reference.image = picture(spheres(), 4);
  CHECK_THROWS_AS(requireSameScene(glimpse, reference), Error);
  reference.image = Image(64, 64);
  CHECK_THROWS_AS(requireSameScene(glimpse, reference), Error);
}

TEST_CASE("a made reference knows its own noise") {
  StudyReference const reference = made(cornell(), 64, "path:sampler=independent");
  StudyReference const better = made(cornell(), 2048, "path:sampler=independent", 5);
  Metrics const m = compareImages(reference.image, better.image, {.epsilon = reference.epsilon});
  CHECK(reference.noise == doctest::Approx(m.relMse).epsilon(0.25));
  CHECK(reference.variance == doctest::Approx(m.mse).epsilon(0.25));
  CHECK(contains(reference.origin, "32 and 32 iterations"));
}

TEST_CASE("a kept reference is read back with its noise") {
  TemporaryFolder const folder;
  Scene const scene = cornell();
  ReferenceOptions options;
  options.iterations = 8;
  options.save = options.file = (folder.path() / "{scene}.exr").string();
  StudyReference const reference = makeReference(options, scene, small(), onCpu(), makeSceneCache(scene));
  saveReference(options, reference, scene);
  StudyReference const again = readReference(options, scene, reference.stats.settings);
  CHECK(again.image.pixels == reference.image.pixels);
  CHECK(again.noise == doctest::Approx(reference.noise));
  CHECK(again.variance == doctest::Approx(reference.variance));
  CHECK(again.mode == reference.mode);
}

TEST_CASE("every mode and seed runs to its limit, with samples at spread places") {
  StudyScene const study = runModes(cornell(), small(), runner("path,sppm", 40, 3));
  REQUIRE(study.modes.size() == 2);
  for (const StudyMode& mode : study.modes) {
    REQUIRE(mode.runs.size() == 3);
    for (std::size_t k = 0; k < 3; ++k) {
      const StudyRun& run = mode.runs[k];
      CHECK(run.seed == 1 + k);
      REQUIRE(run.samples.size() > 6);
      CHECK(run.samples.size() < 20);
      CHECK(run.samples.front().iterations == 1);
      CHECK(run.samples.back().iterations == 40);
      for (std::size_t i = 1; i < run.samples.size(); ++i) CHECK(run.samples[i].seconds > run.samples[i - 1].seconds);
    }
    CHECK(mode.runs[0].samples.back().metrics.mse != mode.runs[1].samples.back().metrics.mse);
    CHECK(mode.picture.width == size);
    CHECK(mode.pictureSeconds > 0);
    CHECK(mode.pictureFlip > 0);
    CHECK(mode.split.variance > 0);
    CHECK(mode.pictureEdges.pixels > 0.05);
    CHECK(mode.pictureEdges.pixels < 1);
    CHECK(mode.pictureEdges.error > 0);
    double mse = 0;
    for (const StudyRun& run : mode.runs) mse += run.samples.back().metrics.mse / 3;
    CHECK(mode.split.mse == doctest::Approx(mse));
  }
}

TEST_CASE("the same study finds the same errors") {
  StudyScene const a = runModes(cornell(), small(), runner("sppm", 10, 1));
  StudyScene const b = runModes(cornell(), small(), runner("sppm,path", 10, 1));
  CHECK(a.modes[0].runs[0].samples.back().metrics.mse == b.modes[0].runs[0].samples.back().metrics.mse);
}

TEST_CASE("one mode against itself with other seeds has no winner") {
  StudyScene const study = runModes(cornell(), small(), runner("path,path:seed=100", 16, 4));
  std::string const verdict = verdictOf(study, false);
  CAPTURE(verdict);
  CHECK(contains(verdict, "No mode is called best"));
}

TEST_CASE("a reference noisier than what it judges is flagged") {
  RunnerOptions options = runner("path:sampler=independent", 256, 1);
  options.reference.mode = "path:sampler=independent";
  options.reference.iterations = 16;
  StudyScene const study = runModes(cornell(), small(), options);
  CAPTURE(study.reference.noise);
  CAPTURE(study.modes[0].runs[0].samples.back().metrics.relMse);
  CHECK(contains(study.modes[0].referenceWarning, "noise"));
  options.reference.iterations = 2048;
  options.limits.iterations = 4;
  CHECK(runModes(cornell(), small(), options).modes[0].referenceWarning.empty());
}

TEST_CASE("a study that is stopped keeps what it has") {
  RunnerOptions options = runner("path", 100000, 2);
  options.reference.mode = "path";
  int asked = 0;
  options.stop = [&] { return ++asked > 30; };
  StudyScene const study = runModes(cornell(), small(), options);
  REQUIRE(study.modes[0].runs.size() >= 1);
  CHECK(study.modes[0].runs[0].samples.size() >= 1);
  CHECK(std::isnan(study.modes[0].split.mse));
}

TEST_CASE("pixels near edges are those within the radius of a turned normal or a jump in depth") {
  int const n = 41;
  Image normal(n, n), depth(n, n);
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      normal.at(x, y) = x < 20 ? Rgb(0, 0, 1) : Rgb(1, 0, 0);
      depth.at(x, y) = Rgb(2.0f);
    }
  CameraDesc camera;
  camera.verticalFov = 90;  // a pixel is 4/41 wide at depth 2
  auto const count = [&](double radius) {
    auto const mask = nearEdges(normal, depth, camera, radius);
    return std::count(mask.begin(), mask.end(), true);
  };
  CHECK(count(0) == n * 4);              // the two columns at the edge and their neighbours
  CHECK(count(5.5 * 4 / 41) == n * 12);  // five more to each side
  CHECK(count(100) == n * n);
  normal = Image(n, n);
  CHECK(count(100) == 0);  // one plane
  depth.at(20, 20) = Rgb(2.5f);
  auto const mask = nearEdges(normal, depth, camera, 10.2 * 4 / 41);
  CHECK(mask[20 * n + 31]);  // ten pixels from the neighbour that jumps
  CHECK_FALSE(mask[20 * n + 32]);
  depth.at(20, 20) = Rgb(2.1f);
  CHECK(count(100) == 0);
}

TEST_CASE("the share of the error near edges") {
  StudyReference reference;
  reference.image = Image(2, 1);
  reference.epsilon = 1;
  Image image(2, 1);
  image.pixels = {Rgb(1.0f), Rgb(2.0f)};  // relative squares 1 and 4
  EdgeShare const share = edgeShare(image, reference, {false, true});
  CHECK(share.error == doctest::Approx(0.8));
  CHECK(share.pixels == doctest::Approx(0.5));
  CHECK(std::isnan(edgeShare(reference.image, reference, {false, true}).error));
}
