#include "render/import/json/json_transform.h"

#include <fmt/format.h>

#include "render/scene/scene.h"
#include "render/scene/transform.h"

namespace ropelight {
namespace {

Mat4d readTranslate(const JsonNode& node) { return translation(node.vector(coordinateLimits)); }

Mat4d readRotate(const JsonNode& node) {
  node.allowKeys({"axis", "degrees"});
  Vec3d const axis = node.at("axis").vector(coordinateLimits);
  if (axis == Vec3d(0)) node.at("axis").failExpected("an axis other than [0, 0, 0]");
  return rotation(axis, node.at("degrees").number({"", -1e6, 1e6, "degrees"}));
}

Mat4d readScale(const JsonNode& node) {
  return scaling(node.isNumber() ? Vec3d(node.number(coordinateLimits)) : node.vector(coordinateLimits));
}

Mat4d readMatrix(const JsonNode& node) {
  std::vector<JsonNode> const entries = node.items();
  if (entries.size() != 16) node.failExpected("16 numbers, row by row");
  Mat4d m;
  for (int i = 0; i < 16; ++i) m[i % 4][i / 4] = entries[i].number(coordinateLimits);
  if (glm::dvec4(m[0][3], m[1][3], m[2][3], m[3][3]) != glm::dvec4(0, 0, 0, 1))
    node.fail("expected 0, 0, 0, 1 as the last row: transforms are affine");
  return m;
}

struct Operation {
  const char* key;
  Mat4d (*read)(const JsonNode&);
};

constexpr Operation operations[] = {
    {"translate", readTranslate}, {"rotate", readRotate}, {"scale", readScale}, {"matrix", readMatrix}};

Mat4d readOperation(const JsonNode& node) {
  std::vector<std::string> known;
  for (const Operation& operation : operations) known.push_back(operation.key);
  node.allowKeys(known);
  if (node.keys().size() != 1) node.fail("expected exactly one of translate, rotate, scale and matrix");
  Mat4d m(1.0);
  for (const Operation& operation : operations)
    if (auto value = node.find(operation.key)) m = operation.read(*value);
  return m;
}

}  // namespace

Mat4d readTransform(const JsonNode& node) {
  Mat4d m(1.0);
  for (const JsonNode& operation : node.items()) m = readOperation(operation) * m;
  return m;
}

}  // namespace ropelight
