#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/study/study.h"
#include "app/studio/nouns/study/study_commands.h"
#include "app/studio/nouns/study/study_plots.h"
#include "app/studio/nouns/study/study_saver.h"
#include "app/studio/nouns/study/study_state.h"
#include "app/studio/nouns/study/study_varied.h"
#include "core/base/error.h"
#include "core/base/text/shown_message.h"
#include "ui/widgets/choice_field.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr std::uint64_t kMostPerParameter = 100;
constexpr const char* kNone = "none";
constexpr float kWidth = 44, kHeight = 36;  // initial size, in heights of text

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
    ImGui::ProgressBar(static_cast<float>(study.shown.fraction), ImVec2(-width - ImGui::GetStyle().ItemSpacing.x, 0));
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

/// Returns why the displayed study cannot be written as a data set, or an empty text.
std::string save_obstacle(const StudyState& study) {
  if (study.saving.busy) return "A study is being written";
  if (study.shown.busy) return "The study runs: wait for its end";
  if (!study.shown.curves || !study.shown.curves->problem.empty()) return "Run a study first";
  if (!study.shown.curves->folder.empty()) return "These runs are those of a data set already";
  return "";
}

/// Draws the buttons for data sets, in one row.
void draw_files(WindowUi& ui, StudyState& study) {
  const std::string why_not = save_obstacle(study);
  ImGui::BeginDisabled(!why_not.empty());
  if (button(ui, "Save as data set...")) ui.post(SaveStudy{});
  ImGui::EndDisabled();
  if (ImGui::IsItemHovered(ImGuiHoveredFlags_ForTooltip | ImGuiHoveredFlags_AllowWhenDisabled))
    ImGui::SetTooltip("%s", why_not.empty() ? "Write the runs into a folder, in the form of `taxel batch`, with 64 bits"
                                            : why_not.c_str());
  ImGui::SameLine();
  if (button(ui, "Open data set...")) ui.post(OpenStudy{});
  tooltip("Show the runs of a data set in which one or two numbers vary: choose its meta/info.json");
  if (!study.saving.busy) return;
  ImGui::SameLine();
  const float width = ImGui::CalcTextSize("Cancel writing").x + 2 * ImGui::GetStyle().FramePadding.x;
  ImGui::ProgressBar(static_cast<float>(study.saving.fraction), ImVec2(-width - ImGui::GetStyle().ItemSpacing.x, 0));
  ImGui::SameLine();
  if (button(ui, "Cancel writing")) study.save.reset();
  tooltip("The finished runs are kept: the same folder continues");
}

void draw_result(WindowUi& ui, const DocumentView& document, const StudyState& study, const Project& project) {
  const StudyCurvesPtr& curves = study.shown.curves;
  if (study.cancelled) {
    ImGui::TextWrapped("%s", curves ? "The study was cancelled. Below is the one before it."
                                    : "The study was cancelled: none of its runs is kept.");
  }
  if (curves && !curves->problem.empty()) {
    ImGui::TextWrapped("%s", curves->problem.c_str());
  } else if (curves) {
    if (!curves->folder.empty()) caption(("Runs of the data set " + curves->folder).c_str());
    draw_study_plots(ui, document, project, *curves);
  } else if (!study.cancelled) {
    caption("Runs the scenario once for each value. Click a run to apply its parameters.");
  }
}

void draw_study_panel(WindowUi& ui, const ViewPlace& place, const Shown& shown, StudyState& study, bool& open) {
  const float line = ImGui::GetFontSize();
  const ImVec2 corner = ImGui::GetMainViewport()->WorkPos, room = ImGui::GetMainViewport()->WorkSize;
  const ImVec2 size(std::min(kWidth * line, room.x), std::min(kHeight * line, room.y));
  ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowPos(ImVec2(std::min(place.rect.x0 + line, corner.x + room.x - size.x),
                                 std::min(place.rect.y0 + 3 * line, corner.y + room.y - size.y)),
                          ImGuiCond_FirstUseEver);
  if (begin_panel(ui, kStudy.title, &open)) {
    if (!shown.document.editing.project || !shown.run.simulates_document) {
      ImGui::TextDisabled("No layout is simulated.");
    } else {
      draw_fields(ui, study, *shown.document.editing.project);
      draw_files(ui, study);
      draw_result(ui, shown.document, study, *shown.document.editing.project);
    }
  }
  ImGui::End();
}

}  // namespace

constinit const Feature kStudy{
    .title = "Study",
    .dock = Dock::floating,
    .opens = Opens::by_user,
    .key = "panel_study",
    .label = "Study panel",
    .context = kSimulate,
    .draw =
        [](App& app) {
          draw_study_panel(*app.ui, app.viewer->view, *app.shown, app.get<StudyState>(),
                           app.get<PanelsShown>()[kStudy]);
        },

    .make_job = studio::make_study_job,
    .dump = dump_study,
};

}  // namespace taxel::ui
