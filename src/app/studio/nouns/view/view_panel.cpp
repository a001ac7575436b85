#include "app/studio/nouns/view/view_panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "app/studio/frame/shown_scene.h"
#include "app/studio/nouns/camera/camera_state.h"
#include "core/base/stopwatch.h"
#include "core/base/text/rounded.h"
#include "ui/scene/color_map.h"
#include "ui/scene/marks/marks.h"
#include "ui/scene/picking.h"
#include "ui/theme.h"
#include "ui/widgets/format.h"
#include "ui/widgets/pressure_legend.h"
#include "ui/widgets/text_fit.h"

namespace taxel::ui {
namespace {

constexpr float kPlate = 0.88f;  // opacity of the plate behind a label, on which text is readable

/// Draws a line from a mark to the nearest point of its label.
void draw_leader(const ViewPlace& place, const dvec2& mark, const Rect& label, const ImVec4& color, ImDrawList& list) {
  const ImVec2 from(place.rect.x0 + static_cast<float>(mark.x), place.rect.y0 + static_cast<float>(mark.y));
  const ImVec2 to(std::clamp(from.x, label.x0, label.x1), std::clamp(from.y, label.y0, label.y1));
  list.AddLine(from, to, to_u32(color, 0.9f));
}

/// Returns the file name of a title, because a scene's title may be a whole path.
std::string file_name_of(const std::string& title) {
  const std::size_t slash = title.find_last_of('/');
  return slash == std::string::npos || slash + 1 == title.size() ? title : title.substr(slash + 1);
}

std::string taxel_text(const Viewer& viewer, const Shown& shown, const SensorModel& model, int index) {
  const auto i = static_cast<std::size_t>(index);
  const Taxel& taxel = model.layout.taxels[i];
  std::string text = fmt::format("Taxel {}{}{}", taxel.id, taxel.name.empty() ? "" : ", ", taxel.name);
  text += fmt::format(
      "\n{}, radius {}",
      counted(static_cast<std::size_t>(model.fields.first[i + 1] - model.fields.first[i]), "sample", "samples"),
      in_mm(taxel.radius));
  const SensorStep* sensor = shown.state(viewer);
  if (sensor != nullptr && i < sensor->readings.size())
    text += fmt::format("\n{}", in_unit(sensor->readings[i], shown_unit(model.layout.readout.aggregate)));
  return text;
}

std::string sample_text(const SensorModel& model, int sample) {
  const std::vector<SampleUse> uses = uses_of_sample(model, sample);
  std::string text = fmt::format("Sample {}", sample);
  if (uses.empty()) return text + ", used by no taxel";
  for (const SampleUse& use : uses) {
    text += fmt::format("\nTaxel {}: distance {}, angle {:.1f}\u00b0, weight {} mm\u00b2",
                        model.layout.taxels[static_cast<std::size_t>(use.taxel)].id, in_mm(use.distance), use.angle_deg,
                        rounded(1e6 * use.weight, 3, 6));
  }
  return text;
}

}  // namespace

void render_if_changed(Viewer& viewer, ProfileState& profile, ViewShown& view, SceneInput scene,
                       SceneRenderer& renderer, int width, int height) {
  ViewPlace& place = viewer.view;
  const bool same = view.drawn && place.width == width && place.height == height && view.camera == viewer.camera() &&
                    view.input == scene;
  if (same) return;
  const Stopwatch watch(profile.scene_seconds);
  renderer.render(scene, viewer.camera(), width, height);
  view.numbers = renderer.field_numbers();
  view.input = std::move(scene);
  view.camera = viewer.camera();
  place.width = width;
  place.height = height;
  view.drawn = true;
  ++view.draws;
}

void CoveredBoxes::add() {
  const int end = list_.VtxBuffer.Size;
  dvec2 lo(std::numeric_limits<double>::infinity()), hi(-lo);
  for (int i = std::exchange(begin_, end); i < end; ++i) {
    const dvec2 at(static_cast<double>(list_.VtxBuffer[i].pos.x), static_cast<double>(list_.VtxBuffer[i].pos.y));
    lo = glm::min(lo, at);
    hi = glm::max(hi, at);
  }
  if (lo.x < hi.x) boxes_.push_back({lo - corner_, hi - corner_});
}

void CoveredBoxes::add(const Rect& rect) {
  if (rect.empty()) return;
  const dvec2 lo(static_cast<double>(rect.x0), static_cast<double>(rect.y0));
  const dvec2 hi(static_cast<double>(rect.x1), static_cast<double>(rect.y1));
  boxes_.push_back({lo - corner_, hi - corner_});
}

void place_labels(const ViewPlace& place, ViewShown& view, std::vector<LabelBox> covered) {
  if (!view.drawn || (view.labelled == view.draws && view.covered == covered)) return;
  view.covered = std::move(covered);
  view.labelled = view.draws;
  const LabelRoom room{static_cast<double>(kSmallText * ImGui::GetFontSize()),
                       [](const std::string& text) { return static_cast<double>(small_width(text)); }, view.covered,
                       view.labels};
  view.labels = scene_labels(view.input, view.camera, place.width, place.height, room);
}

bool shows_pressure(const Viewer& viewer, const Shown& shown) {
  const bool is_scene_in_layout = viewer.mode == Mode::layout && shown.shows_scene(viewer);
  return shown.state(viewer) != nullptr && !is_scene_in_layout;
}

namespace {

const ImVec4& color_of_mode(Mode mode, const Palette& colors) {
  switch (mode) {
    case Mode::layout:
      return colors.layout_mode;
    case Mode::simulate:
      return colors.simulate_mode;
    case Mode::analyse:
      return colors.analyse_mode;
  }
  return colors.simulate_mode;
}

}  // namespace

std::string displayed_name(const Viewer& viewer, const Shown& shown) {
  const SimFramePtr& frame = shown.run.frame;
  const bool is_scene = shows_run(viewer.mode) && frame && frame->scene && !frame->scene->title.empty();
  return is_scene ? file_name_of(frame->scene->title) : shown.document.name;
}

void draw_heading(const WindowUi& ui, const Viewer& viewer, const Shown& shown, float legend_width, ImDrawList& list) {
  const Palette& colors = palette(ui.dark);
  const ImVec4& mode_color = color_of_mode(viewer.mode, colors);
  const float line = ImGui::GetFontSize();
  const ImVec2 at(viewer.view.rect.x0 + 0.8f * line, viewer.view.rect.y0 + 0.7f * line);
  const char* mode = name_of(viewer.mode);
  const float width = ImGui::CalcTextSize(mode).x + line;
  list.AddRectFilled(at, {at.x + width, at.y + 1.5f * line}, to_u32(mode_color), 3);
  list.AddText({at.x + 0.5f * line, std::round(at.y + 0.22f * line)}, to_u32(text_on(mode_color)), mode);
  std::string text = displayed_name(viewer, shown);
  if (shows_run(viewer.mode) && shown.run.frame && shown.run.frame->finished) text += "   (finished)";
  const float end = viewer.view.rect.x1 - (legend_width > 0 ? legend_width + line : 0.5f * line);
  const ImVec4 room(at.x, at.y, end, at.y + 2 * line);  // the legend begins there
  const ImVec2 place(at.x + width + 0.6f * line, std::round(at.y + 0.22f * line));
  if (!text.empty()) {  // a bright sky or lines of the skin may be behind
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddRectFilled({place.x - 6, place.y - 3}, {std::min(place.x + size.x + 6, end), place.y + size.y + 3},
                       to_u32(colors.panel, 0.85f), 3);
  }
  list.AddText(nullptr, 0, place, to_u32(colors.text), shortened(text, end - place.x, 1).c_str(), nullptr, 0, &room);
}

void draw_border(const WindowUi& ui, const Viewer& viewer, ImDrawList& list) {
  const Palette& colors = palette(ui.dark);
  const ImVec4& color = color_of_mode(viewer.mode, colors);
  list.AddRect({viewer.view.rect.x0, viewer.view.rect.y0}, {viewer.view.rect.x1, viewer.view.rect.y1}, to_u32(color), 0,
               2);
}

void draw_hover_tooltip(const Viewer& viewer, const Shown& shown) {
  const SensorModelPtr model = shown.model(viewer);
  if (!viewer.hovered || !model) return;
  const Pick& under = *viewer.hovered;
  const bool shown_sensor = viewer.mode == Mode::layout || under.sensor == viewer.selection.sensor;
  std::string text;
  if (under.taxel >= 0 && under.taxel < model->taxel_count() && shown_sensor) {
    text = taxel_text(viewer, shown, *model, under.taxel);
  } else if (under.polygon >= 0) {
    text = fmt::format("Contact surface\n{}", in_kpa(under.pressure));
  } else if (under.sample >= 0 && shown_sensor && viewer.overlays().samples) {
    text = sample_text(*model, under.sample);
  }
  if (!text.empty()) ImGui::SetTooltip("%s", text.c_str());
}

void draw_labels(const WindowUi& ui, const ViewPlace& place, const ViewShown& view, ImDrawList& list) {
  const Palette& colors = palette(ui.dark);
  const float size = kSmallText * ImGui::GetFontSize();
  for (const SceneLabel& label : view.labels) {
    const float width = kSmallText * ImGui::CalcTextSize(label.text.c_str()).x;
    const ImVec2 at(std::round(place.rect.x0 + static_cast<float>(label.pixel.x) - 0.5f * width),
                    std::round(place.rect.y0 + static_cast<float>(label.pixel.y) - 0.5f * size));
    const ImVec4& plate = label.selected ? colors.accent : colors.panel;
    if (label.leader)
      draw_leader(place, *label.leader, {at.x - 3, at.y - 1, at.x + width + 3, at.y + size + 1},
                  label.occluded ? colors.dim : colors.text, list);
    list.AddRectFilled({at.x - 3, at.y - 1}, {at.x + width + 3, at.y + size + 1},
                       to_u32(plate, label.selected ? 1.0f : kPlate), 3);
    list.AddText(ImGui::GetFont(), size, at,
                 to_u32(label.selected   ? text_on(colors.accent)
                        : label.occluded ? colors.dim
                                         : colors.text),
                 label.text.c_str());
  }
}

LegendPlace legend_place(const ViewPlace& place, const LegendScales& scales) {
  const float margin = 0.7f * ImGui::GetFontSize();
  const ImVec2 size = legend_size(scales, {place.rect.width() - 2 * margin, place.rect.height() - 2 * margin});
  return {{place.rect.x1 - margin, place.rect.y0 + margin}, size.x, size.y};
}

namespace {

using MarkRows = std::vector<MarkRow>;

constexpr const char* kFolded = "Legend";
constexpr float kLegendPlate = 0.92f;  // opacity

double length_of(const std::vector<dvec3>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += glm::distance(line[i - 1], line[i]);
  return length;
}

/// Returns the colour of the first taxel that there is.
glm::vec4 color_of_taxels(const std::vector<SensorView>& views) {
  for (const SensorView& view : views)
    if (view.model->taxel_count() > 0) return glm::vec4(taxel_color(view.model->color(0)), 1);
  return glm::vec4(1);
}

void add_contact_rows(const SceneInput& input, const std::vector<SensorView>& views, const Look& look, MarkRows& rows) {
  const Overlays& show = input.overlays;
  bool touches = false, reads = false, sticks = false;
  for (const SensorView& view : views) {
    touches = touches || (view.state != nullptr && !view.state->surfaces.empty());
    sticks = sticks || (view.state != nullptr && !view.state->sticking.empty());
    reads = reads || (view.state != nullptr && view.model->taxel_count() > 0);
  }
  if (!force_marks(input, views).empty())
    rows.push_back({Glyph::arrow, look.force, "Net force",
                    fmt::format("{:g} mm = {:g} N", 1e3 * kNamedArrow, force_of_named_arrow(views))});
  if (show.rays && reads) {
    rows.push_back({Glyph::line, glm::vec4(glm::vec3(look.ray_hit), 1), "Rays to the contact", "true length, mm"});
    rows.push_back({Glyph::dot, glm::vec4(input.range.color(0.5 * (input.range.lo + input.range.hi)), 1),
                    "Pressure at their ends", "kPa"});
  }
  if (show.slip_map && show.contact_surface && sticks) {
    rows.push_back({Glyph::disc, glm::vec4(kSlipRange.color(0), 1), "Contact that sticks", "slip 0"});
    rows.push_back({Glyph::disc, glm::vec4(kSlipRange.color(1), 1), "Contact that slips", "slip 1"});
  } else if (show.slip_map && show.contact_surface && touches) {
    rows.push_back({Glyph::disc, glm::vec4(input.range.color(input.range.hi), 1), "No slip map: friction has no memory",
                    "pressure, kPa"});
  }
  if (show.contact_edges && touches) rows.push_back({Glyph::line, {0, 0, 0, 1}, "Edges of polygons", "true size, mm"});
  if (input.before)
    rows.push_back({Glyph::line, glm::vec4(glm::vec3(look.ghost), 1), "Previous step", "true size, mm"});
}

void add_taxel_rows(const SceneInput& input, const FieldNumbers& numbers, const std::vector<SensorView>& views,
                    const ReadingUnit& unit, MarkRows& rows) {
  const MarkCounts& marks = numbers.marks;
  const glm::vec4 color = color_of_taxels(views);
  if (marks.discs > 0)
    rows.push_back({Glyph::disc, glm::vec4(input.reading_range.color(0.5 * input.reading_range.hi), 1),
                    "Readings of fields", unit.text});
  if (marks.arrows > 0)
    rows.push_back({Glyph::arrow, color, "Normals of taxels",
                    views.size() == 1 ? in_mm(taxel_arrow_length(*views[0].model), 1) + " long" : "no unit"});
  if (marks.rings > 0 && input.overlays.receptive_fields)
    rows.push_back({Glyph::line, color, "Receptive fields", "true size, mm"});
  if (input.ghosts && input.frame) rows.push_back({Glyph::line, kGhostColor, "Fields of layout B", "true size, mm"});
  if (marks.samples > 0) rows.push_back({Glyph::dot, color, "Samples", grouped(marks.samples)});
  if (input.overlays.sample_normals) rows.push_back({Glyph::line, color, "Normals of samples", "no unit"});
}

void add_scene_rows(const SceneInput& input, const Look& look, MarkRows& rows) {
  if (const std::vector<dvec3> path = drawn_path(input); path.size() > 1)
    rows.push_back({Glyph::line, look.path, "Path of the finger", in_mm(length_of(path), 1)});
  if (!input.measure_points.empty())
    rows.push_back({Glyph::line, look.measure, "Measured distance",
                    input.measured ? in_mm(length_of(input.measured->path)) : "mm"});
  if (!input.frame) return;
  if (input.frame->perturbed) rows.push_back({Glyph::arrow, look.hand, "Pull on the body", "true length, mm"});
  if (!input.overlays.constraints) return;
  const std::vector<ConstraintPoints>& points = input.frame->constraint_points;
  const auto has = [&](bool weld) {
    return std::any_of(points.begin(), points.end(), [&](const ConstraintPoints& held) { return held.weld == weld; });
  };
  if (has(true)) rows.push_back({Glyph::line, look.weld, "Held fixed (weld)", "gap, mm"});
  if (has(false)) rows.push_back({Glyph::line, look.connection, "Held at a point", "gap, mm"});
}

void draw_glyph(ImDrawList& list, const MarkRow& row, ImVec2 middle, float size, const Palette& colors) {
  const ImU32 color = to_u32({row.color.x, row.color.y, row.color.z, 1}), rim = to_u32(colors.dim);
  const float half = 0.5f * size;
  switch (row.glyph) {
    case Glyph::arrow:
      list.AddLine({middle.x - half, middle.y + 0.5f * half}, {middle.x + 0.4f * half, middle.y - 0.2f * half}, rim, 4);
      list.AddLine({middle.x - half, middle.y + 0.5f * half}, {middle.x + 0.4f * half, middle.y - 0.2f * half}, color,
                   2.5f);
      list.AddTriangleFilled({middle.x + half, middle.y - 0.5f * half}, {middle.x, middle.y - 0.6f * half},
                             {middle.x + 0.4f * half, middle.y + 0.4f * half}, color);
      break;
    case Glyph::line:
      list.AddLine({middle.x - half, middle.y}, {middle.x + half, middle.y}, rim, 4);
      list.AddLine({middle.x - half, middle.y}, {middle.x + half, middle.y}, color, 2.5f);
      break;
    case Glyph::dot:
      list.AddCircleFilled(middle, 0.35f * half, color);
      list.AddCircle(middle, 0.35f * half + 1, rim);
      break;
    case Glyph::disc:
      list.AddCircleFilled(middle, 0.8f * half, color);
      list.AddCircle(middle, 0.8f * half, rim);
      break;
  }
}

}  // namespace

std::vector<MarkRow> mark_rows(const SceneInput& input, const FieldNumbers& numbers, const ReadingUnit& unit) {
  const std::vector<SensorView> views = sensor_views(input);
  const Look& colors = look(input.dark);
  MarkRows rows;
  add_contact_rows(input, views, colors, rows);
  add_taxel_rows(input, numbers, views, unit, rows);
  add_scene_rows(input, colors, rows);
  return rows;
}

std::vector<Rect> rects_to_see(const Viewer& viewer, const Shown& shown) {
  std::vector<BoxCorners> boxes = sensor_boxes(viewer, shown);
  if (const Aabb contact_W = contact_box(viewer, shown); !contact_W.empty()) boxes.push_back(corners_of(contact_W, {}));
  std::vector<Rect> rects;
  for (const BoxCorners& corners : boxes) {
    Rect rect{viewer.view.rect.x1, viewer.view.rect.y1, viewer.view.rect.x0, viewer.view.rect.y0};
    for (const dvec3& p_W : corners) {
      if (!(viewer.project(p_W).z > viewer.camera().near_plane())) continue;
      const ImVec2 at = on_screen(viewer, p_W);
      rect = {std::min(rect.x0, at.x), std::min(rect.y0, at.y), std::max(rect.x1, at.x), std::max(rect.y1, at.y)};
    }
    if (!rect.empty()) rects.push_back(rect);
  }
  return rects;
}

namespace {

/// Returns whether a legend covers one of the rectangles. A folded legend needs more room to unfold, so that it does
/// not flicker while a sensor moves at its edge.
bool covers(const ImVec2& corner, const ImVec2& size, const std::vector<Rect>& rects, bool was_folded) {
  const float room = was_folded ? 2 * ImGui::GetFontSize() : 0;
  return std::any_of(rects.begin(), rects.end(), [&](const Rect& rect) {
    return rect.x0 < corner.x + size.x + room && corner.x - room < rect.x1 && rect.y0 < corner.y + size.y + room &&
           corner.y - room < rect.y1;
  });
}

}  // namespace

void draw_mark_legend(WindowUi& ui, const ViewPlace& place, const std::vector<MarkRow>& rows, float top,
                      const std::vector<Rect>& rects, bool& is_folded) {
  constexpr float kMaxWidth = 0.45f, kMaxHeight = 0.6f;  // largest part of the view that the legend may cover
  if (rows.empty()) return;
  const Palette& colors = palette(ui.dark);
  ImGui::PushFont(nullptr, kTextHeight * kSmallText);
  const float line = ImGui::GetFontSize(), pad = 0.5f * line, step = 1.25f * line, glyph = 1.6f * line;
  const auto wide = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
  float name = 0, value = 0;
  for (const MarkRow& row : rows) {
    name = std::max(name, wide(row.name));
    value = std::max(value, wide(row.value));
  }
  const ImVec2 corner(std::floor(place.rect.x0 + place.strip + 0.9f * line), std::floor(top));
  const ImVec2 size(glyph + name + line + value + 2 * pad, step * static_cast<float>(rows.size()) + pad);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const auto text = [&](ImVec2 at, const ImVec4& color, const std::string& words) {
    list.AddText(at, to_u32(color), words.c_str());
    ui.widgets.note("Marks", words, {at.x, at.y, at.x + wide(words), at.y + line});
  };
  const ImVec2 folded(corner.x + wide(kFolded) + 2 * pad, corner.y + step + pad);
  const bool fits = size.x <= kMaxWidth * place.rect.width() && size.y <= kMaxHeight * place.rect.height();
  is_folded = !fits || covers(corner, size, rects, is_folded);
  if (is_folded && !ImGui::IsMouseHoveringRect(corner, folded)) {
    list.AddRectFilled(corner, folded, to_u32(colors.panel, kLegendPlate), 3);
    text({corner.x + pad, corner.y + 0.5f * pad}, colors.text, kFolded);
  } else {
    list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y}, to_u32(colors.panel, kLegendPlate), 3);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const ImVec2 at(corner.x + pad, std::round(corner.y + 0.5f * pad + step * static_cast<float>(i)));
      draw_glyph(list, rows[i], {at.x + 0.5f * line, at.y + 0.5f * line}, line, colors);
      text({at.x + glyph, at.y}, colors.text, rows[i].name);
      text({corner.x + size.x - pad - wide(rows[i].value), at.y}, colors.dim, rows[i].value);
    }
  }
  ImGui::PopFont();
}

namespace {

/// Returns an explanation of a reason of rejection.
const char* explain(Rejection reason) {
  switch (reason) {
    case Rejection::sliver:
      return "slivers, too thin to have a normal";
    case Rejection::touching:
      return "touching, in the skin without pressure";
    case Rejection::back_face:
      return "back faces, against the pressure's gradient";
    default:
      return "beyond the tets of a field that ends there (not drawn)";
  }
}

}  // namespace

std::array<RejectedPolygons, kRejections> left_out(const SensorStep& sensor) {
  std::array<RejectedPolygons, kRejections> sums{};
  for (const ContactSurface& surface : sensor.surfaces) {
    for (std::size_t r = 0; r < kRejections; ++r) {
      sums[r].count += surface.rejected[r].count;
      sums[r].area += surface.rejected[r].area;
      sums[r].force += surface.rejected[r].force;
    }
  }
  return sums;
}

float draw_filtered_legend(const WindowUi& ui, const ViewPlace& place, const SensorStep& sensor) {
  const Palette& colors = palette(ui.dark);
  const std::array<RejectedPolygons, kRejections> sums = left_out(sensor);
  std::array<std::string, kRejections> rows;
  const std::string title = "Left out of the contact surface";
  float width = ImGui::CalcTextSize(title.c_str()).x;
  for (std::size_t r = 0; r < kRejections; ++r) {
    rows[r] = fmt::format("{}: {}, {}, {}", explain(static_cast<Rejection>(r)), grouped(sums[r].count),
                          in_mm2(sums[r].area), in_newtons(sums[r].force));
    width = std::max(width, ImGui::CalcTextSize(rows[r].c_str()).x + ImGui::GetFontSize());
  }
  const float line = ImGui::GetFontSize(), pad = 0.5f * line, step = 1.3f * line;
  const float height = step * static_cast<float>(kRejections + 1) + pad;
  const ImVec2 corner(place.rect.x1 - 0.7f * line - width - 2 * pad, place.rect.y1 - 0.7f * line - height);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(corner, {corner.x + width + 2 * pad, corner.y + height}, to_u32(colors.panel, 0.85f), 3);
  list.AddText({corner.x + pad, corner.y + pad}, to_u32(colors.text), title.c_str());
  for (std::size_t r = 0; r < kRejections; ++r) {
    const float y = corner.y + pad + step * static_cast<float>(r + 1);
    const glm::vec3 c = rejection_color(static_cast<Rejection>(r));
    list.AddCircleFilled({corner.x + pad + 0.35f * line, y + 0.5f * line}, 0.3f * line,
                         to_u32(ImVec4(c.x, c.y, c.z, 1)));
    list.AddText({corner.x + pad + line, y}, to_u32(sums[r].count > 0 ? colors.text : colors.dim), rows[r].c_str());
  }
  return corner.y;
}

}  // namespace taxel::ui
