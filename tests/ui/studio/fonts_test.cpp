// The window's font is part of the program.
#include "app/studio/shell/window/window.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <filesystem>
#include <fstream>

#include "fixtures/tiny_font.h"

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

TEST(Fonts, TakeMissingCharactersFromAFontOfTheSystem) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "taxel_tiny.ttf";
  std::ofstream(file, std::ios::binary) << test::tiny_font(U'\u4E2D');
  ImGui::CreateContext();
  load_fonts();
  add_fonts({{file, 0}, {"no such font.ttf", 0}});
  ImFont* const font = ImGui::GetIO().Fonts->Fonts[0];
  EXPECT_EQ(ImGui::GetIO().Fonts->Fonts.Size, 1) << "one font for all characters";
  EXPECT_TRUE(font->IsGlyphInFont(0x4E2D));
  EXPECT_FALSE(font->IsGlyphInFont(0xAC00));
  EXPECT_TRUE(font->IsGlyphInFont('A'));
  ImGui::DestroyContext();
}

}  // namespace
}  // namespace taxel::studio
