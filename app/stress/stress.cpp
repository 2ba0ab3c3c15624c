#include "app/stress/stress.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "accel/bvh/build.h"
#include "accel/kdtree/builder/build.h"
#include "app/run/output.h"
#include "measure/rays/hit_judge.h"
#include "measure/rays/meshes.h"
#include "measure/rays/stress_meshes.h"
#include "measure/rays/stress_rays.h"
#include "render/core/error.h"

namespace ropelight {
namespace {

constexpr std::size_t batchSize = 1u << 18;
constexpr std::uint32_t bruteLimit = 20000;  // with up to so many triangles brute force is the reference
constexpr std::int64_t fewUlp = 4;
constexpr double mostDoubtful = 1e-5;  // share of rays, beyond three

/// The result of one traversal on one mesh.
struct Verdict {
  std::string traversal;
  std::uint64_t rays = 0;
  std::uint64_t different = 0;  ///< another primitive at another distance than the reference has, which is acceptable
  std::uint64_t wrong = 0;      ///< not acceptable in double precision
  std::uint64_t escaped = 0;    ///< from within a closed mesh
};

struct MeshVerdict {
  std::string mesh, reference;
  std::size_t triangles = 0;
  std::uint64_t rays = 0;      ///< compared with the reference
  std::uint64_t doubtful = 0;  ///< of these, answered wrongly by the reference itself: left out
  std::vector<Verdict> verdicts;

  bool failed() const {
    bool const exact = reference == "brute";
    if (double(doubtful) > 3 + mostDoubtful * double(rays)) return true;
    return std::any_of(verdicts.begin(), verdicts.end(),
                       [&](const Verdict& v) { return v.wrong > 0 || v.escaped > 0 || (exact && v.different > 0); });
  }
};

/// Steps of float between two positive numbers.
std::int64_t ulpsBetween(float a, float b) {
  return std::abs(std::int64_t(std::bit_cast<std::int32_t>(a)) - std::int64_t(std::bit_cast<std::int32_t>(b)));
}

bool same(const StreamHit& a, const StreamHit& b) {
  if (a.found() != b.found()) return false;
  return !a.found() || a.primitive == b.primitive || ulpsBetween(a.t, b.t) <= fewUlp;
}

class MeshCheck {
 public:
  MeshCheck(const StressMesh& mesh, const StressOptions& options) : mesh_(mesh), options_(options) {
    scene_.flat = std::make_shared<FlatScene>(triangleScene(mesh.triangles));
    KdConfig tree;
    BvhConfig bvh;
    tree.threads = bvh.threads = options.backend.threads;
    scene_.tree = std::make_shared<KdTree>(buildKdTree(*scene_.flat, tree));
    scene_.bvh = std::make_shared<Bvh<2>>(buildBvh(*scene_.flat, bvh));
    scene_.wide = std::make_shared<Bvh<4>>(widen(*scene_.bvh));
    stream_ = makeRayStream(scene_, options.backend);
    for (const TraversalInfo& t : traversals)
      if (stream_->supports(t.id) && t.id != Traversal::embree && (t.id != Traversal::brute || byBruteForce()))
        used_.push_back(t);
    reference_ =
        byBruteForce() ? Traversal::brute : (stream_->supports(Traversal::embree) ? Traversal::embree : Traversal::bvh);
  }

  MeshVerdict run() {
    result_.mesh = mesh_.name;
    result_.triangles = mesh_.triangles.size();
    result_.reference = traversals[std::size_t(reference_)].name;
    for (const TraversalInfo& t : used_) result_.verdicts.push_back({t.name});
    StressRays rays(*scene_.flat, scene_.tree.get(), std::uint32_t(options_.seed));
    if (!byBruteForce() && reference_ != Traversal::embree) compare(rays.make(bruteRays()), Traversal::brute);
    for (std::uint64_t done = 0; done < options_.rays; done += batchSize) {
      std::size_t const n = std::size_t(std::min<std::uint64_t>(batchSize, options_.rays - done));
      compare(rays.make(n), reference_);
      if (mesh_.insideRadius > 0) countEscapes(rays.makeInside(n, mesh_.insideRadius));
    }
    return result_;
  }

  DeviceInfo device() const { return stream_->device(); }

 private:
  bool byBruteForce() const { return mesh_.triangles.size() <= bruteLimit; }

  /// As many as brute force answers in seconds.
  std::size_t bruteRays() const {
    double const tests = device().backend == BackendKind::cuda ? 5e11 : 1e9;
    return std::size_t(std::max(1.0, tests / double(mesh_.triangles.size())));
  }

  std::vector<StreamHit> trace(Traversal traversal, bool anyHit) {
    stream_->trace(traversal, anyHit);
    return stream_->hits();
  }

  struct Answers {
    std::vector<StreamHit> closest, any;
  };

  void compare(const std::vector<StreamRay>& rays, Traversal reference) {
    stream_->setRays(rays);
    std::vector<StreamHit> const expected = trace(reference, false);
    std::vector<Answers> answers;
    for (const TraversalInfo& t : used_)
      answers.push_back({t.id == reference ? expected : trace(t.id, false), trace(t.id, true)});
    result_.rays += rays.size();
    for (std::size_t i = 0; i < rays.size(); ++i) {
      bool const doubtful = std::any_of(answers.begin(), answers.end(), [&](const Answers& a) {
        return !same(a.closest[i], expected[i]) && !acceptable(rays[i], expected[i], a.closest[i]);
      });
      result_.doubtful += doubtful;
      for (std::size_t k = 0; k < used_.size() && !doubtful; ++k)
        note(result_.verdicts[k], rays[i], answers[k].closest[i], answers[k].any[i], expected[i]);
    }
  }

  /// Whether the double-precision judge accepts a hit, given another structure's.
  bool acceptable(const StreamRay& ray, const StreamHit& hit, const StreamHit& other) const {
    StreamHit const candidates[] = {hit, other};
    return HitJudge(*scene_.flat).acceptable(ray, hit, candidates);
  }

  void note(Verdict& verdict, const StreamRay& ray, const StreamHit& hit, const StreamHit& any,
            const StreamHit& expected) {
    ++verdict.rays;
    verdict.wrong += any.found() != hit.found();
    if (same(hit, expected)) return;
    ++verdict.different;
    verdict.wrong += !acceptable(ray, hit, expected);
  }

  void countEscapes(const std::vector<StreamRay>& rays) {
    stream_->setRays(rays);
    for (std::size_t k = 0; k < used_.size(); ++k) {
      std::vector<StreamHit> const hits = trace(used_[k].id, false), any = trace(used_[k].id, true);
      result_.verdicts[k].rays += rays.size();
      for (std::size_t i = 0; i < rays.size(); ++i) result_.verdicts[k].escaped += !hits[i].found() || !any[i].found();
    }
  }

  const StressMesh& mesh_;
  const StressOptions& options_;
  StreamScene scene_;
  std::unique_ptr<RayStream> stream_;
  std::vector<TraversalInfo> used_;
  Traversal reference_;
  MeshVerdict result_;
};

void print(const MeshVerdict& m) {
  fmt::print("\n{}: {} triangles, against {}\n", m.mesh, m.triangles, m.reference);
  for (const Verdict& v : m.verdicts)
    fmt::print("  {:<14}{:>12} rays {:>8} different {:>8} wrong {:>8} escaped\n", v.traversal, v.rays, v.different,
               v.wrong, v.escaped);
  if (m.doubtful > 0)
    fmt::print("  {} of {} rays left out: there the reference is wrong in double precision\n", m.doubtful, m.rays);
}

nlohmann::ordered_json toJson(const MeshVerdict& m) {
  auto verdicts = nlohmann::ordered_json::array();
  for (const Verdict& v : m.verdicts)
    verdicts.push_back({{"traversal", v.traversal},
                        {"rays", v.rays},
                        {"different", v.different},
                        {"wrong", v.wrong},
                        {"escaped", v.escaped}});
  return {{"mesh", m.mesh}, {"triangles", m.triangles}, {"reference", m.reference},
          {"rays", m.rays}, {"doubtful", m.doubtful},   {"verdicts", verdicts}};
}

}  // namespace

int runStress(const StressOptions& options) {
  requireOutputs({options.json}, {options.mesh});
  std::vector<StressMesh> meshes = stressMeshes(options.full);
  if (!options.mesh.empty()) {
    meshes.push_back({options.mesh, objTriangles(options.mesh), 0});
    normalise(meshes.back().triangles);
  }
  auto json = nlohmann::ordered_json::array();
  bool failed = false;
  std::string device;
  for (const StressMesh& mesh : meshes) {
    MeshCheck check(mesh, options);
    MeshVerdict const verdict = check.run();
    device = check.device().name;
    failed |= verdict.failed();
    if (options.json != "-") print(verdict);
    json.push_back(toJson(verdict));
  }
  if (options.json != "-")
    fmt::print("\n{} on {}, seed {}\n", failed ? "FAILED" : "all hits right", device, options.seed);
  if (!options.json.empty()) writeJson(options.json, {{"device", device}, {"seed", options.seed}, {"meshes", json}});
  return int(failed ? ExitCode::checkFailed : ExitCode::done);
}

}  // namespace ropelight
