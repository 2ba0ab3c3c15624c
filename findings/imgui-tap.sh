#!/usr/bin/env bash
# Dear ImGui 1.86: a key or button that goes down and up between two frames was never pressed.
#
# One would guess: IsKeyPressed and IsMouseClicked tell of every press since the last frame, as the window system does.
# What happens: a backend writes io.KeysDown and io.MouseDown, and NewFrame looks at what they are then. A tap shorter than a
#   frame leaves no trace; at 200 ms a frame, which a renderer reaches easily, that is most taps. (Text is queued and stays.
#   ImGui's own GLFW backend remembers mouse buttons, but not keys. From 1.87 on there is a queue of events.)
# Seen in: 1.86.
# ropelight instead: the window keeps a list of keys that went down (docs/decisions.md, "A tap counts").
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

#include <cstdio>

int failures = 0;
void expect(bool seen, const char* what) {
  if (seen) return;
  std::printf("CHANGED: no longer so: %s\n", what);
  ++failures;
}

struct Seen {
  int keys = 0, clicks = 0, letters = 0;
};

Seen frame() {
  ImGui::NewFrame();
  const Seen seen = {ImGui::IsKeyPressed('G', false), ImGui::IsMouseClicked(0), ImGui::GetIO().InputQueueCharacters.Size};
  ImGui::EndFrame();
  return seen;
}

int main() {
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.DisplaySize = {400, 300};
  io.DeltaTime = 0.2f;
  unsigned char* texture;
  int width, height;
  io.Fonts->GetTexDataAsRGBA32(&texture, &width, &height);
  std::printf("Dear ImGui %s\n", ImGui::GetVersion());
  frame();

  io.KeysDown['G'] = io.MouseDown[0] = true;
  io.AddInputCharacter('g');
  io.KeysDown['G'] = io.MouseDown[0] = false;
  const Seen tap = frame();
  std::printf("down and up between two frames: %d keys, %d clicks, %d letters\n", tap.keys, tap.clicks, tap.letters);
  expect(tap.keys == 0 && tap.clicks == 0 && tap.letters == 1, "key and click lost, letter kept");

  io.KeysDown['G'] = io.MouseDown[0] = true;
  const Seen held = frame();
  std::printf("held over a frame's start:      %d keys, %d clicks\n", held.keys, held.clicks);
  expect(held.keys == 1 && held.clicks == 1, "seen when held");
  return failures != 0;
}
CPP
lib=root/usr/lib/$(g++ -print-multiarch)
g++ -std=c++17 -Iroot/usr/include/imgui main.cpp -o main "$lib/libimgui.a" "$lib/libstb.a" -lm
./main
