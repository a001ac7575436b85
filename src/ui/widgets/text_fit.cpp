#include "ui/widgets/text_fit.h"

namespace taxel::ui {

float small_width(const std::string& text) {
  return kSmallText * ImGui::CalcTextSize(text.c_str()).x;
}

void draw_small_text(ImDrawList& list, ImVec2 at, ImU32 color, const std::string& text, std::vector<TextShown>& shown) {
  const float size = kSmallText * ImGui::GetFontSize();
  list.AddText(ImGui::GetFont(), size, at, color, text.c_str());
  shown.push_back({text, {at.x, at.y, at.x + small_width(text), at.y + size}});
}

std::string shortened(const std::string& text, float width, float size) {
  const auto width_of = [&](const std::string& part) { return size * ImGui::CalcTextSize(part.c_str()).x; };
  if (width_of(text) <= width) return text;
  const auto is_inside_letter = [&](std::size_t i) { return (static_cast<unsigned char>(text[i]) & 0xC0) == 0x80; };
  for (std::size_t end = text.size(); end > 1;) {
    do --end;
    while (end > 0 && is_inside_letter(end));
    const std::string part = text.substr(0, end) + "\u2026";
    if (end > 0 && width_of(part) <= width) return part;
  }
  return "";
}

bool TextLine::reserve(float x0, float x1) {
  const auto after = places_.lower_bound(x0);
  if (after != places_.end() && after->first < x1 + gap_) return false;
  if (after != places_.begin() && std::prev(after)->second + gap_ > x0) return false;
  places_.emplace(x0, x1);
  return true;
}

}  // namespace taxel::ui
