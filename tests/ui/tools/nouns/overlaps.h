// A search for drawn texts that overlap.
#pragma once

#include <string>
#include <vector>

#include "ui/widgets/text_fit.h"

namespace taxel::ui::test {

/// Returns the first two texts whose boxes overlap, or an empty text.
inline std::string first_overlap(const std::vector<TextShown>& texts) {
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rect &a = texts[i].rect, &b = texts[j].rect;
      if (a.x0 < b.x1 && b.x0 < a.x1 && a.y0 < b.y1 && b.y0 < a.y1) return texts[j].text + " and " + texts[i].text;
    }
  }
  return "";
}

}  // namespace taxel::ui::test
