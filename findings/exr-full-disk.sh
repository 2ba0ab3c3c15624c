#!/usr/bin/env bash
# OpenEXR: every writePixels succeeds, the disk is full, and nobody is told.
#
# One would guess: a write that fails throws, at the latest when the OutputFile is closed; there is no other call to make.
# What happens: the table of line offsets is written by the destructor, which catches and drops whatever the stream throws;
#   and the library's own file stream closes its buffer without looking. So a picture that fits the stream's buffer is
#   "written" to /dev/full without an exception, and any picture loses its table to a disk that fills at the last moment.
#   What is left opens, but is not complete. A caller has to bring a stream of his own that keeps the first failure and ask
#   it after the OutputFile is gone, or read the file again and ask isComplete().
# Seen in: 3.1.5.
# ropelight instead: a stream of its own keeps what was thrown, rethrows it, and only then renames the file to its place.
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
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <vector>

namespace Imf = OPENEXR_IMF_NAMESPACE;

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

/// A disk that is full from the moment on that `full` is set.
struct Disk : Imf::OStream {
  Disk() : OStream("a disk") {}
  void write(const char bytes[], int count) override {
    if (full) {
      ++refused;
      throw IEX_NAMESPACE::IoExc("the disk is full");
    }
    content.resize(std::max(content.size(), position + std::size_t(count)));
    std::copy_n(bytes, count, content.begin() + long(position));
    position += std::size_t(count);
  }
  uint64_t tellp() override { return position; }
  void seekp(uint64_t to) override { position = to; }

  bool full = false;
  int refused = 0;
  std::size_t position = 0;
  std::vector<char> content;
};

const int size = 32;
std::vector<float> pixels(size* size, 0.5f);

template <class Target, class BeforeTheEnd>
bool throwsWhenWriting(Target&& target, BeforeTheEnd beforeTheEnd) {
  try {
    Imf::Header header(size, size);
    header.channels().insert("Y", Imf::Channel(Imf::FLOAT));
    Imf::FrameBuffer frame;
    frame.insert("Y", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(pixels.data()), 4, 4 * size));
    Imf::OutputFile file(target, header);
    file.setFrameBuffer(frame);
    file.writePixels(size);
    beforeTheEnd();
  } catch (const std::exception& problem) {
    std::printf("  %s\n", problem.what());
    return true;
  }
  return false;
}

int main() {
  std::printf("OpenEXR %s\n", OPENEXR_VERSION_STRING);
  const bool device = throwsWhenWriting("/dev/full", [] {});
  std::printf("to /dev/full: %s\n", device ? "an exception" : "no exception");
  expect(!device, "silence on /dev/full");

  Disk disk;
  const bool thrown = throwsWhenWriting(disk, [&] { disk.full = true; });
  std::printf("disk full after the last writePixels: the stream threw %d times, the caller saw %s\n", disk.refused,
              thrown ? "an exception" : "none");
  expect(!thrown && disk.refused > 0, "the destructor swallows the exception");

  std::ofstream("left.exr", std::ios::binary).write(disk.content.data(), long(disk.content.size()));
  const bool complete = Imf::InputFile("left.exr").isComplete();
  std::printf("what is left: %zu bytes, opens, isComplete() = %d\n", disk.content.size(), complete);
  expect(!complete, "an incomplete file");
  return failures != 0;
}
CPP
lib=root/usr/lib/$(g++ -print-multiarch)
g++ -std=c++17 -Iroot/usr/include -Iroot/usr/include/OpenEXR -Iroot/usr/include/Imath main.cpp -o main -L"$lib" \
  -lOpenEXR -lImath -lIex -lIlmThread
LD_LIBRARY_PATH="$lib" ./main
