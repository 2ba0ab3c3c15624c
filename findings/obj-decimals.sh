#!/usr/bin/env bash
# tinyobjloader in double precision: half of plain decimal numbers are not the nearest double.
#
# One would guess: a build with TINYOBJLOADER_USE_DOUBLE gives the double that strtod gives, the nearest.
# What happens: digits after the point are added one by one as digit * 10^-n, so that errors add up: of numbers with six
#   decimals within 500 about 49% are another double than the nearest, by up to three units in the last place, and the
#   largest double becomes infinity. A mesh written with 17 digits does not come back as it was. (As floats all are right.)
# Seen in: 2.0.0rc10.
# ropelight instead: std::from_chars, and its own exponent where that is out of range.
set -euo pipefail

packages=(libtinyobjloader-dev=2.0.0~rc10+dfsg-2+b1)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -qq -o APT::Sandbox::User="$(id -un)" "${packages[@]}"
for deb in *.deb; do dpkg -x "$deb" root; done
echo "packages: ${packages[*]}"

cat > main.cpp <<'CPP'
#define TINYOBJLOADER_USE_DOUBLE
#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

std::vector<double> read(const std::vector<std::string>& numbers) {
  std::string text;
  for (const std::string& number : numbers) text += "v " + number + " 0 0\n";
  tinyobj::ObjReader reader;
  expect(reader.ParseFromString(text + "f 1 2 3\n", "") && reader.Warning().empty(), "no complaint");
  std::vector<double> values;
  for (std::size_t i = 0; i < numbers.size(); ++i) values.push_back(reader.GetAttrib().vertices[3 * i]);
  return values;
}

int main() {
  std::mt19937 random(1);
  const int count = 100000;
  for (int decimals : {1, 3, 6, 12}) {
    std::vector<std::string> numbers;
    for (int i = 0; i < count; ++i) {
      char text[64];
      std::snprintf(text, sizeof text, "%.*f", decimals, double(random()) / 4294967296.0 * 1000 - 500);
      numbers.push_back(text);
    }
    const std::vector<double> values = read(numbers);
    int wrong = 0, wrongFloats = 0;
    double most = 0;
    for (int i = 0; i < count; ++i) {
      const double nearest = std::strtod(numbers[i].c_str(), nullptr);
      wrong += values[i] != nearest;
      wrongFloats += float(values[i]) != std::strtof(numbers[i].c_str(), nullptr);
      const double step = std::nextafter(std::abs(nearest), INFINITY) - std::abs(nearest);
      most = std::max(most, std::abs(values[i] - nearest) / step);
    }
    std::printf("%2d decimals: %5.2f%% are not the nearest double, by up to %g ulp; as floats %d of %d\n", decimals,
                100.0 * wrong / count, most, wrongFloats, count);
    if (decimals == 6) expect(wrong > count * 0.4 && wrong < count * 0.6 && most > 1, "about half at six decimals");
  }
  const std::vector<std::string> edges = {"1.7976931348623157e308", "2.2250738585072014e-308", "0.000001e306"};
  const std::vector<double> values = read(edges);
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const double nearest = std::strtod(edges[i].c_str(), nullptr);
    std::printf("%-24s -> %.17g, nearest %.17g\n", edges[i].c_str(), values[i], nearest);
    expect(values[i] != nearest, edges[i].c_str());
  }
  expect(std::isinf(values[0]), "the largest double becomes infinity");
  return failures != 0;
}
CPP
g++ -std=c++17 -Iroot/usr/include main.cpp -o main
./main
