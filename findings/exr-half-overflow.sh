#!/usr/bin/env bash
# Two ways from float to half in one library: 65505 is infinite as a file's pixel and 65504 as a number.
#
# One would guess: reading a FLOAT channel into HALF pixels gives what Imath's half(float) gives, the nearest.
# What happens: half(float) rounds to the nearest, so that all below 65520 become 65504, the largest half. The file reader
#   first compares with 65504 and makes all above it infinite. Between the two a pixel's fate depends on who converts.
# Seen in: OpenEXR 3.1.5 with Imath 3.1.6.
# ropelight instead: reads and writes FLOAT, and never converts to half.
set -euo pipefail

packages=(libopenexr-dev=3.1.5-5 libopenexr-3-1-30=3.1.5-5 libimath-dev=3.1.6-1 libimath-3-1-29=3.1.6-1)
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
#include <half.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace Imf = OPENEXR_IMF_NAMESPACE;

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

int main() {
  std::printf("OpenEXR %s\n", OPENEXR_VERSION_STRING);
  std::vector<float> pixels = {65503, 65504, 65505, 65519, -65519, 65520};
  const int width = int(pixels.size());
  {
    Imf::Header header(width, 1);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), 4, 0));
    Imf::OutputFile file("a.exr", header);
    file.setFrameBuffer(frame);
    file.writePixels(1);
  }
  std::vector<half> read(pixels.size());
  Imf::FrameBuffer frame;
  frame.insert("Y", Imf::Slice(Imf::HALF, reinterpret_cast<char*>(read.data()), 2, 0));
  Imf::InputFile file("a.exr");
  file.setFrameBuffer(frame);
  file.readPixels(0);
  for (int i = 0; i < width; ++i) {
    const float number = half(pixels[i]), pixel = read[i], size = std::abs(pixels[i]);
    std::printf("%8g: half(float) %g, read from the file as HALF %g\n", pixels[i], number, pixel);
    expect(std::isinf(number) == (size >= 65520), "half(float) rounds to the nearest");
    expect(std::isinf(pixel) == (size > 65504), "the file reader does not");
  }
  return failures != 0;
}
CPP
lib=root/usr/lib/$(g++ -print-multiarch)
g++ -std=c++17 -Iroot/usr/include -Iroot/usr/include/OpenEXR -Iroot/usr/include/Imath main.cpp -o main -L"$lib" \
  -lOpenEXR -lImath -lIex -lIlmThread
LD_LIBRARY_PATH="$lib" ./main
