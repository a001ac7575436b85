// The curves that the plot chooses, curves that lie on each other, isolated curves, and the values at the pointer.
#include "app/studio/nouns/plot/plot_state.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "app/studio/nouns/real/real_state.h"
#include "core/base/text/rounded.h"
#include "ui/tools/hand_frame.h"
#include "ui/widgets/plot_curves.h"

namespace taxel::ui {
namespace {

using test::run_of;
using Labels = std::vector<std::string>;

/// Curves with one peak per taxel, at the third of three rows 0.1 s apart.
PlotCurves curves_with_peaks(const std::vector<double>& peaks) {
  Trace trace;
  for (int r = 0; r < 3; ++r) {
    TraceRow row;
    row.time = 0.1 * r;
    for (const double peak : peaks) row.readings.push_back(0.5 * r * peak);
    trace.rows.push_back(row);
  }
  PlotCurves curves;
  update_curves(curves, trace, false);
  return curves;
}

Labels labels_of(const PlotChoice& choice) {
  Labels labels;
  for (const ChosenCurve& curve : choice.curves) labels.push_back(curve.label);
  return labels;
}

TEST(ChooseCurves, NamesTaxelsAfterTheirSensorsIfThereAreSeveral) {
  PlotCurves curves = curves_with_peaks({100, 1, 90, 80});
  const RunView two = run_of({{"index", {0, 0}}, {"thumb", {0, 0}}}), one = run_of({{"index", {0, 0, 0, 0}}});
  EXPECT_EQ(labels_of(choose_curves(curves, sensors_shown(two), {}, {}, {})),
            (Labels{"index 1", "thumb 1", "thumb 2"}));
  EXPECT_EQ(labels_of(choose_curves(curves, sensors_shown(one), {}, {}, {})), (Labels{"1", "3", "4"}));
}

TEST(ChooseCurves, KeepsSelectedAndStoppedTaxelsThatDoNotRespond) {
  PlotCurves curves = curves_with_peaks({100, 1, 2, 3});
  const RunView run = run_of({{"index", {0, 0}}, {"thumb", {0, 0}}});
  Selection selection;
  selection.set(2);
  const PlotChoice choice = choose_curves(curves, sensors_shown(run), selection, {}, TaxelKey{1, 1});
  EXPECT_EQ(labels_of(choice), (Labels{"index 1", "index 2", "thumb 1"}));
  EXPECT_TRUE(choice.curves[1].selected);
  EXPECT_FALSE(choice.curves[1].jumped);
  EXPECT_TRUE(choice.curves[2].jumped);
}

TEST(ChooseCurves, CanLeaveOutOtherSensors) {
  PlotCurves curves = curves_with_peaks({100, 90, 80, 70});
  const RunView run = run_of({{"index", {0, 0}}, {"thumb", {0, 0}}});
  Selection selection;
  selection.sensor = 1;
  PlotOptions options;
  options.all_sensors = false;
  EXPECT_EQ(labels_of(choose_curves(curves, sensors_shown(run), selection, options, {})),
            (Labels{"thumb 1", "thumb 2"}));
}

TEST(ChooseCurves, LeavesOutSensorsWithAnotherUnit) {
  PlotCurves curves = curves_with_peaks({100, 90, 5000, 1});
  const RunView run = run_of({{"index", {0, 0}}, {"thumb", {0, 0}, Aggregate::force}});
  const PlotChoice pressures = choose_curves(curves, sensors_shown(run), {}, {}, {});
  EXPECT_EQ(labels_of(pressures), (Labels{"index 1", "index 2"}));
  EXPECT_EQ(pressures.largest, 100) << "not 5000 N";
  EXPECT_EQ(pressures.other_units, 1);
}

TEST(StoppedTaxel, IsTheOneOfTheBreakpoint) {
  RunView run = run_of({{"index", {0, 0}}, {"thumb", {0, 0}}});
  EXPECT_FALSE(stopped_taxel(run, sensors_shown(run)));
  auto frame = std::make_shared<SimFrame>(*run.frame);
  Jump jump;
  jump.sensor = 1, jump.taxel = 1;
  frame->stop = jump;
  run.frame = frame;
  EXPECT_EQ(stopped_taxel(run, sensors_shown(run)), (TaxelKey{1, 2})) << "its id, not its index";
}

TEST(ChooseCurves, PutsCurvesOfMirrorTwinsThatLieOnEachOtherIntoOneGroup) {
  PlotCurves curves = curves_with_peaks({100, 50, 100, 100});
  const RunView run = run_of({{"index", {0, 0, 0, 0}}});
  std::vector<SensorShown> sensors = sensors_shown(run);
  const auto groups = [&] {
    std::vector<std::pair<int, int>> found;  // place in the group, curves of the group
    for (const ChosenCurve& curve : choose_curves(curves, sensors, {}, {}, {}).curves)
      found.emplace_back(curve.place, curve.of);
    return found;
  };
  using Groups = std::vector<std::pair<int, int>>;
  EXPECT_EQ(groups(), (Groups{{0, 1}, {0, 1}, {0, 1}, {0, 1}})) << "all taxels are in one place";

  const auto model = std::make_shared<SensorModel>(*sensors[0].model);
  Layout& layout = model->layout;
  const dvec3 across = glm::cross(layout.frame.distal, layout.frame.pad);
  const std::array<double, 4> places{2, 1, -2, -1};
  for (std::size_t k = 0; k < places.size(); ++k) {
    layout.taxels[k].center = 0.01 * places[k] * across;
    layout.taxels[k].radius = 0.002;
  }
  sensors[0].model = model;
  curves.paired.clear();
  EXPECT_EQ(groups(), (Groups{{0, 2}, {0, 1}, {1, 2}, {0, 1}})) << "the fourth has no equal twin";
}

TEST(LegendEntries, JoinTaxelsWithEqualCurvesOnly) {
  PlotCurves curves = curves_with_peaks({100, 50, 100.1, 50.5});
  std::vector<ChosenCurve> chosen(4);
  for (std::size_t i = 0; i < chosen.size(); ++i)
    chosen[i].reading = i, chosen[i].key = {0, static_cast<int>(i)}, chosen[i].label = std::to_string(i);
  find_twins(curves, chosen);
  Labels labels;
  for (const LegendEntry& entry : legend_entries(chosen)) labels.push_back(entry.label);
  EXPECT_EQ(labels, (Labels{"0 = 2", "1", "3"})) << "50.5 is not within 0.2 % of 50";
  EXPECT_EQ(focus_of(chosen, TaxelKey{0, 0}, {}), (std::vector<TaxelKey>{{0, 0}, {0, 2}}));
  EXPECT_EQ(focus_of(chosen, std::nullopt, {{0, 2}}), (std::vector<TaxelKey>{{0, 0}, {0, 2}}));
  PlotChoice choice;
  choice.curves = chosen;
  const std::optional<PlotReadout> readout = read_curves(curves, choice, {}, 0.2, 1);
  ASSERT_TRUE(readout);
  EXPECT_EQ(readout->lines[0].label, "0 = 2");
  EXPECT_EQ(readout->omitted, 2U);
}

TEST(PartTwins, GivesTaxelsThatDifferInTheRecordingTheirOwnEntries) {
  std::vector<ChosenCurve> equal(2);
  equal[0].key = {0, 4}, equal[1].key = {0, 10};
  equal[1].twin = 0;
  const auto twin_with = [&](std::vector<double> second, int sensor) {
    auto shown = std::make_shared<RealShown>();
    shown->sensor = sensor;
    shown->recording.series.taxel_ids = {4, 10};
    shown->recording.series.values = {{0, 10}, std::move(second)};
    RealState real;
    real.shown = shown;
    std::vector<ChosenCurve> curves = equal;
    part_twins(curves, real);
    return curves[1].twin;
  };
  EXPECT_EQ(twin_with({0, 10.01}, 0), 0);
  EXPECT_EQ(twin_with({0, 10.5}, 0), -1);
  EXPECT_EQ(twin_with({std::nan(""), 10}, 0), -1) << "a value is missing";
  EXPECT_EQ(twin_with({0, 10.5}, 1), 0) << "a recording of another sensor";
}

/// At each length along the curve, the topmost drawn member of a group of `of` curves must change from dash to dash.
TEST(StyleOf, LetsEachCurveOfAGroupShowInTheGapsOfTheOthers) {
  constexpr int kOf = 4;
  std::vector<ChosenCurve> curves(kOf);
  for (int i = 0; i < kOf; ++i)
    curves[static_cast<std::size_t>(i)].place = i, curves[static_cast<std::size_t>(i)].of = kOf;
  EXPECT_FALSE(style_of(curves[0], {}).dashes) << "the first is a line below the others";
  EXPECT_GT(style_of(curves[0], {}).width, style_of(curves[1], {}).width);
  std::vector<int> visible(kOf, 0);
  for (double at = 0.5; at < 200; at += 1) {
    int top = 0;
    for (int i = 1; i < kOf; ++i) {
      const DashLengths dashes = *style_of(curves[static_cast<std::size_t>(i)], {}).dashes;
      if (std::fmod(dashes.start + at, dashes.dash + dashes.gap) < dashes.dash) {
        EXPECT_EQ(top, 0) << "two dashes at " << at;
        top = i;
      }
    }
    ++visible[static_cast<std::size_t>(top)];
  }
  for (const int pixels : visible) EXPECT_EQ(pixels, 50);
}

TEST(FocusOf, PrefersTheHoveredCurveAndIgnoresCurvesThatAreNotDrawn) {
  std::vector<ChosenCurve> curves(3);
  curves[0].key = {0, 1}, curves[1].key = {0, 2}, curves[2].key = {1, 1};
  using Keys = std::vector<TaxelKey>;
  EXPECT_EQ(focus_of(curves, {}, {}), Keys{});
  EXPECT_EQ(focus_of(curves, {}, {{1, 1}, {7, 7}}), (Keys{{1, 1}}));
  EXPECT_EQ(focus_of(curves, TaxelKey{0, 2}, {{1, 1}}), (Keys{{0, 2}}));
  EXPECT_EQ(focus_of(curves, {}, {{7, 7}}), Keys{}) << "nothing would stand out";
  EXPECT_TRUE(style_of(curves[0], {{1, 1}}).dimmed);
  EXPECT_FALSE(style_of(curves[2], {{1, 1}}).dimmed);
}

TEST(ClickIsolated, KeepsACurveUntilItIsClickedAgain) {
  std::vector<TaxelKey> isolated;
  using Keys = std::vector<TaxelKey>;
  click_isolated(isolated, {0, 1}, false);
  EXPECT_EQ(isolated, (Keys{{0, 1}}));
  click_isolated(isolated, {1, 1}, false);
  EXPECT_EQ(isolated, (Keys{{1, 1}}));
  click_isolated(isolated, {0, 1}, true);
  EXPECT_EQ(isolated, (Keys{{1, 1}, {0, 1}}));
  click_isolated(isolated, {0, 1}, true);
  EXPECT_EQ(isolated, (Keys{{1, 1}}));
  click_isolated(isolated, {1, 1}, false);
  EXPECT_EQ(isolated, Keys{});
}

TEST(ReadCurves, GivesTheValuesOfTheNearestRow) {
  PlotCurves curves = curves_with_peaks({100, 80, 60});
  const RunView run = run_of({{"index", {0, 0, 0}}});
  const PlotChoice choice = choose_curves(curves, sensors_shown(run), {}, {}, {});
  const std::optional<PlotReadout> readout = read_curves(curves, choice, {}, 0.14, 2);
  ASSERT_TRUE(readout);
  EXPECT_DOUBLE_EQ(readout->x, 0.1);
  ASSERT_EQ(readout->lines.size(), 2U);
  EXPECT_EQ(readout->lines[0].value, 50);
  EXPECT_EQ(readout->lines[1].label, "2");
  EXPECT_EQ(readout->omitted, 1U);
  EXPECT_DOUBLE_EQ(read_curves(curves, choice, {}, 9, 2)->x, 0.2);
  EXPECT_EQ(read_curves(curves, choice, {{0, 3}}, 0.2, 2)->lines[0].label, "3") << "the isolated curve is first";
  EXPECT_FALSE(read_curves({}, choice, {}, 0, 2));
}

TEST(CurveColors, HaveAContrastOfThreeOnEveryBackground) {
  for (int number = 0; number < 24; ++number)
    for (const float grey : {0.0f, 0.08f, 0.9f, 1.0f})
      EXPECT_GE(curve_contrast(curve_color_on(number, glm::vec3(grey)), glm::vec3(grey)), 3) << number;
  EXPECT_NEAR(curve_contrast(glm::vec3(0), glm::vec3(1)), 21, 1e-9);
}

TEST(PlotPage, HasACurveAndANameForEachChosenTaxel) {
  PlotCurves curves = curves_with_peaks({100, 80});
  const RunView run = run_of({{"index", {0}}, {"thumb", {0}}});
  const PlotChoice choice = choose_curves(curves, sensors_shown(run), {}, {}, {});
  const Page page = plot_page(curves, choice, {}, {"time (s)", "reading (kPa)", 0.2, 0.1}, false, "hand");
  const std::string svg = page_to_svg(page);
  for (const char* text : {">index 1<", ">thumb 1<", ">time (s)<", ">reading (kPa)<", "<title>hand<"})
    EXPECT_NE(svg.find(text), std::string::npos) << text;
  // The curve of 100 Pa ends at the upper right corner: 0.1 kPa at 0.2 s.
  const auto ends_at_corner = [&](const PageItem& item) {
    const auto* line = std::get_if<PageLine>(&item);
    return line != nullptr && line->points.size() == 2 && line->points.back().x == 366 && line->points.back().y == 12;
  };
  EXPECT_TRUE(std::any_of(page.items.begin(), page.items.end(), ends_at_corner));
}

TEST(PlotPage, HasTheColoursOfTheWindowsLightTheme) {
  PlotCurves curves = curves_with_peaks({100, 80, 60});
  const RunView run = run_of({{"index", {0, 0, 0}}});
  const PlotChoice choice = choose_curves(curves, sensors_shown(run), {}, {}, {});
  const Page page = plot_page(curves, choice, {}, {"time (s)", "reading (kPa)", 0.2, 0.1}, false, "hand");
  const std::string svg = page_to_svg(page), pdf = page_to_pdf(page);
  ASSERT_EQ(choice.curves.size(), 3U);
  for (const ChosenCurve& curve : choice.curves) {
    const ImVec4 shown = curve_color(curve.color, false);
    const ImU32 bytes = ImGui::ColorConvertFloat4ToU32(shown);
    const std::string hex =
        fmt::format("stroke=\"#{:02x}{:02x}{:02x}\"", bytes & 255U, (bytes >> 8U) & 255U, (bytes >> 16U) & 255U);
    EXPECT_NE(svg.find(hex), std::string::npos) << hex;
    const auto part = [](float of_one) { return rounded(static_cast<double>(of_one), 4, 3); };
    const std::string rgb = fmt::format("{} {} {} RG", part(shown.x), part(shown.y), part(shown.z));
    EXPECT_NE(pdf.find(rgb), std::string::npos) << rgb;
    const auto has_color = [&](const PageItem& item) {
      const auto* line = std::get_if<PageLine>(&item);
      return line != nullptr && std::abs(line->color[0] - static_cast<double>(shown.x)) < 1e-6;
    };
    EXPECT_TRUE(std::any_of(page.items.begin(), page.items.end(), has_color));
  }
}

TEST(PlotPage, HasTheRingsOfARecordingWithinTheAxes) {
  PlotCurves curves = curves_with_peaks({100});
  const RunView run = run_of({{"index", {0}}});
  const PlotChoice choice = choose_curves(curves, sensors_shown(run), {}, {}, {});
  const PlotAxes axes{"time (s)", "reading (kPa)", 0.2, 0.1};
  const ChartRings rings{{{0.05, 0.1, 0.1, 0.15, 0.3}, {0.02, 0.04, 0.04, 0.2, 0.05}}, {1, 0, 0}};
  const auto rings_on = [&](const Page& page) {
    return std::ranges::count_if(page.items, [](const PageItem& item) {
      const auto* line = std::get_if<PageLine>(&item);
      return line != nullptr && line->points.size() == 13;
    });
  };
  EXPECT_EQ(rings_on(plot_page(curves, choice, {}, axes, false, "hand")), 0);
  const Page page = plot_page(curves, choice, {}, axes, false, "hand", {rings});
  EXPECT_EQ(rings_on(page), 3) << "two within the axes at different places, and that of the legend";
  EXPECT_NE(page_to_svg(page).find(">real recording<"), std::string::npos);
}

TEST(PlotPage, GrowsByColumnsForALongLegend) {
  const std::vector<double> peaks(60, 100);
  PlotCurves curves = curves_with_peaks(peaks);
  const RunView run = run_of({{"index", peaks}});
  const PlotChoice choice = choose_curves(curves, sensors_shown(run), {}, {}, {});
  const Page page = plot_page(curves, choice, {}, {"time (s)", "reading (kPa)", 0.2, 0.1}, false, "hand");
  EXPECT_GT(page.width, 440);
  for (const PageItem& item : page.items)
    if (const auto* text = std::get_if<PageText>(&item)) {
      EXPECT_LT(text->at.x + text->size * helvetica_width(text->text), page.width + 30) << text->text;
      EXPECT_LT(text->at.y, page.height) << text->text;
    }
}

}  // namespace
}  // namespace taxel::ui
