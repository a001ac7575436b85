// The boxes of all texts on the screen, in each mode and panel, window size, scale and theme: no text is cut, shortened
// or covers another one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>

#include "script_lines.h"

namespace taxel::test {
namespace {

/// A window: its size, the scale of its text and its theme.
struct WindowLook {
  const char* size;
  double scale;
  bool dark;
};

void PrintTo(const WindowLook& look, std::ostream* out) {
  *out << look.size << " at " << look.scale << (look.dark ? " dark" : " light");
}

/// Windows that float over others, which may cover texts.
const std::set<std::string> kFloating{"Study", "Mesh report", "Probe", "Map columns"};

bool may_cover(const std::string& a, const std::string& b) {
  return a != b && (kFloating.contains(a) || kFloating.contains(b));
}

/// Returns whether two boxes overlap by more than a pixel in both directions.
bool overlap(const Json& a, const Json& b) {
  const auto shared = [&](std::size_t low, std::size_t high) {
    return std::min(a[high].get<double>(), b[high].get<double>()) -
           std::max(a[low].get<double>(), b[low].get<double>());
  };
  return shared(0, 2) > 1 && shared(1, 3) > 1;
}

/// Returns the words of a dump that are cut, shortened or cover another one, with their panels.
std::vector<std::string> bad_words(const Json& state) {
  const Json &texts = state["amount"]["texts"], &places = state["amount"]["places"];
  const auto named = [&](std::size_t i) {
    return places[i]["panel"].get<std::string>() + "/" + texts[i].get<std::string>();
  };
  std::vector<std::string> bad;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (places[i]["cut"].get<bool>()) bad.push_back(named(i) + " is cut");
    if (texts[i].get<std::string>().ends_with("\u2026")) bad.push_back(named(i) + " is shortened");
    for (std::size_t j = 0; j < i; ++j)
      if (overlap(places[i]["rect"], places[j]["rect"]) && !may_cover(places[i]["panel"], places[j]["panel"]))
        bad.push_back(named(i) + " covers " + named(j));
  }
  return bad;
}

/// The states that a script dumps, by their names.
class DumpedStates {
 public:
  /// Returns lines that dump a state without a tooltip at the pointer.
  [[nodiscard]] Lines dump_as(const std::string& name) {
    names_.push_back(name);
    return {R"({"event": "mouse_move", "at": [1, 1]})", kIdle, kIdle, dump(name + ".json")};
  }
  /// Checks the words of all states. With more than four tabs, a compact window scrolls them: `scrolls_tabs`.
  void check(const StudioProgram& studio, bool scrolls_tabs = false) const {
    for (const std::string& name : names_) {
      const Json state = studio.state(name + ".json");
      EXPECT_GT(state["amount"]["texts"].size(), 20U) << name;
      std::vector<std::string> bad = bad_words(state);
      if (scrolls_tabs)
        std::erase_if(bad, [](const std::string& each) { return each.starts_with("WindowOverViewport"); });
      EXPECT_EQ(bad, std::vector<std::string>{}) << name;
    }
  }

 private:
  std::vector<std::string> names_;
};

/// Returns the arguments of a window with a sparse fingertip.
std::vector<std::string> window_of(const StudioProgram& studio, const WindowLook& look) {
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/settings.json", Json({{"dark", look.dark}, {"scale", look.scale}}).dump());
  std::vector<std::string> arguments = sparse_fingertip(studio, 1e5, look.size);
  arguments.insert(arguments.begin(), {"--state-dir", "state"});
  return arguments;
}

const Lines kPressed{key("="), key("="), wait_time(1.3), key("Space"), kIdle};

/// Returns lines that choose an entry of the menu Panels.
Lines panel(const std::string& entry) {
  return {press("/Panels"), kIdle, press("Panels/" + entry), kIdle, kIdle};
}

class TextBoxes : public testing::TestWithParam<WindowLook> {};
INSTANTIATE_TEST_SUITE_P(UsualLook, TextBoxes, testing::Values(WindowLook{"1280x800", 1, true}));
INSTANTIATE_TEST_SUITE_P(Looks, TextBoxes,
                         testing::Values(WindowLook{"800x600", 1, false}, WindowLook{"800x600", 1, true},
                                         WindowLook{"1280x800", 1, false}, WindowLook{"1920x1080", 1, true},
                                         WindowLook{"1920x1080", 1, false}, WindowLook{"2560x1600", 2, true},
                                         WindowLook{"2560x1600", 2, false}));

TEST_P(TextBoxes, AreWholeInEachPanelOfSimulate) {
  const StudioProgram studio;
  DumpedStates states;
  Lines lines = joined({kPressed, states.dump_as("begins")});
  for (const char* entry : {"Outliner", "Taxels", "Inspector", "Pressure bars", "Taxel map", "Plot", "Heat map",
                            "Section", "Models", "Compare", "Profiler", "Messages", "Explain", "Controls", "Study"})
    lines = joined({lines, panel(entry), states.dump_as(entry)});
  studio.play(lines, window_of(studio, GetParam()));
  states.check(studio);
}

TEST_P(TextBoxes, AreWholeInEachPanelOfLayout) {
  const StudioProgram studio;
  DumpedStates states;
  Lines lines = joined({{kIdle, kLayoutMode, kIdle}, states.dump_as("begins")});
  for (const char* entry : {"Outliner", "Taxels", "Inspector", "Messages"})
    lines = joined({lines, panel(entry), states.dump_as(entry)});
  lines = joined({lines, {key("a"), kIdle}, states.dump_as("all selected"), {key("g", kCtrl), kIdle, kIdle}});
  for (const char* kind : {"Grid", "Hexagonal", "Ring", "Helix", "Spiral", "Spread", "Table", "Image"})
    lines = joined({lines, {press(std::string("Generate/") + kind), kIdle}, states.dump_as(kind)});
  lines = joined({lines,
                  {key("Escape"), kIdle, key("Escape"), kIdle, key("x"), kIdle,
                   R"({"event": "mouse_move", "at": {"taxel": 3}})", kIdle, click(taxel(3)), kIdle},
                  states.dump_as("probe")});
  studio.play(lines, window_of(studio, GetParam()));
  states.check(studio);
}

/// Texts of ANALYSE, whose answers take long and are the same in both themes.
class AnalyseTexts : public testing::TestWithParam<WindowLook> {};
INSTANTIATE_TEST_SUITE_P(Looks, AnalyseTexts,
                         testing::Values(WindowLook{"800x600", 1, true}, WindowLook{"1280x800", 1, false},
                                         WindowLook{"1920x1080", 1, true}, WindowLook{"2560x1600", 2, true}));

TEST_P(AnalyseTexts, AreWholeInEachTab) {
  const StudioProgram studio;
  DumpedStates states;
  Lines lines = joined({kPressed, {key("3", kCtrl), kIdle, kIdle}});
  for (const char* tab : {"Taxels", "Models", "Compare", "Study", "Explain", "Real"})
    lines = joined({lines, {press(std::string(tab) + " tab"), kIdle, kIdle}, states.dump_as(tab)});
  const Lines explain{press("/Mode"), kIdle, press("Why did a reading jump?"), kIdle, kIdle};
  const Lines compare{press("/Simulation"), kIdle, press("Compare with the paper's released model"), kIdle, kIdle};
  const Lines study{press("/Mode"), kIdle, press("Which parameter matters?"), kIdle, kIdle};
  lines = joined({lines, explain, states.dump_as("explained"), compare});
  // In the smallest window the table of a comparison scrolls, and B's name is shortened, with all of it in its tooltip.
  if (std::string_view(GetParam().size) != "800x600") lines = joined({lines, states.dump_as("compared")});
  lines = joined({lines, study, states.dump_as("studied")});
  studio.play(lines, window_of(studio, GetParam()));
  states.check(studio);
}

/// Returns a recording of taxels 3 and 4, in counts of a device.
std::string recorded_counts() {
  std::string table = "time,3,4\n";
  for (int row = 0; row < 140; ++row) {
    const double time = 0.01 * row, pressed = std::max(0.0, time - 0.7);
    table += std::to_string(time) + "," + std::to_string(50 + 200 * pressed) + "," +
             std::to_string(40 + 900 * pressed * pressed) + "\n";
  }
  return table;
}

TEST_P(TextBoxes, AreWholeAroundARecordingOfARealSensor) {
  const StudioProgram studio;
  write_text(studio.folder() / "real.csv", recorded_counts());
  DumpedStates states;
  const Lines import{press("/File"), kIdle,           press("Import real recording..."),
                     kIdle,          key("a", kCtrl), type((studio.folder() / "real.csv").string()),
                     kIdle,          key("Enter"),    kIdle,
                     kIdle};
  studio.play(joined({kPressed,
                      import,
                      states.dump_as("mapped"),
                      {press("Overlay"), kIdle, kIdle},
                      states.dump_as("overlaid"),
                      {press("Fit gains"), kIdle, kIdle},
                      states.dump_as("fitted"),
                      {key("3", kCtrl), kIdle, press("Real tab"), kIdle},
                      states.dump_as("analysed")}),
              window_of(studio, GetParam()));
  EXPECT_EQ(studio.state("fitted.json")["real"]["shown"]["fits"].size(), 2U);
  states.check(studio, std::string(GetParam().size) == "800x600");
}

TEST(StatusLine, HasOneRowInEverySize) {
  for (const char* size : {"640x480", "800x600", "1280x800"}) {
    const StudioProgram studio;
    studio.play(joined({kPressed, {dump("paused.json")}}), window_of(studio, {size, 1, true}));
    const Json state = studio.state("paused.json");
    std::set<double> rows;
    bool has_force = false, has_pace = false;
    for (const Json& widget : state["widgets"]) {
      if (widget["panel"] != "Status" || widget["label"] == "Status") continue;
      rows.insert(widget["rect"][1].get<double>());
      has_force = has_force || widget["label"].get<std::string>().starts_with("force ");
      has_pace = has_pace || widget["label"] == "simulation paused";
    }
    EXPECT_EQ(rows.size(), 1U) << size;
    EXPECT_TRUE(has_force && has_pace) << size << ": the most important parts stay";
  }
}

}  // namespace
}  // namespace taxel::test
