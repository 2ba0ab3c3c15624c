#include "app/output.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "render/core/error.h"
#include "render/film/atomic_file.h"

namespace ropelight {

void requireWritable(const std::string& path) {
  try {
    checkWritable(path);
  } catch (const Error& error) {
    throw Error(error.what(), ExitCode::badInput);
  }
}

void writeJson(const std::string& path, const nlohmann::ordered_json& json) {
  std::string const text = json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  if (path != "-") return writeFile(path, text);
  if (std::fputs(text.c_str(), stdout) < 0 || std::fflush(stdout) != 0)
    throw Error(fmt::format("standard output: cannot write: {}", std::strerror(errno)), ExitCode::internal);
}

}  // namespace ropelight
