#include "app/studio/features/generate/generate.h"

#include <imgui.h>

#include <cmath>

#include "app/studio/features/taxel/gesture.h"

namespace taxel::ui {

namespace {

constexpr double kDegPerNotch = 5;
constexpr double kPitch = 0.11;  // of a grid, relative to the mesh's diagonal
/// How near to the frame's centre a drag of it begins, at scale 1 [pixels].
constexpr double kReach = 14;

void put_frame(UiState& ui, const UiInput& input, const SurfacePlace& place) {
  PlacingFrame& frame = ui.generate.frame;
  frame.center = place.position;
  frame.normal = place.normal;
  frame.along_row = row_direction(input.editing.project->layout.frame, place.normal);
}

/// A length as one would set it: to half a millimetre, or to one digit where it is smaller.
double round_length(double length) {
  constexpr double kStep = 0.5e-3;
  if (length >= 2 * kStep) return kStep * std::round(length / kStep);
  const double digit = std::pow(10.0, std::floor(std::log10(length)));
  return digit * std::round(length / digit);
}

/// Sets the lengths of a kind to fractions of the mesh's size.
void size_shape(PatternShape& shape, double diagonal) {
  constexpr std::pair<std::string_view, double> kFractions[] = {
      {"row_pitch", kPitch}, {"column_pitch", kPitch}, {"disc_radius", 0.2}, {"rise", 0.25}, {"width", 0.4}};
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

PatternJob job_of(const UiState& ui, const UiInput& input) {
  const GenerateState& g = ui.generate;
  PatternJob job{g.pattern, g.frame, input.editing.project->layout.frame, input.model->skin, {}, nullptr, "", nullptr};
  // What a kind does not look at makes no difference.
  if (g.pattern.is<patterns::Spread>()) job.region = input.editing.project->layout.sampling.region;
  if (g.pattern.is<patterns::Spread>()) job.frame = {};
  if (g.pattern.is<patterns::Table>()) job.table = g.table;
  if (g.pattern.is<patterns::Table>()) job.table_file = g.table_file;
  if (g.pattern.is<patterns::Image>()) job.image = g.image;
  return job;
}

}  // namespace

void toggle_generate(UiState& ui, const UiInput& input) {
  if (ui.generate.open) return close_generate(ui);
  if (!can_edit(ui, input)) return;
  cancel_tool(ui);
  GenerateState& g = ui.generate;
  g.open = g.wants_focus = true;
  if (!g.sized) size_pattern(g, input.model->mesh->bounds().diagonal());
  g.sized = true;
  const MeshIndex& skin = *input.model->skin;
  const GestureView view = gesture_view(ui, input);
  const auto place = place_under(skin, view.ray_M({0.5 * ui.view.width, 0.5 * ui.view.height}));
  put_frame(ui, input, place ? *place : place_near(skin, view.X_WM.inverse() * ui.camera().target));
}

void close_generate(UiState& ui) {
  GenerateState& g = ui.generate;
  g.open = g.dragging = false;
  g.ghosts.reset();
  g.problem.clear();
  g.file_problem.clear();
  g.asked = {};
  g.shown = ++g.number;
  ui.ask(DropPreview{});
}

bool can_accept_generate(const UiState& ui, const UiInput& input) {
  const GenerateState& g = ui.generate;
  return g.open && can_edit(ui, input) && !g.waiting() && g.ghosts && !g.ghosts->empty() &&
         g.asked == job_of(ui, input);
}

void accept_generate(UiState& ui, const UiInput& input) {
  if (!can_accept_generate(ui, input)) return;
  std::vector<Taxel> taxels = with_unused_ids(*ui.generate.ghosts, input.editing.project->layout);
  ui.selection.clear();
  for (const Taxel& taxel : taxels) ui.selection.taxels.push_back(taxel.id);
  ui.ask(EditProject{AddTaxels{std::move(taxels), std::nullopt}, {}});
  close_generate(ui);
}

void keep_preview_current(UiState& ui, const UiInput& input) {
  GenerateState& g = ui.generate;
  if (!g.open) return;
  if (!can_edit(ui, input)) return close_generate(ui);
  PatternJob job = job_of(ui, input);
  if (job == g.asked) return;
  g.asked = std::move(job);
  ++g.number;
  ui.ask(PreviewPattern{});
}

bool frame_mouse(UiState& ui, const UiInput& input, double x, double y, bool hovered) {
  GenerateState& g = ui.generate;
  if (!g.open || !has_frame(g.pattern)) return false;
  const ImGuiIO& io = ImGui::GetIO();
  const GestureView view = gesture_view(ui, input);
  if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !io.KeyCtrl && !io.KeyShift) {
    const double reach = kReach * ui.pixel_scale;
    g.dragging = glm::distance(view.pixel_of(g.frame.center), dvec2(x, y)) < reach;
  }
  const bool moved = io.MouseDragMaxDistanceSqr[ImGuiMouseButton_Left] >= io.MouseDragThreshold * io.MouseDragThreshold;
  const bool released = ImGui::IsMouseReleased(ImGuiMouseButton_Left);
  const bool clicked = hovered && released && !moved && !io.KeyCtrl && !io.KeyShift;
  if (clicked || (g.dragging && moved)) {
    if (const auto place = place_under(*input.model->skin, view.ray_M({x, y}))) put_frame(ui, input, *place);
  }
  const bool mine = g.dragging || clicked;
  if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) g.dragging = false;
  return mine;
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

void turn_pattern(UiState& ui, double notches) {
  double& turn = ui.generate.pattern.turn_deg;
  turn = std::remainder(turn + kDegPerNotch * notches, 360.0);
}

}  // namespace taxel::ui
