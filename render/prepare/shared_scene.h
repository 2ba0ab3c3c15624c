#pragma once
// What several renderings of one scene share, as the program sees it.

#include <memory>

namespace ropelight {

struct Scene;

/// What integrators of one scene may share: its flat form, and the trees built so far (the latest few). Any thread may
/// use it.
class SceneCache;
std::shared_ptr<SceneCache> makeSceneCache(const Scene& scene);

}  // namespace ropelight
