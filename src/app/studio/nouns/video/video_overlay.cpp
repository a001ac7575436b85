#include "app/studio/nouns/video/video_overlay.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <vector>

#include "ui/theme.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {
namespace {

constexpr int kBands = 64, kTicks = 4;

/// A list to draw into, and the size of its texts.
struct VideoPage {
  ImDrawList& list;
  ImFont* font;
  float line;  ///< height of texts [pixels]
  const Palette& colors;

  [[nodiscard]] ImVec2 size_of(const std::string& text, float scale = 1) const {
    return font->CalcTextSizeA(scale * line, FLT_MAX, 0, text.c_str());
  }
  void text(ImVec2 at, const ImVec4& color, const std::string& what, float scale = 1) const {
    list.AddText(font, scale * line, {std::round(at.x), std::round(at.y)}, to_u32(color), what.c_str());
  }
};

void draw_time(const VideoPage& page, int height, const std::string& time) {
  const float pad = 0.4f * page.line;
  const ImVec2 size = page.size_of(time, 1.3f);
  const ImVec2 lo(page.line, static_cast<float>(height) - page.line - size.y - 2 * pad);
  page.list.AddRectFilled(lo, {lo.x + size.x + 2 * pad, lo.y + size.y + 2 * pad}, to_u32(page.colors.panel, 0.82f),
                          0.25f * page.line);
  page.text({lo.x + pad, lo.y + pad}, page.colors.text, time, 1.3f);
}

void draw_legend(const VideoPage& page, int width, const PressureRange& range) {
  const std::vector<std::string> texts = legend_texts(range, kTicks);
  float numbers = 0;
  for (const std::string& text : texts) numbers = std::max(numbers, page.size_of(text).x);
  const std::string title = "Pressure [kPa]";
  const float line = page.line, pad = 0.6f * line, bar = 1.1f * line;
  const float inner = std::max(page.size_of(title).x, bar + 0.7f * line + numbers);
  const ImVec2 hi(static_cast<float>(width) - line, 14.5f * line), lo(hi.x - inner - 2 * pad, line);
  page.list.AddRectFilled(lo, hi, to_u32(page.colors.panel, 0.82f), 0.25f * line);
  page.text({lo.x + pad, lo.y + 0.4f * line}, page.colors.text, title);
  const float top = lo.y + 2.4f * line, bottom = hi.y - 1.0f * line, left = lo.x + pad;
  const auto pressure_at = [&](double part) { return range.lo + part * (range.hi - range.lo); };
  const auto y_at = [&](double part) { return bottom + (top - bottom) * static_cast<float>(part); };
  for (int i = 0; i < kBands; ++i) {
    const double a = static_cast<double>(i) / kBands, b = static_cast<double>(i + 1) / kBands;
    const ImU32 below = pressure_color(range, pressure_at(a)), above = pressure_color(range, pressure_at(b));
    page.list.AddRectFilledMultiColor({left, y_at(b)}, {left + bar, y_at(a)}, above, above, below, below);
  }
  for (int i = 0; i <= kTicks; ++i) {
    const float y = y_at(static_cast<double>(i) / kTicks);
    page.list.AddLine({left + bar, y}, {left + bar + 0.3f * line, y}, to_u32(page.colors.text),
                      std::max(1.0f, 0.06f * line));
    const std::string& text = texts[static_cast<std::size_t>(i)];
    page.text({left + bar + 0.6f * line, y - 0.5f * page.size_of(text).y}, page.colors.text, text);
  }
}

}  // namespace

void draw_video_notes(ImDrawList& list, int width, int height, const VideoNotes& notes) {
  const float line = std::max(10.0f, std::round(0.024f * static_cast<float>(std::min(width, height))));
  ImFontAtlas& fonts = *ImGui::GetIO().Fonts;
  const VideoPage page{list, fonts.Fonts[0], line, palette(notes.dark)};
  if (notes.range != nullptr) draw_legend(page, width, *notes.range);
  draw_time(page, height, notes.time);
}

}  // namespace taxel::ui
