#include "render/text/text_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string_view>

#include "render/core/error.h"

namespace ropelight {
namespace {

/// UTF-16 or UTF-32 by mark, or by how many of the first bytes are zero; nothing where it is neither.
const char* wideEncoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
  if (text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv)) return "UTF-16";
  std::string_view const start = text.substr(0, 256);
  auto const zeros = std::size_t(std::count(start.begin(), start.end(), '\0'));
  if (zeros * 10 > start.size() * 6) return "UTF-32";
  if (zeros * 10 > start.size() * 3) return "UTF-16";
  return nullptr;
}

}  // namespace

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
  std::string bytes = std::move(text).str();
  if (const char* const encoding = wideEncoding(bytes))
    throw Error(fmt::format("{}: the text is in {}; save it in UTF-8", path.string(), encoding));
  if (std::size_t const zero = bytes.find('\0'); zero != std::string::npos)
    throw Error(fmt::format("{}: byte {} is zero, so this is no text; {}", path.string(), zero + 1, remedy));
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.erase(0, 3);
  return bytes;
}

}  // namespace ropelight
