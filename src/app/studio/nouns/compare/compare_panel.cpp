// The panel that compares a run with a second layout: numbers, bars and curves of both, on one contact and one
// timeline.
#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <array>
#include <iterator>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/bars/pressure_bars.h"
#include "app/studio/nouns/compare/compare_state.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/plot/plot_drawing.h"
#include "core/base/text/rounded.h"
#include "core/sensor/readout/reading.h"
#include "ui/scene/scene_input.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {

namespace {

constexpr float kMaxCompareLegend = 0.3f;  // largest part of the width that the legend takes
constexpr double kCurveReach = 12;         // distance at which the pointer is at a curve, at scale 1 [pixels]

/// Returns the curves that are drawn in full: the hovered one, otherwise the isolated ones. If both layouts have the
/// same taxels, each of them comes with the curve of the same taxel in the other layout. Empty if all curves are equal.
std::vector<TaxelKey> compared_focus(const ComparedLayouts& compared, const std::vector<ChosenCurve>& curves,
                                     const std::optional<TaxelKey>& hovered, const std::vector<TaxelKey>& isolated) {
  std::vector<TaxelKey> wanted = hovered ? std::vector{*hovered} : isolated;
  if (!compared.taxels_of_b)
    for (std::size_t i = 0, count = wanted.size(); i < count; ++i)
      wanted.push_back({1 - wanted[i].sensor, wanted[i].id});
  return focus_of(curves, std::nullopt, wanted);
}

PlotAxes compared_axes(const RunView& run, const ComparedLayouts& compared, const CompareState& compare,
                       bool relative) {
  PlotChoice both;
  both.unit = shown_unit(compared.model->layout.readout.aggregate);
  for (std::size_t s = 0; s < compare.sides.size(); ++s)
    if (compare.drawn[s]) both.largest = std::max(both.largest, compare.sides[s].summary.peak.value);
  PlotAxes axes = plot_axes(run, both, relative);
  if (relative) axes.y_name = "reading / largest of its layout";
  return axes;
}

/// Names the curve under the pointer with its value, and with the value of the same taxel in the other layout.
void draw_compared_tip(const RunView& run, const ComparedLayouts& compared, const CompareState& compare,
                       const TaxelKey& key, double x) {
  const PlotCurves& curves = compare.sides[0].curves;
  auto row = std::lower_bound(curves.x.begin(), curves.x.end(), x);
  if (row == curves.x.end() || (row != curves.x.begin() && x - *(row - 1) < *row - x)) --row;
  const std::string place = run.by_travel() ? rounded(*row, 4, 4) + " mm" : rounded(*row, 4, 6) + " s";
  std::string text = side_taxel(compared, key) + "\nat " + place + ": ";
  const auto value = [&](std::size_t side, std::size_t reading) {
    const SensorModelPtr& model = compared.of(side);
    return in_unit(compare.sides[side].curves.readings[reading][static_cast<std::size_t>(row - curves.x.begin())],
                   shown_unit(model->layout.readout.aggregate));
  };
  const auto side = static_cast<std::size_t>(key.sensor);
  const int taxel = index_of(compared.of(side)->layout, key.id);
  if (taxel < 0) return;
  text += value(side, static_cast<std::size_t>(taxel));
  if (!compared.taxels_of_b)
    text += fmt::format("\n{}: {}", side_taxel(compared, {1 - key.sensor, key.id}),
                        value(1 - side, static_cast<std::size_t>(taxel)));
  ImGui::SetTooltip("%s", text.c_str());
}

void draw_sides(WindowUi& ui, const ComparedLayouts& compared, CompareState& compare, bool relative) {
  for (std::size_t s = 0; s < compare.sides.size(); ++s) {
    CompareSide& side = compare.sides[s];
    const double scale = side_scale(compared, s, side.summary, relative);
    for (const std::size_t i : drawing_order(compare.shown.curves[s], compare.shown.focus)) {
      const ChosenCurve& curve = compare.shown.curves[s][i];
      draw_plot_curve(ui, side.curves, curve, style_of(curve, compare.shown.focus), scale);
    }
  }
}

std::vector<ChosenCurve> fill_curves(const ComparedLayouts& compared, const Selection& selection,
                                     CompareState& compare) {
  std::vector<ChosenCurve> all;
  for (std::size_t s = 0; s < compare.sides.size(); ++s) {
    std::vector<ChosenCurve>& curves = compare.shown.curves[s];
    if (compare.drawn[s])
      curves = choose_side(compared, s, compare.sides[s].summary, selection, compare.responding_only);
    if (compare.drawn[s] && !compare.sides[s].curves.readings.empty()) find_twins(compare.sides[s].curves, curves);
    const auto before = static_cast<int>(all.size());
    std::copy(curves.begin(), curves.end(), std::back_inserter(all));
    for (std::size_t i = static_cast<std::size_t>(before); i < all.size(); ++i)
      if (all[i].twin >= 0) all[i].twin += before;
  }
  return all;
}

/// Draws plot and legend into an area of `size` at the cursor. A click into the plot displays that step; a click on an
/// entry of A selects its taxel. Fills the curves of `compare.shown`.
void draw_compare_plot(WindowUi& ui, Viewer& viewer, const RunView& run, const ComparedLayouts& compared,
                       CompareState& compare, ImVec2 size, bool fits) {
  constexpr auto kFlags = ImPlotFlags_NoTitle | ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect |
                          ImPlotFlags_NoMouseText | ImPlotFlags_NoLegend;
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const std::vector<ChosenCurve> all = fill_curves(compared, viewer.selection, compare);
  const ImVec2 at = ImGui::GetCursorPos();
  const float legend = std::min(plot_legend_width(all), kMaxCompareLegend * size.x);
  ImGui::SetCursorPos({at.x + size.x - legend, at.y});
  const LegendPointer pointer =
      draw_plot_legend(ui, all, compare.isolated, {legend, size.y}, [&](const ChosenCurve& curve) {
        return side_taxel(compared, curve.key) + "\nClick: keep the other curves dim. Shift adds.";
      });
  if (pointer.clicked && pointer.clicked->sensor == 0)
    click_taxel(viewer.selection, pointer.clicked->id, ImGui::GetIO().KeyShift);
  const std::optional<TaxelKey> hovered = pointer.hovered ? pointer.hovered : compare.hovered;
  compare.shown.focus = compared_focus(compared, all, hovered, compare.isolated);
  compare.hovered.reset();
  ImGui::SetCursorPos(at);
  if (ImPlot::BeginPlot("##compared", {size.x - legend, size.y}, kFlags)) {
    const bool relative = is_relative(compared, compare);
    PlotAxes axes = compared_axes(run, compared, compare, relative);
    if (fits) fit_to_contact(axes, run);
    setup_plot_axes(axes, size.y);
    draw_sides(ui, compared, compare, relative);
    draw_plot_cursor(ui, run);
    if (ImPlot::IsPlotHovered()) {
      const ImPlotPoint mouse = ImPlot::GetPlotMousePos();
      const double reach = kCurveReach * ui.pixel_scale * ImPlot::GetPlotLimits().Y.Size() /
                           std::max(1.0, static_cast<double>(ImPlot::GetPlotSize().y));
      compare.hovered = nearest_curve(compare, compared, {mouse.x, mouse.y, reach});
      if (compare.hovered) draw_compared_tip(run, compared, compare, *compare.hovered, mouse.x);
    }
    if (const auto& named = pointer.hovered ? pointer.hovered : compare.hovered)
      compare.shown.hovered = side_taxel(compared, *named);
    scrub_in_plot(ui, run);
    ImPlot::EndPlot();
    ui.widgets.note_item("Compared curves");
  }
  ImGui::PopFont();
}

constexpr float kLeastWidthOfTwo = 50;  // smallest width for bars and plot next to each other, in heights of text
constexpr float kLeastBars = 6, kLeastPlot = 5, kLeastLeft = 16;  // smallest heights, in heights of text
constexpr float kPartOfBars = 0.44f;                              // of the width
constexpr int kBarsOfB = -2;                                      // BarGroup::sensor of the second layout

/// Continues the row if an item with this text fits into it.
void continue_row(const char* text, float extra = 1.5f) {
  const float width = ImGui::CalcTextSize(text).x + extra * ImGui::GetFontSize();
  ImGui::SameLine(0, 0.6f * ImGui::GetFontSize());
  if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

void wrapped_text(const std::string& text, const ImVec4& color) {
  ImGui::PushTextWrapPos();
  ImGui::TextColored(color, "%s", text.c_str());
  ImGui::PopTextWrapPos();
}

void draw_compare_buttons(WindowUi& ui, CompareState& compare) {
  if (button(ui, "Open a second layout...")) ui.post(CompareLayout{});
  tooltip("A layout or project file for the same mesh. It reads the contact of this run.");
  continue_row("The paper's released model");
  if (button(ui, "The paper's released model")) ui.post(CompareLayout{"", true});
  tooltip("The same taxels with the samples, the star field and the formula of the paper's released demo");
  if (!compare.request) return;
  continue_row("Close comparison");
  if (button(ui, "Close comparison")) end_comparison(compare);
}

void draw_contact_choice(WindowUi& ui, CompareState& compare, const ComparedLayouts& compared) {
  if (compared.equal_contact || !compare.request) return;
  SecondContact& contact = compare.request->contact;
  continue_row("A's contact");
  if (small_choice(ui, "A's contact", contact == SecondContact::recorded)) contact = SecondContact::recorded;
  tooltip("B reads the contact surfaces of A, as they were recorded");
  continue_row("B's own field");
  if (small_choice(ui, "B's own field", contact == SecondContact::own)) contact = SecondContact::own;
  tooltip("The contact is computed again with the pressure field of B, in the recorded poses");
}

void draw_compare_options(WindowUi& ui, CompareState& compare, const ComparedLayouts& compared) {
  draw_contact_choice(ui, compare, compared);
  const ReadingUnit a = shown_unit(compared.model->layout.readout.aggregate),
                    b = shown_unit(compared.b->layout.readout.aggregate);
  const bool one_unit = std::string_view(a.text) == b.text;
  continue_row("Relative kPa", 3);
  if (small_choice(ui, "Relative", is_relative(compared, compare))) compare.relative = true;
  tooltip("Each layout divided by its own largest reading of the run");
  ImGui::SameLine(0, 2);
  ImGui::BeginDisabled(!one_unit);
  if (small_choice(ui, a.text, !is_relative(compared, compare))) compare.relative = false;
  ImGui::EndDisabled();
  tooltip(one_unit ? std::string("Readings in ") + a.text
                   : fmt::format("A reads in {} and B in {}: they have no common axis", a.text, b.text));
  for (std::size_t s = 0; s < compare.drawn.size(); ++s) {
    continue_row("A", 2.5f);
    checkbox(ui, s == 0 ? "A" : "B", &compare.drawn[s]);
    tooltip(fmt::format("Draw the curves of {}, {}", side_name(compared, s), s == 0 ? "as lines" : "as dashes"));
  }
  continue_row("Responding only", 2.5f);
  checkbox(ui, "Responding only", &compare.responding_only);
  tooltip(fmt::format("Only taxels whose peak is above {:g} % of the largest of their layout, and selected ones",
                      100 * kTaxelResponds));
  continue_row("Fields of B in the view", 2.5f);
  ImGui::BeginDisabled(!compared.taxels_of_b);
  checkbox(ui, "Fields of B in the view", &compare.rings);
  ImGui::EndDisabled();
  tooltip(compared.taxels_of_b ? "Draw the receptive fields of B as yellow rings on the sensor: of the responding "
                                 "taxels if B has more than 60"
                               : "B has the taxels of A: their receptive fields are those of A");
  continue_row("Export...");
  if (button(ui, "Export...")) ui.post(ExportFile{FileTask::export_comparison});
  tooltip("Write the readings of both layouts, row by row, as CSV");
}

/// Draws how far the run was read, with a button that stops or continues.
void draw_read_rows(WindowUi& ui, CompareState& compare) {
  const CompareProgress& progress = compare.progress;
  if (progress.read >= progress.due) return;
  continue_row("0000 of 0000 rows");
  ImGui::TextDisabled("%zu of %zu rows", progress.read, progress.due);
  continue_row("Continue");
  if (button(ui, compare.stopped ? "Continue" : "Stop")) compare.stopped = !compare.stopped;
  tooltip(compare.stopped ? "Read the remaining rows of the run" : "Read no further rows of the run");
}

void draw_building(WindowUi& ui, CompareState& compare) {
  const std::string text = compare.request->is_paper() ? "Building the paper's released model ..."
                                                       : "Building " + compare.request->file + " ...";
  ImGui::TextDisabled("%s", text.c_str());
  progress_bar(ui, static_cast<float>(compare.progress.building), 16 * ImGui::GetFontSize());
  ImGui::SameLine();
  if (button(ui, "Cancel comparison")) end_comparison(compare);
}

void compare_cell(const std::string& text, const std::string& tip = "") {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
  if (!tip.empty()) tooltip(tip);
}

/// Draws the numbers of both layouts over the rows that were read.
void draw_numbers(const RunView& run, const ComparedLayouts& compared, const CompareState& compare, float width) {
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable("##numbers", 4, kFlags, ImVec2(width, 0))) return;
  const bool by_travel = run.by_travel();
  const double distance = row_distance(compared.steps, by_travel);
  const std::string per = by_travel ? rounded(1e3 * distance, 2, 4) + " mm" : rounded(1e3 * distance, 2, 4) + " ms";
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  for (const std::string& head :
       {std::string("Layout"), std::string("Peak"), std::string("Respond"), "Jump per " + per}) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", head.c_str());
  }
  for (std::size_t s = 0; s < compare.sides.size(); ++s) {
    const SideSummary& summary = compare.sides[s].summary;
    const Layout& layout = compared.of(s)->layout;
    const ReadingUnit unit = shown_unit(layout.readout.aggregate);
    const auto where = [&](const RowReading& reading) {
      if (reading.taxel < 0) return std::string("No reading yet");
      const std::string place = by_travel ? in_mm(reading.x) : fmt::format("{:.4g} s", reading.x);
      return fmt::format("Taxel {} at {}", layout.taxels[static_cast<std::size_t>(reading.taxel)].id, place);
    };
    ImGui::TableNextRow();
    compare_cell(fmt::format("{} {}", side_letter(s), side_name(compared, s)), s == 0 ? "The layout of the run"
                                                                               : compared.request.is_paper()
                                                                                   ? ""
                                                                                   : compared.request.file);
    compare_cell(in_unit(summary.peak.value, unit), where(summary.peak));
    compare_cell(fmt::format("{} of {}", summary.responding, layout.taxels.size()),
                 fmt::format("Taxels whose peak is above {:g} % of the largest reading", 100 * kTaxelResponds));
    const double part = summary.peak.value > 0 ? 100 * summary.jump.value / summary.peak.value : 0.0;
    compare_cell(fmt::format("{} ({:.1f} %)", in_unit(summary.jump.value, unit), part), where(summary.jump));
  }
  ImGui::EndTable();
}

/// Draws the same numbers with a column for each layout: for a narrow panel.
void draw_numbers_below_each_other(const RunView& run, const ComparedLayouts& compared, const CompareState& compare) {
  constexpr float kHead = 5;  // width of the first column, in heights of text
  if (!ImGui::BeginTable("##narrow numbers", 3, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchSame)) return;
  ImGui::TableSetupColumn("", ImGuiTableColumnFlags_WidthFixed, kHead * ImGui::GetFontSize());
  const bool by_travel = run.by_travel();
  const double distance = row_distance(compared.steps, by_travel);
  ImGui::TableSetupColumn("A");
  ImGui::TableSetupColumn("B");
  ImGui::TableNextRow();
  ImGui::TableSetColumnIndex(1);
  const float room = ImGui::GetContentRegionAvail().x;
  std::array<std::array<std::string, 4>, 2> cells;
  for (std::size_t s = 0; s < cells.size(); ++s) {
    const SideSummary& summary = compare.sides[s].summary;
    const Layout& layout = compared.of(s)->layout;
    const ReadingUnit unit = shown_unit(layout.readout.aggregate);
    const double part = summary.peak.value > 0 ? 100 * summary.jump.value / summary.peak.value : 0.0;
    cells[s] = {shortened(fmt::format("{} {}", side_letter(s), side_name(compared, s)), room, 1),
                in_unit(summary.peak.value, unit), fmt::format("{} of {}", summary.responding, layout.taxels.size()),
                fmt::format("{} ({:.1f} %)", in_unit(summary.jump.value, unit), part)};
  }
  const std::string per = "Largest change per " + rounded(1e3 * distance, 2, 4) + (by_travel ? " mm" : " ms");
  constexpr std::array kHeads{"", "Peak", "Respond", "Jump"};
  for (std::size_t row = 0; row < kHeads.size(); ++row) {
    if (row > 0) ImGui::TableNextRow();
    ImGui::TableSetColumnIndex(0);
    ImGui::TextDisabled("%s", kHeads[row]);
    if (row + 1 == kHeads.size()) tooltip(per);
    for (std::size_t s = 0; s < cells.size(); ++s)
      compare_cell(cells[s][row], row == 0 ? side_name(compared, s) : std::string());
  }
  ImGui::EndTable();
}

/// Draws the readings of both layouts in the displayed step, A | B, on one axis if they have one unit.
void draw_compared_bars(WindowUi& ui, Viewer& viewer, const ComparedLayouts& compared, CompareState& compare,
                        ImVec2 size) {
  const ComparedStepPtr& step = compare.shown.step = compared.displayed;
  if (!step) return;
  std::vector<BarGroup> groups;
  const bool relative = is_relative(compared, compare);
  std::array<double, 2> tops{};  // the displayed step may be beyond the rows that the peaks are of
  for (std::size_t s = 0; s < tops.size(); ++s) {
    tops[s] = compare.sides[s].summary.peak.value;
    for (const double reading : side_readings(*step, s)) tops[s] = std::max(tops[s], reading);
  }
  for (std::size_t s = 0; s < compare.sides.size(); ++s) {
    const SensorModel& model = *compared.of(s);
    const SideSummary& summary = compare.sides[s].summary;
    BarGroup& group = groups.emplace_back();
    group.sensor = s == 0 ? viewer.selection.sensor : kBarsOfB;
    group.name = fmt::format("{} {}", side_letter(s), side_name(compared, s));
    group.unit = shown_unit(model.layout.readout.aggregate);
    group.top = axis_top(relative ? tops[s] : std::max(tops[0], tops[1]), group.unit);
    for (std::size_t k = 0; k < side_readings(*step, s).size(); ++k)
      group.values.push_back({model.layout.taxels[k].id, side_readings(*step, s)[k],
                              k < summary.peaks.size() ? summary.peaks[k] : 0.0, model.color(static_cast<int>(k))});
  }
  const auto clicked = draw_pressure_bars(ui, viewer, compare.shown.bars, groups, size, true);
  if (clicked && clicked->sensor != kBarsOfB) click_taxel(viewer.selection, clicked->id, ImGui::GetIO().KeyShift);
}

/// Draws the numbers of both layouts, and a sentence on their equal parts.
void draw_comparison_result(const WindowUi& ui, const RunView& run, const ComparedLayouts& compared,
                            CompareState& compare) {
  constexpr float kNarrow = 32;  // heights of text
  const float width = ImGui::GetContentRegionAvail().x;
  width < kNarrow* ImGui::GetFontSize() ? draw_numbers_below_each_other(run, compared, compare)
                                        : draw_numbers(run, compared, compare, width);
  compare.shown.held = held_equal(compared);
  wrapped_text(compare.shown.held, palette(ui.dark).dim);
  if (run.frame->trace) {
    const std::string missing = missing_rows(compared, *run.frame->trace, run.by_travel());
    if (!missing.empty()) wrapped_text(missing, palette(ui.dark).warning);
  }
}

/// Draws the comparison: the plot at the right in its whole height or, in a narrow panel, below everything else.
void draw_read_comparison(WindowUi& ui, Viewer& viewer, const RunView& run, const ComparedLayouts& compared,
                          CompareState& compare) {
  take_rows(compare, compared, run.by_travel());
  const bool has_plot_elsewhere = viewer.mode == Mode::analyse;
  const float line = ImGui::GetFontSize();
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const bool beside = room.x > kLeastWidthOfTwo * line;
  const ImVec2 left(has_plot_elsewhere ? 0.0f
                    : beside           ? kPartOfBars * room.x
                                       : 0.0f,
                    has_plot_elsewhere || beside ? 0.0f : std::max(kLeastLeft * line, 0.55f * room.y));
  if (ImGui::BeginChild("##numbers and bars", left)) {
    draw_comparison_result(ui, run, compared, compare);
    draw_compare_buttons(ui, compare);
    draw_compare_options(ui, compare, compared);
    draw_read_rows(ui, compare);
    const ImVec2 rest = ImGui::GetContentRegionAvail();
    draw_compared_bars(ui, viewer, compared, compare, {rest.x, std::max(kLeastBars * line, rest.y)});
  }
  ImGui::EndChild();
  if (has_plot_elsewhere) return;
  if (beside) ImGui::SameLine();
  const ImVec2 size = ImGui::GetContentRegionAvail();
  draw_compare_plot(ui, viewer, run, compared, compare, {size.x, std::max(kLeastPlot * line, size.y)}, false);
}

void draw_compare_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, CompareState& compare, bool& open) {
  if (begin_panel(ui, kCompare.title, &open)) {
    ImGui::PushFont(nullptr, kTextHeight * kSmallText);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(6, 2));
    const ComparedLayouts* compared = displayed_comparison(viewer, shown, compare, open);
    const bool is_read = compared != nullptr && compared->problem.empty() && compared->b;
    if (!is_read) draw_compare_buttons(ui, compare);
    if (is_read) {
      draw_read_comparison(ui, viewer, shown.run, *compared, compare);
    } else if (shown.sensor(viewer) == nullptr) {
      ImGui::TextDisabled("No sensor is simulated.");
    } else if (!compare.request) {
      wrapped_text("Choose what another layout, or the paper's released model, would read on the contact of this run.",
                   palette(ui.dark).dim);
    } else if (compared != nullptr && !compared->problem.empty()) {
      wrapped_text(compared->problem, palette(ui.dark).error);
    } else {
      draw_building(ui, compare);
    }
    ImGui::PopStyleVar();
    ImGui::PopFont();
  }
  ImGui::End();
}

/// Draws the curves of both layouts into the large plot of ANALYSE.
bool draw_compare_answer(App& app) {
  CompareState& compare = app.get<CompareState>();
  const RunView& run = app.shown->run;
  const ComparedLayouts* compared = displayed_comparison(*app.viewer, *app.shown, compare, true);
  if (compared == nullptr || !compared->problem.empty() || !compared->b) return false;
  take_rows(compare, *compared, run.by_travel());
  draw_compare_plot(*app.ui, *app.viewer, run, *compared, compare, ImGui::GetContentRegionAvail(), fits_contact(app));
  return true;
}

/// Returns the taxels of the second layout whose fields are drawn: all of few, the responding ones of many.
std::shared_ptr<const std::vector<Taxel>> drawn_taxels_of_b(const ComparedLayouts& compared) {
  constexpr std::size_t kFew = 60;
  const std::vector<Taxel>& all = *compared.taxels_of_b;
  if (all.size() <= kFew) return compared.taxels_of_b;
  auto drawn = std::make_shared<std::vector<Taxel>>();
  if (!compared.displayed) return drawn;
  const std::vector<double>& readings = side_readings(*compared.displayed, 1);
  const double largest = readings.empty() ? 0 : *std::max_element(readings.begin(), readings.end());
  for (std::size_t k = 0; k < std::min(all.size(), readings.size()); ++k)
    if (readings[k] > kTaxelResponds * largest) drawn->push_back(all[k]);
  return drawn;
}

/// Sets the receptive fields of the second layout, unless it has the taxels of the displayed layout.
void set_second_layout(const App& app, SceneInput& scene) {
  const CompareState& compare = app.get<CompareState>();
  const ComparedLayouts* compared = displayed_comparison(*app.viewer, *app.shown, compare, is_in_use(kCompare, app));
  if (!compare.rings || compared == nullptr || !compared->taxels_of_b) return;
  scene.ghosts = drawn_taxels_of_b(*compared);
  scene.ghosts_sensor = compared->sensor;
}

std::vector<PanelPart> compare_parts() {
  constexpr auto kWhyNot = [](const App& app) -> const char* {
    return app.shown->run.frame != nullptr ? nullptr : "Nothing is simulated";
  };
  return {{"Open a second layout...", "", "Compare the run with another layout", kSimulate, kWhyNot},
          {"The paper's released model", "", "Compare the run with the paper's released model", kSimulate, kWhyNot},
          {"A's contact", "", "The second layout reads the recorded contact", kSimulate, kWhyNot},
          {"B's own field", "", "The second layout reads contact of its own pressure field", kSimulate, kWhyNot},
          {"Fields of B in the view", "", "Draw the receptive fields of the second layout", kSimulate, kWhyNot}};
}

}  // namespace

constinit const Feature kCompare{
    .title = "Compare",
    .dock = Dock::bottom,
    .opens = Opens::by_user,
    .key = "panel_compare",
    .label = "Compare",
    .context = kSimulate,
    .chord = ImGuiMod_Shift | ImGuiKey_C,
    .draw =
        [](App& app) {
          draw_compare_panel(*app.ui, *app.viewer, *app.shown, app.get<CompareState>(),
                             app.get<PanelsShown>()[kCompare]);
        },
    .parts = compare_parts,
    .guide = "Compare layouts",
    .analyse = {.tab = 3, .question = "Which layout reads better?", .draw_answer = draw_compare_answer},
    .begin_frame = [](App& app) { app.get<CompareState>().shown = {}; },
    .mark = set_second_layout,
    .make_job = studio::make_compare_job,
    .dump = dump_compare,
};

}  // namespace taxel::ui
