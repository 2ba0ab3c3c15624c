#include "app/converge/study/runner.h"

#include <algorithm>
#include <limits>

#include "app/bench/results/timing.h"
#include "app/converge/study/contestant.h"
#include "app/converge/study/edges.h"
#include "render/film/flip.h"

namespace ropelight {
namespace {

using Contestants = std::vector<std::unique_ptr<Contestant>>;

/// A few iterations of sppm, whose film is right to a few percent nearly everywhere.
Image glimpse(const Scene& scene, const Settings& base, const RunnerOptions& options,
              std::shared_ptr<SceneCache> cache) {
  Settings settings = base;
  settings.mode = Mode::sppm;
  settings.photons = std::max<std::uint64_t>(settings.photons, Settings{}.photons);
  auto const integrator = makeIntegrator(scene, settings, options.backend, nullptr, std::move(cache));
  integrator->advance(4);
  return integrator->film();
}

/// All modes with one seed, in turn.
class Round {
 public:
  Round(Contestants& all, const RunnerOptions& options, const StudyReference& reference, bool pictures)
      : all_(all), options_(options), reference_(reference), pictures_(pictures) {
    if (options.limits.seconds > 0) equalTime_ = options.limits.seconds;
  }

  /// Progress continues from the rounds before.
  void run(std::uint64_t& iterations, double& seconds) {
    while (Contestant* const next = leastServed()) {
      if (options_.stop && options_.stop()) break;
      std::uint64_t const iterationsBefore = next->iterations();
      double const secondsBefore = next->seconds();
      next->advance(reference_);
      if (next->done()) equalTime_ = std::min(equalTime_, next->seconds());
      if (pictures_) takePictures();
      iterations += next->iterations() - iterationsBefore;
      seconds += next->seconds() - secondsBefore;
      if (options_.progress) options_.progress(iterations, seconds);
    }
  }

 private:
  Contestant* leastServed() const {
    Contestant* least = nullptr;
    for (auto const& c : all_)
      if (!c->done() && (!least || c->seconds() < least->seconds())) least = c.get();
    return least;
  }

  void takePictures() {
    for (auto const& c : all_)
      if (!c->pictured() && (c->done() || c->seconds() >= equalTime_)) c->takePicture();
  }

  Contestants& all_;
  const RunnerOptions& options_;
  const StudyReference& reference_;
  bool pictures_;
  double equalTime_ = std::numeric_limits<double>::infinity();
};

StudyReference referenceOf(const Scene& scene, const Settings& base, const Settings& resolved,
                           const RunnerOptions& options, const std::shared_ptr<SceneCache>& cache) {
  if (options.reference.file.empty()) {
    ReferenceOptions asked = options.reference;
    asked.stop = options.stop;
    StudyReference made = makeReference(asked, scene, base, options.backend, cache);
    if (!options.reference.save.empty()) saveReference(options.reference, made, scene);
    return made;
  }
  StudyReference reference = readReference(options.reference, scene, resolved);
  requireSameScene(glimpse(scene, base, options, cache), reference);
  return reference;
}

Image firstHits(Aov what, const Scene& scene, const Settings& base, const RunnerOptions& options,
                const std::shared_ptr<SceneCache>& cache) {
  Settings settings = base;
  settings.mode = Mode::sppm;
  settings.aov = what;
  auto const integrator = makeIntegrator(scene, settings, options.backend, nullptr, cache);
  integrator->advance(1);
  return integrator->film();
}

void findEdgeShares(StudyScene& study, const Scene& scene, const Settings& base, const RunnerOptions& options,
                    const std::shared_ptr<SceneCache>& cache) {
  for (const StudyMode& mode : study.modes)
    if (mode.settings.mode == Mode::sppm) study.edgeRadius = std::max(study.edgeRadius, mode.settings.radius);
  if (study.edgeRadius == 0) return;
  std::vector<bool> const mask =
      nearEdges(firstHits(Aov::normal, scene, base, options, cache), firstHits(Aov::depth, scene, base, options, cache),
                scene.camera, study.edgeRadius);
  for (StudyMode& mode : study.modes)
    if (!mode.picture.pixels.empty()) mode.pictureEdges = edgeShare(mode.picture, study.reference, mask);
}

}  // namespace

StudyScene runModes(const Scene& scene, const Settings& base, const RunnerOptions& options) {
  StudyScene study;
  std::shared_ptr<SceneCache> cache;
  study.loadSeconds = secondsOf([&] { cache = makeSceneCache(scene); });
  Contestants all;
  for (const ModeSpec& spec : options.modes) {
    all.push_back(std::make_unique<Contestant>(scene, spec, options, cache));
    all.back()->warmUp();
  }
  study.name = scene.name;
  study.file = scene.file;
  study.reference = referenceOf(scene, base, all.front()->settings(), options, cache);

  std::uint64_t iterations = 0;
  double seconds = 0;
  for (int k = 0; k < options.seeds && !(options.stop && options.stop()); ++k) {
    for (auto const& c : all) c->start(k);
    Round(all, options, study.reference, k == 0).run(iterations, seconds);
    for (auto const& c : all)
      if (c->done()) c->endRun();
  }
  for (auto const& c : all) {
    study.device = c->device();
    study.modes.push_back(c->result(study.reference, options.trimmed));
    StudyMode& mode = study.modes.back();
    if (!mode.picture.pixels.empty()) mode.pictureFlip = flip(mode.picture, study.reference.image).mean;
  }
  findEdgeShares(study, scene, base, options, cache);
  return study;
}

}  // namespace ropelight
