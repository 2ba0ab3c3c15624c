#pragma once
// Scenes spoilt in one place, and what the loaders say of them.

#include <doctest/doctest.h>

#include "render/core/error.h"
#include "render/import/load.h"
#include "tests/support/scene_files.h"

namespace ropelight::bad {

namespace fs = std::filesystem;

/// The message of a failed load, without the path of the folder; the exit code is checked on the way.
inline std::string messageOf(const TemporaryFolder& folder, const fs::path& path) {
  try {
    loadScene(path);
  } catch (const Error& error) {
    CHECK(error.code() == ExitCode::badInput);
    std::string text = error.what();
    std::string const prefix = folder.path().string() + "/";
    for (std::size_t at; (at = text.find(prefix)) != std::string::npos;) text.erase(at, prefix.size());
    return text;
  }
  return "no error";
}

inline std::string messageOfText(const std::string& text, const std::string& name = "s.json") {
  TemporaryFolder folder;
  return messageOf(folder, writeFile(folder, name, text));
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A good scene, part by part, so that a test can spoil one.
struct Parts {
  std::string camera = R"({"position": [0, 0, 5], "target": [0, 0, 0]})";
  std::string materials = R"({"white": {"type": "diffuse"}})";
  std::string shapes = R"([{"type": "sphere", "material": "white"}])";
  std::string more;

  std::string text() const {
    return "{\"camera\": " + camera + ", \"materials\": " + materials + ", \"shapes\": " + shapes + more + "}";
  }
};

inline std::string ofCamera(const std::string& camera) {
  Parts parts;
  parts.camera = camera;
  return messageOfText(parts.text());
}

inline std::string ofMaterial(const std::string& material) {
  Parts parts;
  parts.materials = "{\"white\": {\"type\": \"diffuse\"}, \"m\": " + material + "}";
  return messageOfText(parts.text());
}

inline std::string ofShape(const std::string& shape) {
  Parts parts;
  parts.shapes = "[" + shape + "]";
  return messageOfText(parts.text());
}

inline std::string ofSphere(const std::string& members) {
  return ofShape(R"({"type": "sphere", "material": "white", )" + members + "}");
}

inline std::string ofTransform(const std::string& operations) {
  return ofSphere("\"transform\": [" + operations + "]");
}

inline std::string ofMore(const std::string& more) {
  Parts parts;
  parts.more = ", " + more;
  return messageOfText(parts.text());
}

inline std::string ofObj(const std::string& text) { return messageOfText(text, "m.obj"); }

}  // namespace ropelight::bad
