#pragma once
// Keys and mouse, as data: the help window shows them and the documentation is checked against them.

namespace ropelight::view {

struct KeyHelp {
  const char* keys;
  const char* what;  ///< empty: `keys` is a heading
};

inline constexpr KeyHelp keyTable[] = {
    {"Camera", ""},
    {"left drag", "orbit around the target"},
    {"right drag, Shift+left drag", "pan"},
    {"wheel", "dolly towards the target"},
    {"middle drag, Alt+left drag", "look around"},
    {"W A S D, Q E", "fly; with Shift faster"},
    {"Ctrl+left click", "focus there"},
    {"double click", "select the shape"},
    {"F", "frame the selection"},
    {"Shift+F", "frame the whole scene"},
    {"R, Home", "reset the camera"},
    {"Rendering", ""},
    {"Space", "pause or run"},
    {".", "one iteration"},
    {"Backspace", "start accumulation again"},
    {"1, 2, 3", "mode ray, path, sppm"},
    {"Comparing", ""},
    {"C", "compare on or off"},
    {"V", "next layout"},
    {"[, ]", "move the split"},
    {"Display", ""},
    {"+, -", "exposure"},
    {"T", "next tone curve"},
    {"P", "photons"},
    {"K", "cells of the kd-tree"},
    {"I", "inspector"},
    {"L", "error plot"},
    {"Tab", "panel"},
    {"F1, ?", "this help"},
    {"Files", ""},
    {"F2", "screenshot of the window"},
    {"Ctrl+S", "save PNG and EXR"},
    {"Ctrl+O", "type the path of a scene or image"},
    {"Esc", "close this help"},
    {"Ctrl+Q", "quit"},
};

}  // namespace ropelight::view
