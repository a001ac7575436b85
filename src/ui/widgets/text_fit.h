// Texts that fit: names that are shortened to a width, and lines of texts that do not overlap.
#pragma once

#include <imgui.h>

#include <map>
#include <string>
#include <vector>

#include "ui/theme.h"
#include "ui/widgets/ui.h"

namespace taxel::ui {

/// A text that was drawn, with its box [pixels].
struct TextShown {
  std::string text;
  Rect rect;
};

/// Returns the width of a text in small letters [pixels].
[[nodiscard]] float small_width(const std::string& text);

/// Draws a text in small letters whose upper left corner is `at`, and appends its box to `shown`.
void draw_small_text(ImDrawList& list, ImVec2 at, ImU32 color, const std::string& text, std::vector<TextShown>& shown);

/// Returns a text that is at most `width` wide in letters of `size` times the present font: the text itself, or its
/// beginning with an ellipsis. Empty if not even a letter with an ellipsis fits.
[[nodiscard]] std::string shortened(const std::string& text, float width, float size = kSmallText);

/// The places of texts on one line. A text gets a place only if there is a gap between it and all earlier texts.
class TextLine {
 public:
  explicit TextLine(float gap) : gap_(gap) {}

  /// Reserves the place from x0 to x1. Returns false if an earlier text is there.
  [[nodiscard]] bool reserve(float x0, float x1);

 private:
  float gap_;
  std::map<float, float> places_;  ///< left and right ends
};

}  // namespace taxel::ui
