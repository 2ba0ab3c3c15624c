#!/usr/bin/env bash
# stb_image: a PNG of 16 bits becomes 256 different floats, and its gAMA chunk is not asked.
#
# One would guess: stbi_loadf, the way to floats, keeps what a file of 16 bits has; stbi_is_16_bit says true for it.
# What happens: all but HDR files go through 8 bits on their way to floats. A ramp of 65536 greys has 256 levels afterwards,
#   while stbi_load_16 gives all of them. A file that says that it is linear (gAMA 100000) is decoded with 2.2 like any other.
# Seen in: stb_image of 2022-09-08.
# ropelight instead: stbi_load_16, and the curve that the file's own chunks name.
set -euo pipefail

packages=(libstb-dev=0.0~git20220908.8b5f1f3+ds-1)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -qq -o APT::Sandbox::User="$(id -un)" "${packages[@]}"
for deb in *.deb; do dpkg -x "$deb" root; done
echo "packages: ${packages[*]}"

cat > main.cpp <<'CPP'
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

std::string bigEndian(std::uint32_t value) {
  return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}

std::string chunk(const std::string& name, const std::string& data) {
  std::uint32_t rest = 0xFFFFFFFFu;
  for (unsigned char byte : name + data) {
    rest ^= byte;
    for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1 ? 0xEDB88320u : 0);
  }
  return bigEndian(std::uint32_t(data.size())) + name + data + bigEndian(~rest);
}

const int size = 256;

/// All 65536 greys of 16 bits, with a gAMA chunk.
std::string ramp(std::uint32_t gamma) {
  std::string lines;
  for (int y = 0; y < size; ++y) {
    lines += '\0';
    for (int x = 0; x < size; ++x) {
      lines += char(y);
      lines += char(x);
    }
  }
  int length = 0;
  unsigned char* packed = stbi_zlib_compress(reinterpret_cast<unsigned char*>(lines.data()), int(lines.size()), &length, 8);
  const std::string body(reinterpret_cast<char*>(packed), std::size_t(length));
  std::free(packed);
  const std::string head = bigEndian(size) + bigEndian(size) + std::string("\x10\0\0\0\0", 5);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head) + chunk("gAMA", bigEndian(gamma)) + chunk("IDAT", body) + chunk("IEND", "");
}

int main() {
  float middle[2];
  for (bool linear : {false, true}) {
    const std::string file = ramp(linear ? 100000 : 45455);
    const auto* bytes = reinterpret_cast<const stbi_uc*>(file.data());
    const int length = int(file.size());
    int width, height, channels;
    float* floats = stbi_loadf_from_memory(bytes, length, &width, &height, &channels, 1);
    stbi_us* words = stbi_load_16_from_memory(bytes, length, &width, &height, &channels, 1);
    const std::set<float> levels(floats, floats + size * size);
    const std::set<int> numbers(words, words + size * size);
    middle[linear] = floats[size * size / 2];
    std::printf("gAMA %s: is_16_bit %d, load_16 gives %zu levels, loadf %zu; half of white is %g\n", linear ? "1     " : "1 / 2.2",
                stbi_is_16_bit_from_memory(bytes, length), numbers.size(), levels.size(), middle[linear]);
    expect(numbers.size() == 65536 && levels.size() == 256, "256 floats of 65536 greys");
    stbi_image_free(floats);
    stbi_image_free(words);
  }
  expect(middle[0] == middle[1] && std::abs(middle[0] - 0.2195f) < 1e-3f, "the same curve for both");
  return failures != 0;
}
CPP
g++ -std=c++17 -O1 -Iroot/usr/include main.cpp -o main
./main
