#!/usr/bin/env bash
# Dear ImGui: a drag field rounds the value to what its format shows, even where the drag is a hundredth.
#
# One would guess: "%.4g" says how a number looks; a drag of three pixels at 0.01 a pixel adds about 0.03.
# What happens: the dragged VALUE is printed with the format and read back. 5412345.75, shown as 5.412e+06, becomes 5412000 at
#   the first step, 345.75 away, and stays there however far the drag goes on, since every next step is rounded away again.
#   ImGuiSliderFlags_NoRoundToFormat leaves the value alone. Fields for coordinates need it, or a format as fine as the drag.
# Seen in: 1.86.
# ropelight instead: camera fields show and round coordinates by the viewing distance, not by significant digits.
set -euo pipefail

packages=(libimgui-dev=1.86+ds-1+b1 libstb-dev=0.0~git20220908.8b5f1f3+ds-1)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
apt-get download -qq -o APT::Sandbox::User="$(id -un)" "${packages[@]}"
for deb in *.deb; do dpkg -x "$deb" root; done
echo "packages: ${packages[*]}"

cat > main.cpp <<'CPP'
#include <imgui.h>

#include <cmath>
#include <cstdio>
#include <initializer_list>

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

ImVec2 frame(double& value, ImGuiSliderFlags flags) {
  ImGui::NewFrame();
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({400, 300});
  ImGui::Begin("window", nullptr, ImGuiWindowFlags_NoDecoration);
  ImGui::DragScalar("x", ImGuiDataType_Double, &value, 0.01f, nullptr, nullptr, "%.4g", flags);
  const ImVec2 corner = ImGui::GetItemRectMin();
  ImGui::End();
  ImGui::Render();
  return corner;
}

/// The value after the mouse went `pixels` to the right with its button held.
double drag(double value, int pixels, ImGuiSliderFlags flags) {
  ImGuiIO& io = ImGui::GetIO();
  frame(value, flags);
  const ImVec2 corner = frame(value, flags);
  io.MousePos = {corner.x + 20, corner.y + 4};
  frame(value, flags);
  io.MouseDown[0] = true;
  frame(value, flags);
  for (int i = 0; i < pixels; ++i) {
    io.MousePos.x += 1;
    frame(value, flags);
  }
  io.MouseDown[0] = false;
  frame(value, flags);
  return value;
}

int main() {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {400, 300};
  io.DeltaTime = 1;  // so that two drags are no double click
  unsigned char* texture;
  int width, height;
  io.Fonts->GetTexDataAsRGBA32(&texture, &width, &height);
  std::printf("Dear ImGui %s, DragScalar of a double, 0.01 a pixel, format %%.4g\n", ImGui::GetVersion());
  const double start = 5412345.75;
  for (int pixels : {5, 100}) {
    const double rounded = drag(start, pixels, 0), exact = drag(start, pixels, ImGuiSliderFlags_NoRoundToFormat);
    std::printf("%.2f dragged by %3d pixels: %.2f; with NoRoundToFormat %.2f\n", start, pixels, rounded, exact);
    expect(rounded == 5412000, "the value is rounded to the format");
    expect(exact > start && exact <= start + 0.01 * pixels + 1e-6, "the flag leaves it alone");
  }
  return failures != 0;
}
CPP
lib=root/usr/lib/$(g++ -print-multiarch)
g++ -std=c++17 -Iroot/usr/include/imgui main.cpp -o main "$lib/libimgui.a" "$lib/libstb.a" -lm
./main
