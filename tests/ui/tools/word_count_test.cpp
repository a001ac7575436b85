// The number of words that a frame draws.
#include <gtest/gtest.h>
#include <imgui.h>

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
