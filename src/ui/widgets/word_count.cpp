#include "ui/widgets/word_count.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>
#include <map>
#include <utility>

namespace taxel::ui {

namespace {

constexpr float kWordGap = 0.25f;  // least gap between two words, in heights of text; a space of the font has 0.32

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

bool is_letter(unsigned code) {
  constexpr unsigned kFirstBeyondLatin1Signs = 0xc0;
  return (code >= 'a' && code <= 'z') || (code >= 'A' && code <= 'Z') || code >= kFirstBeyondLatin1Signs;
}

/// Groups glyphs to words in the order in which they are drawn.
class Words {
 public:
  void add(const KnownGlyph& known, const ImDrawVert& corner, const ImDrawVert& opposite) {
    const ImFontGlyph& glyph = *known.glyph;
    const float scale = (opposite.pos.x - corner.pos.x) / (glyph.X1 - glyph.X0);
    const float top = corner.pos.y - scale * glyph.Y0, height = scale * known.size;
    const float gap = corner.pos.x - right_;
    if (!is_open_ || std::abs(top - top_) > 0.5f * kWordGap * height || gap > kWordGap * height || gap < -0.5f * height)
      end();
    is_open_ = true;
    char bytes[5];
    text_ += ImTextCharToUtf8(bytes, glyph.Codepoint);
    has_letter_ = has_letter_ || is_letter(glyph.Codepoint);
    top_ = top;
    right_ = opposite.pos.x;
  }
  void end() {
    if (is_open_) {
      ++(has_letter_ ? count_.words : count_.numbers);
      count_.texts.push_back(std::exchange(text_, ""));
    }
    is_open_ = has_letter_ = false;
  }
  [[nodiscard]] const WordCount& count() const { return count_; }

 private:
  WordCount count_;
  std::string text_;
  bool is_open_ = false, has_letter_ = false;
  float top_ = 0, right_ = 0;
};

/// Returns whether the middle of a quad is within a clip rectangle.
bool is_visible(const ImDrawVert& a, const ImDrawVert& b, const ImVec4& clip) {
  const float x = 0.5f * (a.pos.x + b.pos.x), y = 0.5f * (a.pos.y + b.pos.y);
  return x >= clip.x && y >= clip.y && x < clip.z && y < clip.w && (a.col & IM_COL32_A_MASK) != 0;
}

/// Adds the glyphs of one command of a list.
void add_glyphs(Words& words, const ImDrawList& list, const ImDrawCmd& command, const KnownGlyphs& glyphs) {
  constexpr unsigned kQuad = 6;  // indices of two triangles, the first of which has the corners 0, 1 and 2
  for (unsigned i = 0; i + kQuad <= command.ElemCount;) {
    const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset + i;
    const ImDrawVert& a = list.VtxBuffer[static_cast<int>(command.VtxOffset + index[0])];
    const ImDrawVert& c = list.VtxBuffer[static_cast<int>(command.VtxOffset + index[2])];
    const auto found = glyphs.find({a.uv.x, a.uv.y});
    const bool is_glyph =
        found != glyphs.end() && found->second.glyph->U1 == c.uv.x && found->second.glyph->V1 == c.uv.y;
    if (is_glyph && is_visible(a, c, command.ClipRect)) words.add(found->second, a, c);
    i += is_glyph ? kQuad : kQuad / 2;
  }
}

}  // namespace

WordCount count_words(const ImDrawData& data) {
  const KnownGlyphs glyphs = known_glyphs(*ImGui::GetIO().Fonts);
  Words words;
  for (const ImDrawList* list : data.CmdLists) {
    for (const ImDrawCmd& command : list->CmdBuffer)
      if (command.UserCallback == nullptr) add_glyphs(words, *list, command, glyphs);
    words.end();
  }
  return words.count();
}

}  // namespace taxel::ui
