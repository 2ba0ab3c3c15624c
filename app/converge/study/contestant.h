#pragma once
// One mode of a study at work.

#include <memory>

#include "app/converge/study/runner.h"
#include "app/run/sample_schedule.h"

namespace ropelight {

/// Advances one mode's integrator, keeps the time that its iterations take, and measures its film when that is due.
class Contestant {
 public:
  Contestant(const Scene& scene, const ModeSpec& spec, const RunnerOptions& options, std::shared_ptr<SceneCache> cache);

  /// One iteration before the runs, in which the kernels are loaded and the buffers grow.
  void warmUp();
  /// The mean of the iterations since warmUp() or start().
  Image film() const { return integrator_->film(); }
  /// Begins run k with an empty film and the k-th seed after the mode's own.
  void start(int k);
  /// About a tenth of a second of iterations at most, and a sample where one is due.
  void advance(const StudyReference& reference);
  bool done() const { return done_; }
  double seconds() const { return seconds_; }
  std::uint64_t iterations() const { return iterations_; }
  /// Keeps the film as the picture at equal time.
  void takePicture();
  bool pictured() const { return !mode_.picture.pixels.empty(); }
  /// Adds the film to the sums for the split of the error.
  void endRun();
  /// The results; to be called after the runs.
  StudyMode result(const StudyReference& reference, bool trimmed);
  const Settings& settings() const { return mode_.settings; }
  std::string device() const { return integrator_->stats().device; }

 private:
  std::uint64_t nextBatch() const;
  void sample(const StudyReference& reference);
  ErrorSplit split(const StudyReference& reference) const;

  const Scene& scene_;
  const RunnerOptions& options_;
  Settings asked_;
  std::shared_ptr<SceneCache> cache_;
  std::unique_ptr<Integrator> integrator_;
  StudyMode mode_;
  SampleSchedule schedule_;
  double seconds_ = 0;
  std::uint64_t iterations_ = 0;
  std::uint64_t latestBatch_ = 0;
  double latestSeconds_ = 0;
  bool done_ = false;
  int ended_ = 0;
  std::vector<Vec3d> sum_, squares_;  ///< over the films at the end of the runs
};

}  // namespace ropelight
