// Pasting from the clipboard: content that is not a taxel is reported once, and nothing is lost.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// Returns lines that put `text` on the clipboard like a user: type it into a field and copy it from there. Esc
/// restores the field.
Lines copied_from_a_field(const std::string& text) {
  return {press("Name"),   kIdle, key("a", kCtrl), kIdle, type(text), kIdle,
          key("a", kCtrl), kIdle, key("c", kCtrl), kIdle, key("Esc"), kIdle};
}

const std::string kExpected = "taxels as JSON: copied ones, a layout, an array of taxels, or one taxel";

/// Returns a text with many copies of one letter.
std::string joined_text(std::string text, char letter, const std::string& end) {
  constexpr std::size_t kHuge = 20'000;
  text.append(kHuge, letter);
  return text.append(end);
}

struct Pasted {
  std::string text, complaint;
};
const std::vector<Pasted> kNonsense{
    Pasted{"Dear Sir or Madam,", "clipboard: holds no " + kExpected},
    Pasted{R"(\u20ac\ufffd\u4e2d\uffff)", "clipboard: holds no " + kExpected},
    Pasted{R"({\"taxels\": )", "clipboard: line 1, column"},
    Pasted{R"({\"name\": \"gripper\", \"joints\": [1, 2, 3]})", "clipboard: holds no " + kExpected},
    Pasted{R"([{\"center\": [0, 0, \"x\"], \"normal\": [0, 0, 1], \"radius\": 1}])", "clipboard: /0/center"},
    Pasted{R"([{\"center\": [0, 0, 0], \"normal\": [0, 0, 1], \"radius\": -1}])", "taxel 12: radius"},
    Pasted{joined_text("[", '7', "]"), "clipboard: "},
    Pasted{joined_text(R"([\")", 'x', R"(\"])"), "clipboard: /0: must be an object"},
    Pasted{joined_text("", 'x', ""), "clipboard: holds no " + kExpected}};

TEST(Clipboard, ReportsNonsenseOnceAndChangesNothing) {
  const StudioProgram studio;
  Lines script{kLayoutMode, kIdle, click(taxel(3)), kIdle, dump("before.json")};
  for (std::size_t i = 0; i < kNonsense.size(); ++i) {
    const Lines copied = copied_from_a_field(kNonsense[i].text);
    script.insert(script.end(), copied.begin(), copied.end());
    script.insert(script.end(), {key("v", kCtrl), kIdle, dump(std::to_string(i) + ".json")});
  }
  studio.play(script, {kLayoutFile});
  const Json before = studio.state("before.json");
  const int first = before["messages"].empty() ? 1 : before["messages"].back()["number"].get<int>() + 1;
  for (std::size_t i = 0; i < kNonsense.size(); ++i) {
    const Json after = studio.state(std::to_string(i) + ".json");
    EXPECT_EQ(after["document"], before["document"]) << i;
    EXPECT_EQ(after["history"]["depth"], 0) << i;
    EXPECT_EQ(after["selection"], before["selection"]) << i;
    ASSERT_FALSE(after["messages"].empty());
    EXPECT_EQ(after["messages"].back()["number"], first + static_cast<int>(i)) << "one message for each";
    const std::string said = after["messages"].back()["text"];
    EXPECT_EQ(after["messages"].back()["severity"], "error") << i;
    EXPECT_EQ(said.find(kNonsense[i].complaint), 0U) << said.substr(0, 300);
    EXPECT_LT(said.size(), 300U) << i;
  }
}

}  // namespace
}  // namespace taxel::test
