#pragma once
// The closed sets that are the window's own.

#include <cstdint>

#include "render/choices/choice.h"

namespace ropelight {
namespace view {

enum class Curve : std::uint8_t { linear, reinhard, aces, falseColour };
enum class Layout : std::uint8_t { single, split, sideBySide, flicker, difference };

}  // namespace view

template <>
struct ChoicesOf<view::Curve> {
  static constexpr Choice<view::Curve> table[] = {
      {view::Curve::linear, "linear", "clamped"},
      {view::Curve::reinhard, "reinhard", "L / (1 + L) on luminance"},
      {view::Curve::aces, "aces", "a film's, by channel"},
      {view::Curve::falseColour, "false-colour", "the channels' mean as a colour"},
  };
};

template <>
struct ChoicesOf<view::Layout> {
  static constexpr Choice<view::Layout> table[] = {
      {view::Layout::single, "single", "A alone"},
      {view::Layout::split, "split", "A left of a line, the other right of it"},
      {view::Layout::sideBySide, "side-by-side", "the same part of both"},
      {view::Layout::flicker, "flicker", "one after the other"},
      {view::Layout::difference, "difference", "A less the other"},
  };
};

}  // namespace ropelight
