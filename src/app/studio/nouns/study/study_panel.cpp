// The panel of parameter studies, whose runs are small multiples, and the commands about their files.
#include <fmt/format.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/document/documents.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/study/study_state.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "core/base/error.h"
#include "core/base/text/message.h"
#include "core/document/scenario/scenario.h"
#include "core/document/scenario/study.h"
#include "core/sensor/readout/reading.h"
#include "ui/scene/color_map.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"
#include "ui/widgets/plot_curves.h"

namespace taxel::ui {
namespace {

inline constexpr const char *kDensityKey = "density", *kSeedKey = "seed";  // keys of the layout's samples

/// Returns a value with its parameter and unit: "Depth 0.5 mm".
std::string value_text(const FieldSpec& parameter, double si) {
  const DisplayUnit unit = display_unit(parameter.quantity);
  const std::string number = fmt::format("{} {:.4g}", parameter.label, shifted_decimal(si, -unit.decimal));
  const std::string_view symbol = unit.symbol;
  if (symbol.starts_with("1/")) return fmt::format("{}{}", number, symbol.substr(1));  // "10/mm2"
  if (symbol.empty() || symbol.starts_with("\u00b0")) return fmt::format("{}{}", number, symbol);
  return fmt::format("{} {}", number, symbol);
}

/// Returns the numbers that the scenario uses, in the order of the inspector, then density and seed of the samples.
std::vector<FieldSpec> varied_in(const Scenario& scenario) {
  std::vector<FieldSpec> all;
  visit_fields(scenario, [&](const FieldSpec& field, const auto& value) {
    if constexpr (std::is_same_v<decltype(value), const double&>) all.push_back(field);
  });
  all.push_back({kDensityKey, "Density", "", FieldQuantity::density});
  all.push_back({kSeedKey, "Seed", "", FieldQuantity::number});
  return all;
}

constexpr float kLeastPlotHeight =
    9;  // smallest height of a run's plot, in heights of text; below it the panel scrolls

std::string title_of(const Study& study, const StudyRun& run) {
  const std::vector<FieldSpec> all = varied_in(study.scenario);
  std::string title;
  for (std::size_t i = 0; i < run.values.size(); ++i) {
    const auto varied =
        std::find_if(all.begin(), all.end(), [&](const FieldSpec& one) { return one.key == study.parameters[i].key; });
    if (varied != all.end()) title += (title.empty() ? "" : ", ") + value_text(*varied, run.values[i]);
  }
  return title;
}

/// Applies the values of a run to the document and runs the scenario.
void load_run(WindowUi& ui, const Project& project, const StudyRun& run) {
  if (run.density || run.seed) {
    Sampling sampling = project.layout.sampling;
    sampling.density = run.density.value_or(sampling.density);
    sampling.seed = run.seed.value_or(sampling.seed);
    ui.post(EditProject{SetSampling{sampling}, {}});
  }
  ui.post(RunScenario{run.scenario});
}

void draw_curves(const DocumentView& document, const StudyCurves& curves, const StudyCurve& curve,
                 const std::vector<bool>& responds, double scale, double pixel_scale) {
  for (std::size_t k = 0; k < curve.readings.size(); ++k) {
    if (!responds[k]) continue;
    std::vector<double> shown;
    for (const double reading : curve.readings[k]) shown.push_back(scale * reading);
    const glm::vec3 c = taxel_color(document.model && k < document.model->layout.taxels.size()
                                        ? document.model->color(static_cast<int>(k))
                                        : static_cast<int>(k));
    ImPlotSpec spec;
    spec.LineColor = ImVec4(c.x, c.y, c.z, 1);
    spec.LineWeight = static_cast<float>(1.4 * pixel_scale);
    ImPlot::PlotLine(fmt::format("{}", curves.taxel_ids[k]).c_str(), curve.time.data(), shown.data(),
                     static_cast<int>(shown.size()), spec);
  }
}

/// Returns, for each taxel, whether the taxel responds in any run.
std::vector<bool> responding(const StudyCurves& curves) {
  std::vector<bool> responds(curves.taxel_ids.size(), false);
  for (const StudyCurve& curve : curves.runs)
    for (std::size_t k = 0; k < curve.readings.size(); ++k)
      for (const double reading : curve.readings[k])
        responds[k] = responds[k] || reading > kTaxelResponds * curves.largest_reading;
  return responds;
}

/// Draws the runs. A click on a run applies its values to `project`, the simulated document, and runs the scenario.
/// With null a click does nothing.
void draw_study_plots(WindowUi& ui, const DocumentView& document, const Project* project, const StudyCurves& curves) {
  const int count = static_cast<int>(curves.runs.size());
  const bool grid = curves.study.parameters.size() == 2;
  const int columns =
      grid ? static_cast<int>(curves.study.parameters[1].values.size()) : static_cast<int>(std::ceil(std::sqrt(count)));
  const int rows = (count + columns - 1) / columns;
  const ReadingUnit unit = shown_unit(curves.aggregate);
  const std::vector<bool> responds = responding(curves);
  constexpr auto kFlags = ImPlotSubplotFlags_NoResize | ImPlotSubplotFlags_NoMenus;
  constexpr auto kPlot = ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect | ImPlotFlags_NoMouseText | ImPlotFlags_NoLegend;
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const ImVec2 size(room.x, std::max(room.y, static_cast<float>(rows) * kLeastPlotHeight * ImGui::GetFontSize()));
  if (ImPlot::BeginSubplots("##runs", rows, columns, size, kFlags)) {
    for (int i = 0; i < count; ++i) {
      const StudyCurve& curve = curves.runs[static_cast<std::size_t>(i)];
      const std::string title = title_of(curves.study, curve.run) + fmt::format("##{}", i);
      if (!ImPlot::BeginPlot(title.c_str(), ImVec2(0, 0), kPlot)) continue;
      ImPlot::SetupAxes("time (s)", i % columns == 0 ? unit.text : nullptr, ImPlotAxisFlags_NoMenus,
                        ImPlotAxisFlags_NoMenus);
      ImPlot::SetupAxisLimits(ImAxis_X1, 0, std::max(1e-3, curves.longest), ImPlotCond_Always);
      const double top = unit.scale * (curves.largest_reading > 0 ? curves.largest_reading : 1);
      ImPlot::SetupAxisLimits(ImAxis_Y1, 0, 1.08 * top, ImPlotCond_Always);
      draw_curves(document, curves, curve, responds, unit.scale, ui.pixel_scale);
      if (!curve.error.empty()) ImPlot::PlotText("failed", 0.5 * curves.longest, 0.5 * top);
      if (project != nullptr && plot_clicked()) load_run(ui, *project, curve.run);
      ImPlot::EndPlot();
      ui.widgets.note_item(fmt::format("Run {}", i));
    }
    ImPlot::EndSubplots();
  }
  ImGui::PopFont();
}

constexpr std::uint64_t kMostPerParameter = 100;
constexpr const char* kNone = "none";
constexpr float kStudyWidth = 44, kStudyHeight = 36;  // initial size, in heights of text

/// Returns the document's value of a parameter.
double value_now(const Project& project, std::string_view key) {
  if (key == kDensityKey) return project.layout.sampling.density;
  if (key == kSeedKey) return static_cast<double>(project.layout.sampling.seed);
  return *find_number(project.scenario, key);
}

struct ParameterFields {
  const char* name;
  std::string& key;
  double& from;
  double& to;
  int& count;
};

/// Sets the range from half to twice the document's value, if no range was chosen.
void begin_with(const Project& project, const FieldSpec& varied, ParameterFields& p) {
  const double now = value_now(project, varied.key);
  const bool is_seed = std::string_view(varied.key) == kSeedKey;
  p.from = is_seed ? now : 0.5 * now;
  p.to = is_seed ? now + p.count - 1 : 2 * now;
}

void draw_parameter(WindowUi& ui, const Project& project, ParameterFields p) {
  const std::vector<FieldSpec> all = varied_in(project.scenario);
  std::vector<std::string> labels{kNone};
  for (const FieldSpec& one : all) labels.push_back(label_with_unit(one));
  const std::vector<std::string_view> names(labels.begin(), labels.end());
  auto at = std::find_if(all.begin(), all.end(), [&](const FieldSpec& one) { return one.key == p.key; });
  begin_property(p.name, "Varied parameter");
  const auto made = choice_of(ui, p.name, names, at == all.end() ? 0 : static_cast<std::size_t>(at - all.begin()) + 1);
  if (made) {
    at = *made == 0 ? all.end() : all.begin() + static_cast<std::ptrdiff_t>(*made) - 1;
    if (at != all.end()) begin_with(project, *at, p);
  }
  p.key = at == all.end() ? "" : at->key;
  if (at == all.end()) return;
  if (p.from == 0 && p.to == 0) begin_with(project, *at, p);
  const auto row = [&](const char* what, double& value) {
    const std::string name = fmt::format("{} {}", p.name, what);
    const std::string_view unit = display_unit(at->quantity).symbol;
    begin_property(unit.empty() ? name.c_str() : fmt::format("{} ({})", name, unit).c_str());
    if (const auto typed = number_field(ui, name, {value}, field_unit(at->quantity))) value = *typed;
    show_refusal(ui, name);
  };
  row("from", p.from);
  row("to", p.to);
  const std::string name = fmt::format("{} values", p.name);
  begin_property(name.c_str());
  if (const auto typed = whole_field(ui, name, static_cast<std::uint64_t>(p.count), kMostPerParameter))
    p.count = std::max(1, static_cast<int>(*typed));
  show_refusal(ui, name);
}

StudyParameter parameter_of(const ParameterFields& p) {
  StudyParameter parameter{p.key, {}};
  for (int i = 0; i < p.count; ++i) {
    const double u = p.count > 1 ? static_cast<double>(i) / (p.count - 1) : 0;
    const double value = (1 - u) * p.from + u * p.to;
    parameter.values.push_back(p.key == kSeedKey ? std::round(value) : value);
  }
  return parameter;
}

void run_study(StudyState& study_state, const Scenario& scenario) {
  Study study{scenario, {}};
  if (!study_state.key.empty())
    study.parameters.push_back(
        parameter_of({"", study_state.key, study_state.from, study_state.to, study_state.count}));
  if (!study_state.key2.empty())
    study.parameters.push_back(
        parameter_of({"", study_state.key2, study_state.from2, study_state.to2, study_state.count2}));
  try {
    check_study(study);
    study_state.problem.clear();
    study_state.cancelled = false;
    study_state.before = std::move(study_state.request);
    study_state.request = StudyRequest{++study_state.number, study};
  } catch (const Error& e) {
    study_state.problem = shown_message(e);
  }
}

void draw_fields(WindowUi& ui, StudyState& study, const Project& project) {
  if (begin_properties("study")) {
    draw_parameter(ui, project, {"Vary", study.key, study.from, study.to, study.count});
    draw_parameter(ui, project, {"And", study.key2, study.from2, study.to2, study.count2});
    end_properties();
  }
  if (study.request && study.shown.busy) {
    const float width = ImGui::CalcTextSize("Cancel study").x + 2 * ImGui::GetStyle().FramePadding.x;
    progress_bar(ui, static_cast<float>(study.shown.fraction), -width - ImGui::GetStyle().ItemSpacing.x);
    ImGui::SameLine();
    if (button(ui, "Cancel study")) {
      study.request = std::exchange(study.before, std::nullopt);
      study.cancelled = true;
    }
  } else if (button(ui, "Run study", ImVec2(-1, 0))) {
    run_study(study, project.scenario);
  }
  if (!study.problem.empty()) ImGui::TextWrapped("%s", study.problem.c_str());
}

/// Returns why the displayed study cannot be written as a batch, or an empty text.
std::string save_obstacle(const StudyState& study) {
  if (study.saving.busy) return "A study is being written";
  if (study.shown.busy) return "The study runs: wait for its end";
  if (!study.shown.curves || !study.shown.curves->problem.empty()) return "Run a study first";
  if (!study.shown.curves->folder.empty()) return "These runs are those of a batch already";
  return "";
}

/// Draws the buttons for the files of studies, in one row.
void draw_files(WindowUi& ui, StudyState& study) {
  const std::string why_not = save_obstacle(study);
  ImGui::BeginDisabled(!why_not.empty());
  if (button(ui, "Save as batch...")) ui.post(SaveStudy{});
  ImGui::EndDisabled();
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled))
    ImGui::SetTooltip("%s", why_not.empty() ? "Write the runs into a folder, in the form of `taxel batch`, with 64 bits"
                                            : why_not.c_str());
  ImGui::SameLine();
  if (button(ui, "Open study...")) ui.post(OpenStudy{});
  tooltip("Show the runs of a batch in which one or two numbers vary: choose its batch.json");
  if (!study.saving.busy) return;
  ImGui::SameLine();
  const float width = ImGui::CalcTextSize("Cancel writing").x + 2 * ImGui::GetStyle().FramePadding.x;
  progress_bar(ui, static_cast<float>(study.saving.fraction), -width - ImGui::GetStyle().ItemSpacing.x);
  ImGui::SameLine();
  if (button(ui, "Cancel writing")) study.save.reset();
  tooltip("The finished runs are kept: the same folder continues");
}

/// Returns the document whose scenario a click on a run plays, or null.
const Project* simulated_project(const Shown& shown) {
  return shown.run.simulates_document && !shown.document.is_scene ? shown.document.editing.project.get() : nullptr;
}

/// Runs the study that the fields describe, unless one runs or is displayed.
void answer_by_study(App& app) {
  StudyState& study = app.get<StudyState>();
  const Project* project = simulated_project(*app.shown);
  if (project == nullptr || study.request) return;
  const std::vector<FieldSpec> all = varied_in(project->scenario);
  const auto varied = std::ranges::find_if(all, [&](const FieldSpec& one) { return one.key == study.key; });
  if (varied == all.end()) return;  // the scenario has no such number: the user chooses another
  ParameterFields fields{"Vary", study.key, study.from, study.to, study.count};
  if (study.from == 0 && study.to == 0) begin_with(*project, *varied, fields);
  run_study(study, project->scenario);
}

/// Draws the runs into the large plot of ANALYSE.
bool draw_study_answer(App& app) {
  const StudyCurvesPtr& curves = app.get<StudyState>().shown.curves;
  if (!curves || !curves->problem.empty()) return false;
  draw_study_plots(*app.ui, app.shown->document, simulated_project(*app.shown), *curves);
  return true;
}

/// Draws what there is to say about the runs, and the runs themselves unless the large plot of ANALYSE has them.
void draw_result(WindowUi& ui, const DocumentView& document, const StudyState& study, const Project* project,
                 bool with_plots) {
  const StudyCurvesPtr& curves = study.shown.curves;
  if (study.cancelled) {
    ImGui::TextWrapped("%s", curves ? "The study was cancelled. Below is the one before it."
                                    : "The study was cancelled: none of its runs is kept.");
  }
  if (curves && !curves->problem.empty()) {
    ImGui::TextWrapped("%s", curves->problem.c_str());
  } else if (curves) {
    if (!curves->folder.empty()) caption(("Runs of the batch " + curves->folder).c_str());
    if (!with_plots) caption("Click a run to apply its parameters.");
    if (with_plots) draw_study_plots(ui, document, project, *curves);
  } else if (!study.cancelled) {
    caption("Runs the scenario once for each value. Click a run to apply its parameters.");
  }
}

void draw_study_panel(WindowUi& ui, const Viewer& viewer, const Shown& shown, StudyState& study, bool& open) {
  const ViewPlace& place = viewer.view;
  const float line = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetMainViewport()->WorkPos, room = ImGui::GetMainViewport()->WorkSize;
  const ImVec2 size(std::min(kStudyWidth * line, room.x), std::min(kStudyHeight * line, room.y));
  ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowPos(ImVec2(std::min(place.rect.x0 + line, corner.x + room.x - size.x),
                                 std::min(place.rect.y0 + 3 * line, corner.y + room.y - size.y)),
                          ImGuiCond_FirstUseEver);
  if (begin_panel(ui, kStudy.title, &open)) {
    const Project* project = simulated_project(shown);
    project != nullptr ? draw_fields(ui, study, *project) : ImGui::TextDisabled("No layout is simulated.");
    if (project != nullptr || study.shown.curves) {
      draw_files(ui, study);
      draw_result(ui, shown.document, study, project, viewer.mode != Mode::analyse);
    }
  }
  ImGui::End();
}

std::vector<PanelPart> study_parts() {
  constexpr auto kWhyNot = [](const App& app) -> const char* {
    return app.shown->run.frame != nullptr ? nullptr : "Nothing is simulated";
  };
  return {{"Vary", "", "First parameter that a study varies", kSimulate, kWhyNot},
          {"And", "", "Second parameter that a study varies", kSimulate, kWhyNot},
          {"Run study", "", "Run the scenario once for each value of the parameters", kSimulate, kWhyNot},
          {"Save as batch...", "", "Write the runs of the study into a folder", kSimulate, kWhyNot},
          {"Open study...", "", "Show the runs of a batch", kSimulate, kWhyNot}};
}

}  // namespace

constinit const Feature kStudy{
    .title = "Study",
    .dock = Dock::floating,
    .opens = Opens::by_user,
    .key = "panel_study",
    .label = "Study",
    .context = kSimulate,
    .draw =
        [](App& app) {
          draw_study_panel(*app.ui, *app.viewer, *app.shown, app.get<StudyState>(), app.get<PanelsShown>()[kStudy]);
        },
    .parts = study_parts,
    .guide = "Study a parameter",
    .analyse = {.tab = 4,
                .question = "Which parameter matters?",
                .draw_answer = draw_study_answer,
                .answer = answer_by_study},
    .make_job = studio::make_study_job,
    .dump = dump_study,
};

}  // namespace taxel::ui

namespace taxel::studio {

/// The displayed study is written in the background.
void carry_out(const ui::SaveStudy& command, Host& host) {
  if (command.path.empty()) return ask_for_file(host.app, ui::FileTask::save_study, "");
  ui::StudyState& study = host.app.get<ui::StudyState>();
  study.save = ui::StudySaveRequest{++study.save_number, command.path};
}

void carry_out(const ui::OpenStudy& command, Host& host) {
  if (command.path.empty()) return ask_for_file(host.app, ui::FileTask::open_study, "");
  const auto folder = batch_folder(command.path);
  if (!folder) {
    ui::add_message(host.app.get<ui::Messages>(), Severity::error,
                    command.path + ": is no batch: choose the file batch.json of one", ImGui::GetTime());
    return;
  }
  ui::StudyState& study = host.app.get<ui::StudyState>();
  study.problem.clear();
  study.cancelled = false;
  study.before = std::move(study.request);
  study.request = ui::StudyRequest{++study.number, {}, folder->string()};
  carry_out(ui::SetMode{ui::Mode::analyse, false}, host);
  host.app.ui->open_in_front(host.app.get<ui::PanelsShown>()[ui::kStudy]);
  if (!ui::shows_run(host.app.viewer->mode))  // the panel is hidden
    ui::add_message(host.app.get<ui::Messages>(), Severity::warning,
                    "The runs of " + folder->string() + " are in the panel Study of ANALYSE, which needs taxels",
                    ImGui::GetTime());
}

}  // namespace taxel::studio
