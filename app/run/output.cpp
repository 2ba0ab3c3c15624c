#include "app/run/output.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <cstdio>
#include <filesystem>
#include <optional>
#include <system_error>

#include "app/run/standard_streams.h"
#include "render/core/error.h"
#include "render/image_files/atomic_file.h"

namespace ropelight {
namespace {

namespace fs = std::filesystem;

bool isFile(const std::string& path) { return !path.empty() && path != "-"; }

/// Where a file that is not there yet would be made.
fs::path placeOf(const std::string& path) {
  std::error_code failed;
  fs::path const given(path);
  fs::path const folder = fs::canonical(given.has_parent_path() ? given.parent_path() : fs::path("."), failed);
  return failed ? given.lexically_normal() : folder / given.filename();
}

bool sameFile(const std::string& a, const std::string& b) {
  struct stat of[2];
  bool const there[2] = {stat(a.c_str(), &of[0]) == 0, stat(b.c_str(), &of[1]) == 0};
  if (there[0] && there[1]) return of[0].st_dev == of[1].st_dev && of[0].st_ino == of[1].st_ino;
  return there[0] == there[1] && placeOf(a) == placeOf(b);
}

std::string alsoCalled(const std::string& name, const std::string& other) {
  return name == other ? "" : fmt::format(" (as {})", other);
}

}  // namespace

void requireWritable(const std::string& path) {
  try {
    checkWritable(path);
  } catch (const Error& error) {
    throw Error(error.what(), ExitCode::badInput);
  }
}

void requireNoInput(const std::string& output, const std::vector<std::string>& inputs) {
  if (!isFile(output)) return;
  for (const std::string& input : inputs)
    if (isFile(input) && sameFile(output, input))
      throw Error(fmt::format("{}: is read{} and would be overwritten; name another file for the output", output,
                              alsoCalled(output, input)),
                  ExitCode::usage);
}

void requireOutputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (!isFile(outputs[i])) continue;
    requireNoInput(outputs[i], inputs);
    for (std::size_t k = 0; k < i; ++k)
      if (isFile(outputs[k]) && sameFile(outputs[i], outputs[k]))
        throw Error(fmt::format("{}: two outputs are this file{}; name another one for each", outputs[i],
                                alsoCalled(outputs[i], outputs[k])),
                    ExitCode::usage);
  }
  for (const std::string& path : outputs)
    if (isFile(path)) requireWritable(path);
}

std::vector<std::string> filesOf(const Scene& scene) {
  std::vector<std::string> files{scene.file};
  for (const Mesh& mesh : scene.meshes) files.push_back(mesh.file);
  return files;
}

void makeFolder(const std::string& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) throw Error(fmt::format("{}: cannot make the folder: {}; name another one", folder, failed.message()));
}

void writeJson(const std::string& path, const nlohmann::ordered_json& json) {
  std::string const text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (path != "-") return writeFile(path, text);
  std::fputs(text.c_str(), stdout);
  flushStandardOutput();  // whose failure is reported at the end of the program
}

void writeAll(const std::vector<std::function<void()>>& writers) {
  std::optional<Error> failed;
  for (const auto& write : writers) {
    try {
      write();
    } catch (const Error& error) {
      if (!failed) failed = Error(error.what(), ExitCode::internal);
    }
  }
  if (failed) throw *failed;
}

}  // namespace ropelight
