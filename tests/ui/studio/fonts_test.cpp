// The window's font is part of the program.
#include "app/studio/shell/window/window.h"

#include <gtest/gtest.h>
#include <imgui.h>

namespace taxel::studio {
namespace {

// Among them the signs of a degree, a square, a product and a triangle.
TEST(Fonts, HaveTheCharactersOfTheInterfaceOnAnyMachine) {
  ImGui::CreateContext();
  load_fonts();
  ImFont* const font = ImGui::GetIO().Fonts->Fonts[0];
  EXPECT_EQ(ImGui::GetIO().Fonts->Fonts.Size, 1);
  for (const ImWchar character : {0xB0, 0xB2, 0xB5, 0xD7, 0x2190, 0x2264, 0x25BC})
    EXPECT_TRUE(font->IsGlyphInFont(character)) << std::hex << character;
  EXPECT_FALSE(font->IsGlyphInFont(0x4E00)) << "which DejaVu Sans does not have";
  ImGui::DestroyContext();
}

}  // namespace
}  // namespace taxel::studio
