// A scene format and a BSDF that are in their list are found, named in errors, and used.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "render/core/error.h"
#include "render/import/json/json_material.h"
#include "render/import/load.h"
#include "render/upload/upload.h"

namespace ropelight {

struct DummyParams {
  static constexpr const char* name = "dummy";
  static constexpr const char* doc = "Of this test.";
  static constexpr FeatureBits bit = feature::diffuse;
  static constexpr bool transmits = false;
  float grey = 0.5f;

  template <class V>
  void params(V&& v) {
    v("grey", grey, ParamInfo{"fraction of the light reflected", 0, 1});
  }
};

namespace cpu {
struct Dummy : DummyParams {
  using Params = DummyParams;
  static constexpr std::uint32_t possibleLobes = lobe::diffuse;
  std::uint32_t lobes() const { return possibleLobes; }
  Rgb directionalAlbedo(Vec3) const { return Rgb(grey); }
};
}  // namespace cpu

}  // namespace ropelight

using namespace ropelight;
using namespace ropelight::cpu;

namespace {

#define WITH_DUMMY(X) RL_BSDFS(X) X(Dummy)
#define PARAMS(name) , name##Params
#define BSDF(name) , cpu::name
using Desc = FromWords<std::variant, void WITH_DUMMY(PARAMS)>;
using Kinds = FromWords<List, void WITH_DUMMY(BSDF)>;

Desc materialOf(const char* text) {
  std::string const file = "s.json";
  nlohmann::json const json = nlohmann::json::parse(text);
  return readMaterial<Desc>(JsonNode(file, json));
}

std::vector<Importer> withDummy() {
  std::vector<Importer> all(importers().begin(), importers().end());
  all.push_back({{".dummy", ".dmy"}, "a format of this test", [](const std::filesystem::path& path) {
                   Scene scene = loadScene(std::string(ROPELIGHT_ASSETS) + "/cornell.json");
                   scene.name = path.stem().string();
                   return scene;
                 }});
  return all;
}

}  // namespace

TEST_CASE("a scene format is one line of the table") {
  CHECK(loadScene("there.DMY", withDummy()).name == "there");
  CHECK(sceneExtensions(withDummy()) == std::vector<std::string>{".json", ".obj", ".dummy", ".dmy"});
  CHECK_THROWS_WITH_AS(loadScene("x.abc", withDummy()),
                       "x.abc: \".abc\" is no known scene format; expected one of .json, .obj, .dummy, .dmy", Error);
  CHECK_THROWS_AS(loadScene("there.dmy"), Error);
}

TEST_CASE("a BSDF is one word of the list") {
  Desc const desc = materialOf(R"({"type": "dummy", "grey": 0.25})");
  REQUIRE(std::holds_alternative<DummyParams>(desc));
  CHECK_THROWS_WITH_AS(materialOf(R"({"type": "chalk"})"), doctest::Contains("dielectric, dummy"), Error);
  CHECK_THROWS_WITH_AS(materialOf(R"({"type": "dummy", "grey": 2})"), doctest::Contains("/grey"), Error);

  Material const material = toTarget<Kinds>(desc);
  CHECK(material.kind == 3);
  int visits = 0;
  visitBsdf<feature::all, Kinds>(material, [&](const auto& bsdf) {
    ++visits;
    CHECK(bsdf.directionalAlbedo(Vec3(0, 0, 1)) == Rgb(0.25f));
  });
  CHECK(visits == 1);
}
