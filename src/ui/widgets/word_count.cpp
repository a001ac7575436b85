#include "ui/widgets/word_count.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace taxel::ui {

namespace {

constexpr float kWordGap = 0.2f;  // least gap between two words, in heights of text; a space of the font has 0.32

/// A glyph of the texture, and the height of the font that it was drawn for.
struct KnownGlyph {
  const ImFontGlyph* glyph = nullptr;
  float size = 0;
};

/// All glyphs by the upper left corner of their image.
using KnownGlyphs = std::map<std::pair<float, float>, KnownGlyph>;

KnownGlyphs known_glyphs(ImFontAtlas& atlas) {
  KnownGlyphs glyphs;
  if (atlas.Builder == nullptr) return glyphs;
  for (int i = 0; i < atlas.Builder->BakedPool.Size; ++i) {
    const ImFontBaked& baked = atlas.Builder->BakedPool[i];
    for (const ImFontGlyph& glyph : baked.Glyphs)
      if (glyph.Visible != 0) glyphs[{glyph.U0, glyph.V0}] = {&glyph, baked.Size};
  }
  return glyphs;
}

/// A glyph as a quad of a draw list. ImGui leaves out the parts of a quad that some widgets clip.
struct DrawnGlyph {
  const ImFontGlyph* glyph = nullptr;
  Rect whole;        ///< box of the whole glyph [pixels]
  Rect visible;      ///< box of the part that is not clipped
  float top = 0;     ///< upper end of its line of text [pixels]
  float height = 0;  ///< height of its font [pixels]
};

/// Returns whether the images of a quad are those of a glyph or of a part of it.
bool has_image(const ImFontGlyph& glyph, const ImVec2& a, const ImVec2& c) {
  return a.x >= glyph.U0 && a.y >= glyph.V0 && c.x <= glyph.U1 && c.y <= glyph.V1;
}

/// Returns the glyph whose image a quad has, wholly or in part; its pointer is null if there is none.
KnownGlyph glyph_of(const KnownGlyphs& glyphs, const ImVec2& a, const ImVec2& c) {
  if (!(a.x < c.x) || !(a.y < c.y)) return {};
  const auto found = glyphs.find({a.x, a.y});
  if (found != glyphs.end() && has_image(*found->second.glyph, a, c)) return found->second;
  for (const auto& [corner, known] : glyphs)
    if (has_image(*known.glyph, a, c)) return known;
  return {};
}

/// Returns the glyph of a quad with the corners `a` and `c`, within a clip rectangle.
DrawnGlyph drawn_glyph(const KnownGlyph& known, const ImDrawVert& a, const ImDrawVert& c, const ImVec4& clip) {
  const ImFontGlyph& glyph = *known.glyph;
  const float per_u = (c.pos.x - a.pos.x) / (c.uv.x - a.uv.x), per_v = (c.pos.y - a.pos.y) / (c.uv.y - a.uv.y);
  DrawnGlyph drawn;
  drawn.glyph = &glyph;
  drawn.whole.x0 = a.pos.x - per_u * (a.uv.x - glyph.U0);
  drawn.whole.y0 = a.pos.y - per_v * (a.uv.y - glyph.V0);
  drawn.whole.x1 = drawn.whole.x0 + per_u * (glyph.U1 - glyph.U0);
  drawn.whole.y1 = drawn.whole.y0 + per_v * (glyph.V1 - glyph.V0);
  drawn.visible = {std::max(a.pos.x, clip.x), std::max(a.pos.y, clip.y), std::min(c.pos.x, clip.z),
                   std::min(c.pos.y, clip.w)};
  const float scale = drawn.whole.width() / (glyph.X1 - glyph.X0);
  drawn.top = drawn.whole.y0 - scale * glyph.Y0;
  drawn.height = scale * known.size;
  return drawn;
}

bool is_letter(unsigned code) {
  constexpr unsigned kFirstBeyondLatin1Signs = 0xc0;
  return (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z') || code >= kFirstBeyondLatin1Signs;
}

/// Groups glyphs to words in the order in which they are drawn.
class Words {
 public:
  /// Begins the glyphs of a window, or of a list without a window.
  void begin_list(const ImGuiWindow* window) {
    window_ = window;
    panel_ = window != nullptr ? panel_name(window) : "";
  }
  void add(const DrawnGlyph& drawn) {
    const float gap = drawn.whole.x0 - right_;
    if (!is_open_ || std::abs(drawn.top - top_) > 0.5f * kWordGap * drawn.height || gap > kWordGap * drawn.height ||
        gap < -0.5f * drawn.height)
      end();
    top_ = drawn.top;
    right_ = drawn.whole.x1;
    const bool is_cut = hides_part(drawn);
    if (is_seen(drawn)) {
      extend(drawn);
      word_.is_cut = word_.is_cut || is_cut;
    } else if (is_open_ && is_cut) {
      word_.is_cut = true;
    }
  }
  void end() {
    if (is_open_) {
      ++(has_letter_ ? count_.words : count_.numbers);
      count_.shown.push_back(std::exchange(word_, {}));
    }
    is_open_ = has_letter_ = false;
  }
  [[nodiscard]] const WordCount& count() const { return count_; }

 private:
  /// Returns whether the middle of a glyph is visible.
  static bool is_seen(const DrawnGlyph& drawn) {
    const float x = drawn.whole.center_x(), y = drawn.whole.center_y();
    const Rect& seen = drawn.visible;
    return x >= seen.x0 && y >= seen.y0 && x < seen.x1 && y < seen.y1;
  }
  /// Returns whether an edge hides more of a glyph than rounding does: up or down in a window that cannot be scrolled
  /// there, left or right in one that the user has not scrolled.
  [[nodiscard]] bool hides_part(const DrawnGlyph& drawn) const {
    constexpr float kRounding = 1;  // [pixel]
    const Rect &whole = drawn.whole, &seen = drawn.visible;
    const bool scrolls_x = window_ != nullptr && window_->Scroll.x > 0;
    const bool scrolls_y = window_ != nullptr && window_->ScrollMax.y > 0;
    const bool x = seen.x0 - whole.x0 > kRounding || whole.x1 - seen.x1 > kRounding;
    const bool y = seen.y0 - whole.y0 > kRounding || whole.y1 - seen.y1 > kRounding;
    return (x && !scrolls_x) || (y && !scrolls_y);
  }
  void extend(const DrawnGlyph& drawn) {
    const Rect& seen = drawn.visible;
    Rect& ink = word_.ink;
    ink = is_open_ ? Rect{std::min(ink.x0, seen.x0), std::min(ink.y0, seen.y0), std::max(ink.x1, seen.x1),
                          std::max(ink.y1, seen.y1)}
                   : seen;
    word_.panel = panel_;
    is_open_ = true;
    char bytes[5];
    ImTextCharToUtf8(bytes, drawn.glyph->Codepoint);  // ends them with 0
    word_.text += bytes;
    has_letter_ = has_letter_ || is_letter(drawn.glyph->Codepoint);
  }

  WordCount count_;
  WordShown word_;
  const ImGuiWindow* window_ = nullptr;
  std::string panel_;
  bool is_open_ = false, has_letter_ = false;
  float top_ = 0, right_ = 0;
};

/// Adds the glyphs of one command of a list.
void add_glyphs(Words& words, const ImDrawList& list, const ImDrawCmd& command, const KnownGlyphs& glyphs) {
  constexpr unsigned kQuad = 6;  // indices of two triangles, the first of which has the corners 0, 1 and 2
  for (unsigned i = 0; i + kQuad <= command.ElemCount;) {
    const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset + i;
    const ImDrawVert& a = list.VtxBuffer[static_cast<int>(command.VtxOffset + index[0])];
    const ImDrawVert& c = list.VtxBuffer[static_cast<int>(command.VtxOffset + index[2])];
    const KnownGlyph known = glyph_of(glyphs, a.uv, c.uv);
    if (known.glyph != nullptr && (a.col & IM_COL32_A_MASK) != 0) words.add(drawn_glyph(known, a, c, command.ClipRect));
    i += known.glyph != nullptr ? kQuad : kQuad / 2;
  }
}

}  // namespace

WordCount count_words(const ImDrawData& data) {
  const KnownGlyphs glyphs = known_glyphs(*ImGui::GetIO().Fonts);
  Words words;
  for (const ImDrawList* list : data.CmdLists) {
    words.begin_list(list->_OwnerName != nullptr ? ImGui::FindWindowByName(list->_OwnerName) : nullptr);
    for (const ImDrawCmd& command : list->CmdBuffer)
      if (command.UserCallback == nullptr) add_glyphs(words, *list, command, glyphs);
    words.end();
  }
  return words.count();
}

}  // namespace taxel::ui
