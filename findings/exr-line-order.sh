#!/usr/bin/env bash
# tinyexr turns pictures upside down that were written from the last line to the first.
#
# One would guess: lineOrder says in what order lines lie in the file; every line carries its y, so that a reader gives the
#   same picture for INCREASING_Y and DECREASING_Y.
# What happens: OpenEXR does; tinyexr's LoadEXR flips the picture of a DECREASING_Y file. Two programs on one file, and on
#   files that OpenEXR holds to be equal, differ by a mirror. The data window's place is dropped as well: pictures at
#   different places of the same display window come back equal.
# Seen in: tinyexr 1.0.1 beside OpenEXR 3.1.5.
# ropelight instead: reads through OpenEXR, and puts the data window to its place in the display window.
set -euo pipefail

packages=(libopenexr-dev=3.1.5-5 libopenexr-3-1-30=3.1.5-5 libimath-dev=3.1.6-1 libimath-3-1-29=3.1.6-1 libtinyexr-dev=1.0.1+dfsg-4 libtinyexr1d=1.0.1+dfsg-4)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -qq -o APT::Sandbox::User="$(id -un)" "${packages[@]}"
for deb in *.deb; do dpkg -x "$deb" root; done
echo "packages: ${packages[*]}"

cat > main.cpp <<'CPP'
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <tinyexr.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

namespace Imf = OPENEXR_IMF_NAMESPACE;

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

const int width = 2, height = 3;
using Pixels = std::vector<float>;

Imf::FrameBuffer frameOver(Pixels& pixels, const Imath::Box2i& window) {
  Imf::FrameBuffer frame;
  frame.insert("Y", Imf::Slice::Make(Imf::FLOAT, pixels.data(), window, 4, 4 * width));
  return frame;
}

void write(const char* path, Imf::LineOrder order, const Imath::V2i& corner) {
  Pixels pixels = {1, 2, 3, 4, 5, 6};
  const Imath::Box2i window(corner, corner + Imath::V2i(width - 1, height - 1));
  Imf::Header header(Imath::Box2i(Imath::V2i(0, 0), Imath::V2i(7, 7)), window);
  header.lineOrder() = order;
  header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
  Imf::OutputFile file(path, header);
  file.setFrameBuffer(frameOver(pixels, window));
  file.writePixels(height);
}

Pixels byOpenExr(const char* path) {
  Pixels pixels(width * height);
  Imf::InputFile file(path);
  const Imath::Box2i window = file.header().dataWindow();
  file.setFrameBuffer(frameOver(pixels, window));
  file.readPixels(window.min.y, window.max.y);
  return pixels;
}

Pixels byTinyExr(const char* path) {
  float* rgba = nullptr;
  int columns = 0, rows = 0;
  const char* problem = nullptr;
  expect(LoadEXR(&rgba, &columns, &rows, path, &problem) == TINYEXR_SUCCESS && columns == width && rows == height, "tinyexr reads it");
  Pixels pixels;
  for (int i = 0; i < columns * rows; ++i) pixels.push_back(rgba[4 * i]);
  std::free(rgba);
  return pixels;
}

Pixels show(const char* title, const Pixels& pixels) {
  std::printf("%-38s", title);
  for (float value : pixels) std::printf(" %g", value);
  std::printf("\n");
  return pixels;
}

int main() {
  write("up.exr", Imf::INCREASING_Y, {0, 0});
  write("down.exr", Imf::DECREASING_Y, {0, 0});
  write("moved.exr", Imf::INCREASING_Y, {5, 4});
  const Pixels upright = {1, 2, 3, 4, 5, 6}, mirrored = {5, 6, 3, 4, 1, 2};
  expect(show("OpenEXR, INCREASING_Y", byOpenExr("up.exr")) == upright, "OpenEXR, increasing");
  expect(show("OpenEXR, DECREASING_Y", byOpenExr("down.exr")) == upright, "OpenEXR, decreasing");
  expect(show("tinyexr, INCREASING_Y", byTinyExr("up.exr")) == upright, "tinyexr, increasing");
  expect(show("tinyexr, DECREASING_Y", byTinyExr("down.exr")) == mirrored, "tinyexr turns it upside down");
  expect(show("tinyexr, data window at (5, 4) of 8x8", byTinyExr("moved.exr")) == upright, "tinyexr drops the place");
  return failures != 0;
}
CPP
lib=root/usr/lib/$(g++ -print-multiarch)
g++ -std=c++17 -Iroot/usr/include -Iroot/usr/include/OpenEXR -Iroot/usr/include/Imath main.cpp -o main -L"$lib" \
  -ltinyexr -lOpenEXR -lImath -lIex -lIlmThread
LD_LIBRARY_PATH="$lib" ./main
