// Several sensors in the window: bars, plot, map, table and heat map of a hand that grasps a ball; the plot's legend,
// read-out and exports.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "script_lines.h"

namespace taxel::test {
namespace {

const std::string kHandScene = TAXEL_SOURCE_DIR "/assets/scenes/hand_grasps_ball.xml";
const std::string kRestElsewhere = R"({"event": "mouse_move", "at": [3, 797]})";

std::string rest_on(const std::string& label) {
  return R"({"event": "mouse_move", "at": {"widget": ")" + label + R"("}})";
}
/// Returns lines that open a panel from the menu, in front of other tabs.
Lines panel_opened(const std::string& label) {
  return {press("Panels"), kIdle, press(label), kIdle, kIdle};
}
Lines plot_exported(const std::string& label, const std::string& file) {
  return {press("File"), kIdle, press("Export"), kIdle, press(label), kIdle, type(file), kIdle, key("Enter"), kIdle};
}

/// Returns the arguments of a large window in which only some panels are open.
std::vector<std::string> hand_window(const StudioProgram& studio, const std::string& settings,
                                     const std::string& file) {
  std::filesystem::create_directories(studio.folder() / "state");
  write_text(studio.folder() / "state/settings.json", settings);
  std::vector<std::string> arguments{"--state-dir", "state", "--size", "1600x1000"};
  if (!file.empty()) arguments.push_back(file);
  return arguments;
}

double hand_reading(const Json& state, int sensor, int taxel) {
  return state["simulation"]["sensors"][static_cast<std::size_t>(sensor)]["readings"][static_cast<std::size_t>(taxel)];
}

TEST(Hand, HasNoContactInLayoutWithoutAnEditedLayout) {
  const StudioProgram studio;
  studio.play({kIdle, wait_time(0.3), key("Space"), kIdle, dump("run.json"), kLayoutMode, kIdle, kIdle, kIdle,
               dump("layout.json")},
              {kHandScene});
  const auto has_legend = [](const Json& state) {
    return std::any_of(state["widgets"].begin(), state["widgets"].end(),
                       [](const Json& widget) { return widget["panel"] == "Pressure legend"; });
  };
  const Json run = studio.state("run.json"), layout = studio.state("layout.json");
  ASSERT_FALSE(run["contact"]["arrows"].empty());
  EXPECT_TRUE(has_legend(run));
  EXPECT_TRUE(layout["scene_layout"].is_null());
  EXPECT_TRUE(layout["contact"]["arrows"].empty());
  EXPECT_EQ(layout["marks"]["discs"], 0);
  EXPECT_FALSE(has_legend(layout));
}

TEST(Hand, ShowsTheBarsOfAllSensorsInGroups) {
  const StudioProgram studio;
  studio.play({kIdle, wait_time(0.3), key("Space"), kIdle, dump("held.json")},
              hand_window(studio, R"({"panel_map": false, "panel_heat": false, "panel_messages": false})", kHandScene));
  const Json held = studio.state("held.json");
  const Json& bars = held["bars"];
  ASSERT_EQ(bars.size(), 60U);
  std::set<double> steps;
  for (std::size_t i = 0; i < bars.size(); ++i) {
    EXPECT_EQ(bars[i]["sensor"], i / 12);
    EXPECT_EQ(bars[i]["value"], hand_reading(held, static_cast<int>(i / 12), static_cast<int>(i % 12)));
    EXPECT_EQ(bars[i]["top"], bars[0]["top"]) << "one axis for one unit";
  }
  const double within = bars[11]["rect"][0].get<double>() - bars[10]["rect"][0].get<double>();
  const double between = bars[12]["rect"][0].get<double>() - bars[11]["rect"][0].get<double>();
  EXPECT_GT(between, within + 4);
  const auto named = [&](const char* label) {
    return std::any_of(held["widgets"].begin(), held["widgets"].end(),
                       [&](const Json& widget) { return widget["label"] == label; });
  };
  for (const char* name : {"Bars of index", "Bars of middle", "Bars of ring", "Bars of little", "Bars of thumb"})
    EXPECT_TRUE(named(name)) << name;
}

/// Writes a layout of our fingertip with `count` taxels: those of the shipped layout and copies next to them.
void write_dense_fingertip(const std::filesystem::path& file, int count) {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 3e5;
  const Json shipped = layout["taxels"];
  layout["taxels"] = Json::array();
  for (int k = 0; k < count; ++k) {
    Json taxel = shipped[static_cast<std::size_t>(k) % shipped.size()];
    taxel["id"] = k;
    taxel["center"][2] = taxel["center"][2].get<double>() + 3e-4 * (k / static_cast<int>(shipped.size()));
    layout["taxels"].push_back(taxel);
  }
  write_text(file, layout.dump());
}

/// Writes a scene with the fingertips of a hand of 21 links and 773 taxels, which a plate presses, and returns its
/// name.
std::string write_many_fingertips(const StudioProgram& studio) {
  write_dense_fingertip(studio.folder() / "links.taxels.json", 37);
  write_dense_fingertip(studio.folder() / "palm.taxels.json", 33);
  std::string instances, bodies;
  for (int s = 0; s < 21; ++s) {
    const std::string name =
        s == 0 ? "palm" : "finger" + std::to_string((s - 1) / 4) + "_link" + std::to_string((s - 1) % 4);
    const std::string layout = s == 0 ? "palm" : "links";
    instances += R"(<instance name=")" + name + R"("><config key="layout" value=")" + layout +
                 R"(.taxels.json"/><config key="geom" value=")" + name +
                 R"("/><config key="others" value="plate"/></instance>)";
    bodies += R"(<body name="body_)" + name + R"(" pos=")" + std::to_string(0.03 * (s % 7)) + " 0 " +
              std::to_string(0.05 * (s / 7)) + R"("><joint type="slide" axis="0 1 0" damping="1000"/><geom name=")" +
              name + R"(" type="mesh" mesh="finger"/></body>)";
  }
  write_text(studio.folder() / "many.xml",
             R"(<mujoco><option gravity="0 0 0"/><extension><plugin plugin="taxel.sensor">)" + instances +
                 R"(</plugin></extension><asset><mesh name="finger" file=")" + kMeshFile + R"("/></asset><worldbody>)" +
                 R"(<geom name="plate" type="box" size="0.15 0.01 0.1" pos="0.09 -0.0165 0.06"/>)" + bodies +
                 "</worldbody></mujoco>");
  return "many.xml";
}

/// Returns the first two boxes of `texts`, each with a member "rect", that overlap; or an empty text.
std::string first_overlap(const Json& texts) {
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Json &a = texts[i]["rect"], &b = texts[j]["rect"];
      if (a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3])
        return texts[j]["text"].get<std::string>() + " and " + texts[i]["text"].get<std::string>();
    }
  }
  return "";
}

/// Checks that no label of the view overlaps another one or another text of the view.
void check_labels(const Json& state) {
  EXPECT_EQ(first_overlap(state["labels"]), "");
  for (const Json& label : state["labels"]) {
    const Json& a = label["rect"];
    for (const Json& b : state["covered"])
      EXPECT_FALSE(a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]) << label["text"];
  }
}

TEST(ManySensors, AreCellsWithoutATextOnAnother) {
  const StudioProgram studio;
  const std::string scene = write_many_fingertips(studio);
  for (const char* size : {"1280x800", "1024x700"}) {
    studio.play(
        {kIdle, wait_time(0.004), key("Space"), kIdle, dump("cells.json"), press("As bars"), kIdle, dump("bars.json"),
         key("k", kCtrl), kIdle, type("marks of all"), kIdle, key("Enter"), kIdle, dump("all.json")},
        {"--size", size, scene});
    const Json state = studio.state("cells.json"), bars = studio.state("bars.json");
    EXPECT_TRUE(state["bars"].empty());
    ASSERT_EQ(state["cells"].size(), 773U) << size;
    double largest = 0;
    for (const Json& cell : state["cells"]) {
      EXPECT_EQ(cell["value"], hand_reading(state, cell["sensor"], cell["taxel"]));
      largest = std::max(largest, cell["value"].get<double>());
    }
    EXPECT_GT(largest, 1000) << "the plate is felt";
    EXPECT_EQ(state["bar_texts"].size(), 21U) << "all names";
    EXPECT_EQ(first_overlap(state["bar_texts"]), "");
    EXPECT_GE(state["labels"].size(), 5U);
    check_labels(state);
    EXPECT_EQ(bars["bars"].size(), 773U);
    EXPECT_EQ(first_overlap(bars["bar_texts"]), "");
    EXPECT_EQ(studio.state("all.json")["overlays"]["all_taxels"], true);
    check_labels(studio.state("all.json"));
    EXPECT_GT(studio.state("all.json")["labels"].size(), state["labels"].size());
  }
}

TEST(ManySensors, SelectTheTaxelOfAClickedCell) {
  const StudioProgram studio;
  const std::string scene = write_many_fingertips(studio);
  const Lines begin{kIdle, wait_time(0.004), key("Space"), kIdle, dump("cells.json")};
  studio.play(begin, {scene});
  const Json cell = studio.state("cells.json")["cells"][500];
  const Json& rect = cell["rect"];
  const std::string at = "[" + std::to_string(0.5 * (rect[0].get<double>() + rect[2].get<double>())) + ", " +
                         std::to_string(0.5 * (rect[1].get<double>() + rect[3].get<double>())) + "]";
  studio.play(joined({begin, {click(at), kIdle, dump("clicked.json"), press("Fold"), kIdle, dump("folded.json")}}),
              {scene});
  const Json clicked = studio.state("clicked.json");
  EXPECT_EQ(clicked["selection"]["sensor"], cell["sensor"]);
  EXPECT_EQ(clicked["selection"]["taxels"], Json::array({cell["taxel"]}));
  const auto label_of = [&](const char* file, const std::string& begins) {
    const Json widgets = studio.state(file)["widgets"];
    return std::count_if(widgets.begin(), widgets.end(), [&](const Json& widget) {
      return widget["panel"] == "Taxels" && widget["label"].get<std::string>().starts_with(begins);
    });
  };
  EXPECT_EQ(label_of("clicked.json", "Taxel finger" + std::to_string((cell["sensor"].get<int>() - 1) / 4)) > 0, true)
      << "the table scrolls to the selected taxel";
  EXPECT_EQ(label_of("folded.json", "Taxel "), 0);
  EXPECT_GE(label_of("folded.json", "Sensor "), 5);
}

TEST(Hand, ShowsAllSensorsInPlotTableAndMap) {
  const StudioProgram studio;
  studio.play(joined({{kIdle, wait_time(0.3), key("Space"), kIdle, dump("plot.json")},
                      panel_opened("Taxel map"),
                      {dump("held.json"), press("Disc thumb 0"), kIdle, dump("thumb.json")}}),
              hand_window(studio, R"({"panel_heat": false, "panel_bars": false, "panel_section": false})", kHandScene));
  const Json held = studio.state("held.json"), thumb = studio.state("thumb.json");
  const Json curves = studio.state("plot.json")["plot"]["curves"];
  std::set<int> plotted;
  for (const Json& curve : curves) {
    plotted.insert(curve["sensor"].get<int>());
    EXPECT_GE(curve["label"].get<std::string>().find(' '), 4U) << curve;
  }
  EXPECT_EQ(plotted.size(), 5U);
  ASSERT_EQ(held["table"]["sensor_rows"].size(), 60U);
  EXPECT_EQ(held["table"]["sensor_rows"][59], Json::parse("[4, 11]"));
  const Json& discs = held["map"]["discs"];
  ASSERT_EQ(discs.size(), 60U);
  for (const Json& disc : discs) EXPECT_EQ(disc["value"], hand_reading(held, disc["sensor"], disc["taxel"]));
  EXPECT_EQ(thumb["selection"]["sensor"], 4);
  EXPECT_EQ(thumb["selection"]["taxels"], Json::parse("[0]"));
}

TEST(Hand, FramesTheSelectedSensorAndTaxel) {
  const StudioProgram studio;
  studio.play({kIdle,
               wait_time(0.02),
               key("Space"),
               kIdle,
               dump("all.json"),
               key("Period"),
               kIdle,
               dump("none.json"),
               press("Outliner/index"),
               kIdle,
               key("Period"),
               kIdle,
               dump("index.json"),
               press("Filter the outliner"),
               kIdle,
               type("thumb"),
               kIdle,
               press("Outliner/thumb"),
               kIdle,
               key("Period"),
               kIdle,
               dump("thumb.json"),
               press("Filter taxels"),
               kIdle,
               type("thumb"),
               kIdle,
               press("Taxel thumb 3"),
               kIdle,
               key("Period"),
               kIdle,
               dump("taxel.json")},
              {"--size", "1600x2400", kHandScene});
  const auto target = [&](const char* name) { return vector_of(studio.state(name)["camera"]["target"]); };
  const Json all = studio.state("all.json");
  const auto distance = [&](const char* name) { return studio.state(name)["camera"]["distance"].get<double>(); };
  const auto position = [&](std::size_t sensor) { return vector_of(all["simulation"]["sensors"][sensor]["position"]); };
  const Json none = studio.state("none.json");
  for (const Json& box : none["sensor_boxes"]) EXPECT_TRUE(box["inside"]) << "all sensors";
  EXPECT_LT(glm::distance(target("index.json"), position(0)), 0.02);
  EXPECT_LT(glm::distance(target("thumb.json"), position(4)), 0.02);
  EXPECT_GT(glm::distance(target("index.json"), target("thumb.json")), 0.02);
  EXPECT_LT(distance("index.json"), 0.6 * distance("all.json"));
  EXPECT_LT(distance("taxel.json"), distance("thumb.json"));
}

TEST(Hand, FramesAllContactsUntilAFingerIsChosen) {
  const StudioProgram studio;
  studio.play({kIdle,
               wait_time(0.6),
               key("Space"),
               kIdle,
               key("Period"),
               kIdle,
               dump("all.json"),
               press("Taxel index 0"),
               kIdle,
               click(in_view(0.6, 0.02)),
               kIdle,
               key("Period"),
               kIdle,
               dump("again.json"),
               press("Outliner tab"),
               kIdle,
               kIdle,
               press("Outliner/index"),
               kIdle,
               key("Period"),
               kIdle,
               dump("index.json")},
              {"--size", "1280x1000", "--keyframe", "hold", kHandScene});
  const Json all = studio.state("all.json"), index = studio.state("index.json");
  std::size_t touching = 0;
  for (const Json& sensor : all["simulation"]["sensors"]) touching += sensor["polygons"].get<int>() > 0 ? 1 : 0;
  ASSERT_EQ(touching, 5U);
  const Json& arrows = all["contact"]["arrows"];
  ASSERT_EQ(arrows.size(), 5U);
  const Json& view = all["view"]["rect"];
  for (const Json& arrow : arrows)
    EXPECT_TRUE(arrow[0][0] > view[0] && arrow[0][0] < view[2] && arrow[0][1] > view[1] && arrow[0][1] < view[3])
        << arrow << " begins at a contact in " << view;
  EXPECT_EQ(studio.state("again.json")["camera"], all["camera"])
      << "a click next to the scene deselects the finger too";
  EXPECT_LT(index["camera"]["distance"].get<double>(), 0.6 * all["camera"]["distance"].get<double>());
}

TEST(Hand, NamesTheFingerWhoseForceIsShown) {
  const StudioProgram studio;
  studio.play({kIdle, wait_time(0.6), key("Space"), kIdle, dump("index.json"), press("Filter taxels"), kIdle,
               type("thumb"), kIdle, press("Taxel thumb 4"), kIdle, kIdle, dump("thumb.json"), key("F9"), kIdle, kIdle,
               dump("presented.json")},
              {"--size", "1600x2400", "--keyframe", "hold", kHandScene});
  const auto has_label = [](const Json& state, const std::string& begin) {
    return std::any_of(state["widgets"].begin(), state["widgets"].end(),
                       [&](const Json& widget) { return widget["label"].get<std::string>().starts_with(begin); });
  };
  EXPECT_TRUE(has_label(studio.state("index.json"), "force index: "));
  EXPECT_TRUE(has_label(studio.state("thumb.json"), "force thumb: "));
  const Json texts = studio.state("presented.json")["amount"]["texts"];
  EXPECT_NE(std::find(texts.begin(), texts.end(), "thumb:"), texts.end()) << texts;
}

TEST(Hand, IsNotCoveredByTheLegendOfTheMarks) {
  const StudioProgram studio;
  studio.play({kIdle, wait_time(0.6), key("Space"), kIdle, dump("held.json"), rest_on("Legend"), kIdle, kIdle,
               dump("asked.json")},
              {"--size", "1280x800", kHandScene});
  const Json held = studio.state("held.json");
  ASSERT_GT(held["contact"]["part_of_view"], 0);
  const auto marks = [](const Json& state) {
    std::vector<Json> texts;
    for (const Json& widget : state["widgets"])
      if (widget["panel"] == "Marks") texts.push_back(widget);
    return texts;
  };
  const std::vector<Json> folded = marks(held);
  ASSERT_EQ(folded.size(), 1U) << "only the title";
  EXPECT_EQ(folded[0]["label"], "Legend");
  for (const Json& polygon : held["polygons"]) {
    const Json &rect = folded[0]["rect"], &at = polygon["pixel"];
    EXPECT_FALSE(at[0] > rect[0] && at[0] < rect[2] && at[1] > rect[1] && at[1] < rect[3]);
  }
  EXPECT_GT(marks(studio.state("asked.json")).size(), 6U) << "the rows while the pointer rests on the title";
}

TEST(HeatMap, ScrubsToTheClickedStep) {
  const StudioProgram studio;
  studio.play({kIdle,
               wait_time(0.075),
               key("Space"),
               kIdle,
               dump("responding.json"),
               press("Heat map/Responding only"),
               kIdle,
               key("Space"),
               wait_time(0.3),
               key("Space"),
               kIdle,
               kIdle,
               dump("before.json"),
               rest_on("Heat index 0"),
               kIdle,
               dump("hover.json"),
               press("Heat index 0"),
               kIdle,
               kIdle,
               dump("after.json")},
              hand_window(studio, R"({"panel_plot": false, "panel_bars": false, "panel_section": false})", kHandScene));
  const Json before = studio.state("before.json"), hover = studio.state("hover.json"),
             after = studio.state("after.json");
  const Json& heat = before["heat"];
  const std::size_t responding = studio.state("responding.json")["heat"]["rows"].size();
  EXPECT_GE(responding, 36U) << "index, middle and thumb touch first";
  EXPECT_LT(responding, 60U);
  ASSERT_EQ(heat["rows"].size(), 60U);
  EXPECT_EQ(heat["rows"][12], "middle 0");
  EXPECT_TRUE(heat["hover"].is_null());
  EXPECT_EQ(heat["last_step"], before["simulation"]["step"]);
  const Json& cell = hover["heat"]["hover"];
  ASSERT_TRUE(cell.is_object());
  EXPECT_EQ(cell["sensor"], 0);
  EXPECT_EQ(cell["taxel"], 0);
  EXPECT_NEAR(cell["step"].get<double>(), 0.5 * before["simulation"]["step"].get<double>(), 2) << "the middle";
  EXPECT_EQ(after["simulation"]["step"], cell["step"]);
  EXPECT_EQ(after["simulation"]["time"], cell["time"]);
  EXPECT_EQ(hand_reading(after, 0, 0), cell["reading"]) << "the recorded bits";
  EXPECT_GT(cell["reading"], 0);
}

/// The colour of a cell is that of the legend for the reading of its step.
TEST(HeatMap, HasTheColourOfTheReading) {
  const StudioProgram studio;
  studio.play({kIdle, wait_time(0.3), key("Space"), kIdle, rest_on("Heat thumb 4"), kIdle, dump("hover.json"),
               kRestElsewhere, kIdle, R"({"do": "screenshot", "file": "heat.png"})"},
              hand_window(studio, R"({"panel_plot": false, "panel_bars": false, "panel_section": false})", kHandScene));
  const Json state = studio.state("hover.json");
  const Picture picture = studio.picture("heat.png");
  for (const Json& widget : state["widgets"]) {
    if (widget["label"] != "Heat ring 4" && widget["label"] != "Heat thumb 4") continue;
    const Json& rect = widget["rect"];
    const bool is_pressed = widget["label"] == "Heat thumb 4";  // in the middle; ring 4 is read near the start
    const double left = rect[0], right = rect[2], x = left + (is_pressed ? 0.5 : 0.1) * (right - left);
    const double y = 0.5 * (rect[1].get<double>() + rect[3].get<double>());
    const std::array<int, 3> pixel = picture.pixel(x, y);
    if (is_pressed) {
      EXPECT_GT(pixel[1], 20) << "a reading";
    } else {
      EXPECT_LE(std::abs(pixel[0] - 68) + std::abs(pixel[1] - 1) + std::abs(pixel[2] - 84), 6)
          << "no reading: viridis 0";
    }
  }
}

/// Returns the number of count_dimmed curves.
std::size_t count_dimmed(const Json& state) {
  const Json& curves = state["plot"]["curves"];
  return static_cast<std::size_t>(
      std::count_if(curves.begin(), curves.end(), [](const Json& curve) { return curve["dimmed"] == true; }));
}

TEST(Plot, IsolatesACurveByHoverAndByClick) {
  const StudioProgram studio;
  studio.play({kIdle, wait_time(1.5), key("Space"), kIdle, dump("all.json"), rest_on("Curve 3"), kIdle,
               dump("hover.json"), kRestElsewhere, kIdle, dump("away.json"), press("Curve 3"), kRestElsewhere, kIdle,
               dump("kept.json"), press("Curve 3"), kRestElsewhere, kIdle, dump("freed.json")},
              hand_window(studio, R"({"panel_heat": false, "panel_bars": false})", ""));
  const std::size_t curves = studio.state("all.json")["plot"]["curves"].size();
  ASSERT_GT(curves, 2U);
  EXPECT_EQ(count_dimmed(studio.state("all.json")), 0U);
  EXPECT_EQ(count_dimmed(studio.state("hover.json")), curves - 1);
  EXPECT_EQ(count_dimmed(studio.state("away.json")), 0U);
  EXPECT_EQ(count_dimmed(studio.state("kept.json")), studio.state("kept.json")["plot"]["curves"].size() - 1);
  EXPECT_EQ(studio.state("kept.json")["selection"]["taxels"], Json::parse("[3]"));
  EXPECT_EQ(count_dimmed(studio.state("freed.json")), 0U);
}

TEST(Plot, ShowsTheValuesAtThePointerWithTheirUnits) {
  const StudioProgram studio;
  studio.play({kIdle, wait_time(1.5), key("Space"), kIdle, dump("before.json"), rest_on("Plot"), kIdle,
               dump("hover.json"), R"({"do": "screenshot", "file": "hover.png"})"},
              hand_window(studio, R"({"panel_heat": false, "panel_bars": false})", ""));
  EXPECT_TRUE(studio.state("before.json")["plot"]["readout"].is_null());
  const Json readout = studio.state("hover.json")["plot"]["readout"];
  ASSERT_TRUE(readout.is_object());
  EXPECT_NEAR(readout["x"].get<double>(), 12, 6) << "near the middle of the axis, or the last row before it [mm]";
  ASSERT_GT(readout["lines"].size(), 1U);
  for (const Json& line : readout["lines"]) EXPECT_TRUE(line["text"].get<std::string>().ends_with("Pa"));
}

TEST(Plot, DrawsSelectedTaxelsThatDoNotRespond) {
  const StudioProgram studio;
  studio.play(
      {kIdle, wait_time(0.3), key("Space"), kIdle, dump("before.json"), press("Taxel 4"), kIdle, dump("selected.json")},
      hand_window(studio, R"({"panel_heat": false, "panel_bars": false})", ""));
  const auto is_drawn = [&](const char* file) {
    const Json state = studio.state(file);
    return std::any_of(state["plot"]["curves"].begin(), state["plot"]["curves"].end(),
                       [](const Json& curve) { return curve["taxel"] == 4; });
  };
  EXPECT_FALSE(is_drawn("before.json"));
  EXPECT_TRUE(is_drawn("selected.json"));
}

TEST(Plot, DrawsTheTaxelThatJumped) {
  const StudioProgram studio;
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 5e5;  // few samples, whose readings jump
  write_text(studio.folder() / "coarse.taxels.json", layout.dump());
  studio.play(
      {kIdle, key("2", kCtrl), kIdle, key("="), key("="), press("Tracks"), kIdle, press("Jump"), key("a", kCtrl),
       type("1"), key("Enter"), key("b", kShift), R"({"frame": 300, "do": "wait_idle"})", dump("stopped.json")},
      hand_window(studio, R"({"panel_heat": false, "panel_bars": false})", "coarse.taxels.json"));
  const Json stopped = studio.state("stopped.json"), stop = stopped["simulation"]["history"]["stop"];
  ASSERT_TRUE(stop.is_object()) << stopped["simulation"]["history"].dump().substr(0, 300);
  std::vector<int> jumped;
  for (const Json& curve : stopped["plot"]["curves"])
    if (curve["jumped"] == true) jumped.push_back(curve["taxel"]);
  EXPECT_EQ(jumped, std::vector<int>{stop["taxel"].get<int>()}) << "ids of our fingertip start at 0";
}

TEST(Plot, ExportsSvgAndPdf) {
  const StudioProgram studio;
  const auto in = [&](const char* name) { return (studio.folder() / name).string(); };
  studio.play(joined({{kIdle, wait_time(1.0), key("Space"), kIdle},
                      plot_exported("Export plot (SVG, PDF)...", in("curves")),
                      {key("F4"), kIdle, kIdle},
                      plot_exported("Export plot (SVG, PDF)...", in("closed")),
                      plot_exported("Export plot (SVG, PDF)...", in("curves.pdf")),
                      {dump("state.json")}}),
              hand_window(studio, R"({"panel_heat": false, "panel_bars": false})", ""));
  const std::string svg = file_text(studio.folder() / "curves.svg"), pdf = file_text(studio.folder() / "curves.pdf");
  EXPECT_TRUE(svg.starts_with("<?xml"));
  EXPECT_NE(svg.find("travel (mm)"), std::string::npos);
  EXPECT_NE(svg.find("reading / largest"), std::string::npos);
  EXPECT_EQ(svg, file_text(studio.folder() / "closed.svg")) << "also with a closed panel";
  EXPECT_TRUE(pdf.starts_with("%PDF-1.4"));
  const std::size_t at = pdf.rfind("startxref\n");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(pdf.compare(std::stoul(pdf.substr(at + 10)), 5, "xref\n"), 0);
  EXPECT_NE(pdf.find("(travel \\(mm\\)) Tj"), std::string::npos);
  EXPECT_NE(studio.state("state.json")["messages"].dump().find("Exported " + in("curves.pdf")), std::string::npos);
}

}  // namespace
}  // namespace taxel::test
