// The table of taxels and the inspector: raw events in, the document out.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/base/files.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

Lines at_layout(const std::vector<Lines>& parts) {
  return joined({{kLayoutMode, kIdle}, joined(parts)});
}
std::string widget(const std::string& label) {
  return R"({"widget": ")" + label + R"("})";
}
std::string double_click(const std::string& label) {
  return R"({"event": "double_click", "at": )" + widget(label) + "}";
}
Lines pressed(const std::string& label) {
  return {press(label), kIdle};
}
/// Types into a field of the inspector.
Lines filled(const std::string& field, const std::string& text, const std::string& end = "Enter") {
  return {press("Inspector/" + field), kIdle, type(text), kIdle, key(end), kIdle};
}
Lines chosen(const std::string& field, const std::string& word) {
  return joined({pressed("Inspector/" + field), pressed(word)});
}

Json ids_of(const Json& state) {
  Json ids = Json::array();
  for (const Json& taxel : state["document"]["layout"]["taxels"]) ids.push_back(taxel["id"]);
  return ids;
}
Json edited(const Json& state, int id) {
  return taxel_of(state["document"]["layout"], id);
}
bool shows(const Json& state, const std::string& label) {
  const Json& widgets = state["widgets"];
  return std::any_of(widgets.begin(), widgets.end(), [&](const Json& w) { return w["label"] == label; });
}

TEST(TaxelTable, IsSortedByItsHeadersAndRestoresTheLayoutOrder) {
  const StudioProgram studio;
  const Lines sorted_by_x{R"({"event": "mouse_move", "at": {"widget": "Sort by x"}})", kIdle, press("Sort by x"),
                          kIdle};
  studio.play(at_layout({{dump("layout.json")},
                         sorted_by_x,
                         {dump("up.json")},
                         sorted_by_x,
                         {dump("down.json")},
                         sorted_by_x,
                         {dump("again.json")}}),
              tall_window(studio));
  const auto places = [&](const char* file) {
    const Json state = studio.state(file);
    std::vector<double> x;
    for (const Json& id : state["table"]["rows"]) x.push_back(edited(state, id)["center"][0]);
    return x;
  };
  const std::vector<double> unsorted = places("layout.json");
  EXPECT_FALSE(std::is_sorted(unsorted.begin(), unsorted.end()));
  const std::vector<double> up = places("up.json"), down = places("down.json");
  EXPECT_EQ(up.size(), 12U);
  EXPECT_TRUE(std::is_sorted(up.begin(), up.end()));
  EXPECT_TRUE(std::is_sorted(down.rbegin(), down.rend()));
  EXPECT_EQ(studio.state("again.json")["table"]["rows"], ids_of(studio.state("again.json")));
}

TEST(TaxelTable, FiltersByIdAndName) {
  const StudioProgram studio;
  studio.play(at_layout({pressed("Filter taxels"),
                         {type("TIP"), kIdle, dump("tip.json"), key("a", kCtrl), type("11"), kIdle, dump("eleven.json"),
                          key("Esc"), kIdle}}),
              tall_window(studio));
  const Json tip = studio.state("tip.json");
  EXPECT_GT(tip["table"]["rows"].size(), 0U);
  EXPECT_LT(tip["table"]["rows"].size(), 12U);
  for (const Json& id : tip["table"]["rows"])
    EXPECT_NE(edited(tip, id)["name"].get<std::string>().find("tip"), std::string::npos);
  EXPECT_EQ(studio.state("eleven.json")["table"]["rows"], Json({11}));
}

TEST(TaxelTable, EditsCellsAndMovesToTheNextByTab) {
  const StudioProgram studio;
  studio.play(at_layout({{dump("before.json"),
                          double_click("Taxel 3 r"),
                          kIdle,
                          type("2*2 mm"),
                          kIdle,
                          key("Tab"),
                          kIdle,
                          type("1.5"),
                          kIdle,
                          key("Tab"),
                          kIdle,
                          type("-0.65 cm"),
                          kIdle,
                          key("Tab", kShift),
                          kIdle,
                          type("1.25"),
                          key("Enter"),
                          kIdle,
                          dump("after.json"),
                          R"({"do": "screenshot", "file": "table.png"})",
                          key("z", kCtrl),
                          kIdle,
                          key("z", kCtrl),
                          kIdle,
                          key("z", kCtrl),
                          kIdle,
                          key("z", kCtrl),
                          kIdle,
                          dump("undone.json")}}),
              tall_window(studio));
  const Json after = studio.state("after.json"), before = studio.state("before.json");
  EXPECT_EQ(edited(after, 3)["radius"], 4e-3);
  EXPECT_EQ(edited(after, 3)["center"][0], 1.25e-3);
  EXPECT_EQ(edited(after, 3)["center"][1], -6.5e-3);
  EXPECT_EQ(edited(after, 3)["center"][2], edited(before, 3)["center"][2]);
  EXPECT_EQ(after["history"]["depth"], 4);
  EXPECT_FALSE(after["table"]["typing"]);
  EXPECT_EQ(studio.state("undone.json")["document"], before["document"]);
}

TEST(TaxelTable, RefusesABadValueInWordsAndKeepsTheTypedText) {
  const StudioProgram studio;
  studio.play(at_layout({{dump("before.json"),
                          double_click("Taxel 3 r"),
                          kIdle,
                          type("-2"),
                          key("Enter"),
                          kIdle,
                          dump("refused.json"),
                          R"({"do": "screenshot", "file": "refused.png"})",
                          double_click("Taxel 3 r"),
                          kIdle,
                          key("End"),
                          key("Backspace"),
                          type("1"),
                          key("Enter"),
                          kIdle,
                          dump("still.json"),
                          double_click("Taxel 3 r"),
                          kIdle,
                          key("Esc"),
                          kIdle,
                          dump("given_up.json")}}),
              tall_window(studio));
  const Json refused = studio.state("refused.json");
  EXPECT_EQ(refused["document"], studio.state("before.json")["document"]);
  EXPECT_EQ(refused["refused"]["field"], "Taxel 3 r");
  EXPECT_EQ(refused["refused"]["typed"], "-2");
  EXPECT_EQ(refused["refused"]["words"], "taxel 3: radius: must be greater than 0, is -0.002");
  EXPECT_TRUE(shows(refused, "Refused"));
  EXPECT_EQ(refused["messages"], studio.state("before.json")["messages"]) << "said once";
  EXPECT_EQ(studio.state("still.json")["refused"]["typed"], "-1") << "the typed text remained for correction";
  EXPECT_TRUE(studio.state("given_up.json")["refused"].is_null());
}

TEST(TaxelTable, RenamesByEnter) {
  const StudioProgram studio;
  studio.play(at_layout({{press("Taxel 3"), kIdle, key("Enter"), kIdle, type("thumb"), key("Enter"), kIdle,
                          dump("renamed.json")}}),
              tall_window(studio));
  EXPECT_EQ(edited(studio.state("renamed.json"), 3)["name"], "thumb");
  EXPECT_EQ(studio.state("renamed.json")["history"]["undo"], "Undo Rename taxel 3");
}

TEST(TaxelTable, ReordersRowsByKeysAndByDragging) {
  const StudioProgram studio;
  studio.play(at_layout({{press("Taxel 3"),
                          kIdle,
                          key("Up", R"("alt")"),
                          kIdle,
                          key("Up", R"("alt")"),
                          kIdle,
                          dump("up.json"),
                          key("Down", R"("alt")"),
                          kIdle,
                          key("z", kCtrl),
                          kIdle,
                          key("z", kCtrl),
                          kIdle,
                          key("z", kCtrl),
                          kIdle,
                          dump("undone.json"),
                          R"({"event": "mouse_down", "at": {"widget": "Taxel 7"}})",
                          kIdle,
                          R"({"event": "mouse_move", "at": {"widget": "Taxel 5"}})",
                          kIdle,
                          R"({"event": "mouse_move", "at": {"widget": "Taxel 2"}})",
                          kIdle,
                          R"({"event": "mouse_up"})",
                          kIdle,
                          dump("dragged.json")}}),
              tall_window(studio));
  EXPECT_EQ(ids_of(studio.state("up.json")), Json({0, 3, 1, 2, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(ids_of(studio.state("undone.json")), Json({0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}));
  EXPECT_EQ(ids_of(studio.state("dragged.json")), Json({0, 1, 7, 2, 3, 4, 5, 6, 8, 9, 10, 11}));
  EXPECT_EQ(studio.state("dragged.json")["table"]["rows"], ids_of(studio.state("dragged.json")));
}

/// Writes the fingertip with a taxel that points inward, one off the skin, and one that is listed twice.
std::string broken_layout(const StudioProgram& studio) {
  Json layout = Json::parse(read_file(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  for (Json& x : layout["taxels"][3]["normal"]) x = -x.get<double>();
  Json& off = layout["taxels"][5];
  for (std::size_t i = 0; i < 3; ++i)
    off["center"][i] =
        off["center"][i].get<double>() + 0.6 * off["radius"].get<double>() * off["normal"][i].get<double>();
  Json twin = layout["taxels"][0];
  twin["id"] = 40;
  layout["taxels"].push_back(twin);
  const std::string file = (studio.folder() / "broken.taxels.json").string();
  write_text(file, layout.dump(1));
  return file;
}

std::vector<std::string> codes_of(const Json& state) {
  std::vector<std::string> codes;
  for (const Json& problem : state["problems"])
    if (problem["severity"] != "note") codes.push_back(problem["code"]);
  return codes;
}

TEST(Repairs, AreMarkedAndAppliedOneByOneOrAllAtOnce) {
  const StudioProgram studio;
  studio.play(at_layout({{dump("broken.json"), press("Taxel 3"), kIdle, dump("three.json"),
                          R"({"event": "mouse_move", "at": {"widget": "Problems of taxel 3"}})", kIdle,
                          R"({"do": "screenshot", "file": "mark.png"})",
                          press("Give taxel 3 the normal of the surface"), kIdle, dump("turned.json"), press("Fix all"),
                          kIdle, dump("fixed.json"), key("z", kCtrl), kIdle, dump("undone.json")}}),
              tall_window(studio, broken_layout(studio)));
  EXPECT_EQ(codes_of(studio.state("broken.json")),
            (std::vector<std::string>{"duplicate_place", "normal_points_inward", "field_empty", "center_off_surface"}));
  EXPECT_TRUE(shows(studio.state("broken.json"), "Problems of taxel 5"));
  EXPECT_FALSE(shows(studio.state("three.json"), "Move taxel 5 to the surface, by 2 mm"));
  const Json turned = studio.state("turned.json"), fixed = studio.state("fixed.json");
  EXPECT_EQ(codes_of(turned), (std::vector<std::string>{"duplicate_place", "center_off_surface"}));
  EXPECT_EQ(turned["history"]["depth"], 1);
  EXPECT_EQ(codes_of(fixed), std::vector<std::string>{});
  EXPECT_EQ(fixed["history"]["depth"], 2);
  EXPECT_EQ(fixed["history"]["undo"], "Undo Fix all problems");
  EXPECT_NE(fixed["messages"].dump().find("2 problems fixed"), std::string::npos);
  EXPECT_EQ(studio.state("undone.json")["document"], turned["document"]);
}

TEST(Repairs, AreFoundByTheWordsOfTheFilter) {
  const StudioProgram studio;
  studio.play(at_layout({pressed("Filter taxels"), {type("inward"), kIdle, dump("filtered.json")}}),
              tall_window(studio, broken_layout(studio)));
  EXPECT_EQ(studio.state("filtered.json")["table"]["rows"], Json({3}));
}

TEST(Subtaxels, AreAddedChangedDeletedAndListed) {
  const StudioProgram studio;
  studio.play(at_layout({{press("Taxel 3"), kIdle, dump("before.json")},
                         pressed("Add a subtaxel"),
                         pressed("Add a subtaxel"),
                         filled("Subtaxel 1 radius (mm)", "1.5"),
                         filled("Subtaxel 1 centre (mm) Y", "-6.5"),
                         {dump("two.json")},
                         pressed("Taxels of the layout"),
                         {double_click("Node of taxel 3"), kIdle, dump("tree.json"),
                          R"({"do": "screenshot", "file": "tree.png"})"},
                         pressed("Delete Subtaxel 0"),
                         {dump("one.json")},
                         filled("Subtaxel 0 radius (mm)", "-3"),
                         {dump("refused.json")},
                         {key("Esc"), kIdle, key("z", kCtrl), kIdle, key("z", kCtrl), kIdle, key("z", kCtrl), kIdle,
                          key("z", kCtrl), kIdle, key("z", kCtrl), kIdle, dump("undone.json")}}),
              tall_window(studio));
  const Json two = edited(studio.state("two.json"), 3)["subtaxels"];
  ASSERT_EQ(two.size(), 2U);
  EXPECT_EQ(two[1]["radius"], 1.5e-3);
  EXPECT_EQ(two[1]["center"][1], -6.5e-3);
  EXPECT_TRUE(shows(studio.state("tree.json"), "Subtaxel 1 of taxel 3"));
  const Json one = edited(studio.state("one.json"), 3)["subtaxels"];
  ASSERT_EQ(one.size(), 1U);
  EXPECT_EQ(one[0], two[1]);
  EXPECT_EQ(studio.state("refused.json")["document"], studio.state("one.json")["document"]);
  EXPECT_EQ(studio.state("refused.json")["refused"]["words"],
            "taxel 3: subtaxels/0/radius: must be greater than 0, is -0.003");
  EXPECT_EQ(studio.state("undone.json")["document"], studio.state("before.json")["document"]);
}

TEST(LayoutSettings, AreEditedWithUndo) {
  const StudioProgram studio;
  const std::vector<Lines> steps = {filled("Density (1/mm\\u00b2)", "2"),
                                    filled("Seed", "7"),
                                    chosen("Weights", "voronoi"),
                                    chosen("Metric", "geodesic"),
                                    filled("Largest angle (\\u00b0)", "0.5 rad"),
                                    filled("Roll-off (\\u00b0)", "7.5"),
                                    chosen("Normals", "interpolated"),
                                    chosen("Method", "exact"),
                                    chosen("Method", "samples"),
                                    chosen("Method", "exact"),
                                    chosen("Aggregate", "max"),
                                    chosen("Misses", "omit"),
                                    chosen("Ray direction", "taxel_normal"),
                                    filled("Largest depth (mm)", "3"),
                                    pressed("Shear"),
                                    filled("Modulus (kPa)", "0.06 MPa"),
                                    filled("Thickness (mm)", "2.5"),
                                    filled("Dissipation (s/m)", "1"),
                                    filled("Friction", "0.8"),
                                    filled("Tangential stiffness (kPa/mm)", "150"),
                                    filled("Bristles", "2000"),
                                    chosen("Field", "star"),
                                    filled("Layout name", "my finger"),
                                    filled("Pad X", "0.01")};
  const auto undo = [&] {
    Lines lines;
    for (std::size_t i = 0; i < steps.size(); ++i) lines.insert(lines.end(), {key("z", kCtrl), kIdle});
    return lines;
  };
  studio.play(at_layout({{dump("before.json")},
                         joined(steps),
                         {dump("after.json"), R"({"do": "screenshot", "file": "settings.png"})"},
                         undo(),
                         {dump("undone.json")}}),
              tall_window(studio));
  const Json after = studio.state("after.json"), layout = after["document"]["layout"];
  EXPECT_EQ(after["history"]["depth"], steps.size());
  EXPECT_EQ(layout["sampling"]["density"], 2e6);
  EXPECT_EQ(layout["sampling"]["seed"], 7);
  EXPECT_EQ(layout["sampling"]["weights"], "voronoi");
  EXPECT_EQ(layout["receptive_field"]["metric"], "geodesic");
  EXPECT_NEAR(layout["receptive_field"]["max_angle_deg"].get<double>(), 28.64788975654116, 1e-12);
  EXPECT_EQ(layout["receptive_field"]["angle_falloff_deg"], 7.5);
  EXPECT_EQ(layout["receptive_field"]["normals"], "interpolated");
  EXPECT_EQ(layout["readout"]["aggregate"], "max");
  EXPECT_EQ(layout["readout"].value("method", "samples"), "samples") << "max has no integral";
  EXPECT_EQ(layout["readout"]["misses"], "omit");
  EXPECT_EQ(layout["readout"]["ray"], "taxel_normal");
  EXPECT_EQ(layout["readout"]["max_depth"], 3e-3);
  EXPECT_EQ(layout["readout"]["shear"], true);
  EXPECT_EQ(layout["material"]["modulus"], 6e4);
  EXPECT_EQ(layout["material"]["thickness"], 2.5e-3);
  EXPECT_EQ(layout["material"]["dissipation"], 1);
  EXPECT_EQ(layout["material"]["friction"], 0.8);
  EXPECT_EQ(layout["material"]["tangential_stiffness"], 1.5e8);
  EXPECT_EQ(layout["material"]["bristles"], 2000);
  EXPECT_EQ(layout["material"]["field"], "star");
  EXPECT_EQ(layout["name"], "my finger");
  EXPECT_EQ(layout["frame"]["pad"][0], 0.01);
  EXPECT_EQ(studio.state("undone.json")["document"], studio.state("before.json")["document"]);
}

TEST(LayoutSettings, KeepRefusedValuesInTheField) {
  const StudioProgram studio;
  studio.play(at_layout({{dump("before.json")},
                         filled("Density (1/mm\\u00b2)", "-1"),
                         {dump("density.json"), R"({"do": "screenshot", "file": "density.png"})"},
                         filled("Largest angle (\\u00b0)", "181"),
                         {dump("angle.json")},
                         filled("Seed", "1.5"),
                         {dump("seed.json")},
                         chosen("Field", "medial_axis"),
                         {dump("field.json")},
                         filled("Modulus (kPa)", "3 mm"),
                         {dump("unit.json")}}),
              tall_window(studio));
  const auto words = [&](const char* file) { return studio.state(file)["refused"]["words"].get<std::string>(); };
  EXPECT_EQ(words("density.json"), "/sampling/density: must be greater than 0, is -1000000");
  EXPECT_EQ(words("angle.json"),
            "/receptive_field/max_angle_deg: must be greater than 0 and at most 180 degrees, is 181");
  EXPECT_TRUE(words("seed.json").starts_with("Seed: must be a whole number")) << words("seed.json");
  EXPECT_TRUE(words("field.json").starts_with("/material/field: \"medial_axis\" is not available"));
  EXPECT_TRUE(words("unit.json").starts_with("Modulus (kPa): ")) << words("unit.json");
  for (const char* file : {"density.json", "angle.json", "seed.json", "field.json", "unit.json"}) {
    EXPECT_EQ(studio.state(file)["document"], studio.state("before.json")["document"]) << file;
    EXPECT_TRUE(shows(studio.state(file), "Refused")) << file;
  }
}

TEST(LayoutSettings, AddEditAndRemoveACalibration) {
  const StudioProgram studio;
  studio.play(at_layout({{dump("before.json")},
                         pressed("Calibrated"),
                         filled("Gain", "0.002"),
                         pressed("Relaxation"),
                         filled("Arm 2 time (s)", "6"),
                         pressed("Low pass"),
                         filled("Time constant (s)", "0.02"),
                         filled("Latency (s)", "0.004"),
                         filled("Noise", "0.1"),
                         pressed("Range"),
                         filled("Range high", "255"),
                         filled("Bits", "8"),
                         {dump("made.json")},
                         pressed("Range"),
                         {dump("refused.json")},
                         pressed("Calibrated"),
                         {dump("removed.json")}}),
              tall_window(studio));
  const Json made = studio.state("made.json")["document"]["layout"]["calibration"];
  EXPECT_EQ(made["gain"], 0.002);
  EXPECT_EQ(made["relaxation"], Json::parse(R"([{"amplitude": 0.1, "time": 1}, {"amplitude": 0.1, "time": 6}])"));
  EXPECT_EQ(made["low_pass"], Json({{"time", 0.02}}));
  EXPECT_EQ(made["latency"], 0.004);
  EXPECT_EQ(made["noise"], 0.1);
  EXPECT_EQ(made["range"], Json({0, 255}));
  EXPECT_EQ(made["quantisation"]["bits"], 8);
  EXPECT_EQ(studio.state("refused.json")["refused"]["words"], "/calibration/quantisation/bits: needs a range");
  EXPECT_EQ(studio.state("removed.json")["document"], studio.state("before.json")["document"]);
}

}  // namespace
}  // namespace taxel::test
