#include "render/scene/text_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>

#include "render/core/error.h"

namespace ropelight {

std::string readTextFile(const std::filesystem::path& path, const std::string& remedy) {
  auto fail = [&](const char* reason) {
    throw Error(fmt::format("{}: cannot be read: {}; {}", path.string(), reason, remedy));
  };
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail("it is a directory");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if (!in) fail(errno ? std::strerror(errno) : "it cannot be opened");
  std::ostringstream text;
  if (in.peek() != std::ifstream::traits_type::eof()) text << in.rdbuf();
  if (in.bad() || !text) fail("reading stopped half-way");
  return std::move(text).str();
}

}  // namespace ropelight
