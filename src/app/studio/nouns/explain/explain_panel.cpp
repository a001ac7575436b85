// The panel that explains a reading: diagnosis, samples, polygons, other numbers of samples, and where the force goes.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui.h>
#include <implot.h>

#include <algorithm>
#include <array>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/explain/explain_state.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/plot/plot_state.h"
#include "core/base/text/rounded.h"
#include "core/document/edit.h"
#include "core/sensor/explain/explanation.h"
#include "ui/scene/scene_input.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/format.h"
#include "ui/widgets/plot_curves.h"

namespace taxel::ui {

namespace {

constexpr int kRowsShown = 8;  // further rows are reached by scrolling

template <std::size_t N>
bool begin_rows(const char* id, const std::array<const char*, N>& heads, std::size_t rows) {
  const float height = ImGui::GetTextLineHeightWithSpacing() *
                       static_cast<float>(1 + std::min(rows, static_cast<std::size_t>(kRowsShown)));
  constexpr auto kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingStretchProp;
  if (!ImGui::BeginTable(id, static_cast<int>(N), kFlags, ImVec2(0, height + 4))) return false;
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const char* head : heads) ImGui::TableSetupColumn(head);
  ImGui::TableHeadersRow();
  return true;
}

void cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

bool is(const PolygonBehind& p, const std::optional<PolygonNumber>& number) {
  return number && p.surface == number->surface && p.polygon == number->polygon;
}

void draw_selected(const PolygonBehind& p) {
  if (!begin_properties("polygon")) return;
  property("Polygon", fmt::format("{} of surface {}", p.polygon, p.surface));
  property("Area", in_mm2(p.area));
  property("Pressure", fmt::format("{} to {}, mean {}", in_kpa(p.lowest), in_kpa(p.highest), in_kpa(p.mean)));
  property("Of the force", rounded(100 * p.force_share, 3, 2) + " %");
  property("Of the reading",
           fmt::format("{} %, exactly {} %", rounded(100 * p.share, 3, 2), rounded(100 * p.exact_share, 3, 2)));
  property("Tet", p.tet < 0 ? "none" : fmt::format("{}{}", p.tet, p.inverted ? ", inside out" : ""));
  property("Serves", p.taxels.empty() ? "no taxel" : fmt::format("taxels {}", fmt::join(p.taxels, ", ")));
  end_properties();
}

void draw_row(WindowUi& ui, ExplainState& explain, const PolygonBehind& p) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  const std::string label = fmt::format("{}/{}", p.surface, p.polygon);
  if (ImGui::Selectable((label + "##polygon").c_str(), is(p, explain.polygon), ImGuiSelectableFlags_SpanAllColumns))
    explain.polygon = PolygonNumber{p.surface, p.polygon};
  ui.widgets.note_item("Polygon " + label);
  cell(fmt::format("{:.2f}", 100 * p.share));
  cell(fmt::format("{:.3f}", 1e6 * p.area));
  cell(rounded(1e-3 * p.mean, 4, 4));
  cell(fmt::format("{:.2f}", 100 * p.force_share));
}

/// Draws the table of the polygons that contribute to the taxel, and the selected polygon. A click selects a polygon.
void draw_polygons(WindowUi& ui, ExplainState& explain, const Explanation& e) {
  std::vector<const PolygonBehind*> rows;
  const PolygonBehind* selected = nullptr;
  for (const PolygonBehind& p : e.polygons) {
    if (is(p, explain.polygon)) selected = &p;
    if (p.samples > 0 || p.exact_share > 0) rows.push_back(&p);
  }
  std::stable_sort(rows.begin(), rows.end(), [](auto* a, auto* b) { return a->share > b->share; });
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  caption(fmt::format("{} of {} polygons in its field", rows.size(), e.polygons.size()).c_str());
  if (selected != nullptr) draw_selected(*selected);
  constexpr std::array kHeads{"Polygon", "Share %", "mm\xc2\xb2", "kPa", "Force %"};
  if (!rows.empty() && begin_rows("polygons", kHeads, rows.size())) {
    for (const PolygonBehind* p : rows) draw_row(ui, explain, *p);
    ImGui::EndTable();
  }
  ImGui::PopFont();
}

/// Draws the table of the samples that hit a polygon, in the explained step or the previous step.
void draw_samples(WindowUi& ui, const Explanation& e) {
  std::vector<std::size_t> rows;
  const auto hit_before = [&](std::size_t i) { return !e.samples_before.empty() && e.samples_before[i].hit; };
  for (std::size_t i = 0; i < e.samples.size(); ++i)
    if (e.samples[i].hit || hit_before(i)) rows.push_back(i);
  std::stable_sort(rows.begin(), rows.end(),
                   [&](std::size_t a, std::size_t b) { return e.samples[a].share > e.samples[b].share; });
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  caption(fmt::format("{} of {} samples hit, now or before: share in %, depth in mm, weight in mm\xc2\xb2", rows.size(),
                      e.samples.size())
              .c_str());
  ui.widgets.note_item("Samples caption");
  constexpr std::array kHeads{"No.", "Share", "Depth", "kPa", "Before", "Weight"};
  if (!rows.empty() && begin_rows("samples", kHeads, rows.size())) {
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()));
    while (clipper.Step()) {
      for (int r = clipper.DisplayStart; r < clipper.DisplayEnd; ++r) {
        const std::size_t i = rows[static_cast<std::size_t>(r)];
        const TaxelSampleReading& s = e.samples[i];
        ImGui::TableNextRow();
        cell(fmt::format("{}", s.sample));
        cell(fmt::format("{:.2f}", 100 * s.share));
        cell(s.hit ? fmt::format("{:.3f}", 1e3 * s.depth) : "miss");
        cell(rounded(1e-3 * s.pressure, 4, 4));
        cell(hit_before(i) ? rounded(1e-3 * e.samples_before[i].pressure, 4, 4) : "miss");
        cell(rounded(1e6 * s.weight, 3, 6));
      }
    }
    ImGui::EndTable();
  }
  ImGui::PopFont();
}

constexpr float kPlotLines = 7.5f;  // height of a plot, in lines of text
constexpr auto kPlotFlags = ImPlotFlags_NoTitle | ImPlotFlags_NoMenus | ImPlotFlags_NoBoxSelect |
                            ImPlotFlags_NoMouseText | ImPlotFlags_NoLegend;
constexpr auto kAxisFlags = ImPlotAxisFlags_NoMenus | ImPlotAxisFlags_NoHighlight | ImPlotAxisFlags_Lock;

bool begin_plot(const char* id) {
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const ImVec2 size(ImGui::GetContentRegionAvail().x, kPlotLines * ImGui::GetTextLineHeight());
  if (ImPlot::BeginPlot(id, size, kPlotFlags)) return true;
  ImGui::PopFont();
  return false;
}
void end_plot() {
  ImPlot::EndPlot();
  ImGui::PopFont();
}

void plot_level(const char* id, double y, const ImVec4& color) {
  ImPlotSpec spec;
  spec.LineColor = color;
  spec.LineWeight = 1.2f;
  spec.Flags = ImPlotInfLinesFlags_Horizontal;
  ImPlot::PlotInfLines(id, &y, 1, spec);
}

/// Areas [mm^2] and mean pressures [kPa] of a group of polygons.
struct Dots {
  std::vector<double> area, pressure;
  void add(const PolygonBehind& p) {
    area.push_back(1e6 * p.area);
    pressure.push_back(1e-3 * p.mean);
  }
};

void plot_dots(const char* id, const Dots& dots, const ImVec4& color, float size) {
  ImPlotSpec spec;
  spec.LineColor = color;
  spec.Marker = ImPlotMarker_Circle;
  spec.MarkerSize = size;
  spec.MarkerFillColor = color;
  ImPlot::PlotScatter(id, dots.area.data(), dots.pressure.data(), static_cast<int>(dots.area.size()), spec);
}

/// Selects the polygon whose dot is nearest to a click, within a few pixels.
void pick_dot(ExplainState& explain, const Explanation& e) {
  constexpr float kReach = 12;
  if (!plot_clicked()) return;
  const ImVec2 mouse = ImGui::GetMousePos();
  float nearest = kReach * kReach;
  for (const PolygonBehind& p : e.polygons) {
    const ImVec2 dot = ImPlot::PlotToPixels(1e6 * p.area, 1e-3 * p.mean);
    const float dx = dot.x - mouse.x, dy = dot.y - mouse.y, away = dx * dx + dy * dy;
    if (!(away < nearest)) continue;
    nearest = away;
    explain.polygon = PolygonNumber{p.surface, p.polygon};
  }
}

/// Draws the reading against the number of samples, together with the exact integral.
void draw_convergence(WindowUi& ui, const Explanation& e) {
  if (!e.levels) {
    caption(e.no_levels.c_str());
    return;
  }
  const ReadingUnit unit = shown_unit(e.aggregate);
  const Palette& colors = palette(ui.dark);
  std::array<double, 3> x{}, y{};
  double lo = std::numeric_limits<double>::infinity(), hi = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = e.levels->samples[i];
    y[i] = unit.scale * e.levels->now[i];
    lo = std::min(lo, y[i]), hi = std::max(hi, y[i]);
  }
  const double exact = e.exact.value ? unit.scale * *e.exact.value : y[1];
  lo = std::min(lo, exact), hi = std::max(hi, exact);
  const double room = std::max(0.15 * (hi - lo), 0.02 * std::max(hi, 1e-9));
  caption("Reading by number of samples; the line is the exact one");
  if (!begin_plot("##convergence")) return;
  ImPlot::SetupAxes(nullptr, unit.text, kAxisFlags, kAxisFlags);
  ImPlot::SetupAxisScale(ImAxis_X1, ImPlotScale_Log10);
  ImPlot::SetupAxisLimits(ImAxis_X1, 0.7 * std::max(1.0, x[0]), 1.4 * std::max(1.0, x[2]), ImPlotCond_Always);
  std::array<std::string, 3> counts;
  std::array<const char*, 3> labels{};
  for (std::size_t i = 0; i < counts.size(); ++i) labels[i] = (counts[i] = grouped(e.levels->samples[i])).c_str();
  ImPlot::SetupAxisTicks(ImAxis_X1, x.data(), static_cast<int>(x.size()), labels.data());
  ImPlot::SetupAxisLimits(ImAxis_Y1, lo - room, hi + room, ImPlotCond_Always);
  ImPlot::SetupFinish();
  if (e.exact.value) plot_level("##exact", exact, colors.path);
  ImPlotSpec spec;
  spec.LineColor = colors.text;
  spec.LineWeight = 1.4f;
  spec.Marker = ImPlotMarker_Circle;
  ImPlot::PlotLine("##readings", x.data(), y.data(), static_cast<int>(x.size()), spec);
  end_plot();
  ui.widgets.note_item("Convergence plot");
}

/// Draws the area against the pressure of all polygons. A click selects the nearest polygon.
void draw_scatter(WindowUi& ui, ExplainState& explain, const Explanation& e) {
  if (e.polygons.empty()) return;
  const Palette& colors = palette(ui.dark);
  Dots others, serving, selected;
  double area = 0, pressure = 0;
  for (const PolygonBehind& p : e.polygons) {
    (p.samples > 0 || p.exact_share > 0 ? serving : others).add(p);
    if (explain.polygon == PolygonNumber{p.surface, p.polygon}) selected.add(p);
    area = std::max(area, 1e6 * p.area), pressure = std::max(pressure, 1e-3 * p.mean);
  }
  if (!begin_plot("##scatter")) return;
  ImPlot::SetupAxes("area (mm\xc2\xb2)", "kPa", kAxisFlags, kAxisFlags);
  ImPlot::SetupAxisLimits(ImAxis_X1, 0, 1.08 * area, ImPlotCond_Always);
  ImPlot::SetupAxisLimits(ImAxis_Y1, 0, 1.08 * pressure, ImPlotCond_Always);
  ImPlot::SetupFinish();
  plot_dots("##others", others, colors.dim, 1.6f);
  plot_dots("##serving", serving, colors.accent, 2.4f);
  plot_dots("##selected", selected, colors.text, 5.0f);
  pick_dot(explain, e);
  const ImVec2 lo = ImPlot::GetPlotPos(), size = ImPlot::GetPlotSize();
  ui.widgets.note(kExplain.title, "Scatter dots", {lo.x, lo.y, lo.x + size.x, lo.y + size.y});
  end_plot();
  ui.widgets.note_item("Scatter");
}

/// Returns the change with its sign and unit.
std::string change_text(double change, const ReadingUnit& unit) {
  return change_in_unit(change, unit);
}

std::string newtons(double force) {
  return in_newtons(force);
}
std::string newtons(const dvec3& force) {
  return fmt::format("{}, {}, {} N", rounded(force.x, 3, 4), rounded(force.y, 3, 4), rounded(force.z, 3, 4));
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
void draw_remedy(WindowUi& ui, const Shown& shown, PlotState& plot, RunAhead& ahead, const Explanation& e,
                 const PlotCloseUp& explained) {
  const ProjectPtr& project = shown.document.editing.project;
  const std::optional<Remedy> remedy = project ? remedy_of(e, project->layout) : std::nullopt;
  if (!remedy) return;
  const std::string blocked = remedy_blocked(shown);
  ImGui::BeginDisabled(!blocked.empty());
  if (button(ui, "Fix it")) {
    plot.before = readings_before(shown.run, explained.key, apply_edit(*project, remedy->edit).layout);
    plot.close_up = explained;
    apply_remedy(ui, shown, ahead, *remedy);
  }
  ImGui::EndDisabled();
  tooltip(blocked.empty() ? "Changes the layout, makes the same run again, and shows this step with the curves before "
                            "and after. Ctrl+Z takes it back."
                          : blocked);
  ImGui::SameLine();
  ImGui::PushTextWrapPos();
  ImGui::TextDisabled("%s", remedy->text.c_str());
  ImGui::PopTextWrapPos();
}

/// Draws a property row for an exact reading. `text` is the exact reading with its unit.
void property_exact(const char* name, const ExactReading& exact, const std::string& text, const ReadingUnit& unit) {
  property(name, exact.value ? fmt::format("{} \xc2\xb1 {}", text, rounded(unit.scale * exact.error, 1, 6))
                             : "there is none");
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
    property(name, fmt::format("{}, {}", counted(static_cast<std::size_t>(s.count), "sample", "samples"),
                               change_text(s.change, unit)));
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

/// Draws the button for the step of the run that is most worth an explanation.
void draw_way_to_largest(WindowUi& ui) {
  if (button(ui, "Largest change of the run")) ui.post(ShowAnswer{&kExplain});
  tooltip("Goes to ANALYSE, to the step in which a reading changes most");
}

void draw_found(WindowUi& ui, Viewer& viewer, const Shown& shown, ExplainState& explain, const Explanation& e,
                PlotState& plot, bool& plot_is_open, RunAhead& ahead) {
  constexpr const char* kOnion = "Onion skin (previous step)";
  Overlays& overlays = viewer.overlays();
  const ReadingUnit unit = shown_unit(e.aggregate);
  const PlotCloseUp explained{{viewer.selection.sensor, e.id}, shown.run.frame->step};
  draw_verdict(ui, shown.run, e);
  draw_remedy(ui, shown, plot, ahead, e, explained);
  if (e.change && e.change->verdict.cause == Cause::none) draw_way_to_largest(ui);
  if (e.change) {
    if (button(ui, "Show in the plot")) {
      plot.close_up = explained;
      ui.open_in_front(plot_is_open);
    }
    tooltip("Magnifies the plot around this step, with the exact readings behind it");
    ImGui::SameLine();
    const float wanted = ImGui::GetFrameHeightWithSpacing() + ImGui::CalcTextSize(kOnion).x;
    if (ImGui::GetContentRegionAvail().x < wanted) ImGui::NewLine();
  }
  checkbox(ui, kOnion, &overlays.ghost);
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

void draw_explain_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, ExplainState& explain, PlotState& plot,
                        RunAhead& ahead, PanelsShown& panels) {
  bool& open = panels[kExplain];
  if (explain.wants_focus) ImGui::SetNextWindowFocus();
  explain.wants_focus = false;
  if (shown.run.frame && shown.run.frame->step != explain.step) explain.polygon.reset();  // of another step
  if (shown.run.frame) explain.step = shown.run.frame->step;
  if (begin_panel(ui, kExplain.title, &open)) {
    if (const Explanation* found = shown_explanation(viewer, shown, explain, open)) {
      draw_found(ui, viewer, shown, explain, *found, plot, panels[kPlot], ahead);
    } else {
      ImGui::PushTextWrapPos();
      ImGui::TextDisabled("%s", reason(viewer, shown, explain).c_str());
      ImGui::PopTextWrapPos();
      if (shown.run.has_history() && viewer.selection.empty()) draw_way_to_largest(ui);
    }
  }
  ImGui::End();
}

void mark_explained(const App& app, SceneInput& scene) {
  if (!shows_run(app.viewer->mode) || !is_in_use(kExplain, app)) return;
  if (app.shown->run.frame && app.viewer->overlays().ghost) scene.before = app.shown->run.frame->before;
  if (const auto& polygon = app.get<ExplainState>().polygon) {
    scene.marked_surface = polygon->surface;
    scene.marked_polygon = polygon->polygon;
  }
}

std::vector<PanelPart> explain_parts() {
  constexpr auto kWhyNot = [](const App& app) -> const char* {
    return app.shown->run.has_history() ? nullptr : "No step is recorded yet";
  };
  return {{"Fix it", "", "Apply the remedy of the diagnosis and run again", kSimulate, kWhyNot},
          {"Convergence", "", "Reading with fewer and with more samples", kSimulate, kWhyNot},
          {"Force budget", "", "How the contact force divides among the taxels", kSimulate, kWhyNot},
          {"Polygons", "", "Polygons of the contact that make the reading", kSimulate, kWhyNot},
          {"Exact and sampled", "", "Reading and its exact integral", kSimulate, kWhyNot}};
}

}  // namespace

constinit const Feature kExplain{
    .title = "Explain",
    .dock = Dock::inspector,
    .opens = Opens::by_user,
    .key = "panel_explain",
    .label = "Explain",
    .context = kSimulate,
    .draw =
        [](App& app) {
          draw_explain_panel(*app.ui, *app.viewer, *app.shown, app.get<ExplainState>(), app.get<PlotState>(),
                             app.get<RunAhead>(), app.get<PanelsShown>());
        },
    .parts = explain_parts,
    .guide = "Find why a taxel jumps",
    .analyse = {.tab = 5, .question = "Why did a reading jump?", .answer = answer_why_it_jumped, .magnifies = true},
    .end_panels =
        [](App& app) {
          end_message_of_run(app);
          answer_at_first_sight(app);
          if (advance_run_ahead(*app.ui, *app.shown, app.get<RunAhead>())) show_result(app);
        },
    .mark = mark_explained,
    .hint = [](const App& app,
               std::vector<ViewHint>& lines) { lines.push_back({run_ahead_hint(*app.shown, app.get<RunAhead>())}); },
    .make_job = studio::make_explain_job,
    .dump = dump_explanation,
};

}  // namespace taxel::ui
