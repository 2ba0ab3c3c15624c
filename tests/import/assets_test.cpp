// The scenes in assets/ and the page on their format.

#include <doctest/doctest.h>

#include <sstream>

#include "render/import/load.h"
#include "render/scene/transform.h"
#include "tests/support/scene_files.h"
#include "tests/support/temporary_folder.h"

using namespace ropelight;
namespace fs = std::filesystem;

namespace {

void checkNear(Vec3d a, Vec3d b, double tolerance = 1e-12) {
  for (int i = 0; i < 3; ++i) CHECK(a[i] == doctest::Approx(b[i]).epsilon(tolerance).scale(1));
}

Vec3d at(const ShapeDesc& shape, Vec3d local) { return transformPoint(shape.toWorld, local); }

const ShapeDesc& shapeNamed(const Scene& scene, const std::string& name) {
  for (const ShapeDesc& shape : scene.shapes)
    if (shape.name == name) return shape;
  throw std::runtime_error("no shape " + name);
}

const MaterialDesc& materialOf(const Scene& scene, const ShapeDesc& shape) {
  return scene.materials.at(shape.material).desc;
}

/// Calls f with a default material of every kind.
template <class... Params, class F>
void forEachMaterial(const std::variant<Params...>&, F&& f) {
  (f(Params{}), ...);
}

}  // namespace

TEST_CASE("every asset loads and holds light") {
  int count = 0;
  for (const auto& entry : fs::directory_iterator(ROPELIGHT_ASSETS)) {
    if (entry.path().extension() != ".json") continue;
    CAPTURE(entry.path().string());
    ++count;
    if (entry.path().stem() == "bumpy" && !fs::exists(fs::path(ROPELIGHT_ASSETS) / "generated/bumpy100k.obj")) {
      MESSAGE("skipped bumpy.json: scripts/make_bumpy_mesh.py has not been run");
      continue;
    }
    Scene const scene = loadScene(entry.path());
    CHECK(scene.film.width == 512);
    bool lit = false;
    for (const ShapeDesc& shape : scene.shapes) lit = lit || shape.emission;
    CHECK(lit);
    if (entry.path().stem() == "bumpy") CHECK(scene.meshes.at(0).triangles.size() >= 100000);
  }
  CHECK(count >= 7);
}

TEST_CASE("the box with spheres is the outside renderers' scene") {
  Scene const scene = loadScene(fs::path(ROPELIGHT_ASSETS) / "box-spheres-diffuse.json");
  CHECK(scene.film.width == 512);
  CHECK(scene.film.height == 512);
  CHECK(scene.camera.verticalFov == 45);
  checkNear(scene.camera.position, {-0.0439815, -4.12529, 0.222539});
  checkNear(glm::normalize(scene.camera.target - scene.camera.position),
            glm::normalize(Vec3d(0.00688625, 0.998505, -0.0542161)));
  checkNear(scene.camera.up, {0.000373896, 0.0542148, 0.998529});

  // Each wall by its corners, its normal into the room, and its albedo.
  struct Wall {
    const char* name;
    Vec3d low, high, normal;
    Rgb albedo;
  };
  Vec3d const low(-1.27029, -1.25549, -1.28002), high(1.28975, 1.30455, 1.28002);
  Wall const walls[] = {
      {"floor", low, {high.x, high.y, low.z}, {0, 0, 1}, Rgb(.803922f)},
      {"ceiling", {low.x, low.y, high.z}, high, {0, 0, -1}, Rgb(.803922f)},
      {"back wall", {low.x, high.y, low.z}, high, {0, -1, 0}, Rgb(.803922f)},
      {"left wall", low, {low.x, high.y, high.z}, {1, 0, 0}, {.156863f, .803922f, .172549f}},
      {"right wall", {high.x, low.y, low.z}, high, {-1, 0, 0}, {.803922f, .152941f, .152941f}},
      {"light, left side", {-.25, -.25, 1.26002}, {-.25, .25, 1.28002}, {-1, 0, 0}, Rgb(.803922f)},
      {"light, right side", {.25, -.25, 1.26002}, {.25, .25, 1.28002}, {1, 0, 0}, Rgb(.803922f)},
      {"light, front side", {-.25, -.25, 1.26002}, {.25, -.25, 1.28002}, {0, -1, 0}, Rgb(.803922f)},
      {"light, back side", {-.25, .25, 1.26002}, {.25, .25, 1.28002}, {0, 1, 0}, Rgb(.803922f)},
      {"light", {-.25, -.25, 1.26002}, {.25, .25, 1.26002}, {0, 0, -1}, Rgb(0.0f)},
  };
  CHECK(scene.shapes.size() == std::size(walls) + 2);
  for (const Wall& wall : walls) {
    CAPTURE(wall.name);
    const ShapeDesc& shape = shapeNamed(scene, wall.name);
    Vec3d const a = at(shape, {0, 0, 0}), b = at(shape, {1, 1, 0});
    checkNear(glm::min(a, b), wall.low);
    checkNear(glm::max(a, b), wall.high);
    checkNear(glm::normalize(transformVector(shape.toWorld, {0, 0, 1})), wall.normal);
    CHECK(std::get<DiffuseParams>(materialOf(scene, shape)).albedo == wall.albedo);
    CHECK(bool(shape.emission) == (std::string(wall.name) == "light"));
  }
  const ShapeDesc& light = shapeNamed(scene, "light");
  CHECK(light.emission->radiance == Rgb(25.033299f));
  CHECK(light.emission->side == Side::out);

  const ShapeDesc& mirror = shapeNamed(scene, "mirror sphere");
  checkNear(at(mirror, {0, 0, 0}), {-.53885, .02453, -.78002});
  checkNear(at(mirror, {0, 0, -1}), {-.53885, .02453, -1.28002});
  CHECK(std::get<MirrorParams>(materialOf(scene, mirror)).reflectance == Rgb(1.0f));
  const ShapeDesc& glass = shapeNamed(scene, "glass sphere");
  checkNear(at(glass, {0, 0, 0}), {.55831, .02453, -.78002});
  checkNear(at(glass, {1, 0, 0}), {1.05831, .02453, -.78002});
  auto const dielectric = std::get<DielectricParams>(materialOf(scene, glass));
  CHECK(dielectric.ior == 1.6f);
  CHECK(dielectric.reflectance == Rgb(1.0f));
  CHECK(dielectric.transmittance == Rgb(1.0f));
}

TEST_CASE("the page on the scene format names every material, every parameter and its range") {
  std::string const page = fileBytes(fs::path(ROPELIGHT_ASSETS) / "../docs/scene-format.md");
  forEachMaterial(MaterialDesc{}, [&](auto params) {
    CAPTURE(params.name);
    CHECK(page.find(std::string("`\"type\": \"") + params.name + "\"`") != std::string::npos);
    params.params([&](const char* name, auto&, const ParamInfo& info) {
      std::ostringstream range;
      range << "[" << info.min << ", " << info.max << "]";
      CAPTURE(name);
      std::size_t const row = page.find(std::string("| `") + name + "` | " + params.name + " |");
      REQUIRE(row != std::string::npos);
      CHECK(page.substr(row, page.find('\n', row) - row).find(range.str()) != std::string::npos);
    });
  });
}

TEST_CASE("the complete example of the page loads") {
  std::string const page = fileBytes(fs::path(ROPELIGHT_ASSETS) / "../docs/scene-format.md");
  std::string const fence = "```json\n";
  std::size_t const start = page.find(fence);
  REQUIRE(start != std::string::npos);
  std::size_t const end = page.find("```", start + fence.size());
  REQUIRE(end != std::string::npos);
  TemporaryFolder folder;
  Scene const scene =
      loadScene(writeFile(folder, "example.json", page.substr(start + fence.size(), end - start - fence.size())));
  CHECK(scene.shapes.size() == 3);
}
