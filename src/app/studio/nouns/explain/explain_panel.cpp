#include "app/studio/nouns/explain/explain.h"

#include <fmt/format.h>
#include <imgui.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain_job.h"
#include "app/studio/nouns/explain/explain_plots.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/explain/explain_tables.h"
#include "app/studio/nouns/explain/explain_tool.h"
#include "app/studio/nouns/explain/hunt.h"
#include "app/studio/nouns/explain/hunt_state.h"
#include "app/studio/nouns/explain/remedy.h"
#include "core/sensor/explain/behind/back_faces_behind.h"
#include "ui/scene/scene_input.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"

namespace taxel::ui {
namespace {

/// Returns the change with its sign and unit.
std::string change_text(double change, const ReadingUnit& unit) {
  return fmt::format("{:+.3g} {}", unit.scale * change, unit.text);
}

std::string newtons(double force) {
  return fmt::format("{:.4g} N", force);
}
std::string newtons(const dvec3& force) {
  return fmt::format("{:.3g}, {:.3g}, {:.3g} N", force.x, force.y, force.z);
}

/// Returns the colour of a cause. Causes that are artefacts of the method have the colour of warnings.
const ImVec4& color_of(Cause cause, const Palette& colors) {
  const bool method = cause == Cause::sampling_noise || cause == Cause::star_field || cause == Cause::inverted_tets ||
                      cause == Cause::cone || cause == Cause::mesh_edges;
  return cause == Cause::none ? colors.dim : method ? severity_color(colors, Severity::warning) : colors.accent;
}

void draw_verdict(WindowUi& ui, const RunView& run, const Explanation& e) {
  const Palette& colors = palette(ui.dark);
  const std::string name = e.name.empty() ? "" : " (" + e.name + ")";
  caption(fmt::format("Taxel {}{}, step {}, {:.6g} s", e.id, name, run.frame->step, e.time).c_str());
  if (!e.change) {
    ImGui::PushTextWrapPos();
    ImGui::TextDisabled("There is no step before this one of the same layout: nothing to compare with.");
    ImGui::PopTextWrapPos();
    return;
  }
  const ImVec2 top = ImGui::GetCursorScreenPos();
  ImGui::Indent(8);
  ImGui::PushTextWrapPos();
  ImGui::TextUnformatted(e.change->verdict.text.c_str());
  ImGui::PopTextWrapPos();
  ui.widgets.note_item("Verdict");
  ImGui::Unindent(8);
  const float bottom = ImGui::GetItemRectMax().y;
  ImGui::GetWindowDrawList()->AddRectFilled(top, ImVec2(top.x + 3, bottom),
                                            to_u32(color_of(e.change->verdict.cause, colors)));
}

/// Draws the button that applies the remedy, if there is one, with its text or the reason why it cannot be applied.
void draw_remedy(WindowUi& ui, const Shown& shown, ExplainState& explain, const Explanation& e) {
  const ProjectPtr& project = shown.document.editing.project;
  const std::optional<Remedy> remedy = project ? remedy_of(e, project->layout) : std::nullopt;
  if (!remedy) return;
  const std::string blocked = remedy_blocked(shown);
  ImGui::BeginDisabled(!blocked.empty());
  if (button(ui, "Fix it")) apply_remedy(ui, shown, explain, *remedy);
  ImGui::EndDisabled();
  tooltip(blocked.empty() ? "Changes the layout and runs again from the start. Ctrl+Z takes it back." : blocked);
  ImGui::SameLine();
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("%s", remedy->text.c_str());
  ImGui::PopTextWrapPos();
}

/// Draws a property row for an exact reading. `text` is the exact reading with its unit.
void property_exact(const char* name, const ExactReading& exact, const std::string& text, const ReadingUnit& unit) {
  property(name, exact.value ? fmt::format("{} \xc2\xb1 {:.1g}", text, unit.scale * exact.error) : "there is none");
  if (!exact.value) tooltip(exact.missing);
}

void draw_exact(WindowUi& ui, const Explanation& e, const ReadingUnit& unit) {
  if (!header(ui, "Exact and sampled") || !begin_properties("exact")) return;
  const NumberPair readings = pair_in_unit(e.reading, e.change ? e.change->reading.before : e.reading, unit);
  const double exact = e.exact.value.value_or(0);
  const double exact_before = e.exact_before ? e.exact_before->value.value_or(exact) : exact;
  const NumberPair exacts = pair_in_unit(exact, exact_before, unit);
  property("Reading", readings.first);
  property_exact("Exact integral", e.exact, exacts.first, unit);
  if (e.change) property("Reading before", readings.second);
  if (e.exact_before) property_exact("Exact before", *e.exact_before, exacts.second, unit);
  end_properties();
}

void draw_change(WindowUi& ui, const Explanation& e, const ReadingUnit& unit) {
  if (!e.change || !header(ui, "Change since the step before") || !begin_properties("change")) return;
  const StepChange& c = *e.change;
  property("Reading", change_text(c.verdict.change, unit));
  property("by samples", change_text(c.verdict.noise, unit));
  property("by the field", change_text(c.verdict.field, unit));
  property("by the angle limit", change_text(c.verdict.cone, unit));
  property("by mesh edges", change_text(c.verdict.edges, unit));
  property("by the contact", change_text(c.verdict.contact, unit));
  const auto samples = [&](const char* name, const SampleChange& s) {
    property(name, fmt::format("{} samples, {}", s.count, change_text(s.change, unit)));
  };
  samples("Samples gained", c.began);
  samples("Samples lost", c.ceased);
  samples("Samples kept", c.stayed);
  constexpr int kForceDigits = 4;
  const NumberPair forces = number_pair(c.force.before, c.force.now, kForceDigits);
  property("Force", fmt::format("{} to {} N", forces.first, forces.second));
  end_properties();
}

void draw_budget(WindowUi& ui, const ForceBudget& b) {
  if (!header(ui, "Force budget") || !begin_properties("budget")) return;
  property("Surfaces", newtons(b.surfaces_W));
  property("Taxels together", newtons(b.taxels_W));
  property("This taxel", newtons(b.taxel_W));
  property("As simulated", newtons(b.net_W));
  property("Normal force", newtons(b.pressed));
  property("inside fields", newtons(b.covered));
  property("outside fields", newtons(b.uncovered));
  end_properties();
}

void draw_found(WindowUi& ui, Overlays& overlays, const Shown& shown, ExplainState& explain, const Explanation& e) {
  const ReadingUnit unit = shown_unit(e.aggregate);
  draw_verdict(ui, shown.run, e);
  draw_remedy(ui, shown, explain, e);
  checkbox(ui, "Onion skin (previous step)", &overlays.ghost);
  tooltip("Its contact surfaces, as lines in the view");
  draw_exact(ui, e, unit);
  if (const std::string back = back_faces_text(e); !back.empty()) ImGui::TextWrapped("%s", back.c_str());
  draw_change(ui, e, unit);
  if (header(ui, "Convergence")) draw_convergence(ui, e);
  if (header(ui, "Polygons")) {
    draw_scatter(ui, explain, e);
    draw_polygons(ui, explain, e);
  }
  if (header(ui, "Samples")) draw_samples(ui, e);
  draw_budget(ui, e.budget);
}

/// Returns the reason why there is no explanation to show.
std::string reason(const Viewer& viewer, const Shown& shown, const ExplainState& explain) {
  if (shown.sensor(viewer) == nullptr) return "No sensor is simulated.";
  if (viewer.selection.empty()) return "Click a bar or a taxel: its reading is explained, in the step that is shown.";
  if (explain.explained && !explain.explained->problem.empty()) return explain.explained->problem;
  return shown.run.playing ? "Pause, and the reading is explained." : "The reading is being explained ...";
}

void draw_explain_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, ExplainState& explain, bool& open) {
  if (explain.wants_focus) ImGui::SetNextWindowFocus();
  explain.wants_focus = false;
  if (shown.run.frame && shown.run.frame->step != explain.step) explain.polygon.reset();  // of another step
  if (shown.run.frame) explain.step = shown.run.frame->step;
  if (begin_panel(ui, kExplain.title, &open)) {
    if (const Explanation* found = shown_explanation(viewer, shown, explain, open)) {
      draw_found(ui, viewer.overlays(), shown, explain, *found);
    } else {
      ImGui::PushTextWrapPos();
      ImGui::TextDisabled("%s", reason(viewer, shown, explain).c_str());
      ImGui::PopTextWrapPos();
    }
  }
  ImGui::End();
}

void mark_explained(const App& app, SceneInput& scene) {
  if (app.viewer->mode != Mode::simulate || !app.get<PanelsShown>()[kExplain]) return;
  if (app.shown->run.frame && app.viewer->overlays().ghost) scene.before = app.shown->run.frame->before;
  if (const auto& polygon = app.get<ExplainState>().polygon) {
    scene.marked_surface = polygon->surface;
    scene.marked_polygon = polygon->polygon;
  }
}

}  // namespace

constinit const Feature kExplain{
    .title = "Explain",
    .dock = Dock::inspector,
    .opens = Opens::by_user,
    .key = "panel_explain",
    .label = "Explain panel",
    .context = kSimulate,
    .draw =
        [](App& app) {
          draw_explain_panel(*app.ui, *app.viewer, *app.shown, app.get<ExplainState>(),
                             app.get<PanelsShown>()[kExplain]);
        },
    .end_panels =
        [](App& app) {
          follow_hunt(*app.viewer, *app.shown, app.get<HuntState>(), app.get<ExplainState>(),
                      app.get<PanelsShown>()[kExplain]);
          rerun_after_remedy(*app.ui, *app.shown, app.get<ExplainState>());
        },
    .mark = mark_explained,
    .make_job = studio::make_explain_job,
    .dump = dump_explanation,
};

}  // namespace taxel::ui
