#include "ui/panels/study_panel.h"

#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <cmath>

#include "core/base/error.h"
#include "ui/panels/dock_layout.h"
#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/tools/path_tool.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr FieldUnit kSi{"", 0, -1};
constexpr std::uint64_t kMostPerParameter = 100;
/// A taxel is drawn where its peak in any run is above this part of the largest.
constexpr double kResponding = 0.05;
constexpr const char* kNone = "none";
constexpr float kWidth = 44, kHeight = 36;  // at first, in heights of text

/// Keys that can be varied in this scenario.
std::vector<std::string_view> keys_of(const Scenario& scenario) {
  std::vector<std::string_view> keys{kNone};
  for (const ScenarioParameter& parameter : scenario_parameters())
    if (parameter.used_by(scenario.kind)) keys.emplace_back(parameter.key);
  keys.emplace_back("density");
  keys.emplace_back("seed");
  return keys;
}

/// What the document has of it.
double value_now(const Project& project, const std::string& key) {
  if (key == "density") return project.layout.sampling.density;
  if (key == "seed") return static_cast<double>(project.layout.sampling.seed);
  for (const ScenarioParameter& parameter : scenario_parameters())
    if (key == parameter.key) return project.scenario.*parameter.value;
  return 0;
}

struct ParameterFields {
  const char* name;
  std::string& key;
  double& from;
  double& to;
  int& count;
};

/// Half of what the document has to twice of it, where nothing was chosen.
void begin_with(const Project& project, ParameterFields& p) {
  const double now = value_now(project, p.key);
  p.from = p.key == "seed" ? now : 0.5 * now;
  p.to = p.key == "seed" ? now + p.count - 1 : 2 * now;
}

void draw_parameter(UiState& ui, const Project& project, ParameterFields p) {
  const std::vector<std::string_view> keys = keys_of(project.scenario);
  const std::string_view shown = p.key.empty() ? kNone : std::string_view(p.key);
  const auto at = std::find(keys.begin(), keys.end(), shown);
  const std::size_t chosen = at == keys.end() ? 0 : static_cast<std::size_t>(at - keys.begin());
  begin_property(p.name, "What is varied, as scenario files name it: SI units");
  if (const auto made = choice_of(ui, p.name, keys, chosen)) {
    p.key = *made == 0 ? "" : std::string(keys[*made]);
    begin_with(project, p);
  }
  if (p.key.empty()) return;
  if (p.from == 0 && p.to == 0) begin_with(project, p);
  const auto row = [&](const char* what, double& value) {
    const std::string name = fmt::format("{} {}", p.name, what);
    begin_property(name.c_str());
    if (const auto typed = number_field(ui, name, {value}, kSi)) value = *typed;
  };
  row("from", p.from);
  row("to", p.to);
  const std::string name = fmt::format("{} values", p.name);
  begin_property(name.c_str());
  if (const auto typed = whole_field(ui, name, static_cast<std::uint64_t>(p.count), kMostPerParameter))
    p.count = std::max(1, static_cast<int>(*typed));
}

StudyParameter parameter_of(const ParameterFields& p) {
  StudyParameter parameter{p.key, {}};
  for (int i = 0; i < p.count; ++i) {
    const double u = p.count > 1 ? static_cast<double>(i) / (p.count - 1) : 0;
    const double value = (1 - u) * p.from + u * p.to;
    parameter.values.push_back(p.key == "seed" ? std::round(value) : value);
  }
  return parameter;
}

void run_study(UiState& ui, const Scenario& scenario) {
  StudyState& s = ui.study;
  Study study{scenario, {}};
  if (!s.key.empty()) study.parameters.push_back(parameter_of({"", s.key, s.from, s.to, s.count}));
  if (!s.key2.empty()) study.parameters.push_back(parameter_of({"", s.key2, s.from2, s.to2, s.count2}));
  try {
    check_study(study);
    s.problem.clear();
    s.wish = StudyWish{++s.number, study};
  } catch (const Error& e) {
    s.problem = e.what();
  }
}

void draw_fields(UiState& ui, const UiInput& input, const Project& project) {
  StudyState& s = ui.study;
  if (begin_properties("study")) {
    draw_parameter(ui, project, {"Vary", s.key, s.from, s.to, s.count});
    draw_parameter(ui, project, {"And", s.key2, s.from2, s.to2, s.count2});
    end_properties();
  }
  if (input.study.busy) {
    ImGui::ProgressBar(static_cast<float>(input.study.fraction), ImVec2(-6 * ImGui::GetFontSize(), 0));
    ImGui::SameLine();
    if (button(ui, "Cancel study")) s.wish.reset();
  } else if (button(ui, "Run study", ImVec2(-1, 0))) {
    run_study(ui, project.scenario);
  }
  if (!s.problem.empty()) ImGui::TextWrapped("%s", s.problem.c_str());
}

std::string title_of(const Study& study, const StudyRun& run) {
  std::string title;
  for (std::size_t i = 0; i < run.values.size(); ++i)
    title += fmt::format("{}{} {:.4g}", i > 0 ? ", " : "", study.parameters[i].key, run.values[i]);
  return title;
}

/// The plot that is being drawn; while the button is down it is not hovered, as ImPlot has it.
bool plot_clicked() {
  const ImVec2 lo = ImPlot::GetPlotPos(), size = ImPlot::GetPlotSize(), at = ImGui::GetIO().MousePos;
  const bool inside = at.x >= lo.x && at.y >= lo.y && at.x < lo.x + size.x && at.y < lo.y + size.y;
  constexpr auto kHovered = ImGuiHoveredFlags_AllowWhenBlockedByActiveItem | ImGuiHoveredFlags_ChildWindows;
  return inside && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && ImGui::IsWindowHovered(kHovered);
}

/// Its values become the document's, and it runs.
void load_run(UiState& ui, const Project& project, const StudyRun& run) {
  if (run.density || run.seed) {
    Sampling sampling = project.layout.sampling;
    sampling.density = run.density.value_or(sampling.density);
    sampling.seed = run.seed.value_or(sampling.seed);
    ui.ask(EditProject{SetSampling{sampling}, {}});
  }
  ui.ask(RunSweep{run.scenario});
}

void draw_curves(const UiInput& input, const StudyCurves& curves, const StudyCurve& curve,
                 const std::vector<bool>& responds, double scale, double pixel_scale) {
  for (std::size_t k = 0; k < curve.readings.size(); ++k) {
    if (!responds[k]) continue;
    std::vector<double> shown;
    for (const double reading : curve.readings[k]) shown.push_back(scale * reading);
    const glm::vec3 c =
        taxel_color(input.model && k < input.model->layout.taxels.size() ? input.model->color(static_cast<int>(k))
                                                                         : static_cast<int>(k));
    ImPlotSpec spec;
    spec.LineColor = ImVec4(c.x, c.y, c.z, 1);
    spec.LineWeight = static_cast<float>(1.4 * pixel_scale);
    ImPlot::PlotLine(fmt::format("{}", curves.taxel_ids[k]).c_str(), curve.time.data(), shown.data(),
                     static_cast<int>(shown.size()), spec);
  }
}

std::vector<bool> responding(const StudyCurves& curves) {
  std::vector<bool> responds(curves.taxel_ids.size(), false);
  for (const StudyCurve& curve : curves.runs)
    for (std::size_t k = 0; k < curve.readings.size(); ++k)
      for (const double reading : curve.readings[k])
        responds[k] = responds[k] || reading > kResponding * curves.largest_reading;
  return responds;
}

void draw_multiples(UiState& ui, const UiInput& input, const Project& project, const StudyCurves& curves) {
  const int count = static_cast<int>(curves.runs.size());
  const bool grid = curves.study.parameters.size() == 2;
  const int columns =
      grid ? static_cast<int>(curves.study.parameters[1].values.size()) : static_cast<int>(std::ceil(std::sqrt(count)));
  const int rows = (count + columns - 1) / columns;
  const ReadingUnit unit = shown_unit(project.layout.readout.aggregate);
  const std::vector<bool> responds = responding(curves);
  constexpr auto kFlags = ImPlotSubplotFlags_NoResize | ImPlotSubplotFlags_NoMenus;
  constexpr auto kPlot = ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect | ImPlotFlags_NoMouseText | ImPlotFlags_NoLegend;
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  if (ImPlot::BeginSubplots("##runs", rows, columns, ImGui::GetContentRegionAvail(), kFlags)) {
    for (int i = 0; i < count; ++i) {
      const StudyCurve& curve = curves.runs[static_cast<std::size_t>(i)];
      const std::string title = title_of(curves.study, curve.run) + fmt::format("##{}", i);
      if (!ImPlot::BeginPlot(title.c_str(), ImVec2(0, 0), kPlot)) continue;
      ImPlot::SetupAxes("time (s)", i % columns == 0 ? unit.text : nullptr, ImPlotAxisFlags_NoMenus,
                        ImPlotAxisFlags_NoMenus);
      ImPlot::SetupAxisLimits(ImAxis_X1, 0, std::max(1e-3, curves.longest), ImPlotCond_Always);
      const double top = unit.scale * (curves.largest_reading > 0 ? curves.largest_reading : 1);
      ImPlot::SetupAxisLimits(ImAxis_Y1, 0, 1.08 * top, ImPlotCond_Always);
      draw_curves(input, curves, curve, responds, unit.scale, ui.pixel_scale);
      if (!curve.error.empty()) ImPlot::PlotText("failed", 0.5 * curves.longest, 0.5 * top);
      if (plot_clicked()) load_run(ui, project, curve.run);
      ImPlot::EndPlot();
      ui.widgets.note_item(fmt::format("Run {}", i));
    }
    ImPlot::EndSubplots();
  }
  ImGui::PopFont();
}

}  // namespace

void draw_study_panel(UiState& ui, const UiInput& input) {
  const float line = ImGui::GetFontSize();
  ImGui::SetNextWindowSize(ImVec2(kWidth * line, kHeight * line), ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowPos(ImVec2(ui.view.rect.x0 + line, ui.view.rect.y0 + 3 * line), ImGuiCond_FirstUseEver);
  if (begin_panel(ui, kStudyTitle, &ui.saved.panels.study)) {
    if (!input.editing.project || !input.simulates_document) {
      ImGui::TextDisabled("No layout is simulated.");
    } else {
      const Project& project = *input.editing.project;
      draw_fields(ui, input, project);
      if (input.study.curves && !input.study.curves->problem.empty())
        ImGui::TextWrapped("%s", input.study.curves->problem.c_str());
      else if (input.study.curves)
        draw_multiples(ui, input, project, *input.study.curves);
      else
        caption("Runs the scenario once for each value. A click on a run makes its values the document's.");
    }
  }
  ImGui::End();
}

}  // namespace taxel::ui
