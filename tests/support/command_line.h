#pragma once
// What the tests of the command line share.

#include <doctest/doctest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/program.h"

#ifdef ROPELIGHT_PROGRAM

namespace ropelight {

struct Result {
  int code;
  std::string out, err;
};

using Arguments = std::vector<std::string>;

inline const Arguments smallRender = {"render", "cornell",  "--backend", "cpu",       "--width",
                                      "16",     "--height", "12",        "--photons", "64"};

inline Arguments operator+(Arguments first, const Arguments& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

inline Result run(const TemporaryFolder& folder, const Arguments& arguments,
                  const std::string& program = ROPELIGHT_PROGRAM) {
  Program running(program, arguments, folder.path());
  int const code = running.exitCode();
  return {code, running.out(), running.err()};
}

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline nlohmann::json readJson(const std::filesystem::path& path) { return nlohmann::json::parse(fileBytes(path)); }

/// Refused with this code and one line on standard error that holds every part.
inline void checkRefused(const Arguments& arguments, int code, const Arguments& parts) {
  CAPTURE(arguments.back());
  TemporaryFolder const folder;
  Result const result = run(folder, arguments);
  CAPTURE(result.err);
  CHECK(result.code == code);
  CHECK(result.out.empty());
  CHECK(result.err.starts_with("ropelight: "));
  CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
  for (const std::string& part : parts) CHECK(contains(result.err, part));
  CHECK(folder.entries() == 2);  // the two streams and nothing else
}

}  // namespace ropelight

#endif
