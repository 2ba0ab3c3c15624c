#include "render/image_files/png_colour.h"

#include <fmt/format.h>
#include <zlib.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string_view>

namespace ropelight {
namespace {

constexpr std::string_view signature("\x89PNG\r\n\x1a\n", 8);
constexpr std::uint32_t mostLength = 0x7fffffff;
constexpr int mostChunks = 10000;  // before the image data

std::uint32_t bigEndian(std::string_view bytes) {
  std::uint32_t value = 0;
  for (char const c : bytes.substr(0, 4)) value = value << 8 | std::uint8_t(c);
  return value;
}

std::string readBytes(std::istream& in, std::size_t count) {
  std::string bytes(count, '\0');
  in.read(bytes.data(), std::streamsize(count));
  bytes.resize(std::size_t(in.gcount()));
  return bytes;
}

/// Printable ASCII of the name that starts an iCCP chunk.
std::string profileName(std::string_view data) {
  std::string name;
  for (char const c : data.substr(0, data.find('\0')))
    if (c >= ' ' && c <= '~' && name.size() < 79) name += c;
  return name;
}

/// Whether cHRM has the primaries and the white of Rec. 709, in units of 10⁻⁵.
bool isRec709(std::string_view data) {
  constexpr std::array<int, 8> ours = {31270, 32900, 64000, 33000, 30000, 60000, 15000, 6000};
  for (std::size_t i = 0; i < ours.size(); ++i)
    if (std::abs(double(bigEndian(data.substr(4 * i))) - ours[i]) > 100) return false;
  return true;
}

class Reader {
 public:
  void take(const std::string& type, std::string_view data) {
    if (type == "sRGB") {
      if (data.size() == 1) standard_ = true;
    } else if (type == "gAMA") {
      std::uint32_t const value = data.size() == 4 ? bigEndian(data) : 0;
      if (value == 0) return ignore("a damaged gAMA chunk");
      gamma_ = value * 1e-5;
    } else if (type == "iCCP") {
      ignore(fmt::format("its ICC profile \"{}\"", profileName(data)));
    } else if (type == "cICP") {
      ignore("its coding-independent code points (cICP)");
    } else if (type == "cHRM" && data.size() == 32 && !isRec709(data)) {
      ignore("primaries other than Rec. 709's (cHRM)");
    }
  }
  void ignore(const std::string& what) { ignored_ += (ignored_.empty() ? "" : "; ") + what; }

  PngColour colour() const { return {standard_ ? 0 : gamma_, ignored_}; }

 private:
  bool standard_ = false;
  double gamma_ = 0;
  std::string ignored_;
};

bool wanted(const std::string& type) {
  for (const char* known : {"sRGB", "gAMA", "iCCP", "cICP", "cHRM"})
    if (type == known) return true;
  return false;
}

/// Reads the data and the CRC of a chunk whose type has been read; nothing where it is damaged.
std::optional<std::string> sound(std::istream& in, const std::string& type, std::uint32_t length) {
  constexpr std::uint32_t mostData = 1 << 24;
  if (length > mostData) return {};
  std::string const data = readBytes(in, length), sum = readBytes(in, 4);
  std::string const body = type + data;
  auto const expected = crc32_z(0, reinterpret_cast<const Bytef*>(body.data()), body.size());
  if (data.size() != length || sum.size() != 4 || bigEndian(sum) != expected) return {};
  return data;
}

}  // namespace

PngColour readPngColour(const std::filesystem::path& path) {
  Reader reader;
  std::ifstream in(path, std::ios::binary);
  if (readBytes(in, signature.size()) != signature) return {};
  for (int i = 0; i < mostChunks && in; ++i) {
    std::string const start = readBytes(in, 8);
    if (start.size() != 8) break;
    std::uint32_t const length = bigEndian(start);
    std::string const type = start.substr(4);
    if (length > mostLength || type == "IDAT" || type == "IEND") break;
    if (!wanted(type)) {
      in.seekg(std::streamoff(length) + 4, std::ios::cur);
    } else if (auto const data = sound(in, type, length)) {
      reader.take(type, *data);
    } else {
      reader.ignore(fmt::format("a damaged {} chunk", type));
      break;
    }
  }
  return reader.colour();
}

}  // namespace ropelight
