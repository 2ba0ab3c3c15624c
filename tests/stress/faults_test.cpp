// The catalogue's bounds are tight enough to find the faults that they are there for: each is put into the kernels, and
// its case must fail. Without a fault the same copy of the kernels holds; that the program's does is in
// stress_test.cpp.

#include <doctest/doctest.h>

#include <string>

#include "app/stress/catalogue.h"
#include "tests/stress/faulty_integrators.h"

using namespace ropelight;
using namespace ropelight::testing;

namespace {

struct Mutation {
  Fault fault;
  const char* what;
  const char* caseName;
};

constexpr Mutation mutations[] = {
    {Fault::roulette, "a constant cap of roulette", "furnace"},
    {Fault::depthLimit, "paths end after 256 edges", "facing mirrors"},
    {Fault::rayOrigin, "rays start on the surface", "sphere sizes"},
    {Fault::segmentEnd, "shadow rays start on the surface", "same place"},
    {Fault::reflectance, "Schlick for Fresnel", "grazing pane"},
    {Fault::totalReflection, "no total reflection", "light pipe"},
    {Fault::otherSide, "photons count through a wall", "thin wall"},
    {Fault::discHeight, "discs without ends", "radii"},
    {Fault::chunkNumbers, "every pass has the same photons", "memory"},
    {Fault::wholeDisc, "walls darken towards their edges", "edges"},
    {Fault::foreignRows, "colliding rows count twice", "collisions"},
    {Fault::lampCone, "1 - cos cancels", "small light"},
};

CaseResult run(const StressCase& c, Fault fault) {
  CaseResult result;
  Probe probe({BackendKind::cpu, 0, 0, false}, 1, true, [] {});
  probe.useMaker([&](const Scene& scene, const Settings& settings, const BackendChoice& choice) {
    return makeFaulty(scene, settings, choice, fault);
  });
  result.measurements = c.measure(probe);
  result.nonFinite = probe.nonFinite();
  return result;
}

}  // namespace

TEST_SUITE("slow") {
  TEST_CASE("stress finds each of twelve faults") {
    CHECK(run(chooseCases(stressCatalogue(), {"thin wall"}, true)[0].cases[0], Fault::none).verdict() == Holds::yes);
    for (const Mutation& m : mutations) {
      std::string const what = m.what;
      CAPTURE(what);
      std::vector<StressFamily> const chosen = chooseCases(stressCatalogue(), {m.caseName}, true);
      REQUIRE(chosen.size() == 1);
      const StressCase& c = chosen[0].cases[0];
      CHECK(run(c, m.fault).verdict() == Holds::no);
    }
  }
}
