// The words on the screen and their places, from the glyphs that a frame draws.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "ui/widgets/ui.h"

struct ImDrawData;

namespace taxel::ui {

/// A word or number on the screen.
struct WordShown {
  std::string text;
  std::string panel;    ///< title of its panel, or empty
  Rect ink;             ///< box of the visible glyphs [pixels]
  bool is_cut = false;  ///< whether an edge hides a part, without scrolling
};

struct WordCount {
  std::size_t words = 0;         ///< words with at least one letter
  std::size_t numbers = 0;       ///< groups of digits and signs without a letter
  std::vector<WordShown> shown;  ///< both, in the order in which they are drawn
};

/// Counts the words of a frame, by the quads of its draw lists whose texture is a glyph and which the clip rectangle
/// does not hide. A gap as wide as a space, or another line, ends a word. The texture of the fonts must not have been
/// built again since the frame was laid out.
[[nodiscard]] WordCount count_words(const ImDrawData& data);

}  // namespace taxel::ui
