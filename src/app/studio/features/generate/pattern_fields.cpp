#include "app/studio/features/generate/pattern_fields.h"

#include <fmt/format.h>
#include <imgui.h>
#include <misc/cpp/imgui_stdlib.h>

#include <array>
#include <cmath>
#include <limits>

#include "app/studio/app/perform.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/number_field.h"

namespace taxel::ui {

namespace {

constexpr FieldUnit kDegrees{"deg", 0, 1}, kWhole{"", 0, 0};

void begin_row(const char* name, const char* tip) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::AlignTextToFramePadding();
  ImGui::TextDisabled("%s", name);
  tooltip(tip);
  ImGui::TableNextColumn();
}

void number_row(UiState& ui, const char* name, double& value, const FieldUnit& unit, const char* tip) {
  begin_row(name, tip);
  if (const auto typed = number_field(ui, name, {value}, unit)) value = *typed;
  tooltip(tip);
}

/// Whole numbers; whether they make sense is said where the pattern is made.
template <class Int>
void count_row(UiState& ui, const char* name, Int& value, const char* tip) {
  begin_row(name, tip);
  const auto typed = number_field(ui, name, {static_cast<double>(value)}, kWhole);
  tooltip(tip);
  if (!typed) return;
  const double least = std::is_signed_v<Int> ? -1e9 : 0.0, most = 2e9;
  if (*typed == std::floor(*typed) && *typed >= least && *typed <= most) {
    value = static_cast<Int>(*typed);
  } else {
    ui.generate.file_problem = fmt::format("{}: must be a whole number, is {:g}", name, *typed);
  }
}

void check_row(UiState& ui, const char* name, bool& value, const char* tip) {
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TableNextColumn();
  checkbox(ui, name, &value);
  tooltip(tip);
}

template <class T, std::size_t N>
void choice_row(UiState& ui, const char* name, T& value, const std::array<std::pair<const char*, T>, N>& choices,
                const char* tip) {
  begin_row(name, tip);
  ImGui::PushID(name);
  for (std::size_t i = 0; i < N; ++i) {
    if (i > 0) ImGui::SameLine(0, 2);
    if (small_choice(ui, choices[i].first, value == choices[i].second)) value = choices[i].second;
  }
  ImGui::PopID();
}

void draw_grid(UiState& ui, Pattern& p) {
  count_row(ui, "Rows", p.rows, "Rows follow one another across the direction of rows");
  count_row(ui, "Columns", p.columns, "Taxels in a row");
  number_row(ui, "Row pitch (mm)", p.row_pitch, kMillimetres, "From row to row [mm]");
  number_row(ui, "Column pitch (mm)", p.column_pitch, kMillimetres, "From column to column [mm]");
  number_row(ui, "Turn (deg)", p.turn_deg, kDegrees, "About the skin's normal, counter-clockwise [degrees]");
  check_row(ui, "Onto the skin", p.projected,
            "Straight down onto the skin, with its normals; else a plane that touches it at the frame");
}

void draw_axis(UiState& ui, Pattern& p) {
  using Choice = std::pair<const char*, PatternAxis>;
  constexpr std::array kAxes{Choice{"distal", PatternAxis::distal}, Choice{"X", PatternAxis::x},
                             Choice{"Y", PatternAxis::y}, Choice{"Z", PatternAxis::z}};
  choice_row(ui, "Axis", p.axis, kAxes, "The ring goes round it: where the finger points, or an axis of the mesh file");
}

void draw_around(UiState& ui, Pattern& p) {
  count_row(ui, "Taxels", p.count, "Their number");
  draw_axis(ui, p);
  if (p.kind == PatternKind::helix) {
    number_row(ui, "Rise (mm)", p.rise, kMillimetres, "Along the axis, from the first taxel to the last [mm]");
    number_row(ui, "Turns", p.turns, kPlain, "Times around; negative: clockwise");
  }
  number_row(ui, "Turn (deg)", p.turn_deg, kDegrees, "About the axis, from the frame to the first taxel [degrees]");
}

void draw_spiral(UiState& ui, Pattern& p) {
  count_row(ui, "Taxels", p.count, "Their number; equal area each (Vogel 1979)");
  number_row(ui, "Disc radius (mm)", p.disc_radius, kMillimetres, "Of the disc that is projected onto the skin [mm]");
}

void draw_spread(UiState& ui, const UiInput& input, Pattern& p) {
  count_row(ui, "Taxels", p.count, "Each as far from the others along the skin as it can be (Gonzalez 1985)");
  count_row(ui, "Seed", p.seed, "Another one, another spread");
  const bool painted = !input.editing.project->layout.sampling.region->empty();
  begin_row("Over", "The painted region, or the whole skin where nothing is painted");
  ImGui::AlignTextToFramePadding();
  ImGui::TextUnformatted(painted ? "the painted region" : "the whole skin");
  begin_row("", "");
  if (button(ui, "Paint...")) perform(ToggleTool{Tool::brush}, ui, input);
  tooltip("Take the brush (Q), and paint where taxels shall be");
}

void draw_file(UiState& ui, std::string& path, const char* hint) {
  begin_row("File", "Type a path, choose one, or drop the file on the window");
  ImGui::SetNextItemWidth(-1);
  const bool entered = ImGui::InputTextWithHint("##file", hint, &path, ImGuiInputTextFlags_EnterReturnsTrue);
  ui.widgets.note_item("File");
  if (!path.empty()) tooltip(path);
  if (entered && !path.empty()) ui.ask(ReadPoints{path});
  begin_row("", "");
  if (button(ui, "Browse...")) {
    begin_dialog(ui, FileTask::read_points);
    ui.ask(ListFolder{ui.dialog.folder});
  }
}

void draw_table(UiState& ui, Pattern& p) {
  draw_file(ui, ui.generate.table_path, "points.csv");
  using Choice = std::pair<const char*, double>;
  constexpr std::array kUnits{Choice{"m", 1.0}, Choice{"cm", 0.01}, Choice{"mm", 1e-3}, Choice{"in", 0.0254}};
  choice_row(ui, "Unit", p.unit, kUnits, "Of the lengths in the table");
  check_row(ui, "Onto the skin", p.onto_skin,
            "To the nearest points of the skin, with its normals; else as the table says");
}

void draw_image(UiState& ui, Pattern& p) {
  draw_file(ui, ui.generate.image_path, "dots.png");
  number_row(ui, "Picture width (mm)", p.width, kMillimetres, "Of the whole picture where it lies over the skin [mm]");
  number_row(ui, "Turn (deg)", p.turn_deg, kDegrees, "About the skin's normal, counter-clockwise [degrees]");
  count_row(ui, "Threshold", p.threshold, "A pixel is of a dot where it is darker than this, 1 to 255");
  count_row(ui, "Least pixels", p.least_pixels, "Smaller dots are dust");
  check_row(ui, "Light dots", p.light_dots, "Dots are lighter than their ground");
}

void wrapped(const char* head, const std::string& text) {
  ImGui::TextDisabled("%s", head);
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
}

/// Over the whole width: titles and sources are long.
void draw_preset(UiState& ui, Pattern& p) {
  for (const PresetNote& note : ui.generate.presets) {
    if (selectable(ui, note.title.c_str(), p.preset == note.name)) p.preset = note.name;
    tooltip(note.source);
  }
  for (const PresetNote& note : ui.generate.presets) {
    if (note.name != p.preset) continue;
    ImGui::Spacing();
    wrapped("Source", note.source);
    wrapped("Unverified", note.unverified);
  }
}

}  // namespace

void draw_pattern_fields(UiState& ui, const UiInput& input) {
  Pattern& p = ui.generate.pattern;
  if (p.kind == PatternKind::preset) draw_preset(ui, p);
  if (!begin_properties("pattern")) return;
  switch (p.kind) {
    case PatternKind::grid:
      draw_grid(ui, p);
      break;
    case PatternKind::ring:
    case PatternKind::helix:
      draw_around(ui, p);
      break;
    case PatternKind::spiral:
      draw_spiral(ui, p);
      break;
    case PatternKind::spread:
      draw_spread(ui, input, p);
      break;
    case PatternKind::table:
      draw_table(ui, p);
      break;
    case PatternKind::image:
      draw_image(ui, p);
      break;
    case PatternKind::preset:
      break;
  }
  if (p.kind != PatternKind::preset)
    number_row(ui, "Radius (mm)", p.radius, kMillimetres,
               "Of the receptive fields [mm]; a table's own radii go before");
  const bool over = p.kind == PatternKind::grid || p.kind == PatternKind::spiral || p.kind == PatternKind::image ||
                    p.kind == PatternKind::preset;
  if (over)
    check_row(ui, "Skip what misses", p.leave_out,
              "Points that are not over the skin are left out; else they are an error");
  end_properties();
}

}  // namespace taxel::ui
