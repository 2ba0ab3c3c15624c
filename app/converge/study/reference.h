#pragma once
// The image that a study measures against: from a file, or made, and how far it is itself converged.

#include <functional>
#include <memory>
#include <optional>

#include "app/converge/analysis/study.h"
#include "app/converge/study/mode_spec.h"
#include "render/scene/scene.h"

namespace ropelight {

struct ReferenceOptions {
  std::string file;               ///< .exr; {scene} stands for the scene's name; empty: made
  double seconds = 0;             ///< to make it in; 0: see iterations
  std::uint64_t iterations = 0;   ///< to make it of, both halves together
  std::string mode;               ///< as --modes takes it; empty: path or sppm, whichever trials say will be nearer
  std::optional<double> noise;    ///< relMSE of a file's noise, where the file does not say
  std::string save;               ///< .exr to keep a made one in; {scene} as above; empty: nowhere
  std::function<bool()> stop;     ///< asked now and then while one is made
  std::optional<double> epsilon;  ///< ε of relMSE; empty: 0.01·mean(reference²)
};

/// `pattern` with {scene} replaced by the scene's name.
std::string forScene(const std::string& pattern, const Scene& scene);

/// Reads the reference of a scene whose runs have these resolved settings. Throws Error (badInput) where it cannot be
/// that: another size, primaries other than Rec. 709's, pixels that are not finite, or metadata that name another
/// scene or settings under which the scene emits other light (aov, max-depth, indirect-only, direct light left out).
StudyReference readReference(const ReferenceOptions& options, const Scene& scene, const Settings& resolved);

/// ε of relMSE: what is asked for, or 0.01·mean(reference²).
double relativeEpsilon(const Image& reference, std::optional<double> asked);

/// Makes it from two independent halves, whose difference gives the noise of their mean. What both halves have in
/// common, such as the bias that a gather radius leaves, the noise does not show; sppm takes half the automatic radius,
/// so that it is less.
StudyReference makeReference(const ReferenceOptions& options, const Scene& scene, const Settings& base,
                             const BackendChoice& backend, std::shared_ptr<SceneCache> cache);

/// Writes a made reference with its noise, so that readReference knows it.
void saveReference(const ReferenceOptions& options, const StudyReference& reference, const Scene& scene);

/// Throws Error (badInput) where a quick image of the scene is nowhere near the reference: where the means of half of
/// its tiles (a sixteenth of its width wide, at most 32 pixels) are off by more than 8% of the tile's mean and of the
/// image's.
void requireSameScene(const Image& glimpse, const StudyReference& reference);

}  // namespace ropelight
