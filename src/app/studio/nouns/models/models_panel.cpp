// The panel that compares readings of one contact by several models, in a table and as curves.
#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "app/studio/nouns/models/models_state.h"
#include "app/studio/nouns/plot/plot_drawing.h"
#include "core/base/text/rounded.h"
#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

std::optional<ModelsRequest> models_request(const Viewer& viewer, const Shown& shown, bool open) {
  if (!open || !shows_run(viewer.mode) || shown.sensor(viewer) == nullptr) return std::nullopt;
  return ModelsRequest{viewer.selection.sensor};
}

const ComparedSteps* shown_comparison(const Viewer& viewer, const Shown& shown, const ModelsState& models, bool open) {
  const std::optional<ModelsRequest> request = models_request(viewer, shown, open);
  const ComparedPtr& found = models.compared;
  if (!request || !found || found->sensor != request->sensor || found->model != shown.model(viewer)) return nullptr;
  return found.get();
}

int compared_taxel(const Selection& selection, const ComparedSteps& compared) {
  if (const int active = active_index(selection, compared.model->layout); active >= 0) return active;
  int best = compared.steps.empty() || compared.model->layout.taxels.empty() ? -1 : 0;
  double largest = 0;
  for (const ComparedStepPtr& step : compared.steps) {
    const std::vector<double>& readings = step->readings[ReadingModel::reading].values;
    const auto most = std::max_element(readings.begin(), readings.end());
    if (most == readings.end() || !(*most > largest)) continue;
    largest = *most;
    best = static_cast<int>(most - readings.begin());
  }
  return best;
}

namespace {

constexpr float kModelsLeastWidth = 75;  // smallest width for table and curves next to each other, in heights of text
constexpr float kModelsLeastHeight = 8;  // smallest height of each, in heights of text; below it the panel scrolls
constexpr std::array kColors{0, 5, 2, 3, 1, 6};  // numbers of taxel_color, by model
constexpr std::array kNames{"Reading", "Star field", "Weighted sum", "Exact", "<tactile>", "<touch>"};
constexpr std::array kWidths{1.35f, 1.35f, 1.15f, 0.8f, 0.95f, 0.85f};  // relative widths of the columns
constexpr std::array kTips{
    "The layout as it is",
    "The same layout with a star field: tets from the centroid",
    "Sum of w p over the layout's own hits, not divided by the weights",
    "The layout's aggregate as an integral, without samples",
    "MuJoCo's <tactile>: penetration depth, mean over the taxel's field",
    "One MuJoCo <touch> site for each taxel: normal forces of MuJoCo's own contact points, which "
    "carry the force of this contact"};

std::size_t number(ReadingModel model) {
  return static_cast<std::size_t>(model);
}

/// Returns the unit in which the values of a model are displayed.
ReadingUnit shown_unit_of(ReadingModel model, Aggregate aggregate) {
  if (model == ReadingModel::tactile) return {"mm", 1e3, false};
  if (model == ReadingModel::touch) return {"N", 1, false};
  return shown_unit(model == ReadingModel::weighted_sum ? Aggregate::weighted_sum : aggregate);
}

/// Returns the colour of a model, darker on a light background.
ImVec4 color_of(ReadingModel model, bool dark) {
  const glm::vec3 c = (dark ? 1.0f : 0.62f) * taxel_color(kColors[number(model)]);
  return {c.x, c.y, c.z, 1};
}

std::string four_digits(double value) {
  return std::abs(value) >= 1e4 ? fmt::format("{:.0f}", value) : rounded(value, 4, 4);
}

/// Returns the text of a value, with the difference to the exact reading if both have the same unit.
std::string cell_text(const ModelReadings& readings, ReadingModel model, std::size_t taxel, Aggregate aggregate) {
  if (!readings[model].has(taxel)) return "-";
  const double value = readings[model].values[taxel];
  const ReadingUnit unit = shown_unit_of(model, aggregate);
  const bool beside =
      (model == ReadingModel::reading || model == ReadingModel::star) && readings[ReadingModel::exact].has(taxel);
  const double difference = beside ? value - readings[ReadingModel::exact].values[taxel] : 0;
  if (value == 0 && difference == 0) return "0";
  return beside ? four_digits(unit.scale * value) + fmt::format(" ({})", rounded_change(unit.scale * difference, 2, 4))
                : four_digits(unit.scale * value);
}

void draw_row(const char* name, const char* tip, const std::array<std::string, kReadingModels.size()>& cells) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", name);
  tooltip(tip);
  for (const std::string& cell : cells) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(cell.c_str());
  }
}

/// Draws the differences between each model and the exact reading over the recorded steps, for the taxel of the curves.
void draw_differences(const ComparedSteps& compared, int taxel) {
  if (taxel < 0) return;
  const auto k = static_cast<std::size_t>(taxel);
  std::array<std::string, kReadingModels.size()> peak, correlation, rms, step;
  for (const ReadingModel model : kReadingModels) {
    const CurveComparison c = compare_with_exact(compared.steps, model, k);
    const std::size_t m = number(model);
    peak[m] = four_digits(shown_unit_of(model, compared.model->layout.readout.aggregate).scale * c.peak);
    correlation[m] = c.correlation ? fmt::format("{:.4f}", *c.correlation) : "-";
    rms[m] = c.rms ? fmt::format("{:.2f}", 100 * *c.rms) : "-";
    step[m] = fmt::format("{:.1f}", 100 * c.largest_step);
  }
  draw_row("peak", "Largest value of the taxel whose curves are drawn, over the recorded steps", peak);
  draw_row("corr.", "Correlation with the exact integral", correlation);
  draw_row("rms %",
           "Difference to the exact integral after the best gain, root of the mean square, as a part of its peak", rms);
  draw_row("step %", "Largest change between neighbours of the curve, as a part of its peak", step);
}

void draw_step_table(WindowUi& ui, Selection& selection, const ComparedSteps& compared, const ComparedStep* step,
                     int taxel, ImVec2 size) {
  const Layout& layout = compared.model->layout;
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerV |
                          ImGuiTableFlags_SizingStretchSame;
  if (!ImGui::BeginTable("##models", 1 + static_cast<int>(kReadingModels.size()), kFlags, size)) return;
  ImGui::TableSetupScrollFreeze(0, 1);
  ImGui::TableSetupColumn("Id", ImGuiTableColumnFlags_WidthStretch, 0.6f);
  for (const ReadingModel model : kReadingModels)
    ImGui::TableSetupColumn(kNames[number(model)], ImGuiTableColumnFlags_WidthStretch, kWidths[number(model)]);
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers);
  ImGui::TableNextColumn();
  ImGui::TextDisabled("Id");
  for (const ReadingModel model : kReadingModels) {
    ImGui::TableNextColumn();
    ImGui::PushTextWrapPos(0);
    ImGui::TextColored(color_of(model, ui.dark), "%s", kNames[number(model)]);
    ImGui::PopTextWrapPos();
    tooltip(kTips[number(model)]);
    ImGui::TextDisabled("%s", shown_unit_of(model, layout.readout.aggregate).text);
  }
  for (std::size_t k = 0; k < layout.taxels.size() && step != nullptr; ++k) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    const int id = layout.taxels[k].id;
    const std::string label = fmt::format("{}##model", id);
    if (ImGui::Selectable(label.c_str(), selection.contains(id), ImGuiSelectableFlags_SpanAllColumns))
      click_taxel(selection, id, ImGui::GetIO().KeyShift);
    ui.widgets.note_item(fmt::format("Model row {}", id).c_str());
    for (const ReadingModel model : kReadingModels) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(cell_text(step->readings, model, k, layout.readout.aggregate).c_str());
    }
  }
  draw_differences(compared, taxel);
  ImGui::EndTable();
}

/// Draws the switch of the error bars, which are drawn at the displayed step.
void draw_error_switch(WindowUi& ui, const RunView& run, const ComparedSteps& compared, int taxel,
                       ErrorBarsState& errors) {
  checkbox(ui, "Error bars of the reading", &errors.on);
  tooltip("How far the reading is from the next better computation, at the displayed step");
  const std::span<const double> bars = run.error_bars(compared.sensor);
  if (taxel < 0 || static_cast<std::size_t>(taxel) >= bars.size()) return;
  caption(
      ("\u00b1 " + in_unit(bars[static_cast<std::size_t>(taxel)], shown_unit(compared.model->layout.readout.aggregate)))
          .c_str());
}

/// Draws the numbers of one taxel, a row for each model: for a narrow panel.
void draw_model_rows(WindowUi& ui, const ComparedSteps& compared, const ComparedStep* step, int taxel) {
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit;
  if (taxel < 0 || !ImGui::BeginTable("##rows", 6, kFlags)) return;
  const Aggregate aggregate = compared.model->layout.readout.aggregate;
  struct Head {
    const char *name, *tip;
  };
  constexpr std::array kHeads = {Head{"Model", "Model of the reading"},
                                 Head{"Now", "Value in the displayed step"},
                                 Head{"Peak", "Largest value over the recorded steps"},
                                 Head{"Corr.", "Correlation with the exact integral"},
                                 Head{"RMS", "Difference to the exact integral after the best gain, in % of its peak"},
                                 Head{"Step", "Largest change between neighbours of the curve, in % of its peak"}};
  // A row of heads would not count for the widths of the columns.
  ImGui::TableNextRow();
  ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg0, ImGui::GetColorU32(ImGuiCol_TableHeaderBg));
  for (const Head& head : kHeads) {
    ImGui::TableNextColumn();
    ImGui::TextDisabled("%s", head.name);
    tooltip(head.tip);
  }
  const auto k = static_cast<std::size_t>(taxel);
  for (const ReadingModel model : kReadingModels) {
    const CurveComparison c = compare_with_exact(compared.steps, model, k);
    const ReadingUnit unit = shown_unit_of(model, aggregate);
    const bool is_known = step != nullptr && step->readings[model].has(k);
    const auto cell = [](const std::string& text) {
      ImGui::TableNextColumn();
      ImGui::TextUnformatted(text.c_str());
    };
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::TextColored(color_of(model, ui.dark), "%s", kNames[number(model)]);
    tooltip(fmt::format("{}, in {}", kTips[number(model)], unit.text));
    ui.widgets.note_item(fmt::format("Row {}", kNames[number(model)]));
    cell(is_known ? rounded(unit.scale * step->readings[model].values[k], 3, 3) : "-");
    cell(rounded(unit.scale * c.peak, 3, 3));
    cell(c.correlation ? fmt::format("{:.3f}", *c.correlation) : "-");
    cell(c.rms ? rounded(100 * *c.rms, 3, 1) : "-");
    cell(rounded(100 * c.largest_step, 3, 1));
  }
  ImGui::EndTable();
}

/// Rebuilds the curves if the compared steps or the taxel have changed.
void update_curves(ModelsState& state, const ComparedSteps& compared, int taxel, bool sweep) {
  if (state.curves_of == &compared && state.taxel == taxel) return;
  state.curves_of = &compared;
  state.taxel = taxel;
  state.x.clear();
  for (const ComparedStepPtr& step : compared.steps) state.x.push_back(sweep ? 1e3 * step->travel : step->time);
  state.y.clear();
  for (const ReadingModel model : kReadingModels) {
    std::vector<double>& y = state.y.emplace_back(model_curve(compared.steps, model, static_cast<std::size_t>(taxel)));
    double peak = 0;
    for (const double value : y) peak = std::isnan(value) ? peak : std::max(peak, value);
    for (double& value : y) value = peak > 0 ? value / peak : value;
  }
}

/// Draws the error bar of the reading at the displayed step.
void draw_reading_error(const WindowUi& ui, const RunView& run, const ComparedSteps& compared, int taxel) {
  const ComparedStep* step = compared.at(run.frame->step);
  const std::span<const double> bars = run.error_bars(compared.sensor);
  const auto k = static_cast<std::size_t>(taxel);
  if (step == nullptr || k >= bars.size() || !step->readings[ReadingModel::reading].has(k)) return;
  double peak = 0;
  for (const ComparedStepPtr& each : compared.steps)
    if (each->readings[ReadingModel::reading].has(k))
      peak = std::max(peak, each->readings[ReadingModel::reading].values[k]);
  if (!(peak > 0)) return;
  const double x = run.by_travel() ? 1e3 * step->travel : step->time;
  const double y = step->readings[ReadingModel::reading].values[k] / peak, error = bars[k] / peak;
  ImPlotSpec spec;
  spec.LineColor = palette(ui.dark).text;
  spec.LineWeight = 1.6f * static_cast<float>(ui.pixel_scale);
  ImPlot::PlotErrorBars("##error", &x, &y, &error, 1, spec);
}

/// Displays the recorded step under a click.
void draw_curves(WindowUi& ui, const RunView& run, const ModelsState& state, const ComparedSteps& compared, ImVec2 size,
                 bool fits) {
  constexpr auto kFlags = ImPlotFlags_NoTitle | ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect | ImPlotFlags_NoMouseText;
  constexpr auto kAxis = ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight | ImPlotAxisFlags_Lock;
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  if (ImPlot::BeginPlot("##curves", size, kFlags)) {
    ImPlot::SetupAxes(run.by_travel() ? "travel (mm)" : "time (s)", nullptr, kAxis, kAxis);
    const double first = state.x.empty() ? 0 : state.x.front(), last = state.x.empty() ? 1 : state.x.back();
    PlotAxes axes;
    axes.x_begin = first, axes.x_end = last > first ? last : first + 1;
    if (fits) fit_to_contact(axes, run);
    ImPlot::SetupAxisLimits(ImAxis_X1, axes.x_begin, axes.x_end, ImPlotCond_Always);
    ImPlot::SetupAxisLimits(ImAxis_Y1, 0, 1.08, ImPlotCond_Always);
    ImPlot::SetupLegend(ImPlotLocation_East, ImPlotLegendFlags_Outside | ImPlotLegendFlags_NoMenus);
    ImPlot::SetupFinish();
    for (const ReadingModel model : kReadingModels) {
      const std::vector<double>& y = state.y[number(model)];
      ImPlotSpec spec;
      spec.LineColor = color_of(model, ui.dark);
      spec.LineWeight = (model == ReadingModel::exact ? 2.6f : 1.6f) * static_cast<float>(ui.pixel_scale);
      ImPlot::PlotLine(kNames[number(model)], state.x.data(), y.data(), static_cast<int>(y.size()), spec);
    }
    draw_reading_error(ui, run, compared, state.taxel);
    draw_plot_cursor(ui, run);
    scrub_in_plot(ui, run);
    ImPlot::EndPlot();
    ui.widgets.note_item("Model curves");
  }
  ImGui::PopFont();
}

/// Returns a text about the progress of the comparison, or about a missing input.
std::string status_text(const ComparedSteps& compared, const ComparedStep* step, int taxel) {
  std::string text;
  if (taxel >= 0)
    text = fmt::format("Taxel {}, each curve normalised to its peak",
                       compared.model->layout.taxels[static_cast<std::size_t>(taxel)].id);
  if (compared.steps.size() < compared.due)
    text += fmt::format("; {} of {} steps", compared.steps.size(), compared.due);
  for (const ReadingModel model : kReadingModels)
    if (step != nullptr && !step->readings[model].missing.empty())
      text += fmt::format("\n{}: {}", kNames[number(model)], step->readings[model].missing);
  return text;
}

/// Draws the curves into the large plot of ANALYSE.
bool draw_models_answer(App& app) {
  ModelsState& models = app.get<ModelsState>();
  const RunView& run = app.shown->run;
  const ComparedSteps* compared = shown_comparison(*app.viewer, *app.shown, models, true);
  if (compared == nullptr || !compared->problem.empty()) return false;
  const int taxel = compared_taxel(app.viewer->selection, *compared);
  if (taxel < 0) return false;
  update_curves(models, *compared, taxel, run.by_travel());
  draw_curves(*app.ui, run, models, *compared, ImGui::GetContentRegionAvail(), fits_contact(app));
  return true;
}

void draw_comparison(WindowUi& ui, Selection& selection, const RunView& run, ModelsState& models,
                     const ComparedSteps& compared, ErrorBarsState* errors) {
  const int taxel = compared_taxel(selection, compared);
  const ComparedStep* step = compared.at(run.frame->step);
  ImGui::PushTextWrapPos();
  caption(status_text(compared, step, taxel).c_str());
  ImGui::PopTextWrapPos();
  if (step == nullptr) caption("The displayed step is read while the simulation is paused.");
  if (errors != nullptr) {
    ImGui::PushFont(nullptr, kTextHeight * kSmallText);
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(4, 2));
    draw_model_rows(ui, compared, step, taxel);
    ImGui::PopStyleVar();
    ImGui::PopFont();
    return draw_error_switch(ui, run, compared, taxel, *errors);
  }
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const bool beside = room.x > kModelsLeastWidth * ImGui::GetFontSize();
  const float least = kModelsLeastHeight * ImGui::GetFontSize(),
              height = std::max(least, beside ? room.y : 0.5f * room.y);
  if (!beside) ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  draw_step_table(ui, selection, compared, step, taxel, {beside ? 0.54f * room.x : room.x, height});
  if (!beside) ImGui::PopFont();
  if (taxel < 0) return;
  update_curves(models, compared, taxel, run.by_travel());
  if (beside) ImGui::SameLine();
  const ImVec2 rest = ImGui::GetContentRegionAvail();
  draw_curves(ui, run, models, compared, {rest.x, std::max(least, rest.y)}, false);
}

std::string reason(const Viewer& viewer, const Shown& shown) {
  if (shown.sensor(viewer) == nullptr) return "No sensor is simulated.";
  return shown.run.playing ? "Pause, and the recorded steps are read by other models."
                           : "The step is being read by other models ...";
}

void draw_models_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, ModelsState& models, ErrorBarsState& errors,
                       bool& open) {
  if (begin_panel(ui, kModels.title, &open)) {
    const ComparedSteps* compared = shown_comparison(viewer, shown, models, open);
    if (compared != nullptr && compared->problem.empty()) {
      draw_comparison(ui, viewer.selection, shown.run, models, *compared,
                      viewer.mode == Mode::analyse ? &errors : nullptr);
    } else {
      ImGui::PushTextWrapPos();
      ImGui::TextDisabled("%s", (compared != nullptr ? compared->problem : reason(viewer, shown)).c_str());
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::End();
}

}  // namespace

constinit const Feature kModels{
    .title = "Models",
    .dock = Dock::bottom,
    .opens = Opens::by_user,
    .key = "panel_models",
    .label = "Models",
    .context = kSimulate,
    .draw =
        [](App& app) {
          draw_models_panel(*app.ui, *app.viewer, *app.shown, app.get<ModelsState>(), app.get<ErrorBarsState>(),
                            app.get<PanelsShown>()[kModels]);
        },
    .guide = "Compare models",
    .analyse = {.tab = 2, .question = "Which model of a reading is right?", .draw_answer = draw_models_answer},
    .make_job = studio::make_models_job,
    .dump = dump_models,
};

}  // namespace taxel::ui
