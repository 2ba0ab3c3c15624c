// One iteration of every mode, and the parts of a photon-mapping one, against the triangle count (paper, Figure 10).

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "app/arguments/scene_path.h"
#include "app/bench/bench.h"
#include "app/bench/results/result.h"
#include "app/bench/results/timing.h"
#include "measure/rays/meshes.h"
#include "render/import/load.h"
#include "render/scene/transform.h"

namespace ropelight {
namespace {

/// For all modes on one scene.
double limitSeconds(const BenchOptions& options) { return fullSizes(options) ? 40 : 3; }

// The stages of an iteration that the parts are made of; those of neither list store, order and gather photons.
constexpr const char* cameraStages[] = {"TraceCamera", "CommitFilm", "EndIteration", "ResolveFilm"};
constexpr const char* photonStages[] = {"TracePhotons", "TraceTails"};

bool oneOf(const std::string& name, std::span<const char* const> names) {
  return std::any_of(names.begin(), names.end(), [&](const char* n) { return name == n; });
}

ShapeDesc shapeOf(ShapeKind kind, const char* name, int material, const Mat4d& toWorld) {
  ShapeDesc shape;
  shape.kind = kind;
  shape.name = name;
  shape.material = material;
  shape.toWorld = toWorld;
  return shape;
}

/// A bumpy ball in a closed box under a square light.
Scene ballInBox(std::vector<FlatTriangle> triangles) {
  Scene scene;
  scene.name = fmt::format("bumpy ball of {} triangles", triangles.size());
  scene.camera.position = {0.8, 0.6, 2.2};
  scene.camera.target = {0, -0.2, 0};
  scene.camera.verticalFov = 60;
  scene.materials = {{"white", DiffuseParams{Rgb(0.75f)}}, {"black", DiffuseParams{Rgb(0.0f)}}};
  Mesh mesh;
  for (const FlatTriangle& t : triangles) {
    auto const first = std::uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {t.a, t.b, t.c});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  scene.meshes.push_back(std::move(mesh));
  ShapeDesc ball = shapeOf(ShapeKind::mesh, "ball", 0, Mat4d(1.0));
  ball.mesh = 0;
  ShapeDesc light = shapeOf(ShapeKind::quad, "light", 1, quadToWorld({-0.6, 2.45, -0.6}, {1.2, 0, 0}, {0, 0, 1.2}));
  light.emission = Emission{Rgb(12.0f), Side::out};
  scene.shapes = {ball, shapeOf(ShapeKind::box, "box", 0, scaling(Vec3d(2.5))), light};
  return scene;
}

struct ModeRun {
  Mode mode;
  const char* series;
};

constexpr const char* scenes[] = {
    "cornell", "box-spheres-diffuse", "cornell-caustics", "glass-caustic", "light-in-glass", "six-lights", "bumpy"};

constexpr ModeRun modes[] = {{Mode::ray, "ray"}, {Mode::path, "path"}, {Mode::sppm, "all combined"}};

/// Share of a photon-mapping iteration that each part takes, by stages timed one by one.
struct Shares {
  double photonTrace = 0, withGather = 0;
  std::string stages;
};

Shares sharesOf(const std::map<std::string, double>& stageSeconds) {
  double all = 0, photons = 0, camera = 0;
  Shares shares;
  for (const auto& [stage, seconds] : stageSeconds) {
    all += seconds;
    if (oneOf(stage, photonStages)) photons += seconds;
    if (oneOf(stage, cameraStages))
      camera += seconds;
    else
      shares.stages += (shares.stages.empty() ? "" : ", ") + stage;
  }
  if (!(all > 0)) return shares;
  shares.photonTrace = photons / all;
  shares.withGather = (all - camera) / all;
  return shares;
}

/// A row's place on the axis: a number of triangles, or a scene.
struct Place {
  std::string name;
  double value;
};

BenchRow rowOf(const std::string& series, const Place& place, std::vector<double> seconds) {
  BenchRow row;
  row.series = series;
  row.x = place.name;
  row.place = place.value;
  row.seconds = std::move(seconds);
  return row;
}

std::vector<double> times(std::vector<double> seconds, double share) {
  for (double& s : seconds) s *= share;
  return seconds;
}

class ModeTimer {
 public:
  ModeTimer(const Scene& scene, const Settings& settings, const BenchOptions& options)
      : scene_(scene), settings_(settings), options_(options), cache_(makeSceneCache(scene)) {}

  /// Rows of the modes and of the parts of sppm; every mode's iterations in turn.
  std::vector<BenchRow> run(const Place& place, std::string& stages) {
    std::vector<std::unique_ptr<Integrator>> integrators;
    std::vector<Contender> contenders;
    for (const ModeRun& mode : modes) {
      integrators.push_back(make(mode.mode, false));
      contenders.push_back(
          {[&integrator = *integrators.back()] { return secondsOf([&] { integrator.advance(1); }); }, {}});
    }
    timeInTurn(contenders, warmUpRuns, options_.repeat, limitSeconds(options_));
    Image film;
    Shares const shares = sharesOf(stageSeconds(film));
    stages = shares.stages;
    device_ = integrators.front()->stats().device;
    std::vector<BenchRow> rows;
    for (std::size_t i = 0; i < std::size(modes); ++i) {
      rows.push_back(rowOf(modes[i].series, place, contenders[i].seconds));
      check(rows.back(), integrators[i]->stats());
    }
    checkAgain(rows.back(), *integrators.back(), film);
    const std::vector<double> whole = contenders.back().seconds;
    rows.insert(rows.begin() + 2, {rowOf("photon trace", place, times(whole, shares.photonTrace)),
                                   rowOf("photon trace + gather", place, times(whole, shares.withGather))});
    return rows;
  }

  const std::string& device() const { return device_; }

 private:
  std::unique_ptr<Integrator> make(Mode mode, bool stageTimes) const {
    Settings settings = settings_;
    settings.mode = mode;
    BackendChoice choice = options_.scene.backend;
    choice.stageTimes = stageTimes;
    return makeIntegrator(scene_, settings, choice, nullptr, cache_);
  }

  int stagedIterations() const { return std::min(options_.repeat, 5); }

  std::map<std::string, double> stageSeconds(Image& film) const {
    auto const integrator = make(Mode::sppm, true);
    integrator->advance(warmUpRuns);
    integrator->reset();
    integrator->advance(stagedIterations());
    film = integrator->film();
    return integrator->stats().stageSeconds;
  }

  /// The timed integrator must find the light that the one with timed stages found: the same photons, to the bit.
  void checkAgain(BenchRow& row, Integrator& timed, const Image& film) const {
    timed.reset();
    timed.advance(stagedIterations());
    if (timed.film().pixels == film.pixels) return;
    row.failed = true;
    row.seconds.clear();
    row.note = "FAILED: two runs of one seed differ";
  }

  static void check(BenchRow& row, const Stats& stats) {
    row.setRate(double(stats.rays + stats.shadowRays) / double(std::max<std::uint64_t>(1, stats.iterations)), "rays");
    row.note = stats.accel;
    row.failed = stats.nonFinite > 0;
    if (row.failed) row.seconds.clear();
    if (row.failed) row.note = fmt::format("FAILED: {} samples were not finite", stats.nonFinite);
  }

  const Scene& scene_;
  Settings settings_;
  const BenchOptions& options_;
  std::shared_ptr<SceneCache> cache_;
  std::string device_;
};

LinePlot plotOf(const BenchResult& result, const BenchTable& table, const char* title, const PlotAxis& x) {
  LinePlot plot;
  plot.title = title;
  plot.caption = result.caption();
  plot.x = x;
  plot.y = {"time of an iteration (ms)", true, {}};
  plot.curves = curvesOf(table, Plotted::milliseconds);
  return plot;
}

/// All tables use one list of stages, that of the largest scene.
BenchTable againstTriangles(const Settings& settings, const BenchOptions& options, std::string& stages,
                            std::string& device) {
  BenchTable table{"an iteration", "triangles", {}, {}};
  for (int halfDecade = 2; halfDecade <= (fullSizes(options) ? 12 : 10); ++halfDecade) {
    auto triangles = bumpySphereOf(std::uint32_t(std::lround(std::pow(10, halfDecade / 2.0))));
    normalise(triangles);
    Place const place{fmt::format("{}", triangles.size()), double(triangles.size())};
    Scene const scene = ballInBox(std::move(triangles));
    ModeTimer timer(scene, settings, options);
    for (BenchRow& row : timer.run(place, stages)) table.rows.push_back(std::move(row));
    device = timer.device();
  }
  return table;
}

BenchTable overScenes(const Settings& settings, const BenchOptions& options) {
  BenchTable table{"an iteration of each scene", "scene", {}, {}};
  for (std::size_t i = 0; i < std::size(scenes); ++i) {
    Scene const scene = loadScene(findScene(scenes[i]));
    ModeTimer timer(scene, settings, options);
    std::string stages;
    for (BenchRow& row : timer.run({scenes[i], double(i)}, stages)) table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

/// An iteration of each mode and its parts against the triangle count (paper, Figure 10).
BenchResult benchModes(const BenchOptions& options) {
  bool const full = fullSizes(options);
  Settings settings = options.scene.settings;
  if (settings.width == 0) settings.width = full ? 512 : 192;
  if (settings.height == 0) settings.height = full ? 512 : 192;
  if (!full && settings.photons == Settings{}.photons) settings.photons = 32768;
  std::string stages, device;
  BenchTable table = againstTriangles(settings, options, stages, device);
  table.remarks = {
      "photon trace: the share of TracePhotons and TraceTails in an iteration whose stages are timed one by "
      "one",
      "photon trace + gather: the share of " + stages};
  BenchResult result = startResult("modes", device, options,
                                   fmt::format("bumpy ball in a closed lit box, {} × {} pixels, {} photon paths",
                                               settings.width, settings.height, grouped(settings.photons)));
  result.tables = {table, overScenes(settings, options)};
  std::vector<std::string> const names(std::begin(scenes), std::end(scenes));
  result.plots = {
      {"", plotOf(result, table, "One iteration of every mode against triangles", {"triangles", true, {}})},
      {"scenes", plotOf(result, result.tables[1], "One iteration of every mode, scene by scene", {"", false, names})}};
  return result;
}

}  // namespace ropelight
