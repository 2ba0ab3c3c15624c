#!/usr/bin/env bash
# stb's Radiance HDR files are darker than the picture, in every pixel, by 0.3% to 0.6% on average.
#
# One would guess: RGBE with its 8 bits of mantissa rounds, up as often as down, so that means over a picture stay.
# What happens: the writer cuts the mantissa off and the reader does not add the half that Radiance's own reader adds for
#   that. No value grows; greys lose 0.26% in the mean and saturated colours more, since all three share the largest one's
#   exponent. A bias between a reference kept as .hdr and a picture kept as .exr is no error of the renderer. (Once is all:
#   writing what was read changes nothing more.)
# Seen in: stb_image_write of 2022-09-08.
# ropelight instead: writes float EXR, and reads no .hdr files.
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
#include <cstdio>
#include <random>
#include <vector>

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

const int size = 256;
using Pixels = std::vector<float>;

Pixels throughFile(const Pixels& pixels) {
  stbi_write_hdr("a.hdr", size, size, 3, pixels.data());
  int width = 0, height = 0, channels = 0;
  float* read = stbi_loadf("a.hdr", &width, &height, &channels, 3);
  expect(read && width == size && height == size, "the file is read");
  const Pixels result(read, read + pixels.size());
  stbi_image_free(read);
  return result;
}

double look(const char* title, const Pixels& pixels) {
  const Pixels read = throughFile(pixels);
  double before = 0, after = 0;
  int brighter = 0, darker = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    before += pixels[i];
    after += read[i];
    brighter += read[i] > pixels[i];
    darker += read[i] < pixels[i];
  }
  std::printf("%-28s mean %+.3f%%, %d of %zu values brighter, %d darker\n", title, 100 * (after / before - 1), brighter,
              pixels.size(), darker);
  expect(brighter == 0 && darker > size * size, "no value grows");
  expect(throughFile(read) == read, "the second time changes nothing");
  return after / before - 1;
}

int main() {
  std::mt19937 generator(1);
  const auto random = [&] { return float(generator() >> 8) * 0x1p-24f; };
  Pixels grey, colours;
  for (int i = 0; i < size * size; ++i) {
    const float value = 0.1f + 0.9f * random();
    grey.insert(grey.end(), {value, value, value});
    for (int channel = 0; channel < 3; ++channel) colours.push_back(std::exp(8 * random() - 4));
  }
  const double greyBias = look("greys between 0.1 and 1", grey), colourBias = look("colours from 0.02 to 50", colours);
  expect(greyBias < -0.002 && greyBias > -0.004, "greys lose about a quarter per cent");
  expect(colourBias < greyBias * 1.5, "colours lose more");
  return failures != 0;
}
CPP
g++ -std=c++17 -O1 -Iroot/usr/include main.cpp -o main
./main
