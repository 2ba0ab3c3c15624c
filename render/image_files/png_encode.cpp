#include "render/image_files/png_encode.h"

#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

namespace ropelight {
namespace {

constexpr int channels = 3;
constexpr std::size_t bandBytes = 1 << 20;    // deflated by one thread, one IDAT chunk each
constexpr std::size_t windowBytes = 1 << 15;  // how far back deflate looks
constexpr int level = 3;                      // renders come out no larger than at 6, twice as fast

using Bytes = std::vector<std::uint8_t>;

std::string bigEndian(std::uint32_t value) {
  return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}

std::uint32_t crcOf(std::string_view bytes) {
  return std::uint32_t(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

/// Length, type, data, CRC over type and data (PNG 3rd edition, §5.3).
std::string chunk(const char* type, std::string_view data) {
  std::string const body = type + std::string(data);
  return bigEndian(std::uint32_t(data.size())) + body + bigEndian(crcOf(body));
}

std::string header(int width, int height) {
  constexpr std::string_view bitsAndKind("\x08\x02\x00\x00\x00", 5);  // 8 bits, RGB, deflate, adaptive filters
  return std::string("\x89PNG\r\n\x1a\n") +
         chunk("IHDR", bigEndian(std::uint32_t(width)) + bigEndian(std::uint32_t(height)) + std::string(bitsAndKind)) +
         chunk("sRGB", std::string_view("\0", 1));  // perceptual intent
}

std::uint8_t paeth(int left, int up, int corner) {
  int const guess = left + up - corner;
  int const byLeft = std::abs(guess - left), byUp = std::abs(guess - up), byCorner = std::abs(guess - corner);
  if (byLeft <= byUp && byLeft <= byCorner) return std::uint8_t(left);
  return std::uint8_t(byUp <= byCorner ? up : corner);
}

/// The row by filter 0 to 4 (PNG 3rd edition, §9.2), its number first.
template <int filter>
void applyFilter(const std::uint8_t* row, const std::uint8_t* above, int bytes, std::uint8_t* out) {
  *out++ = filter;
  for (int i = 0; i < bytes; ++i) {
    int const left = i < channels ? 0 : row[i - channels], up = above[i],
              corner = i < channels ? 0 : above[i - channels];
    int const guess = filter == 1   ? left
                      : filter == 2 ? up
                      : filter == 3 ? (left + up) / 2
                      : filter == 4 ? paeth(left, up, corner)
                                    : 0;
    out[i] = std::uint8_t(row[i] - guess);
  }
}

/// What the usual heuristic wants small: differences as signed numbers.
std::uint64_t roughness(const std::uint8_t* filtered, int bytes) {
  std::uint64_t sum = 0;
  for (int i = 1; i <= bytes; ++i) sum += std::uint64_t(std::abs(int(std::int8_t(filtered[i]))));
  return sum;
}

/// Appends the row by whichever filter leaves it smoothest.
void appendFiltered(const std::uint8_t* row, const std::uint8_t* above, int bytes, Bytes& out,
                    std::array<Bytes, 5>& tries) {
  for (Bytes& t : tries) t.resize(std::size_t(bytes) + 1);
  applyFilter<0>(row, above, bytes, tries[0].data());
  applyFilter<1>(row, above, bytes, tries[1].data());
  applyFilter<2>(row, above, bytes, tries[2].data());
  applyFilter<3>(row, above, bytes, tries[3].data());
  applyFilter<4>(row, above, bytes, tries[4].data());
  std::size_t best = 0;
  std::uint64_t least = ~std::uint64_t{0};
  for (std::size_t i = 0; i < tries.size(); ++i)
    if (std::uint64_t const rough = roughness(tries[i].data(), bytes); rough < least) {
      best = i;
      least = rough;
    }
  out.insert(out.end(), tries[best].begin(), tries[best].end());
}

/// Rows that one thread filters and deflates. It continues the stream of the band before, whose end it may refer to.
struct Band {
  int first = 0, count = 0;
  Bytes filtered;
  std::string deflated;
  uLong adler = 0;

  void filter(int width, const PngRows& rows) {
    int const bytes = width * channels;
    int const before = first > 0 ? 1 : 0;
    Bytes raw(std::size_t(bytes) * std::size_t(count + 1));  // starts with the row above, black for the first
    rows(first - before, count + before, raw.data() + (before ? 0 : bytes));
    std::array<Bytes, 5> tries;
    filtered.clear();
    filtered.reserve(std::size_t(bytes + 1) * std::size_t(count));
    for (int y = 0; y < count; ++y) {
      const std::uint8_t* const above = raw.data() + std::size_t(y) * std::size_t(bytes);
      appendFiltered(above + bytes, above, bytes, filtered, tries);
    }
    adler = adler32_z(adler32_z(0, nullptr, 0), filtered.data(), filtered.size());
  }

  void deflate(const Bytes& before, bool last) {
    z_stream z{};
    if (deflateInit2(&z, level, Z_DEFLATED, -MAX_WBITS, 9, Z_FILTERED) != Z_OK) throw std::bad_alloc();
    std::size_t const window = std::min(before.size(), windowBytes);
    if (window > 0) deflateSetDictionary(&z, before.data() + before.size() - window, uInt(window));
    deflated.resize(deflateBound(&z, uLong(filtered.size())) + 64);
    z.next_in = filtered.data();
    z.avail_in = uInt(filtered.size());
    z.next_out = reinterpret_cast<Bytef*>(deflated.data());
    z.avail_out = uInt(deflated.size());
    ::deflate(&z, last ? Z_FINISH : Z_SYNC_FLUSH);
    deflated.resize(z.total_out);
    deflateEnd(&z);
  }
};

}  // namespace

void encodePngRows(int width, int height, const PngRows& rows, const std::function<void(std::string_view)>& sink,
                   const WriteProgress& progress) {
  std::size_t const rowBytes = std::size_t(width) * channels + 1;
  int const rowsOfBand = int(std::clamp<std::size_t>(bandBytes / rowBytes, 1, std::size_t(height)));
  std::vector<Band> bands(std::size_t(4 * oneapi::tbb::info::default_concurrency()));
  Bytes before;  // what the band before the first of `bands` held
  uLong adler = adler32_z(0, nullptr, 0);
  sink(header(width, height));
  for (int y = 0; y < height;) {
    int const firstRow = y;
    std::size_t used = 0;
    for (; used < bands.size() && y < height; ++used, y += rowsOfBand) {
      bands[used].first = y;
      bands[used].count = std::min(rowsOfBand, height - y);
    }
    oneapi::tbb::parallel_for(std::size_t(0), used, [&](std::size_t i) { bands[i].filter(width, rows); });
    oneapi::tbb::parallel_for(std::size_t(0), used, [&](std::size_t i) {
      bands[i].deflate(i > 0 ? bands[i - 1].filtered : before, y >= height && i + 1 == used);
    });
    for (std::size_t i = 0; i < used; ++i) {
      adler = adler32_combine(adler, bands[i].adler, z_off_t(bands[i].filtered.size()));
      std::string data = std::move(bands[i].deflated);
      if (firstRow == 0 && i == 0) data.insert(0, "\x78\x9c");  // zlib's header: a window of 32 KiB
      if (y >= height && i + 1 == used) data += bigEndian(std::uint32_t(adler));
      sink(chunk("IDAT", data));
    }
    before = bands[used - 1].filtered;
    if (progress) progress(std::min(1.0, double(y) / height));
  }
  sink(chunk("IEND", {}));
}

}  // namespace ropelight
