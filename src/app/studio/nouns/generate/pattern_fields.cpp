#include "app/studio/nouns/generate/pattern_fields.h"

#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <cmath>
#include <string>
#include <type_traits>

#include "app/studio/nouns/files/file_dialog_tool.h"
#include "app/studio/nouns/files/file_listing.h"
#include "app/studio/nouns/files/file_task.h"
#include "app/studio/nouns/generate/generate.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "app/studio/nouns/taxel/tool_state.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr FieldUnit kWhole{"", 0, 0};

void begin_row(const char* name, const char* tip) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", name);
  tooltip(tip);
  ImGui::TableNextColumn();
}

void draw_field(WindowUi& ui, GenerateState& /*generate*/, const FieldSpec& field, double& value) {
  const bool angle = field.quantity == FieldQuantity::angle;
  const std::string name = angle ? std::string(field.label) + " (deg)" : label_with_unit(field);
  begin_row(name.c_str(), field.help);
  if (const auto typed = number_field(ui, name, {value}, field_unit(field.quantity, angle ? 1 : 2))) value = *typed;
  tooltip(field.help);
}

/// Draws the field of a whole number. Refuses fractions; make_pattern() checks the range.
template <class Int>
requires std::is_same_v<Int, int> || std::is_same_v<Int, std::uint64_t>
void draw_field(WindowUi& ui, GenerateState& generate, const FieldSpec& field, Int& value) {
  begin_row(field.label, field.help);
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
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TableNextColumn();
  checkbox(ui, field.label, &value);
  tooltip(field.help);
}

template <class Choice>
requires std::is_enum_v<Choice>
void draw_field(WindowUi& ui, GenerateState& /*generate*/, const FieldSpec& field, Choice& value) {
  begin_row(field.label, field.help);
  ImGui::PushID(field.label);
  for (const Word<Choice>& word : words_of(value)) {
    if (&word != words_of(value).data()) ImGui::SameLine(0, 2);
    if (small_choice(ui, word.text.data(), value == word.value)) value = word.value;
  }
  ImGui::PopID();
}

void draw_field(WindowUi& /*ui*/, GenerateState& /*generate*/, const FieldSpec& /*field*/, std::string& /*preset*/) {
  // draw_presets() draws the names over the whole width.
}

void draw_region(WindowUi& ui, const DocumentView& document) {
  const bool painted = !document.editing.project->layout.sampling.region->empty();
  begin_row("Over", "The painted region, or the whole skin where nothing is painted");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(painted ? "the painted region" : "the whole skin");
  begin_row("", "");
  if (button(ui, "Paint...")) ui.post(ToggleTool{Tool::brush});
  tooltip("Take the brush (Q), and paint where taxels shall be");
}

void draw_file(WindowUi& ui, FileDialog& dialog, std::string& path, const char* hint) {
  begin_row("File", "Type a path, choose one, or drop the file on the window");
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint("##file", hint, &path, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note_item("File");
  if (!path.empty()) tooltip(path);
  if (entered && !path.empty()) ui.post(ReadPoints{path});
  begin_row("", "");
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

}  // namespace

void draw_pattern_fields(WindowUi& ui, const DocumentView& document, GenerateState& generate, FileDialog& dialog) {
  Pattern& pattern = generate.pattern;
  if (auto* preset = std::get_if<patterns::Preset>(&pattern.shape)) draw_presets(ui, generate, preset->name);
  if (!begin_properties("pattern")) return;
  if (pattern.is<patterns::Spread>()) draw_region(ui, document);
  if (pattern.is<patterns::Table>()) draw_file(ui, dialog, generate.table_path, "points.csv");
  if (pattern.is<patterns::Image>()) draw_file(ui, dialog, generate.image_path, "dots.png");
  visit_fields(pattern, [&](const FieldSpec& field, auto& value) { draw_field(ui, generate, field, value); });
  end_properties();
}

}  // namespace taxel::ui
