// The room ANALYSE through the program: each question has its answer on a large plot after two inputs, the axes show
// the contact, and the rooms keep their arrangements.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kAnalyse = key("3", kCtrl);
const Lines kTouched{key("="), key("="), wait_time(1.3), key("Space"), kIdle};

Json rect_of_widget(const Json& state, const std::string& label) {
  for (const Json& widget : state["widgets"])
    if (widget["label"] == label) return widget["rect"];
  return nullptr;
}

double area_of(const Json& rect) {
  return (rect[2].get<double>() - rect[0].get<double>()) * (rect[3].get<double>() - rect[1].get<double>());
}

/// Returns the part of a window of this size that the large plot covers; 0 without a plot.
double part_of_plot(const Json& state, const std::string& size) {
  const Json rect = rect_of_widget(state, "Answer");
  int width = 0, height = 0;
  char times = 0;
  std::istringstream(size) >> width >> times >> height;
  return rect.is_null() ? 0.0 : area_of(rect) / (static_cast<double>(width) * height);
}

bool shows_widget(const Json& state, const std::string& panel, const std::string& label) {
  return std::ranges::any_of(state["widgets"],
                             [&](const Json& widget) { return widget["panel"] == panel && widget["label"] == label; });
}

class AnalysedWindow : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Sizes, AnalysedWindow, testing::Values("800x600", "1280x800", "1920x1080"));

TEST_P(AnalysedWindow, AnswersEachQuestionOnALargePlotAfterTwoInputs) {
  const StudioProgram studio;
  const auto at = [&](const std::string& panel) { return studio.state(panel + ".json"); };
  const Lines model{kAnalyse, kIdle, press("Models tab"), kIdle, kIdle, dump("Models.json")};
  const Lines jump{kAnalyse, kIdle, press("Explain tab"), kIdle, kIdle, dump("Explain.json")};
  const Lines layout{press("Simulation"), kIdle, press("Compare with the paper's released model"), kIdle, kIdle,
                     dump("Compare.json")};
  const Lines parameter{press("Mode"), kIdle, press("Which parameter matters?"), kIdle, kIdle, dump("Study.json")};
  const Lines real{kAnalyse, kIdle, press("Real tab"), kIdle, kIdle, dump("Real.json")};
  const Lines back{key("2", kCtrl), kIdle};
  const std::string size = GetParam();
  const bool reads_models = size == "1280x800";  // models and explanations take long
  studio.play(joined({kTouched, reads_models ? joined({model, back, jump}) : Lines{}, back, layout, back, parameter,
                      back, real}),
              sparse_fingertip(studio, 1e5, size.c_str()));
  std::vector<std::string> panels{"Compare", "Study", "Real"};
  if (reads_models) panels.insert(panels.end(), {"Models", "Explain"});
  for (const std::string& panel : panels) {
    EXPECT_EQ(at(panel)["mode"], "analyse") << panel;
    EXPECT_GE(part_of_plot(at(panel), size), 0.4) << panel;
  }
  if (reads_models) {
    EXPECT_EQ(at("Models")["plot"]["answer"], "Models");
    EXPECT_EQ(at("Models")["models"]["step"], at("Models")["simulation"]["step"]);
    EXPECT_TRUE(at("Explain")["explain"].is_object()) << "the largest jump is explained without a selection";
    EXPECT_TRUE(at("Explain")["plot"]["close_up"].is_object());
  }
  EXPECT_EQ(at("Compare")["plot"]["answer"], "Compare");
  EXPECT_FALSE(rect_of_widget(at("Compare"), "Compared curves").is_null());
  EXPECT_EQ(at("Study")["plot"]["answer"], "Study");
  EXPECT_EQ(at("Study")["study"]["runs"].size(), 4U);
  EXPECT_TRUE(shows_widget(at("Real"), "Real", "Read a recording..."));
}

TEST(Analyse, PausesTheRunAndPlaysItThere) {
  const StudioProgram studio;
  studio.play(
      {kIdle, key("="), wait_time(0.3), kAnalyse, kIdle, dump("paused.json"), key("Space"), wait_time(0.5),
       dump("played.json"), kLayoutMode, kIdle, dump("layout.json"), key("Space"), wait_time(0.7), dump("on.json")},
      sparse_fingertip(studio, 1e5));
  EXPECT_EQ(studio.state("paused.json")["mode"], "analyse");
  EXPECT_FALSE(studio.state("paused.json")["simulation"]["playing"].get<bool>());
  EXPECT_EQ(studio.state("played.json")["mode"], "analyse");
  EXPECT_TRUE(studio.state("played.json")["simulation"]["playing"].get<bool>());
  EXPECT_FALSE(studio.state("layout.json")["simulation"]["playing"].get<bool>()) << "nothing is simulated in LAYOUT";
  EXPECT_EQ(studio.state("on.json")["mode"], "simulate");
}

TEST(Analyse, FitsTheAxesToTheContactUntilAKeyShowsAll) {
  const StudioProgram studio;
  studio.play(joined({kTouched,
                      {kAnalyse, kIdle, press("Taxels tab"), kIdle, dump("begins.json")},
                      {dump("fitted.json"), key("a"), kIdle, dump("all.json"), key("a"), kIdle, dump("again.json")}}),
              sparse_fingertip(studio, 1e5));
  const auto x = [&](const std::string& file) { return studio.state(file)["plot"]["x"]; };
  const double begin = x("fitted.json")[0], end = x("fitted.json")[1];
  EXPECT_GT(begin, x("all.json")[0].get<double>());
  EXPECT_LT(end, x("all.json")[1].get<double>());
  EXPECT_EQ(x("again.json"), x("fitted.json"));
}

TEST(Analyse, KeepsItsTabsByEscAndRestoresThem) {
  const StudioProgram studio;
  const auto tabs_of = [&](const std::string& file) {
    const Json state = studio.state(file);
    std::vector<std::pair<double, std::string>> tabs;
    for (const Json& widget : state["widgets"])
      if (const std::string label = widget["label"]; label.ends_with(" tab"))
        tabs.emplace_back(widget["rect"][0].get<double>(), label);
    std::ranges::sort(tabs);
    std::vector<std::string> names;
    for (const auto& [left, label] : tabs) names.push_back(label);
    return names;
  };
  const std::string space = key("Space", kCtrl);
  studio.play(joined({kTouched,
                      {kAnalyse,
                       kIdle,
                       press("Study tab"),
                       kIdle,
                       dump("study.json"),
                       key("Escape"),
                       kIdle,
                       key("Escape"),
                       kIdle,
                       dump("escaped.json"),
                       space,
                       kIdle,
                       dump("alone.json"),
                       space,
                       kIdle,
                       dump("restored.json"),
                       key("2", kCtrl),
                       kIdle,
                       dump("simulate.json"),
                       kAnalyse,
                       kIdle,
                       dump("back.json")}}),
              sparse_fingertip(studio, 1e5));
  const std::vector<std::string> expected{"Taxels tab", "Models tab",  "Compare tab",
                                          "Study tab",  "Explain tab", "Real tab"};
  EXPECT_EQ(tabs_of("study.json"), expected);
  for (const char* file : {"study.json", "escaped.json", "restored.json", "back.json"})
    EXPECT_TRUE(shows_widget(studio.state(file), "Study", "Run study")) << file;
  EXPECT_TRUE(tabs_of("alone.json").empty()) << "one panel fills the window";
  EXPECT_EQ(tabs_of("restored.json"), expected);
  EXPECT_EQ(tabs_of("back.json"), expected);
  EXPECT_FALSE(shows_widget(studio.state("simulate.json"), "Study", "Run study"))
      << "SIMULATE has an arrangement of its own";
}

}  // namespace
}  // namespace taxel::test
