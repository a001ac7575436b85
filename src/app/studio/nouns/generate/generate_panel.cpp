// The panel that generates many taxels at once: a pattern, its parameters, and a live preview in the view.
#include "app/studio/nouns/generate/generate_state.h"

#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>
#include <type_traits>

#include "app/studio/frame/app.h"
#include "app/studio/frame/feature.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/shown_scene.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/demo/demo_state.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/files/file_dialog_state.h"
#include "app/studio/nouns/generate/pattern_job.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "ui/scene/scene_input.h"
#include "ui/theme.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"
#include "ui/widgets/format.h"

namespace taxel::ui {

namespace {

constexpr FieldUnit kWhole{"", 0, 0};

void draw_field(WindowUi& ui, GenerateState& /*generate*/, const FieldSpec& field, double& value) {
  const bool angle = field.quantity == FieldQuantity::angle;
  const std::string name = angle ? std::string(field.label) + " (deg)" : label_with_unit(field);
  begin_property(name.c_str(), field.help);
  if (const auto typed = number_field(ui, name, {value}, field_unit(field.quantity, angle ? 1 : 2))) value = *typed;
  tooltip(field.help);
}

/// Draws the field of a whole number. Refuses fractions; make_pattern() checks the range.
template <class Int>
requires std::is_same_v<Int, int> || std::is_same_v<Int, std::uint64_t>
void draw_field(WindowUi& ui, GenerateState& generate, const FieldSpec& field, Int& value) {
  begin_property(field.label, field.help);
  const auto typed = number_field(ui, field.label, {static_cast<double>(value)}, kWhole);
  tooltip(field.help);
  if (!typed) return;
  const double least = std::is_signed_v<Int> ? -1e9 : 0.0, most = 2e9;
  if (*typed == std::floor(*typed) && *typed >= least && *typed <= most) {
    value = static_cast<Int>(*typed);
  } else {
    generate.file_problem = fmt::format("{}: must be a whole number, is {:g}", field.label, *typed);
  }
}

void draw_field(WindowUi& ui, GenerateState& /*generate*/, const FieldSpec& field, bool& value) {
  begin_property(field.label, field.help);
  if (const auto made = switch_field(ui, field.label, value)) value = *made;
  tooltip(field.help);
}

template <class Choice>
requires std::is_enum_v<Choice>
void draw_field(WindowUi& ui, GenerateState& /*generate*/, const FieldSpec& field, Choice& value) {
  begin_property(field.label, field.help);
  ImGui::PushID(field.label);
  Flow flow(2);
  for (const Word<Choice>& word : words_of(value)) {
    flow.next(ImGui::CalcTextSize(word.text.data()).x + 2 * ImGui::GetStyle().FramePadding.x);
    if (small_choice(ui, word.text.data(), value == word.value)) value = word.value;
  }
  ImGui::PopID();
}

void draw_field(WindowUi& /*ui*/, GenerateState& /*generate*/, const FieldSpec& /*field*/, std::string& /*preset*/) {
  // draw_presets() draws the names over the whole width.
}

void draw_region(WindowUi& ui, const DocumentView& document) {
  const bool painted = !document.editing.project->layout.sampling.region->empty();
  begin_property("Over", "The painted region, or the whole skin where nothing is painted");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(painted ? "the painted region" : "the whole skin");
  begin_property("", "");
  if (button(ui, "Paint...")) ui.post(ToggleTool{Tool::brush});
  tooltip("Take the brush (Q), and paint where taxels shall be");
}

void draw_file(WindowUi& ui, FileDialog& dialog, std::string& path, const char* hint) {
  begin_property("File", "Type a path, choose one, or drop the file on the window");
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint("##file", hint, &path, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note_item("File");
  if (!path.empty()) tooltip(path);
  if (entered && !path.empty()) ui.post(ReadPoints{path});
  begin_property("", "");
  if (button(ui, "Browse...")) {
    begin_dialog(dialog, FileTask::read_points);
    ui.post(ListFolder{dialog.folder});
  }
}

void wrapped(const char* head, const std::string& text) {
  ImGui::TextDisabled("%s", head);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

/// Draws the presets over the whole width, because titles and sources are long.
void draw_presets(WindowUi& ui, const GenerateState& generate, std::string& chosen) {
  for (const PresetNote& note : generate.presets) {
    if (selectable(ui, note.title.c_str(), chosen == note.name)) chosen = note.name;
    tooltip(note.source);
  }
  for (const PresetNote& note : generate.presets) {
    if (note.name != chosen) continue;
    ImGui::Spacing();
    wrapped("Source", note.source);
    wrapped("Unverified", note.unverified);
  }
}

void draw_pattern_fields(WindowUi& ui, const DocumentView& document, GenerateState& generate, FileDialog& dialog) {
  Pattern& pattern = generate.pattern;
  if (auto* preset = std::get_if<patterns::Preset>(&pattern.shape)) draw_presets(ui, generate, preset->name);
  constexpr float kNames = 0.57f;  // share of the names, so that "Column pitch (mm)" has one line
  if (!ImGui::BeginTable("pattern", 2, ImGuiTableFlags_SizingStretchProp)) return;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthStretch, kNames);
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch, 1 - kNames);
  if (has_region(pattern)) draw_region(ui, document);
  if (pattern.is<patterns::Table>()) draw_file(ui, dialog, generate.table_path, "points.csv");
  if (pattern.is<patterns::Image>()) draw_file(ui, dialog, generate.image_path, "dots.png");
  visit_fields(pattern, [&](const FieldSpec& field, auto& value) { draw_field(ui, generate, field, value); });
  end_properties();
}

/// Returns the label of a kind: its word with a capital letter.
std::string label_of(std::string_view word) {
  std::string label(word);
  label[0] = static_cast<char>(std::toupper(label[0]));
  return label;
}

void draw_kinds(WindowUi& ui, GenerateState& generate) {
  constexpr std::size_t kPerRow = 4;
  for (std::size_t i = 0; i < generate.shapes.size(); ++i) {
    if (i % kPerRow != 0) ImGui::SameLine(0, 3);
    const auto draw = [&](const auto& kind) {
      const bool chosen = small_choice(ui, label_of(kind.kWord).c_str(), generate.pattern.shape.index() == i);
      tooltip(kind.kHelp);
      return chosen;
    };
    if (!std::visit(draw, generate.shapes[i])) continue;
    change_kind(generate, i);
    generate.file_problem.clear();
  }
}

std::string outcome_text(const GenerateState& g) {
  if (g.waiting()) return "Making the preview...";
  if (!g.ghosts) return "";
  std::string text =
      fmt::format("{} taxel{}", grouped(static_cast<long long>(g.ghosts->size())), g.ghosts->size() == 1 ? "" : "s");
  if (g.left_out > 0) text += fmt::format(", {} left out", grouped(g.left_out));
  if (g.least_distance > 0 && std::isfinite(g.least_distance))
    text += fmt::format(", {} or more apart", in_mm(g.least_distance));
  return text;
}

void draw_outcome(const GenerateState& generate) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(outcome_text(generate).c_str());
  ImGui::PopTextWrapPos();
}

void draw_problems(WindowUi& ui, const GenerateState& generate) {
  ImGui::PushTextWrapPos(0);
  for (const std::string& problem : {generate.file_problem, generate.waiting() ? std::string() : generate.problem}) {
    if (problem.empty()) continue;
    ImGui::TextColored(palette(ui.dark).error, "%s", problem.c_str());
    ui.widgets.note_item("Problem");
  }
  ImGui::PopTextWrapPos();
}

void draw_buttons(WindowUi& ui, Viewer& viewer, const Shown& shown, const ToolState& tool, GenerateState& generate,
                  const TourState& tour) {
  const ImVec2 size(7 * ImGui::GetFontSize(), 0);
  const bool ready = can_accept_generate(viewer, shown, generate);
  // Enter in a field only accepts the typed value of that field.
  const bool entered = ready && !ui.fields.had_keys && tool.tool == Tool::none && tour.step < 0 &&
                       ImGui::IsKeyPressed(ImGuiKey_Enter, false);
  ImGui::BeginDisabled(!ready);
  const bool accepted = button(ui, "Add taxels", size);
  tooltip("Adds them as one step (Enter)");
  ImGui::EndDisabled();
  ImGui::SameLine();
  const bool cancelled = button(ui, "Cancel", size);
  tooltip("Nothing is added (Esc)");
  if (accepted || entered) return accept_generate(ui, viewer, shown, generate);
  if (cancelled) close_generate(generate);
}

void draw_generate_panel(WindowUi& ui, Viewer& viewer, const Shown& shown, const ToolState& tool,
                         GenerateState& generate, const TourState& tour, FileDialog& dialog) {
  keep_preview_current(viewer, shown, generate);
  if (!generate.open) return;
  bool open = true;
  const float line = ImGui::GetFontSize();
  ImGui::SetNextWindowSize({22 * line, 32 * line}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowPos({viewer.view.rect.x1 - 23 * line, viewer.view.rect.y0 + line}, ImGuiCond_FirstUseEver);
  if (generate.wants_focus) ImGui::SetNextWindowFocus();
  generate.wants_focus = false;
  if (begin_panel(ui, kGenerate.title, &open)) {
    draw_kinds(ui, generate);
    ImGui::Spacing();
    draw_problems(ui, generate);
    // Fields that do not fit are scrolled; the result and the buttons stay visible.
    const float footer = 2 * ImGui::GetTextLineHeight() + ImGui::GetFrameHeight() + 3 * ImGui::GetStyle().ItemSpacing.y;
    if (ImGui::BeginChild("fields", ImVec2(0, -footer))) {
      draw_pattern_fields(ui, shown.document, generate, dialog);
      if (has_frame(generate.pattern)) caption("In the view: click or drag moves, Ctrl+wheel turns");
    }
    ImGui::EndChild();
    ImGui::Separator();
    draw_outcome(generate);
    draw_buttons(ui, viewer, shown, tool, generate, tour);
  }
  ImGui::End();
  if (!open && generate.open) close_generate(generate);
}

}  // namespace

namespace {

/// Opens the panel if it is closed.
void open_generate(App& app) {
  if (!app.get<GenerateState>().open) carry_out(ToggleGenerate{}, app);
}

/// Returns the kinds of patterns and the fields of all kinds.
std::vector<PanelPart> generate_parts() {
  constexpr auto kWhyNot = [](const App& app) -> const char* {
    return app.shown->document.editing.project ? nullptr : "No layout is open";
  };
  std::vector<PanelPart> parts;
  const std::vector<PatternShape> shapes = each_alternative<PatternShape>();
  const auto has = [&](const std::string& label) {
    return std::any_of(parts.begin(), parts.end(), [&](const PanelPart& part) { return part.label == label; });
  };
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const auto [word, help] = std::visit([](const auto& kind) { return std::pair(kind.kWord, kind.kHelp); }, shapes[i]);
    const auto choose = [i](App& app) {
      open_generate(app);
      change_kind(app.get<GenerateState>(), i);
    };
    parts.push_back({label_of(word) + " of taxels", "Pattern", help, kLayout, kWhyNot, label_of(word), "", choose});
    Pattern pattern;
    pattern.shape = shapes[i];
    visit_fields(pattern, [&](const FieldSpec& field, auto& value) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if constexpr (std::is_arithmetic_v<Value>) {
        if (has(field.label)) return;
        const bool is_angle = field.quantity == FieldQuantity::angle, is_number = std::is_same_v<Value, double>;
        const std::string widget = is_angle ? field.label + std::string(" (deg)")
                                            : (is_number ? label_with_unit(field) : std::string(field.label));
        parts.push_back({field.label, "Pattern", field.help, kLayout, kWhyNot, widget, "", choose});
      }
    });
  }
  return parts;
}

}  // namespace

constinit const Feature kGenerate{
    .title = "Generate",
    .dock = Dock::inspector,
    .draw =
        [](App& app) {
          draw_generate_panel(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<GenerateState>(),
                              app.get<TourState>(), app.get<FileDialog>());
        },
    .parts = generate_parts,
    .guide = "Fill an area with taxels",
    .tool = {"generate", kEverywhere, nullptr, 4, [](const App& app) { return app.get<GenerateState>().open; },
             [](App& app) { close_generate(app.get<GenerateState>()); }},
    .mark =
        [](const App& app, SceneInput& scene) {
          if (app.viewer->mode == Mode::layout && app.get<GenerateState>().open)
            scene.ghosts = app.get<GenerateState>().ghosts;
        },
    .draw_on_view = [](const App& app) { draw_pattern_frame(*app.viewer, *app.shown, app.get<GenerateState>()); },
    .hint =
        [](const App& app, std::vector<ViewHint>& lines) {
          lines.push_back({pattern_hint(*app.viewer, *app.shown, app.get<GenerateState>())});
        },
    .make_job = studio::make_pattern_job,
    .dump = dump_generate,
};

void draw_pattern_frame(const Viewer& viewer, const Shown& shown, const GenerateState& generate) {
  if (!generate.open || !has_frame(generate.pattern) || !shown.document.model) return;
  const Pose X_WM = shown_pose(viewer, shown);
  const auto pixel_of = [&](const dvec3& p_M) { return on_screen(viewer, X_WM * p_M); };
  const double angle = generate.pattern.turn_deg * glm::pi<double>() / 180;
  const dvec3 across = glm::cross(generate.frame.normal, generate.frame.along_row);
  const dvec3 u = std::cos(angle) * generate.frame.along_row + std::sin(angle) * across;
  const dvec3 v = glm::cross(generate.frame.normal, u);
  constexpr double kArm = 0.07;  // length of an arm, as a fraction of the mesh's diagonal
  const double arm = kArm * shown.document.model->mesh->bounds().diagonal();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 at = pixel_of(generate.frame.center);
  const ImU32 halo = IM_COL32(0, 0, 0, 160);
  const auto arm_line = [&](const dvec3& direction, ImU32 color) {
    const ImVec2 end = pixel_of(generate.frame.center + arm * direction);
    list.AddLine(at, end, halo, 4.5f);
    list.AddLine(at, end, color, 2.5f);
  };
  arm_line(u, IM_COL32(235, 87, 87, 255));
  arm_line(v, IM_COL32(111, 207, 96, 255));
  list.AddCircleFilled(at, 6.5f, halo);
  list.AddCircleFilled(at, 5, IM_COL32_WHITE);
}

}  // namespace taxel::ui
