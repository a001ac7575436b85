// The panel with the plot of readings over travel or time.
#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensor_chooser.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/files/export.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/plot/plot_drawing.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "app/studio/nouns/real/real_state.h"
#include "core/base/text/rounded.h"
#include "core/sensor/readout/reading.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/plot_curves.h"

namespace taxel::ui {

namespace {

/// Title of the same panel if it shows time. ImGui identifies both by the part after ###.
constexpr const char* kTimePlotTitle = "Taxels over time###Taxels over travel";

/// Largest part of the panel's width that the legend takes.
constexpr float kMaxLegend = 0.4f;

constexpr float kChooserWidth = 11;  // width of the chosen sensor, in heights of text

/// Continues the row if an item of this width fits into it.
void same_line_if_fits(float gap, float width) {
  ImGui::SameLine(0, gap);
  if (ImGui::GetContentRegionAvail().x < width) ImGui::NewLine();
}

float checkbox_width(const char* label) {
  return ImGui::GetFrameHeight() + ImGui::GetStyle().ItemInnerSpacing.x + ImGui::CalcTextSize(label).x;
}

float plot_button_width(const char* label) {
  return ImGui::CalcTextSize(label).x + 2 * ImGui::GetStyle().FramePadding.x;
}

/// Draws a button for each quantity. A quantity that no sensor has is greyed out, and its tooltip says why.
void draw_quantities(WindowUi& ui, PlotState& plot, const std::vector<SensorShown>& sensors) {
  const PlotQuantity shown = available_quantity(sensors, plot.quantity);
  for (const PlotQuantity quantity : kPlotQuantities) {
    if (quantity != PlotQuantity::reading) ImGui::SameLine(0, 2);
    const QuantityWords& words = words_of(quantity);
    const std::string missing = why_missing(sensors, quantity);
    ImGui::BeginDisabled(!missing.empty());
    if (small_choice(ui, words.label, quantity == shown)) plot.quantity = quantity;
    ImGui::EndDisabled();
    tooltip(missing.empty() ? words.tip : missing);
  }
}

void draw_options(WindowUi& ui, PlotState& plot, const PlotChoice& choice, const std::vector<SensorShown>& sensors,
                  Selection& selection, SensorChooser& chooser) {
  PlotOptions& options = plot.options;
  const bool is_slip = choice.quantity == PlotQuantity::slip;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(6, 2));
  draw_quantities(ui, plot, sensors);
  same_line_if_fits(14, plot_button_width("Relative") + 2 + plot_button_width(choice.unit.text));
  ImGui::BeginDisabled(is_slip);
  if (small_choice(ui, "Relative", choice.relative)) options.relative = true;
  ImGui::EndDisabled();
  tooltip(is_slip ? "Slip is a share already" : "Divided by the largest value of the run");
  ImGui::SameLine(0, 2);
  if (small_choice(ui, choice.unit.text, !choice.relative) && !is_slip) options.relative = false;
  tooltip(std::string("Values in ") + choice.unit.text);
  same_line_if_fits(14, checkbox_width("Responding only"));
  checkbox(ui, "Responding only", &options.responding_only);
  tooltip(
      fmt::format("Only taxels whose peak is above {:g} % of the largest, and selected ones", 100 * kTaxelResponds));
  if (sensors.size() > 1) {
    same_line_if_fits(14, checkbox_width("All sensors"));
    checkbox(ui, "All sensors", &options.all_sensors);
    tooltip("Taxels of all sensors, not only of the selected one");
    const float width = kChooserWidth * ImGui::GetFontSize();
    if (!options.all_sensors) {
      same_line_if_fits(8, width);
      draw_sensor_chooser(ui, chooser, selection, sensors, std::min(width, ImGui::GetContentRegionAvail().x));
    }
  }
  if (plot.shown.in_analyse) {
    bool contact_only = !options.whole_run;
    same_line_if_fits(14, checkbox_width("Contact only"));
    if (checkbox(ui, "Contact only", &contact_only)) options.whole_run = !contact_only;
    tooltip("The axis has only the part of the run with contact (A: the whole run)");
  }
  same_line_if_fits(14, plot_button_width("Export..."));
  if (button(ui, "Export...")) ui.post(ExportFile{FileTask::export_plot});
  tooltip("Write the plot as SVG or PDF");
  if (plot.close_up && plot.shown.may_magnify) {
    same_line_if_fits(14, plot_button_width("Whole run"));
    if (button(ui, "Whole run")) plot.close_up.reset();
    tooltip("Show all steps, instead of those around one change");
  }
  if (!plot.isolated.empty()) {
    same_line_if_fits(14, plot_button_width("Show all"));
    if (button(ui, "Show all")) plot.isolated.clear();
    tooltip("Draw all curves alike again");
  }
  ImGui::PopStyleVar();
}

/// In a low panel the options are a column at the left, because a row above the plot would take half of its height.
void place_options(WindowUi& ui, PlotState& plot, const PlotChoice& choice, const std::vector<SensorShown>& sensors,
                   Selection& selection, SensorChooser& chooser) {
  constexpr float kLow = 9;  // heights of text
  const ImVec2 room = ImGui::GetContentRegionAvail();
  if (room.y >= kLow * ImGui::GetFontSize()) return draw_options(ui, plot, choice, sensors, selection, chooser);
  const float width =
      plot_button_width("Relative") + plot_button_width(choice.unit.text) + plot_button_width("Export...") + 44;
  if (ImGui::BeginChild("options", {width, room.y}, 0, ImGuiWindowFlags_NoBackground))
    draw_options(ui, plot, choice, sensors, selection, chooser);
  ImGui::EndChild();
  ImGui::SameLine();
}

/// Says how many sensors are left out, because of their unit or because they do not have the quantity.
void draw_left_out(const PlotChoice& choice) {
  const auto line = [](int count, const std::string& why) {
    if (count > 0) caption(fmt::format("{} sensor{} {}", count, count > 1 ? "s are" : " is", why).c_str());
  };
  const bool several = choice.other_units > 1;
  line(choice.other_units, fmt::format("not in {}: select {} to plot {}", choice.unit.text, several ? "one" : "it",
                                       several ? "them" : "it"));
  line(choice.without, fmt::format("left out: without {}", words_of(choice.quantity).key));
}

/// Draws a marker where the samples were polished while the simulation ran. Earlier readings are of preview samples.
void draw_polish_mark(const WindowUi& ui, const PlotCurves& curves) {
  if (!curves.polished_from) return;
  const double x = *curves.polished_from;
  ImPlotSpec spec;
  spec.LineColor = palette(ui.dark).dim;
  spec.LineWeight = 1.0f;
  spec.Flags = ImPlotItemFlags_NoLegend | ImPlotItemFlags_NoFit;
  ImPlot::PlotInfLines("##polished", &x, 1, spec);
  const ImVec2 away(-0.6f * ImGui::GetFontSize(), 0.6f * ImGui::GetFontSize());
  ImPlot::Annotation(x, ImPlot::GetPlotLimits().Y.Max, palette(ui.dark).raised, away, true, "polished samples");
}

/// Draws the values of the curves at the pointer, with their units, and marks them on the curves.
void draw_pointer_values(const WindowUi& ui, const RunView& run, const PlotChoice& choice, const PlotReadout& readout,
                         double scale, bool relative) {
  const Palette& colors = palette(ui.dark);
  ImDrawList& list = *ImPlot::GetPlotDrawList();
  const ImVec2 lo = ImPlot::GetPlotPos(), size = ImPlot::GetPlotSize();
  const float x = std::round(ImPlot::PlotToPixels(readout.x, 0.0).x);
  ImPlot::PushPlotClipRect();
  list.AddLine({x, lo.y}, {x, lo.y + size.y}, to_u32(colors.dim, 0.7f));
  for (const PlotReadout::Line& line : readout.lines)
    list.AddCircleFilled(ImPlot::PlotToPixels(readout.x, scale * line.value), 3.0f * static_cast<float>(ui.pixel_scale),
                         to_u32(curve_color(line.color, ui.dark)));
  ImPlot::PopPlotClipRect();
  if (!ImGui::BeginTooltip()) return;
  ImGui::TextUnformatted(fmt::format("{} {}", rounded(readout.x, 4, 6), run.by_travel() ? "mm" : "s").c_str());
  for (const PlotReadout::Line& line : readout.lines) {
    ImGui::TextColored(curve_color(line.color, ui.dark), "%s", line.label.c_str());
    ImGui::SameLine();
    ImGui::TextUnformatted(in_unit(line.value, choice.unit).c_str());
    if (!relative) continue;
    ImGui::SameLine();
    ImGui::TextDisabled("%.0f %% of the largest", 100 * scale * line.value);
  }
  if (readout.omitted > 0)
    ImGui::TextDisabled("%zu more, not above %s", readout.omitted,
                        in_unit(readout.lines.back().value, choice.unit).c_str());
  ImGui::EndTooltip();
}

/// Room of the axes' numbers and names above and below the curves, in heights of text.
constexpr float kAxisRoom = 3;

/// Sets the view of the close-up. The curves of the other taxels step back, unless the user isolates some.
void view_change(const WindowUi& ui, const RunView& run, PlotState& plot, const std::vector<SensorShown>& sensors,
                 double scale, float height) {
  const auto pixel = static_cast<double>(ui.pixel_scale);
  const double inner = std::max(1.0f, height - kAxisRoom * ImGui::GetFontSize());
  plot.shown.close_up =
      view_close_up(run, sensors, *plot.close_up, plot.exact, plot.shown.before, scale, inner / pixel);
  if (plot.shown.close_up && plot.shown.focus.empty()) plot.shown.focus = {plot.close_up->key};
}

PlotAxes shown_axes(PlotAxes axes, const PlotShown& shown) {
  if (!shown.close_up) return axes;
  const CurveBounds& bounds = shown.close_up->bounds;
  axes.x_begin = bounds.x_low, axes.x_end = bounds.x_high;
  axes.y_begin = bounds.y_low, axes.y_end = bounds.y_high;
  return axes;
}

/// Draws the curves behind those of the taxels, or the curve of the close-up in front of them.
void draw_compared_curves(const WindowUi& ui, PlotState& plot, const std::vector<SensorShown>& sensors, double scale,
                          bool behind) {
  const auto color_of = [&](const TaxelKey& key) {
    for (const SensorShown& sensor : sensors)
      if (sensor.index == key.sensor)
        return curve_color(sensor.model->color(index_of(sensor.model->layout, key.id)), ui.dark);
    return palette(ui.dark).text;
  };
  PlotShown& shown = plot.shown;
  if (shown.close_up && behind) {
    draw_behind_close_up(ui, *shown.close_up, color_of(plot.close_up->key));
  } else if (shown.close_up) {
    draw_close_up(ui, *shown.close_up, color_of(plot.close_up->key), plot.exact ? plot.exact->problem : "");
    shown.change_pixels = shown.close_up->change_height(ImPlot::GetPlotSize().y);
  } else if (shown.before && behind) {
    draw_earlier_curve(ui, *shown.before, color_of(shown.before->key), scale);
  }
}

void draw_plot(WindowUi& ui, Viewer& viewer, const RunView& run, RealState& real, PlotState& plot,
               const std::vector<SensorShown>& sensors) {
  constexpr std::size_t kMaxLines = 10;  // of the read-out
  PlotCurves& curves = plot.curves;
  const PlotChoice& choice = plot.shown.choice;
  constexpr auto kFlags = ImPlotFlags_NoTitle | ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect |
                          ImPlotFlags_NoMouseText | ImPlotFlags_NoLegend;
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const ImVec2 at = ImGui::GetCursorPos(), room = ImGui::GetContentRegionAvail();
  const float legend = std::min(plot_legend_width(choice.curves), kMaxLegend * room.x);
  ImGui::SetCursorPos({at.x + room.x - legend, at.y});
  const LegendPointer pointer = draw_plot_legend(ui, choice.curves, plot.isolated, {legend, room.y}, legend_tip);
  if (pointer.clicked) click_taxel_of(viewer.selection, *pointer.clicked, ImGui::GetIO().KeyShift);
  plot.shown.focus = focus_of(choice.curves, pointer.hovered, plot.isolated);
  ImGui::SetCursorPos(at);
  const double scale = plot_scale(choice, choice.relative);
  const bool is_reading = choice.quantity == PlotQuantity::reading;
  if (is_reading && plot.close_up && plot.shown.may_magnify) view_change(ui, run, plot, sensors, scale, room.y);
  if (ImPlot::BeginPlot("##taxels", {room.x - legend, room.y}, kFlags)) {
    PlotAxes axes = plot_axes(run, choice, choice.relative);
    if (plot.shown.fits_contact) fit_to_contact(axes, run);
    axes = shown_axes(axes, plot.shown);
    plot.shown.x_begin = axes.x_begin, plot.shown.x_end = axes.x_end;
    setup_plot_axes(axes, room.y);
    if (is_reading) draw_compared_curves(ui, plot, sensors, scale, true);
    for (const std::size_t i : drawing_order(choice.curves, plot.shown.focus)) {
      const bool is_by_step = plot.shown.close_up && choice.curves[i].key == plot.close_up->key;
      if (!is_by_step)
        draw_plot_curve(ui, curves, choice.curves[i], style_of(choice.curves[i], plot.shown.focus), scale);
    }
    if (is_reading) draw_compared_curves(ui, plot, sensors, scale, false);
    if (is_reading && !plot.shown.close_up)
      draw_real_curves(ui, viewer.selection, run, real, plot, scale, choice.largest, sensors);
    draw_polish_mark(ui, curves);
    draw_plot_cursor(ui, run);
    if (is_reading) plot.shown.errors = draw_plot_errors(ui, run, sensors, choice.curves, scale);
    if (ImPlot::IsPlotHovered())
      plot.shown.readout = read_curves(curves, choice, plot.shown.focus, ImPlot::GetPlotMousePos().x, kMaxLines);
    if (plot.shown.readout) draw_pointer_values(ui, run, choice, *plot.shown.readout, scale, choice.relative);
    scrub_in_plot(ui, run);
    ImPlot::EndPlot();
    ui.widgets.note_item("Plot");
  }
  ImGui::PopFont();
}

void draw_readings_plot(App& app) {
  const Shown& shown = *app.shown;
  PlotState& plot = app.get<PlotState>();
  const std::vector<SensorShown> sensors = sensors_shown(shown.run);
  if (sensors.empty() || !shown.run.frame->trace) {
    ImGui::TextDisabled("No sensor is simulated.");
    return;
  }
  update_curves(plot.curves, *shown.run.frame->trace, shown.run.by_travel(),
                available_quantity(sensors, plot.quantity));
  plot.shown.choice =
      choose_curves(plot.curves, sensors, app.viewer->selection, plot.options, stopped_taxel(shown.run, sensors));
  part_twins(plot.shown.choice.curves, app.get<RealState>());
  const ProjectPtr& project = shown.document.editing.project;
  if (plot.before && project && project->layout == plot.before->after) plot.shown.before = plot.before;
  place_options(*app.ui, plot, plot.shown.choice, sensors, app.viewer->selection, app.get<SensorChooser>());
  ImGui::BeginGroup();
  draw_left_out(plot.shown.choice);
  draw_plot(*app.ui, *app.viewer, shown.run, app.get<RealState>(), plot, sensors);
  ImGui::EndGroup();
}

/// Draws the answer of the panel that is in front in ANALYSE. Returns false if it has none, or none yet.
bool draw_answer_in_front(App& app) {
  for (const Feature* row : features()) {
    if (row->analyse.draw_answer == nullptr || !is_in_use(*row, app)) continue;
    app.get<PlotState>().shown.answer = row->title;
    if (row->analyse.draw_answer(app)) return true;
    app.get<PlotState>().shown.answer.clear();
  }
  return false;
}

void draw_plot_panel(App& app) {
  PlotState& plot = app.get<PlotState>();
  plot.shown = {};
  plot.shown.in_analyse = app.viewer->mode == Mode::analyse;
  plot.shown.fits_contact = fits_contact(app);
  const auto magnifies = [&](const Feature* row) { return row->analyse.magnifies && is_in_use(*row, app); };
  plot.shown.may_magnify = !plot.shown.in_analyse || std::ranges::any_of(features(), magnifies);
  if (begin_panel(*app.ui, app.shown->run.by_travel() ? kPlot.title : kTimePlotTitle, &app.get<PanelsShown>()[kPlot])) {
    ImGui::BeginGroup();
    if (!plot.shown.in_analyse || !draw_answer_in_front(app)) draw_readings_plot(app);
    ImGui::EndGroup();
    if (plot.shown.in_analyse) app.ui->widgets.note_item("Answer");
  }
  ImGui::End();
}

std::vector<PanelPart> plot_parts() {
  constexpr auto kWhyNot = [](const App& app) -> const char* {
    return app.shown->run.frame != nullptr ? nullptr : "Nothing is simulated";
  };
  return {{"Reading", "", "Plot the readings of the taxels", kSimulate, kWhyNot},
          {"Shear", "", "Plot the friction on each taxel", kSimulate, kWhyNot},
          {"Slip", "", "Plot how much of each taxel slips", kSimulate, kWhyNot},
          {"Relative", "", "Readings as fractions of the largest one", kSimulate, kWhyNot},
          {"Responding only", "", "Leave out the taxels that the contact does not reach", kSimulate, kWhyNot},
          {"All sensors", "", "Curves of all sensors of the scene", kSimulate, kWhyNot}};
}

std::vector<Binding> plot_commands() {
  return {{.command = ToggleWholeRun{},
           .context = kSimulate,
           .chord = ImGuiKey_A,
           .label = "Whole run on the axes",
           .enabled = [](const App& app) { return app.viewer->mode == Mode::analyse; },
           .checked = [](const App& app) { return app.get<PlotState>().options.whole_run; },
           .menu = "Mode",
           .separated = true,
           .needs = "Only in ANALYSE"}};
}

}  // namespace

constinit const Feature kPlot{
    .title = "Taxels over travel",
    .dock = Dock::bottom,
    .opens = Opens::by_user,
    .open = true,
    .key = "panel_plot",
    .label = "Plot",
    .chord = ImGuiKey_F4,
    .of_readings = true,
    .draw = draw_plot_panel,
    .parts = plot_parts,
    .guide = "Look at one step",
    .analyse = {.is_plot = true},
    .begin_frame = [](App& app) { app.get<PlotState>().shown = {}; },
    .commands = plot_commands,
    .make_job = studio::make_close_up_job,
    .dump = dump_plot,
    .saved =
        [](App& app) {
          return std::vector<SavedValue>{{"plot_relative", &app.get<PlotState>().options.relative},
                                         {"plot_responding_only", &app.get<PlotState>().options.responding_only},
                                         {"plot_all_sensors", &app.get<PlotState>().options.all_sensors},
                                         {"plot_whole_run", &app.get<PlotState>().options.whole_run}};
        },
};

}  // namespace taxel::ui
