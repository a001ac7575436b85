// Colours and spacing of the interface: flat and calm, dark or light.
#pragma once

#include <imgui.h>

#include "core/base/error.h"

namespace taxel::ui {

/// Colours with a meaning, for the drawings of panels.
struct Palette {
  ImVec4 background, panel, raised, field, line;  ///< from the back to the front
  ImVec4 text, dim, accent;
  ImVec4 run, pause;                  ///< colours of the Run button
  ImVec4 error, warning, note;        ///< colours of messages
  ImVec4 layout_mode, simulate_mode;  ///< border of the view in each mode
  ImVec4 path;                        ///< path of the finger, and cursor of the plot
};
const Palette& palette(bool dark);

/// Sets ImGui's and ImPlot's styles. `scale` multiplies both text and spacing.
void apply_theme(bool dark, float scale);

/// Returns the colour of text on a fill: black or white.
ImVec4 text_on(const ImVec4& fill);
ImU32 to_u32(const ImVec4& color, float alpha = 1.0f);
const ImVec4& severity_color(const Palette& colors, Severity severity);

/// Height of the small text of captions and axes, relative to the normal one.
inline constexpr float kSmallText = 0.87f;
/// Height of normal text at scale 1 [pixels].
inline constexpr float kTextHeight = 15.0f;

}  // namespace taxel::ui
