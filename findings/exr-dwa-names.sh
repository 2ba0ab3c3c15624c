#!/usr/bin/env bash
# OpenEXR's DWAA: a channel's name decides whether a 32-bit float survives, and values above 65504 do not.
#
# One would guess: a lossy compression treats all channels of a type alike, and is lossy in the small: a value of 100001
#   comes back near 100001.
# What happens: channels whose last name is R, G, B, Y, BY or RY (in any layer) are made 16-bit floats and then quantised;
#   all others ("X", "Z", "A", "red", "albedo.X") keep every bit. Radiance beyond the 16-bit range is cut: 100001, which is
#   a lamp in the picture, comes back as less than 65504. The same pixels under another name are exact.
# Seen in: 3.1.5.
# ropelight instead: writes ZIP, which is lossless for all channels.
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

#include <cstdio>
#include <string>
#include <vector>

namespace Imf = OPENEXR_IMF_NAMESPACE;

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

const int size = 64, lamp = 77;

std::vector<float> throughFile(const std::string& channel, std::vector<float> pixels) {
  const auto frameOver = [&] {
    Imf::FrameBuffer frame;
    frame.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), 4, 4 * size));
    return frame;
  };
  Imf::Header header(size, size);
  header.compression() = Imf::DWAA_COMPRESSION;
  header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
  {
    Imf::OutputFile file("a.exr", header);
    file.setFrameBuffer(frameOver());
    file.writePixels(size);
  }
  pixels.assign(pixels.size(), 0);
  Imf::InputFile file("a.exr");
  file.setFrameBuffer(frameOver());
  file.readPixels(0, size - 1);
  return pixels;
}

int main() {
  std::printf("OpenEXR %s, DWAA, one FLOAT channel of %d pixels\n", OPENEXR_VERSION_STRING, size * size);
  std::vector<float> pixels;
  for (int i = 0; i < size * size; ++i) pixels.push_back(float(i % 97) * 0.013f);
  pixels[lamp] = 100001;
  for (const std::string channel : {"R", "albedo.G", "Y", "BY", "X", "albedo.X", "red", "A", "Z"}) {
    const std::vector<float> read = throughFile(channel, pixels);
    int changed = 0;
    for (int i = 0; i < size * size; ++i) changed += read[i] != pixels[i];
    std::printf("%-9s %4d pixels changed, the lamp of %g is %g\n", channel.c_str(), changed, pixels[lamp], read[lamp]);
    const bool colour = channel == "R" || channel == "albedo.G" || channel == "Y" || channel == "BY";
    expect(colour ? changed > size * size / 2 && read[lamp] <= 65504 : changed == 0, channel.c_str());
  }
  return failures != 0;
}
CPP
lib=root/usr/lib/$(g++ -print-multiarch)
g++ -std=c++17 -Iroot/usr/include -Iroot/usr/include/OpenEXR -Iroot/usr/include/Imath main.cpp -o main -L"$lib" \
  -lOpenEXR -lImath -lIex -lIlmThread
LD_LIBRARY_PATH="$lib" ./main
