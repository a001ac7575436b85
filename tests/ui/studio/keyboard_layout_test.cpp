// Keys by label in real windows: keys at their places, in five layouts that change while the window is open.
#include <gtest/gtest.h>

#include <cctype>

#include "app/studio/shell/window/keyboard.h"
#include "app/studio/shell/window/window.h"
#include "fixtures/surroundings.h"
#include "script_lines.h"
#include "virtual_screen.h"

namespace taxel::test {
namespace {

/// A layout as setxkbmap names it, and the meanings of the keys at kPlaces by the characters of a US keyboard.
struct KeyboardLayout {
  const char* name;
  std::string_view meanings;
  char undo;        ///< place of the key with the label Z
  char select_all;  ///< place of the key with the label A
};
constexpr std::string_view kPlaces = "1234567890qwertyuiopasdfghjkl;'zxcvbnm,./";
constexpr std::array kLayouts = {
    KeyboardLayout{"us", kPlaces, 'z', 'a'},
    KeyboardLayout{"de", "1234567890qwertzuiopasdfghjkl;'yxcvbnm,.-", 'y', 'a'},
    KeyboardLayout{"fr", "1234567890azertyuiopqsdfghjklm'wxcvbn,;./", 'w', 'q'},
    KeyboardLayout{"ru", kPlaces, 'z', 'a'},
    KeyboardLayout{"us -variant dvorak", "1234567890',.pyfgcrlaoeuidhtns-;qjkxbmwvz", '/', 'a'},
};

ImGuiKey key_at(char us_label) {
  return studio::imgui_key(std::toupper(static_cast<unsigned char>(us_label)));
}

/// A window of this process. It sees the events until a condition holds.
struct OpenWindow {
  std::unique_ptr<studio::Window> window = studio::make_glfw_window(320, 200, "keys");
  std::vector<ImGuiKey> pressed, released;
  ui::KeyNames names;
  bool is_focused = false;

  bool sees(const std::function<bool()>& condition) {
    return holds_within(10, [&] {
      for (const studio::InputEvent& event : window->take_events(0.02)) take(event);
      return condition();
    });
  }

 private:
  void take(const studio::InputEvent& event) {
    if (const auto* focus = std::get_if<studio::FocusChange>(&event)) is_focused = focus->focused;
    if (std::holds_alternative<studio::RenameKeys>(event)) names = window->key_names();
    const auto* key = std::get_if<studio::KeyPress>(&event);
    if (key != nullptr && (key->key & ImGuiMod_Mask_) == 0) (key->down ? pressed : released).push_back(key->key);
  }
};

TEST(RealWindow, NamesKeysByTheirLabelsInFiveLayouts) {
  if (const std::string missing = VirtualScreen::missing(); !missing.empty()) GTEST_SKIP() << missing << " is absent";
  const StudioProgram studio;
  const VirtualScreen screen(studio.folder());
  const Surroundings surroundings({{"DISPLAY", screen.name()}});
  OpenWindow open;
  ASSERT_TRUE(open.sees([&] { return open.is_focused; }));
  for (const KeyboardLayout& layout : kLayouts) {
    screen.set_layout(layout.name);
    open.pressed.clear(), open.released.clear();
    std::vector<ImGuiKey> expected;
    for (const char meaning : layout.meanings) expected.push_back(key_at(meaning));
    for (const char place : kPlaces) screen.press({VirtualScreen::code_of(place)});
    ASSERT_TRUE(open.sees([&] { return open.released.size() == kPlaces.size(); })) << layout.name;
    EXPECT_EQ(open.pressed, expected) << layout.name;
    EXPECT_EQ(open.released, expected) << layout.name;
  }
}

TEST(RealWindow, FollowsAChangeOfLayoutAtOnce) {
  if (const std::string missing = VirtualScreen::missing(); !missing.empty()) GTEST_SKIP() << missing << " is absent";
  const StudioProgram studio;
  const VirtualScreen screen(studio.folder());
  const Surroundings surroundings({{"DISPLAY", screen.name()}});
  screen.set_layout("us");
  OpenWindow open;
  ASSERT_TRUE(open.sees([&] { return open.is_focused; }));
  EXPECT_TRUE(open.names.empty());
  screen.set_layout("de");
  EXPECT_TRUE(open.sees([&] { return !open.names.empty(); })) << "the names change without a pressed key";
  EXPECT_EQ(open.names[ImGuiKey_Slash], "ß");

  const unsigned place = VirtualScreen::code_of('y');
  screen.turn_key(place, true);
  ASSERT_TRUE(open.sees([&] { return open.pressed.size() == 1; }));
  screen.set_layout("us");
  EXPECT_TRUE(open.sees([&] { return open.names.empty(); }));
  screen.turn_key(place, false);
  screen.press({place});
  ASSERT_TRUE(open.sees([&] { return open.released.size() == 2; }));
  EXPECT_EQ(open.pressed, (std::vector<ImGuiKey>{ImGuiKey_Z, ImGuiKey_Y}));
  EXPECT_EQ(open.released, (std::vector<ImGuiKey>{ImGuiKey_Z, ImGuiKey_Y})) << "a release belongs to its press";

  screen.set_layout("us,de -option grp:shifts_toggle");
  screen.press({VirtualScreen::kShift, VirtualScreen::kRightShift});  // changes to the second layout
  screen.press({place});
  ASSERT_TRUE(open.sees([&] { return open.released.size() == 5; }));
  EXPECT_EQ(open.released.back(), ImGuiKey_Z);
}

TEST(RealWindow, SelectsAllAndUndoesByTheLabelsOfFiveLayouts) {
  if (const std::string missing = VirtualScreen::missing(); !missing.empty()) GTEST_SKIP() << missing << " is absent";
  const StudioProgram studio;
  const VirtualScreen screen(studio.folder());
  const Surroundings surroundings({{"DISPLAY", screen.name()}});
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/settings.json", R"({"tour_seen": true})");
  os::ChildProcess program;
  ASSERT_TRUE(
      program.start({STUDIO_PROGRAM, "--state-dir", studio.folder() / "state", "--size", "900x700", kLayoutFile},
                    studio.folder() / "errors"));
  const auto is_dirty = [&] { return screen.title().starts_with("*"); };
  const auto is_clean = [&] { return screen.title().starts_with("Fingertip"); };
  ASSERT_TRUE(holds_within(30, is_clean)) << screen.title();
  constexpr auto kControl = VirtualScreen::kControl, kShift = VirtualScreen::kShift;
  for (const KeyboardLayout& layout : kLayouts) {
    screen.set_layout(layout.name);
    const unsigned undo = VirtualScreen::code_of(layout.undo), all = VirtualScreen::code_of(layout.select_all);
    screen.press({kControl, VirtualScreen::code_of('1')});  // LAYOUT
    // Keys of one frame have no order, so each key waits for a frame.
    const auto is_emptied = [&] {
      for (const unsigned code : {all, VirtualScreen::kDelete}) {
        screen.press({code});
        if (holds_within(0.3, is_dirty)) return true;
      }
      return false;
    };
    EXPECT_TRUE(holds_within(10, is_emptied)) << layout.name << ": all taxels are deleted";
    screen.press({kControl, undo});
    EXPECT_TRUE(holds_within(10, is_clean)) << layout.name << ": undone";
    screen.press({kControl, kShift, undo});
    EXPECT_TRUE(holds_within(10, is_dirty)) << layout.name << ": redone";
    screen.press({kControl, undo});
    ASSERT_TRUE(holds_within(10, is_clean)) << layout.name << ": undone again";
  }
}

}  // namespace
}  // namespace taxel::test
