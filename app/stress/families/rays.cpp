// Every traversal on the rays and meshes on which tracers fail.

#include <algorithm>
#include <bit>
#include <cmath>

#include "accel/bvh/build.h"
#include "accel/kdtree/builder/build.h"
#include "app/stress/families/families.h"
#include "measure/rays/hit_judge.h"
#include "measure/rays/meshes.h"
#include "measure/rays/stress_meshes.h"
#include "measure/rays/stress_rays.h"

namespace ropelight::families {
namespace {

constexpr std::size_t batchSize = 1u << 16;
constexpr std::uint32_t bruteLimit = 20000;  // with up to so many triangles brute force is the reference
constexpr double fewTests = 4e8;             // likewise
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

  /// Rays that a traversal failed, and what the reference itself may fail.
  std::vector<Measurement> measurements() const {
    bool const exact = reference == "brute";
    std::vector<Measurement> out;
    for (const Verdict& v : verdicts)
      out.push_back({v.traversal, double(triangles), double(v.wrong + v.escaped + (exact ? v.different : 0))});
    Measurement left{"left out: the reference is wrong in double precision", double(triangles), double(doubtful)};
    left.bound = 3 + mostDoubtful * double(rays);
    out.push_back(left);
    return out;
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
  MeshCheck(const StressMesh& mesh, const RayOptions& options, const BackendChoice& backend, std::uint64_t seed)
      : mesh_(mesh), options_(options), seed_(seed) {
    scene_.flat = std::make_shared<FlatScene>(triangleScene(mesh.triangles));
    KdConfig tree;
    BvhConfig bvh;
    tree.threads = bvh.threads = backend.threads;
    scene_.tree = std::make_shared<KdTree>(buildKdTree(*scene_.flat, tree));
    scene_.bvh = std::make_shared<Bvh<2>>(buildBvh(*scene_.flat, bvh));
    scene_.wide = std::make_shared<Bvh<4>>(widen(*scene_.bvh));
    stream_ = makeRayStream(scene_, backend);
    for (const TraversalInfo& t : traversals)
      if (stream_->supports(t.id) && t.id != Traversal::embree && (t.id != Traversal::brute || byBruteForce()))
        used_.push_back(t);
    reference_ =
        byBruteForce() ? Traversal::brute : (stream_->supports(Traversal::embree) ? Traversal::embree : Traversal::bvh);
  }

  MeshVerdict run(const Probe& probe) {
    result_.mesh = mesh_.name;
    result_.triangles = mesh_.triangles.size();
    result_.reference = traversals[std::size_t(reference_)].name;
    for (const TraversalInfo& t : used_) result_.verdicts.push_back({t.name});
    StressRays rays(*scene_.flat, scene_.tree.get(), std::uint32_t(seed_));
    if (!byBruteForce() && reference_ != Traversal::embree) compare(rays.make(bruteRays()), Traversal::brute);
    for (std::uint64_t done = 0; done < options_.rays; done += batchSize) {
      probe.tick();
      std::size_t const n = std::size_t(std::min<std::uint64_t>(batchSize, options_.rays - done));
      compare(rays.make(n), reference_);
      if (mesh_.insideRadius > 0) countEscapes(rays.makeInside(n, mesh_.insideRadius));
    }
    return result_;
  }

  DeviceInfo device() const { return stream_->device(); }

 private:
  bool byBruteForce() const {
    double const tests = double(mesh_.triangles.size()) * double(options_.rays);
    return mesh_.triangles.size() <= bruteLimit || tests <= fewTests;
  }

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
  const RayOptions& options_;
  std::uint64_t seed_;
  StreamScene scene_;
  std::unique_ptr<RayStream> stream_;
  std::vector<TraversalInfo> used_;
  Traversal reference_;
  MeshVerdict result_;
};

std::vector<Measurement> checkMesh(const StressMesh& mesh, const RayOptions& options, Probe& probe) {
  probe.tick();
  if (probe.backend().backend == BackendKind::cpu64) throw LeftOut{"rays are checked in floats"};
  RayOptions asked = options;
  if (probe.isShort()) asked.rays = std::min<std::uint64_t>(asked.rays, 4000);
  return MeshCheck(mesh, asked, probe.backend(), probe.seed()).run(probe).measurements();
}

const StressMesh* find(const std::vector<StressMesh>& meshes, const std::string& name) {
  for (const StressMesh& mesh : meshes)
    if (mesh.name == name) return &mesh;
  return nullptr;
}

/// most: rays where each takes long.
StressCase onMesh(const char* name, const char* hard, RayOptions options, bool isShort,
                  std::uint64_t most = ~std::uint64_t(0)) {
  options.rays = std::min(options.rays, most);
  return {name,
          hard,
          "triangles",
          "rays answered wrongly or escaped",
          "brute force, else Embree or our BVH; doubts by a judge in double precision",
          "none; up to 3 and 1e-5 of the rays may be too near an edge for any answer",
          isShort,
          [name, options](Probe& probe) {
            std::vector<StressMesh> const meshes = stressMeshes(options.full);
            return checkMesh(*find(meshes, name), options, probe);
          }};
}

}  // namespace

StressFamily rays(const RayOptions& options) {
  StressFamily family{"rays",
                      "rays along edges, through vertices and in planes, on degenerate, dense, tiny and far meshes",
                      {onMesh("closed ball", "rays from inside must not escape", options, true),
                       onMesh("ball in a room", "sizes that differ by far", options, false),
                       onMesh("tiny ball", "coordinates of 1e-9", options, true),
                       onMesh("huge ball", "coordinates of 1e9", options, true),
                       onMesh("far ball", "a place where floats are far apart", options, false),
                       onMesh("soup", "triangles from a millionth of the scene to all of it", options, false),
                       onMesh("needles", "slivers 1e-7 thin", options, true),
                       onMesh("degenerate", "points, segments, triangles that share all vertices", options, true),
                       onMesh("flat", "three walls at one place", options, false),
                       onMesh("grain in a hall", "a dense mesh a millionth of the scene's size", options, false),
                       onMesh("coincident", "nine thousand triangles at one place", options, false),
                       onMesh("fan", "1e5 triangles through one point", options, false, 2000)}};
  if (options.full) family.cases.push_back(onMesh("ball of a million", "a million triangles", options, false));
  if (!options.mesh.empty())
    family.cases.push_back({"mesh", "the mesh of --mesh", "triangles", "rays answered wrongly or escaped", "as above",
                            "as above", true, [options](Probe& probe) {
                              StressMesh mesh{options.mesh, objTriangles(options.mesh), 0};
                              normalise(mesh.triangles);
                              return checkMesh(mesh, options, probe);
                            }});
  return family;
}

}  // namespace ropelight::families
