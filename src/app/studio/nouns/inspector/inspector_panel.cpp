// The inspector: numbers about the compiled layout, its problems with the buttons that repair them, and the panel.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <numeric>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/message_list.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "app/studio/nouns/mesh/mesh_state.h"
#include "app/studio/nouns/scenario/scenario_state.h"
#include "core/base/math.h"
#include "core/base/text/message.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/words.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

std::vector<std::size_t> LayoutProblems::of(int id) const {
  const auto found = of_taxel.find(id);
  return found == of_taxel.end() ? std::vector<std::size_t>{} : found->second;
}

Severity LayoutProblems::worst(int id) const {
  Severity worst = Severity::note;
  for (const std::size_t i : of(id)) worst = std::max(worst, list[i].severity);
  return worst;
}

LayoutProblems layout_problems(const ProjectPtr& project, const SensorModelPtr& model, bool compiled,
                               const std::string& mesh_sha256) {
  LayoutProblems problems;
  problems.project = project;
  problems.model = model;
  problems.compiled = compiled;
  const Layout& layout = project->layout;
  const auto add = [&](Problems found) {
    for (Problem& problem : found) {
      if (problem.code == "no_taxels") continue;  // normal for a layout that is being built
      const std::optional<std::size_t> index = taxel_of_pointer(problem.pointer);
      auto& where =
          index && *index < layout.taxels.size() ? problems.of_taxel[layout.taxels[*index].id] : problems.of_settings;
      where.push_back(problems.list.size());
      problems.list.push_back(std::move(problem));
    }
  };
  add(check_layout_values(layout, ""));
  add(check_layout_on_skin(layout, layout_mesh(*model), mesh_sha256, ""));
  if (!compiled || model->quality == SampleQuality::preview) return problems;
  Problems of_samples;
  for (const Problem& problem : model->problems)
    if (problem.code == kFieldWithoutSamples) of_samples.push_back(problem);
  add(std::move(of_samples));
  return problems;
}

ModelSummary summarize(const SensorModelPtr& model) {
  ModelSummary summary;
  summary.model = model;
  if (!model) return summary;
  summary.skin_area = model->skin->mesh().area();
  for (std::size_t i = 0; i < model->samples.size(); ++i) {
    const std::size_t taxels = i < model->taxels_of_sample.size() ? model->taxels_of_sample[i].size() : 0;
    if (taxels > 0) {
      ++summary.used_samples;
      summary.used_area += model->samples[i].area;
    }
    if (taxels > 1) ++summary.shared_samples;
  }
  for (int k = 0; k < model->taxel_count(); ++k) {
    const auto row = static_cast<std::size_t>(k);
    const Taxel& taxel = model->layout.taxels[row];
    const SurfacePoint nearest = model->skin->closest_point(taxel.center);
    const dvec3& skin_normal = model->skin->mesh().face_normals()[static_cast<std::size_t>(nearest.face)];
    summary.samples_of_taxel.push_back(model->fields.first[row + 1] - model->fields.first[row]);
    summary.distance_to_skin.push_back(nearest.distance);
    summary.angle_to_skin_deg.push_back(angle_deg(taxel.normal, skin_normal));
  }
  return summary;
}

namespace {

/// Largest number of listed problems. The taxel table shows further problems next to their taxels.
constexpr std::size_t kMostShown = 12;

/// Draws a button whose text wraps to the next line if the text is too long.
bool wrapped_button(WindowUi& ui, const std::string& words, std::size_t number) {
  const float room = ImGui::GetContentRegionAvail().x, pad = ImGui::GetStyle().FramePadding.x;
  const ImVec2 text = ImGui::CalcTextSize(words.c_str(), nullptr, false, room - 2 * pad);
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const float height = text.y + 2 * ImGui::GetStyle().FramePadding.y;
  const bool pressed = ImGui::Button(fmt::format("##fix{}", number).c_str(), ImVec2(-1, height));
  ui.widgets.note_item(words);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {corner.x + pad, corner.y + ImGui::GetStyle().FramePadding.y},
               ImGui::GetColorU32(ImGuiCol_Text), words.c_str(), nullptr, room - 2 * pad);
  return pressed;
}

void draw_problem(WindowUi& ui, const DocumentView& document, const LayoutProblems& problems, std::size_t number) {
  const Problem& problem = problems.list[number];
  ImGui::PushStyleColor(ImGuiCol_Text, severity_color(palette(ui.dark), problem.severity));
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(taxel::shown_part(problem.message).c_str());
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
  tooltip(problem.fix.empty() ? problem.pointer : fmt::format("{}: {}", problem.pointer, problem.fix));
  const auto fix =
      fix_for(problem, *document.editing.project, problems.model->skin.get(), document.editing.mesh_sha256);
  if (fix && wrapped_button(ui, fix->words, number)) ui.post(EditProject{fix->edit, {}});
  ImGui::Spacing();
}

void fix_all(WindowUi& ui, const DocumentView& document, const LayoutProblems& problems, Messages& messages) {
  const Mending mending = mend_all(*document.editing.project, layout_mesh(*problems.model));
  if (mending.edit) ui.post(EditProject{*mending.edit, {}});
  std::string text = fmt::format("{} problem{} fixed", mending.mended, mending.mended == 1 ? "" : "s");
  if (!mending.left.empty()) text += fmt::format(", {} left for you to decide", mending.left.size());
  add_message(messages, Severity::note, text, ImGui::GetTime());
}

}  // namespace

std::vector<std::size_t> displayed_problems(const Selection& selection, const LayoutProblems& problems) {
  std::vector<std::size_t> displayed;
  if (selection.empty()) {
    displayed.resize(problems.list.size());
    std::iota(displayed.begin(), displayed.end(), 0U);
    return displayed;
  }
  for (const int id : selection.taxels) {
    const std::vector<std::size_t> own = problems.of(id);
    displayed.insert(displayed.end(), own.begin(), own.end());
  }
  return displayed;
}

void draw_problem_list(WindowUi& ui, const Selection& selection, const DocumentView& document,
                       const LayoutProblems& problems, Messages& messages) {
  if (!document.editing.project || problems.project != document.editing.project || problems.list.empty()) return;
  if (!header(ui, fmt::format("Problems ({})##problems", problems.list.size()).c_str())) return;
  const std::vector<std::size_t> shown = displayed_problems(selection, problems);
  for (std::size_t i = 0; i < std::min(shown.size(), kMostShown); ++i) draw_problem(ui, document, problems, shown[i]);
  if (shown.size() > kMostShown) ImGui::TextDisabled("and %d more", static_cast<int>(shown.size() - kMostShown));
  if (shown.empty()) ImGui::TextDisabled("No problems of the selected taxels.");
  if (button(ui, "Fix all", ImVec2(-1, 0))) fix_all(ui, document, problems, messages);
  tooltip("Every repair that needs no decision, over the whole layout, as one step");
}

namespace {

std::string direction(const dvec3& v) {
  return fmt::format("{:.2f}, {:.2f}, {:.2f}", v.x, v.y, v.z);
}

/// Limits for the distance [m] and the angle to the skin beyond which a value is highlighted.
constexpr double kFarFromSkin = 0.001, kWideAngleDeg = 20;

/// Draws the properties of a taxel, as fields if the taxel can be edited.
void draw_found(const WindowUi& ui, const Viewer& viewer, const Shown& shown, const ModelSummary& summary,
                const SensorModel& model, int index, bool edited) {
  const auto i = static_cast<std::size_t>(index);
  const Taxel& taxel = model.layout.taxels[i];
  const Palette& colors = palette(ui.dark);
  if (!edited) {
    property("Id, name", taxel.name.empty() ? std::to_string(taxel.id) : fmt::format("{}, {}", taxel.id, taxel.name));
    property("Centre (mm)",
             fmt::format("{:.2f}, {:.2f}, {:.2f}", 1e3 * taxel.center.x, 1e3 * taxel.center.y, 1e3 * taxel.center.z));
    property("Normal", direction(taxel.normal));
    property("Radius", in_mm(taxel.radius));
  }
  if (i < summary.samples_of_taxel.size()) {
    const double distance = summary.distance_to_skin[i], angle = summary.angle_to_skin_deg[i];
    property("Samples", grouped(summary.samples_of_taxel[i]),
             summary.samples_of_taxel[i] > 0 ? colors.text : colors.error);
    property("Distance to surface", in_mm(distance), distance < kFarFromSkin ? colors.text : colors.warning);
    property("Normal deviation", fmt::format("{:.1f}\u00b0", angle),
             angle < kWideAngleDeg ? colors.text : colors.warning);
  }
  const SensorStep* sensor = shows_run(viewer.mode) ? shown.sensor(viewer) : nullptr;
  if (sensor != nullptr && i < sensor->readings.size()) {
    const ReadingUnit unit = shown_unit(model.layout.readout.aggregate);
    property("Reading", in_unit(sensor->readings[i], unit));
    if (i < shown.run.peaks.size()) property("Peak", in_unit(shown.run.peaks[i], unit));
  }
}

void draw_taxel(WindowUi& ui, Viewer& viewer, const Shown& shown, const ModelSummary& summary,
                const SensorModel& model) {
  if (!header(ui, "Selected taxel")) return;
  const int index = active_index(viewer.selection, model.layout);
  const bool edited = shown.shows_edited(viewer);
  if (edited ? viewer.selection.empty() : index < 0) {
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("None. Click one in the view.");
    ImGui::PopTextWrapPos();
    return;
  }
  if (!begin_properties("taxel")) return;
  if (edited) draw_taxel_fields(ui, viewer.selection, *shown.document.editing.project);
  if (index >= 0) draw_found(ui, viewer, shown, summary, model, index, edited);
  end_properties();
}

/// Draws the subtaxels of the selected taxel.
void draw_subtaxels_of_selected(WindowUi& ui, const Selection& selection, const Project& project) {
  if (selection.taxels.size() != 1) return;
  if (const Taxel* taxel = find_taxel(project.layout, selection.taxels.front())) draw_subtaxels(ui, *taxel);
}

void draw_sampling(WindowUi& ui, const ModelSummary& summary, const SensorModel& model) {
  if (!header(ui, "Sampling") || !begin_properties("sampling")) return;
  const Layout& layout = model.layout;
  const auto total = static_cast<double>(std::max<std::size_t>(1, model.samples.size()));
  property("Density", fmt::format("{:.4g} / mm\u00b2", 1e-6 * layout.sampling.density));
  property("Seed", std::to_string(layout.sampling.seed));
  property("Samples", grouped(static_cast<long long>(model.samples.size())));
  property("Used", fmt::format("{} ({:.1f} %)", grouped(summary.used_samples), 100.0 * summary.used_samples / total));
  property("Shared",
           fmt::format("{} ({:.1f} %)", grouped(summary.shared_samples), 100.0 * summary.shared_samples / total));
  property("Uncovered skin", in_mm2(summary.skin_area - summary.used_area));
  property("Largest angle", fmt::format("{:g}\u00b0", layout.receptive_field.max_angle_deg));
  property("Reading is", std::string(to_word(layout.readout.aggregate)));
  end_properties();
}

void draw_material(WindowUi& ui, const Layout& layout) {
  if (!header(ui, "Material") || !begin_properties("material")) return;
  const Material& m = layout.material;
  property("Field", std::string(to_word(m.field)));
  property("Modulus", fmt::format("{:.4g} kPa", 1e-3 * m.modulus));
  property("Thickness", m.thickness > 0 ? in_mm(m.thickness) : "from the size");
  property("Dissipation", fmt::format("{:g} s/m", m.dissipation));
  property("Friction", fmt::format("{:g}", m.friction));
  if (!m.law.is_linear()) property("Pressure law", to_text(m.law));
  if (m.faces == FaceRule::all) property("Faces", "all");
  if (m.tangential_stiffness > 0)
    property("Sticks with", fmt::format("{:.4g} kPa/mm, {} bristles", 1e-6 * m.tangential_stiffness, m.bristles));
  end_properties();
}

void draw_scene(WindowUi& ui, const Viewer& viewer, const Shown& shown) {
  if (!shown.run.frame || !shown.run.frame->scene || !header(ui, "Scene") || !begin_properties("scene")) return;
  const SimScene& scene = *shown.run.frame->scene;
  property("Geoms", std::to_string(scene.geoms.size()));
  property("Time step", fmt::format("{:g} ms", 1e3 * scene.timestep));
  if (scene.duration > 0) property("Duration", fmt::format("{:.2f} s", scene.duration));
  if (const SensorStep* sensor = shown.sensor(viewer)) {
    property("Force (N)",
             fmt::format("{:.3f}, {:.3f}, {:.3f}", sensor->force_W.x, sensor->force_W.y, sensor->force_W.z));
    const Layout& layout = scene.sensors[static_cast<std::size_t>(viewer.selection.sensor)]->layout;
    if (layout.readout.aggregate == Aggregate::force)
      property("No taxel feels", fmt::format("{:.3f} N", glm::length(sensor->uncovered_W)));
    double area = 0, largest = 0;
    for (const ContactSurface& surface : sensor->surfaces) {
      area += surface.area();
      largest = std::max(largest, surface.max_pressure());
    }
    property("Contact area", in_mm2(area));
    property("Largest pressure", in_kpa(largest));
  }
  end_properties();
}

void draw_inspector(App& app) {
  WindowUi& ui = *app.ui;
  Viewer& viewer = *app.viewer;
  const Shown& shown = *app.shown;
  const ModelSummary& summary = app.get<ModelSummary>();
  if (begin_panel(ui, kInspector.title, &app.get<PanelsShown>()[kInspector])) {
    const SensorModelPtr model = shown.model(viewer);
    if (model) {
      const bool edited = shown.shows_edited(viewer);
      draw_taxel(ui, viewer, shown, summary, *model);
      if (viewer.mode == Mode::layout)
        draw_mesh_section(ui, viewer, shown.document, app.get<MeshState>(), app.get<FollowState>(),
                          app.get<PanelsShown>(), *model);
      if (edited) {
        draw_subtaxels_of_selected(ui, viewer.selection, *shown.document.editing.project);
        draw_problem_list(ui, viewer.selection, shown.document, app.get<LayoutProblems>(), app.get<Messages>());
        draw_layout_settings(ui, shown.document, summary, app.get<MaterialState>());
      } else {
        draw_sampling(ui, summary, *model);
        draw_material(ui, model->layout);
      }
    }
    if (shows_run(viewer.mode)) {
      draw_scene(ui, viewer, shown);
      draw_scenario_section(ui, viewer, shown, app.get<PathState>(), app.get<Messages>());
    }
    if (!model && !shown.run.frame) ImGui::TextDisabled("%s", shown.empty_text());
  }
  ImGui::End();
}

/// Finds the problems of the edited layout, also if it cannot be compiled, and the numbers about the displayed one.
void update_findings(App& app) {
  if (app.get<ModelSummary>().model != app.shown->model(*app.viewer))
    app.get<ModelSummary>() = summarize(app.shown->model(*app.viewer));
  const Editing& editing = app.shown->document.editing;
  LayoutProblems& problems = app.get<LayoutProblems>();
  if (!editing.project || !app.shown->document.model) {
    problems = {};
  } else if (problems.project != editing.project || problems.model != app.shown->document.model ||
             problems.compiled != editing.compiled) {
    problems = layout_problems(editing.project, app.shown->document.model, editing.compiled, editing.mesh_sha256);
  }
}

}  // namespace

constinit const Feature kInspector{
    .title = "Inspector",
    .dock = Dock::inspector,
    .in_front = true,
    .opens = Opens::by_user,
    .open = true,
    .key = "panel_inspector",
    .label = "Inspector",
    .draw = [](App& app) { draw_inspector(app); },
    .parts = inspector_parts,
    .guide = "Author a layout",
    .begin_frame = update_findings,
    .dump = dump_inspector,
};

}  // namespace taxel::ui
