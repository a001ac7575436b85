// The words that a frame draws: their number, their letters and their places.
#include <gtest/gtest.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "interface_frames.h"
#include "ui/widgets/word_count.h"

namespace taxel::ui {
namespace {

/// Counts the words of a frame with a small window, which is as large as ImGui's font makes it in the second frame.
WordCount count_of(const std::function<void()>& contents) {
  test::InterfaceFrames frames;
  WordCount count;
  for (int i = 0; i < 2; ++i) {
    frames.frame([&] {
      ImGui::SetNextWindowSize({300, 100});
      ImGui::Begin("##window", nullptr, ImGuiWindowFlags_NoTitleBar);
      contents();
      ImGui::End();
      ImGui::Render();
      count = count_words(*ImGui::GetDrawData());
    });
  }
  return count;
}

TEST(WordCount, SeparatesWordsFromNumbers) {
  const WordCount count = count_of([] {
    ImGui::TextUnformatted("Press X and touch");
    ImGui::TextUnformatted("25 -3 120 kPa");
  });
  EXPECT_EQ(count.words, 5U);
  EXPECT_EQ(count.numbers, 3U);
}

TEST(WordCount, ReadsTheLettersOfEachWord) {
  std::vector<std::string> texts;
  const WordCount count = count_of([] { ImGui::TextUnformatted("Press 25 ways"); });
  for (const WordShown& word : count.shown) texts.push_back(word.text);
  EXPECT_EQ(texts, (std::vector<std::string>{"Press", "25", "ways"}));
}

TEST(WordCount, SaysWhichWordAnEdgeCuts) {
  const WordCount count = count_of([] {
    ImGui::TextUnformatted("seen");
    ImGui::PushClipRect(ImGui::GetCursorScreenPos(), {ImGui::GetCursorScreenPos().x + 30, 900}, true);
    ImGui::TextUnformatted("mmmmmmmm");
    ImGui::PopClipRect();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::RenderTextClipped(at, {at.x + 30, at.y + 20}, "nnnnnnnn", nullptr, nullptr);  // as a button does
  });
  ASSERT_EQ(count.shown.size(), 3U);
  EXPECT_FALSE(count.shown[0].is_cut);
  EXPECT_TRUE(count.shown[1].is_cut);
  EXPECT_TRUE(count.shown[2].is_cut);
  EXPECT_LE(count.shown[1].ink.width(), 30);
  EXPECT_GT(count.shown[0].ink.height(), 4);
}

TEST(WordCount, LeavesOutClippedText) {
  const WordCount count = count_of([] {
    ImGui::TextUnformatted("seen");
    ImGui::SetCursorPosY(400);
    ImGui::TextUnformatted("below the window");
  });
  EXPECT_EQ(count.words, 1U);
  EXPECT_EQ(count.numbers, 0U);
}

}  // namespace
}  // namespace taxel::ui
