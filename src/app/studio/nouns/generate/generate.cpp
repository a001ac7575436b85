// Generating taxels: the frame of the pattern on the skin, the preview, and adding the previewed taxels.
#include "app/studio/nouns/generate/generate_state.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>

#include "app/studio/frame/app.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/files/file_dialog.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/taxel/taxel_commands.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/message.h"
#include "core/layout/generators/generated_layout.h"
#include "core/layout/sensor_presets.h"

namespace taxel::ui {

namespace {

constexpr double kDegPerNotch = 5;
constexpr double kPitch = 0.11;  // pitch of a grid, relative to the mesh's diagonal
/// Largest distance from the frame's centre at which a drag of the frame begins, at scale 1 [pixels].
constexpr double kReach = 14;

void put_frame(const DocumentView& document, GenerateState& generate, const SurfacePlace& place) {
  PlacingFrame& frame = generate.frame;
  frame.center = place.position;
  frame.normal = place.normal;
  frame.along_row = row_direction(document.editing.project->layout.frame, place.normal);
}

/// Returns a length rounded to half a millimetre, or to one digit if the length is smaller.
double round_length(double length) {
  constexpr double kStep = 0.5e-3;
  if (length >= 2 * kStep) return kStep * std::round(length / kStep);
  const double digit = std::pow(10.0, std::floor(std::log10(length)));
  return digit * std::round(length / digit);
}

/// Sets the lengths of a kind to fractions of the mesh's size.
void size_shape(PatternShape& shape, double diagonal) {
  constexpr std::pair<std::string_view, double> kFractions[] = {{"pitch", kPitch},        {"row_pitch", kPitch},
                                                                {"column_pitch", kPitch}, {"disc_radius", 0.2},
                                                                {"rise", 0.25},           {"width", 0.4}};
  const auto set = [&](const FieldSpec& field, auto& value) {
    if constexpr (std::is_same_v<decltype(value), double&>)
      for (const auto& [key, fraction] : kFractions)
        if (key == field.key) value = round_length(fraction * diagonal);
  };
  std::visit([&](auto& kind) { kind.visit(kind, set); }, shape);
}

void size_pattern(GenerateState& g, double diagonal) {
  constexpr double kRadiusOfPitch = 0.8;
  for (PatternShape& shape : g.shapes) size_shape(shape, diagonal);
  size_shape(g.pattern.shape, diagonal);
  g.pattern.radius = round_length(kRadiusOfPitch * round_length(kPitch * diagonal));
}

std::vector<PresetNote> preset_notes() {
  std::vector<PresetNote> notes;
  for (const std::string& name : sensor_preset_names()) {
    const SensorPreset preset = make_sensor_preset(name);
    notes.push_back({preset.name, preset.layout.name, preset.source, preset.unverified});
  }
  return notes;
}

PatternInputs inputs_of(const DocumentView& document, const GenerateState& generate) {
  PatternInputs inputs{
      generate.pattern, generate.frame, document.editing.project->layout.frame, document.model->skin, {}, nullptr, "",
      nullptr};
  // Inputs that a kind of pattern does not use stay empty, so that a change of them requests no new preview.
  if (has_region(generate.pattern)) inputs.region = document.editing.project->layout.sampling.region;
  if (generate.pattern.is<patterns::Spread>()) inputs.frame = {};
  if (generate.pattern.is<patterns::Table>()) inputs.table = generate.table;
  if (generate.pattern.is<patterns::Table>()) inputs.table_file = generate.table_file;
  if (generate.pattern.is<patterns::Image>()) inputs.image = generate.image;
  return inputs;
}

/// Puts the frame on the pad of the layout's frame, or at the middle of the view if there is no skin under the pad.
void begin_frame_of_pattern(const Viewer& viewer, const Shown& shown, GenerateState& generate) {
  const MeshIndex& skin = *shown.document.model->skin;
  if (const auto on_pad = frame_on_pad(shown.document.editing.project->layout.frame, skin)) {
    generate.frame = *on_pad;
    return;
  }
  const GestureView view = gesture_view(viewer, shown);
  const auto place = place_under(skin, view.ray_M({0.5 * viewer.view.width, 0.5 * viewer.view.height}));
  put_frame(shown.document, generate, place ? *place : place_near(skin, view.X_WM.inverse() * viewer.camera().target));
}

}  // namespace

void toggle_generate(WindowUi& ui, Viewer& viewer, const Shown& shown, ToolState& tool, GenerateState& generate) {
  if (generate.open) return close_generate(generate);
  if (!can_edit(viewer, shown)) return;
  cancel_tool(ui, viewer.selection, tool);
  generate.open = generate.wants_focus = true;
  if (!generate.sized) size_pattern(generate, shown.document.model->mesh->bounds().diagonal());
  generate.sized = true;
  begin_frame_of_pattern(viewer, shown, generate);
}

void close_generate(GenerateState& generate) {
  generate.open = generate.dragging = false;
  generate.ghosts.reset();
  generate.problem.clear();
  generate.file_problem.clear();
  generate.asked = {};
  generate.shown = ++generate.number;
}

bool can_accept_generate(const Viewer& viewer, const Shown& shown, const GenerateState& generate) {
  return generate.open && can_edit(viewer, shown) && !generate.waiting() && generate.ghosts &&
         !generate.ghosts->empty() && generate.asked == inputs_of(shown.document, generate);
}

void accept_generate(WindowUi& ui, Viewer& viewer, const Shown& shown, GenerateState& generate) {
  if (!can_accept_generate(viewer, shown, generate)) return;
  std::vector<Taxel> taxels = with_unused_ids(*generate.ghosts, shown.document.editing.project->layout);
  viewer.selection.clear();
  for (const Taxel& taxel : taxels) viewer.selection.taxels.push_back(taxel.id);
  ui.post(EditProject{AddTaxels{std::move(taxels), std::nullopt}, {}});
  close_generate(generate);
}

void keep_preview_current(const Viewer& viewer, const Shown& shown, GenerateState& generate) {
  if (!generate.open) return;
  if (!can_edit(viewer, shown)) return close_generate(generate);
  PatternInputs inputs = inputs_of(shown.document, generate);
  if (inputs == generate.asked) return;
  generate.asked = std::move(inputs);
  ++generate.number;
  if (generate.pattern.is<patterns::Preset>() && generate.presets.empty()) generate.presets = preset_notes();
}

bool frame_mouse(WindowUi& ui, const Viewer& viewer, const Shown& shown, GenerateState& generate, double x, double y,
                 bool hovered) {
  if (!generate.open || !has_frame(generate.pattern)) return false;
  const ImGuiIO& io = ImGui::GetIO();
  const GestureView view = gesture_view(viewer, shown);
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !io.KeyCtrl && !io.KeyShift) {
    const double reach = kReach * ui.pixel_scale;
    generate.dragging = glm::distance(view.pixel_of(generate.frame.center), dvec2(x, y)) < reach;
  }
  const bool moved = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >= io.MouseDragThreshold * io.MouseDragThreshold;
  const bool released = ImGui::IsMouseReleased(ImGuiMouseButton_Left);
  const bool clicked = hovered && released && !moved && !io.KeyCtrl && !io.KeyShift;
  if (clicked || (generate.dragging && moved)) {
    if (const auto place = place_under(*shown.document.model->skin, view.ray_M({x, y})))
      put_frame(shown.document, generate, *place);
  }
  const bool mine = generate.dragging || clicked;
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) generate.dragging = false;
  return mine;
}

std::string pattern_hint(const Viewer& viewer, const Shown& shown, const GenerateState& generate) {
  if (!generate.open || !has_frame(generate.pattern) || !can_edit(viewer, shown)) return {};
  const GestureView view = gesture_view(viewer, shown);
  const Ray ray = view.ray_M(view.pixel_of(generate.frame.center));
  const bool is_behind = glm::dot(generate.frame.normal, ray.direction) > 0;
  return fmt::format("Pattern{}: click the surface to move it   Ctrl+wheel turns   Esc ends",
                     is_behind ? " on the far side" : "");
}

void change_kind(GenerateState& generate, std::size_t kind) {
  PatternShape& shape = generate.pattern.shape;
  for (PatternShape& last : generate.shapes) copy_shared_values(shape, last);
  generate.shapes[shape.index()] = shape;
  shape = generate.shapes[kind];
}

bool has_frame(const Pattern& pattern) {
  return std::visit([](const auto& kind) { return kind.kHasFrame; }, pattern.shape);
}

void turn_pattern(GenerateState& generate, double notches) {
  double& turn = generate.pattern.turn_deg;
  turn = std::remainder(turn + kDegPerNotch * notches, 360.0);
}

void carry_out(const ToggleGenerate&, App& app) {
  toggle_generate(*app.ui, *app.viewer, *app.shown, app.get<ToolState>(), app.get<GenerateState>());
}

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::ReadPoints& command, Host& host) {
  ui::GenerateState& g = host.app.get<ui::GenerateState>();
  const std::string file = std::filesystem::absolute(command.path).string();
  g.file_problem.clear();
  try {
    if (is_picture(file)) {
      g.image = std::make_shared<const GreyImage>(read_grey_image(file));
      g.image_path = file;
      ui::change_kind<patterns::Image>(g);
    } else {
      g.table = std::make_shared<const std::string>(read_file(file));
      g.table_path = file;
      g.table_file = std::filesystem::path(file).filename().string();
      ui::change_kind<patterns::Table>(g);
    }
  } catch (const Error& error) {
    g.file_problem = shown_message(error);
  }
}

}  // namespace taxel::studio
