// The panel that draws the readings of the displayed step as bars, and the switch that makes their error bars small.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/sensors_shown.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/bars/bars_state.h"
#include "app/studio/nouns/bars/pressure_bars.h"
#include "app/studio/nouns/bars/taxel_cells.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "core/sensor/error_bars.h"
#include "core/sensor/readout/aggregate.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/pressure_legend.h"

namespace taxel::ui {
namespace {

constexpr double kMostAtOnce = 16;             // largest factor of a density in one edit
constexpr double kPerSquareMillimetre = 1e-6;  // 1/m^2 in 1/mm^2

/// Returns the model that the run reads by, if it is the document's as it is edited now. Null otherwise.
SensorModelPtr measured_model(const Shown& shown) {
  const SimFramePtr& frame = shown.run.frame;
  const bool is_settled = shown.run.simulates_document && shown.document.editing.project && frame && frame->scene &&
                          shown.document.editing.compiled && !frame->scene->sensors.empty();
  if (!is_settled) return nullptr;
  const SensorModelPtr& model = frame->scene->sensors.front();
  return model == shown.document.model && model->quality == SampleQuality::polished ? model : nullptr;
}

/// Returns the largest bar of each taxel of a model, as a fraction of the largest reading of its sensor.
std::vector<double> largest_parts(const RunView& run, const SensorModel& model) {
  std::vector<double> parts(static_cast<std::size_t>(model.taxel_count()), 0.0);
  for (const SensorShown& sensor : sensors_shown(run)) {
    const auto index = static_cast<std::size_t>(sensor.index);
    const double peak = index < run.sensor_peaks.size() ? run.sensor_peaks[index] : 0;
    if (sensor.model.get() != &model || !(peak > 0)) continue;
    const std::span<const double> bars = run.error_bars(sensor.index);
    for (std::size_t k = 0; k < std::min(bars.size(), parts.size()); ++k) parts[k] = std::max(parts[k], bars[k] / peak);
  }
  return parts;
}

/// Rounds up to two digits.
double round_up(double density) {
  const double digit = std::pow(10.0, std::floor(std::log10(density)) - 1);
  return std::ceil(density / digit * (1 - 1e-12)) * digit;
}

/// Higher densities of the taxels whose bars are large.
struct MoreSamples {
  SetTaxels edit;
  bool is_not_enough = false;  ///< true if the largest number of samples does not even double one of them
};

MoreSamples more_samples(const SensorModel& model, const std::vector<double>& parts) {
  const Layout& layout = model.layout;
  std::vector<double> factors(parts.size(), 1.0);
  double wanted = 0, largest = 1;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k] <= kWithin) continue;
    factors[k] = std::clamp(std::pow(parts[k] / kWithin, 2), 1.5, kMostAtOnce);
    const double own = model.fields.first[k + 1] - model.fields.first[k];
    wanted += (factors[k] - 1) * std::max(1.0, own);
    largest = std::max(largest, factors[k]);
  }
  const double room = std::max(0.0, kMostSamples - static_cast<double>(model.samples.size()));
  const double share = wanted > room ? room / wanted : 1.0;
  MoreSamples more;
  more.is_not_enough = share < 1 && 1 + share * (largest - 1) < 2;
  more.edit.twins_follow = false;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (factors[k] == 1) continue;
    TaxelChange& change = more.edit.changes.emplace_back();
    change.id = layout.taxels[k].id;
    const double present = std::max(layout.taxels[k].density, layout.sampling.density);
    change.density = round_up((1 + share * (factors[k] - 1)) * present);
  }
  return more;
}

}  // namespace

LargestError largest_error(const RunView& run) {
  LargestError largest;
  for (const SensorShown& sensor : sensors_shown(run)) {
    const std::span<const double> bars = run.error_bars(sensor.index);
    const auto index = static_cast<std::size_t>(sensor.index);
    const double peak = index < run.sensor_peaks.size() ? run.sensor_peaks[index] : 0;
    if (!(peak > 0)) continue;
    for (std::size_t k = 0; k < std::min(bars.size(), sensor.taxels().size()); ++k)
      if (bars[k] / peak > largest.part) largest = {bars[k] / peak, sensor.taxels()[k].id};
  }
  return largest;
}

WithinStep next_within(const Shown& shown) {
  const SensorModelPtr model = measured_model(shown);
  if (model == nullptr)
    return {std::nullopt, shown.run.simulates_document ? "adds samples" : "needs a run of the layout"};
  const LargestError error = largest_error(shown.run);
  const Layout& layout = model->layout;
  if (error.taxel < 0) return {std::nullopt, "nothing is measured yet"};
  const std::string bar =
      fmt::format("largest bar {:.2g} % of the largest reading (taxel {})", 100 * error.part, error.taxel);
  if (error.part <= kWithin) return {std::nullopt, bar};
  if (!SamplingError::takes_samples(layout.readout)) return {std::nullopt, bar + ", which more samples do not change"};
  const MoreSamples more = more_samples(*model, largest_parts(shown.run, *model));
  if (more.is_not_enough) {
    Readout readout = layout.readout;
    readout.method = ReadingMethod::exact;
    if (aggregate_spec(readout.aggregate).integral != IntegralKind::none)
      return {Edit{SetReadout{readout}}, bar + ": exact readings"};
    return {std::nullopt, bar + fmt::format(", with the {:g} samples that are made at most", kMostSamples)};
  }
  const std::vector<TaxelChange>& changes = more.edit.changes;
  const std::string densities = changes.size() == 1 ? fmt::format("{:.3g} samples per mm\xc2\xb2",
                                                                  kPerSquareMillimetre * *changes.front().density)
                                                    : fmt::format("more samples for {} taxels", changes.size());
  return {Edit{more.edit}, bar + ": " + densities};
}

void keep_within(WindowUi& ui, const Shown& shown, ErrorBarsState& errors) {
  if (!errors.on || !errors.within) {
    errors.text.clear();
    return;
  }
  const WithinStep step = next_within(shown);
  if (step.edit || !step.text.empty()) errors.text = step.text;
  if (step.edit) ui.post(EditProject{*step.edit, {}});
}

namespace {

/// A panel that is lower has no line of text above the bars. In heights of text.
constexpr float kLowPanel = 5;

/// Returns the bars of a sensor. `peaks` are the largest readings, the first one of the sensor at `first`.
BarGroup bar_group(int sensor, const std::string& name, const SensorModel& model, const std::vector<double>& readings,
                   const std::vector<double>& peaks, std::size_t first) {
  const Layout& layout = model.layout;
  BarGroup group;
  group.sensor = sensor;
  group.name = name;
  group.unit = shown_unit(layout.readout.aggregate);
  group.values.reserve(readings.size());
  for (std::size_t i = 0; i < readings.size() && i < layout.taxels.size(); ++i) {
    const double peak = first + i < peaks.size() ? peaks[first + i] : 0.0;
    group.values.push_back(
        {layout.taxels[i].id, readings[i], peak, model.color(static_cast<int>(i)), 0, layout.taxels[i].name});
  }
  return group;
}

}  // namespace

std::vector<BarGroup> bar_groups(const Viewer& viewer, const Shown& shown, bool probed) {
  std::vector<BarGroup> groups;
  const PressureRange range = reading_range(viewer, shown);
  if (probed) {
    groups.push_back(
        bar_group(viewer.selection.sensor, "", *shown.document.probe->model, shown.state(viewer)->readings, {}, 0));
    groups.back().top = range.hi;
    groups.back().range = range;
    return groups;
  }
  const std::vector<SensorShown> sensors = sensors_shown(shown.run);
  const std::vector<SensorPlace> places = places_of(sensors, shown.run);
  for (const SensorShown& sensor : sensors) {
    groups.push_back(
        bar_group(sensor.index, sensor.name, *sensor.model, sensor.step->readings, shown.run.all_peaks, sensor.first));
    const std::span<const double> errors = shown.run.error_bars(sensor.index);
    for (std::size_t i = 0; i < std::min(errors.size(), groups.back().values.size()); ++i)
      groups.back().values[i].error = errors[i];
    groups.back().range = range_of(sensors, sensor, shown.run, viewer.selection, range);
    groups.back().top = groups.back().range.hi;
    groups.back().place = places[groups.size() - 1];
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const BarGroup& a, const BarGroup& b) { return a.place.body < b.place.body; });
  return groups;
}

namespace {

/// Returns why the selected sensor has no error bars, or an empty text.
std::string why_no_errors(const Viewer& viewer, const RunView& run) {
  if (!run.errors) return "";
  if (!run.errors->problem.empty()) return run.errors->problem;
  const auto sensor = static_cast<std::size_t>(std::max(0, viewer.selection.sensor));
  return sensor < run.errors->missing.size() ? run.errors->missing[sensor] : "";
}

/// Draws a checkbox that is not higher than a caption.
void small_checkbox(WindowUi& ui, const char* label, bool& value) {
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(3, 0));
  checkbox(ui, label, &value);
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

/// Draws the choice between bars and cells. A choice that the panel would make by itself is no choice of the user.
void draw_form_choice(WindowUi& ui, BarsForm& form, bool cells, bool fits) {
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(5, 0));
  if (small_choice(ui, "As bars", !cells)) form = fits ? BarsForm::automatic : BarsForm::bars;
  tooltip("A bar for each taxel");
  ImGui::SameLine(0, 2);
  if (small_choice(ui, "As cells", cells)) form = fits ? BarsForm::cells : BarsForm::automatic;
  tooltip("A cell for each taxel in the colour of its reading, in rows by sensor; chosen by itself for many taxels");
  ImGui::PopStyleVar();
  ImGui::PopFont();
}

/// The form in which the panel draws the readings in this frame.
struct FormShown {
  bool cells = false;
  bool fits_bars = true;  ///< whether bars are wide enough: then they are the form without a choice
};

/// Draws the line above the readings: the unit, the form, and the switch of the error bars where there is a run.
void draw_head(WindowUi& ui, const Viewer& viewer, const Shown& shown, const BarGroup& selected, bool probed,
               const FormShown& drawn, BarsForm& form, ErrorBarsState& errors) {
  const std::string what = drawn.cells ? "" : probed ? ", of the probe" : ", the line is the peak";
  caption(fmt::format("{} by taxel{}", selected.unit.text, what).c_str());
  if (drawn.cells || !drawn.fits_bars || (!probed && sensors_shown(shown.run).size() > 1)) {
    ImGui::SameLine(0, 14);
    draw_form_choice(ui, form, drawn.cells, drawn.fits_bars);
  }
  if (drawn.cells) {
    ImGui::SameLine(0, 14);
    draw_color_scale(ui, selected.range, selected.unit, ImGui::GetTextLineHeight());
  }
  if (probed) return;
  ImGui::SameLine(0, 14);
  small_checkbox(ui, "Error bars", errors.on);
  tooltip(
      "How far each reading is from the next better computation of this contact: samples from their exact integral, "
      "exact readings from bodies whose edges are half as long");
  if (!errors.on) return;
  ImGui::SameLine(0, 14);
  if (const std::string why = why_no_errors(viewer, shown.run); !why.empty())
    return ImGui::TextDisabled("none: %s", why.c_str());
  small_checkbox(ui, "Within 1 %", errors.within);
  tooltip(
      "Adds samples to each taxel whose bar is larger than 1 % of the largest reading of the run, up to about "
      "200 000 in all; then readings become exact. Each edit of the layout can be undone.");
  if (errors.text.empty()) return;
  ImGui::SameLine(0, 14);
  ImGui::TextDisabled("%s", errors.text.c_str());
}

/// Draws the readings as bars or cells, and selects the taxel that is clicked.
void draw_readings(WindowUi& ui, Viewer& viewer, const Shown& shown, const std::vector<BarGroup>& groups, bool probed,
                   BarsShown& bars, BarsState& state, ErrorBarsState& errors) {
  const float width = ImGui::GetContentRegionAvail().x;
  const bool low = ImGui::GetContentRegionAvail().y < kLowPanel * ImGui::GetFontSize();
  FormShown drawn;
  drawn.fits_bars = fits_as_bars(groups, width, static_cast<float>(ui.pixel_scale));
  drawn.cells = state.form == BarsForm::automatic ? !drawn.fits_bars : state.form == BarsForm::cells;
  const BarGroup& selected = selected_group(groups, viewer.selection);
  if (!low) draw_head(ui, viewer, shown, selected, probed, drawn, state.form, errors);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const auto clicked = drawn.cells ? draw_taxel_cells(ui, viewer, bars, groups, room)
                                   : draw_pressure_bars(ui, viewer, bars, groups, room, low);
  if (clicked) click_taxel_of(viewer.selection, {clicked->sensor, clicked->id}, ImGui::GetIO().KeyShift);
}

void draw_bars_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, BarsShown& bars, BarsState& state,
                     ErrorBarsState& errors, bool& open) {
  bars = {};
  if (begin_panel(ui, kBars.title, &open)) {
    const bool probed = viewer.mode == Mode::layout && !shown.shows_scene(viewer) && shown.state(viewer) != nullptr;
    const std::vector<BarGroup> groups = bar_groups(viewer, shown, probed);
    if (groups.empty() || groups.front().values.empty()) {
      const bool is_empty = !shown.document.model && !shown.run.frame;
      const bool is_bare = shown.document.is_scene || shown.sensor(viewer) != nullptr;
      ImGui::TextDisabled("%s", is_empty  ? shown.empty_text()
                                : is_bare ? "No geom of the scene has taxels."
                                          : "Run the simulation, or press X to probe.");
    } else {
      draw_readings(ui, viewer, shown, groups, probed, bars, state, errors);
    }
  }
  ImGui::End();
}

std::vector<PanelPart> bars_parts() {
  const auto why = [](const App& app) -> const char* {
    return app.shown->run.frame ? nullptr : "Nothing is simulated";
  };
  return {{"Error bars", "", "How far each reading is from the next better computation", kSimulate, why},
          {"Within 1 %", "", "Add samples until the error bars are below 1 %", kSimulate, why, "", "Error bars"},
          {"As bars", "", "A bar for each taxel", kSimulate, why, "", "Error bars"},
          {"As cells", "", "A cell for each taxel in the colour of its reading", kSimulate, why, "", "Error bars"}};
}

}  // namespace

constinit const Feature kBars{
    .title = "Pressure bars",
    .dock = Dock::bottom,
    .in_front = true,
    .opens = Opens::by_user,
    .open = true,
    .key = "panel_bars",
    .label = "Pressure bars",
    .of_readings = true,
    .draw =
        [](App& app) {
          draw_bars_panel(*app.ui, *app.viewer, *app.shown, app.get<BarsShown>(), app.get<BarsState>(),
                          app.get<ErrorBarsState>(), app.get<PanelsShown>()[kBars]);
        },
    .parts = bars_parts,
    .guide = "Look at one step",
    .begin_frame = [](App& app) { app.get<BarsShown>() = {}; },
    .end_panels = [](App& app) { keep_within(*app.ui, *app.shown, app.get<ErrorBarsState>()); },
    .make_job = studio::make_error_bars_job,
    .dump = dump_bars,
};

}  // namespace taxel::ui
