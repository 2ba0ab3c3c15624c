#pragma once
// Colours, spacing and font of the panel.

namespace ropelight::view {

/// For a screen on which a default font of 13·scale pixels is legible; once after ImGui::CreateContext, before the first
/// frame. Sizes grow with the scale, and the font is made at its final size, so that it stays sharp.
void setStyle(float scale);

}  // namespace ropelight::view
