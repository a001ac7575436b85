// Draws all marks of a sensor in addition to its skin.
#include "ui/scene/marks/marks.h"

#include "ui/scene/paint/field_pass.h"
#include "ui/scene/passes/passes.h"

namespace taxel::ui {
namespace {

// How far marks are drawn before the surface they lie on, in parts of their depth.
constexpr float kPaintOnSkin = 0.002f, kOnSkin = 0.004f, kOnContact = 0.003f, kBeforeContact = 0.005f;
constexpr float kHiddenDim = 0.28f, kHiddenRayDim = 0.55f;
constexpr float kBeforeSkin = 0.02f;                           // taxels, which stick out
constexpr double kSamplePart = 0.5;                            // of the distance between samples
constexpr double kSmallestSample = 1.0, kLargestSample = 8.0;  // [pixel]
constexpr float kTaxelDiameter = 12, kSelectedDiameter = 17, kDotDiameter = 3.4f, kSelectedDotDiameter = 4.6f;
constexpr double kFullSizeArrow = 42, kSmallestMark = 0.4;  // [pixel] on the screen, below which marks shrink; how far
constexpr double kMinSampleSpacing = 2.0;                   // of samples [pixel]
constexpr int kMaxSeenThrough = 300;                        // taxels
constexpr float kForceWidth = 3.6f, kLeaderWidth = 1.2f;
constexpr float kGhostWidth = 1.0f, kMarkedWidth = 2.6f;
constexpr float kTractionOutline = 0.25f;
constexpr float kRingWidth = 1.5f, kThinRingWidth = 1.0f, kRingAlpha = 0.9f;  // of all rings [pixel]
constexpr std::size_t kManyRings = 200;                                       // with more taxels rings are thinner
constexpr double kMinRingRadius = 3;                                          // of the largest ring of a sensor [pixel]
constexpr float kFillOpacity = 0.42f;                                         // of fields that are filled
constexpr float kDiscAtRim = 0.7f;  // opacity of a disc at its rim as a fraction of that in the middle

/// Returns true if marks on the far side are drawn. A solid skin hides them, and if there are many taxels they would be
/// indistinguishable.
bool far_side_seen(const SceneInput& input, const SensorView& view) {
  return input.overlays.sensor_transparent && view.model->taxel_count() <= kMaxSeenThrough;
}

/// Returns the drawn map, or null if no map is active or the map is not computed yet.
const SensorFields* shown_map(const SceneInput& input, const SensorView& view) {
  const FieldMap map = field_map(input.overlays);
  if (map == FieldMap::none || !input.fields || input.fields->request.map != map) return nullptr;
  return input.fields->of(view.model);
}

}  // namespace

void SensorMarks::StraightFields::take(const SensorModelPtr& of) {
  if (model == of) return;
  rings = std::make_shared<const FieldRings>(geometry.rings(*of));
  discs = geometry.discs(*of);
  model = of;
}

/// Returns the rings of a sensor, or null if they are not computed yet. Geodesic rings are computed elsewhere.
std::shared_ptr<const FieldRings> SensorMarks::rings_of(const SceneInput& input, const SensorView& view) {
  if (const SensorFields* fields = input.fields ? input.fields->of(view.model) : nullptr) return fields->rings;
  if (view.model->layout.receptive_field.metric == Metric::geodesic) return nullptr;
  StraightFields& straight = straight_[view.index];
  straight.take(view.model);
  return straight.rings;
}

/// Returns the fields of a sensor, which are empty if they are not computed yet.
const FieldBuffer& SensorMarks::fields_of(const SceneInput& input, const SensorView& view) {
  FieldBuffer& buffer = field_buffers_[view.index];
  if (const SensorFields* fields = input.fields ? input.fields->of(view.model) : nullptr) {
    buffer.take(fields->discs);
  } else if (view.model->layout.receptive_field.metric == Metric::geodesic) {
    buffer.take(nullptr);
  } else {
    StraightFields& straight = straight_[view.index];
    straight.take(view.model);
    buffer.take(straight.discs);
  }
  return buffer;
}

ModelMarks& SensorMarks::marks_of(const Scene& scene, const SensorView& view) {
  std::unique_ptr<ModelMarks>& marks = marks_[view.index];
  std::shared_ptr<const FieldRings> rings = rings_of(scene.input, view);
  if (!marks || !marks->is_for(view.model, view.hidden_taxels, scene.look, rings)) {
    marks = std::make_unique<ModelMarks>(view.model, view.hidden_taxels, scene.look, std::move(rings));
  }
  marks->select(view.selected_taxels);
  return *marks;
}

namespace {

/// Returns the pixels of marks per metre, at the camera's target.
double pixels_per_metre(const SceneInput& input, const Camera& camera, int height) {
  return 0.5 * height / input.scale / (camera.distance * std::tan(0.5 * glm::radians(camera.fov_deg)));
}

}  // namespace

void SensorMarks::draw_on_skin(const SceneInput& input, const Camera& camera, const Look& look, int height,
                               SegmentPass& segments, PointPass& points) {
  const Scene scene{input, camera, look, pixels_per_metre(input, camera, height), segments, points};
  const std::vector<SensorView> views = sensor_views(input);
  tractions_.reset();
  counts_ = {};
  mark_taxels(scene, views);
  for (const SensorView& view : views) {
    if (input.overlays.taxels) draw_taxels(scene, view, false);
    draw_paint(scene, view);
    draw_discs(scene, views, view);
    if (input.overlays.readings_on_skin && view.state != nullptr) draw_skin_readings(scene, view);
    draw_fields(scene, view);
  }
}

void SensorMarks::draw_above(const SceneInput& input, const Camera& camera, const Look& look, int height,
                             SegmentPass& segments, PointPass& points) {
  const Scene scene{input, camera, look, pixels_per_metre(input, camera, height), segments, points};
  const std::vector<SensorView> views = sensor_views(input);
  for (const SensorView& view : views) {
    if (view.state == nullptr) continue;
    const bool selected = view.selected_taxel >= 0;
    if (input.overlays.rays && !selected) draw_rays(scene, view);
    draw_contact(scene, view);
    if (input.overlays.tractions) draw_tractions(scene, view);
    if (input.overlays.contact_surface) draw_explained(scene, view);
    if (input.overlays.filtered_polygons) draw_filtered(scene, view);
    if (input.overlays.rays && selected) draw_rays(scene, view);
  }
  draw_path_marks(input, look, segments, points);
  draw_plans(scene);
  draw_measure_marks(input, look, segments, points);
  for (const SensorView& view : views) {
    if (input.overlays.taxels) draw_taxels(scene, view, true);
    if (input.overlays.normal_angles) draw_normals(scene, view);
  }
  draw_forces(scene, views);
  note_numbers(input, views);
}

FieldPaint& SensorMarks::paint_of(const SensorView& view) {
  std::unique_ptr<FieldPaint>& paint = field_paint_[view.index];
  if (!paint || paint->model() != view.model) paint = std::make_unique<FieldPaint>(view.model);
  return *paint;
}

void SensorMarks::draw_paint(const Scene& scene, const SensorView& view) {
  MarkState state{.world_from_model = matrix(view.X_WM), .toward_eye = kPaintOnSkin};
  state.clipped = scene.input.clip.has_value();
  if (!scene.input.region->empty() && view.state == nullptr)
    paint_.draw(region_.take(view.model->repaired, scene.input.region), state);
  if (scene.input.repair_changes && view.state == nullptr && view.model->mesh != view.model->loaded)
    repair_.draw(view.model->repaired, view.model->loaded, paint_, scene.segments, state);
  if (shown_map(scene.input, view) == nullptr) return;
  if (scene.input.fields->request.map == FieldMap::compared)
    return paint_.draw(paint_of(view).map(scene.input.fields), state);
  const bool coverage = scene.input.fields->request.map == FieldMap::coverage;
  std::vector<int> taxels;
  std::vector<FieldStyle> styles;
  for (int k = 0; k < view.model->taxel_count(); ++k) {
    taxels.push_back(k);
    const glm::vec4 own(taxel_color(view.model->color(k)), kFillOpacity);
    styles.push_back({.fill = pack(coverage ? glm::vec4(kCoveredTint, 1) : own)});
  }
  fields_.draw(fields_of(scene.input, view), taxels, styles, {.state = state, .multiplies = coverage});
}

void SensorMarks::draw_normals(const Scene& scene, const SensorView& view) {
  const double length = taxel_arrow_length(*view.model);
  const auto size =
      static_cast<float>(std::clamp(length * scene.pixels_per_metre / kFullSizeArrow, kSmallestMark, 1.0));
  const FieldPaint::Normals& normals = paint_of(view).normals(length, pack(scene.look.ray_hit));
  MarkState state{.world_from_model = matrix(view.X_WM), .toward_eye = kBeforeSkin, .facing = Facing::eye};
  state.clipped = scene.input.clip.has_value();
  scene.segments.draw_lines(normals.skin, state);
  scene.segments.draw_arrows(normals.arrows, state, scene.look.mark_outline, size);
}

void SensorMarks::note_numbers(const SceneInput& input, const std::vector<SensorView>& views) {
  numbers_ = {};
  numbers_.marks = counts_;
  if (views.empty()) return;
  if (const SensorFields* fields = shown_map(input, views.front())) {
    numbers_.coverage = fields->coverage;
    numbers_.comparison = fields->comparison;
  } else {
    numbers_.due = field_map(input.overlays) != FieldMap::none;
  }
  numbers_.tractions = tractions_;
  if (input.overlays.normal_angles) numbers_.normals = paint_of(views.front()).normal_numbers();
}

/// Draws thin rings of all taxels. Rings that would be a few pixels wide are left out.
void SensorMarks::draw_thin_rings(const Scene& scene, const SensorView& view, bool towards) {
  const std::vector<Taxel>& all = view.model->layout.taxels;
  double largest = 0;
  for (const Taxel& taxel : all) largest = std::max(largest, taxel.radius);
  const double distance =
      scene.camera.depth_scale(glm::distance(scene.camera.eye(), view.X_WM * view.model->mesh->bounds().center()));
  if (largest * scene.pixels_per_metre * scene.camera.distance < kMinRingRadius * distance) return;
  const float width = all.size() > kManyRings ? kThinRingWidth : kRingWidth;
  std::vector<int> taxels;
  std::vector<FieldStyle> styles(all.size());
  for (int k = 0; k < view.model->taxel_count(); ++k) {
    if (view.hidden(k)) continue;
    taxels.push_back(k);
    styles[at(k)] = {.ring = pack(glm::vec4(taxel_color(view.model->color(k)), kRingAlpha)), .ring_width = width};
  }
  FieldDraw how{.state = {.world_from_model = matrix(view.X_WM), .toward_eye = kOnSkin},
                .side = towards ? Side::front : Side::back,
                .casing = scene.look.ring_casing};
  how.state.clipped = scene.input.clip.has_value();
  if (!towards) how.state.dim = kHiddenDim;
  fields_.draw(fields_of(scene.input, view), taxels, styles, how);
  if (towards) counts_.rings += static_cast<int>(taxels.size());
}

void SensorMarks::draw_rings(const Scene& scene, const SensorView& view, bool towards) {
  if (!scene.input.overlays.receptive_fields || !(towards || far_side_seen(scene.input, view))) return;
  draw_thin_rings(scene, view, towards);
  const ModelMarks& marks = marks_of(scene, view);
  MarkState state{.world_from_model = matrix(view.X_WM), .toward_eye = kOnSkin};
  state.clipped = scene.input.clip.has_value();
  state.facing = towards ? Facing::eye : Facing::away;
  if (!towards) state.dim = kHiddenDim;
  const int hovered = scene.input.hovered_taxel;
  if (!scene.input.overlays.all_taxels && scene.input.hovered_sensor == view.index && hovered >= 0 &&
      hovered < view.model->taxel_count() && !view.hidden(hovered)) {
    Segments rim;
    marks.append_rim(hovered, rim);
    scene.segments.draw_lines(rim, state);
    if (towards && !view.selected(hovered)) ++counts_.bold_rings;
  }
  scene.segments.draw_lines(marks.selected().rings, state);
  if (towards) counts_.bold_rings += static_cast<int>(view.selected_taxels.size());
}

void SensorMarks::draw_fields(const Scene& scene, const SensorView& view) {
  ModelMarks& marks = marks_of(scene, view);
  MarkState state{.world_from_model = matrix(view.X_WM), .toward_eye = kOnSkin};
  state.clipped = scene.input.clip.has_value();
  draw_rings(scene, view, false);
  if (scene.input.overlays.samples) {
    counts_.samples += marks.sample_count();
    const double spacing = marks.sample_spacing() * scene.pixels_per_metre;
    // Crowded samples are indistinguishable; fewer and larger samples, spread evenly, look the same.
    const double diameter =
        std::clamp(kSamplePart * std::max(spacing, kMinSampleSpacing), kSmallestSample, kLargestSample);
    const double part = part_apart(spacing, kMinSampleSpacing);
    state.facing = Facing::eye;
    scene.points.draw(marks.samples(), {.diameter = static_cast<float>(diameter)}, state, scene.camera.eye(),
                      static_cast<int>(std::ceil(part * marks.sample_count())));
    state.facing = Facing::all;
  }
  if (scene.input.overlays.sample_normals) scene.segments.draw_lines(marks.sample_normals(), state);
  draw_rings(scene, view, true);
}

void SensorMarks::draw_contact(const Scene& scene, const SensorView& view) {
  if (!scene.input.overlays.contact_surface) return;
  std::vector<SurfaceVertex> triangles;
  Segments edges, rim;
  const std::vector<StickingFriction>& sticking = view.state->sticking;
  const bool slips = scene.input.overlays.slip_map && !sticking.empty();
  const PressureRange& range = slips ? kSlipRange : scene.input.range;
  for (std::size_t s = 0; s < view.state->surfaces.size(); ++s) {
    const ContactSurface& surface = view.state->surfaces[s];
    const std::vector<double> slip = slips ? slip_values(surface, sticking[s]) : std::vector<double>();
    const std::span<const double> values = slips ? std::span(slip) : std::span<const double>(surface.pressure);
    append_triangles(surface, values, triangles);
    append_rim(surface, values, range, rim);
    if (scene.input.overlays.contact_edges) append_edges(surface, 1.0f, pack(glm::vec4(0, 0, 0, 0.55f)), edges);
  }
  // The surface is inside the skin, and must not reach through an opaque one.
  const float lift = shows_opaque_skins(scene.input) ? 0.0f : kOnContact;
  MarkState state{.world_from_model = matrix(view.X_WM), .toward_eye = lift, .depth_write = true};
  scene.segments.draw_lines(rim, {.world_from_model = state.world_from_model, .toward_eye = lift});
  surfaces_.draw(triangles, range, state);
  state.toward_eye = lift + kBeforeContact - kOnContact;
  state.depth_write = false;
  scene.segments.draw_lines(edges, state);
}

/// Draws the surfaces of the previous step as thin lines at their former places, and the marked polygon of the
/// displayed step with a thick outline.
void SensorMarks::draw_explained(const Scene& scene, const SensorView& view) {
  const SceneInput& input = scene.input;
  if (const Step* before = input.before.get();
      before != nullptr && static_cast<std::size_t>(view.index) < before->sensors.size()) {
    const SensorStep& was = before->sensors[static_cast<std::size_t>(view.index)];
    Segments lines;
    for (const ContactSurface& surface : was.surfaces)
      append_edges(surface, kGhostWidth, pack(scene.look.ghost), lines);
    scene.segments.draw_lines(lines, {.world_from_model = matrix(was.X_WM), .toward_eye = kBeforeContact});
  }
  if (view.index != input.selected_sensor || input.marked_polygon < 0) return;
  const auto s = static_cast<std::size_t>(input.marked_surface), p = static_cast<std::size_t>(input.marked_polygon);
  if (s >= view.state->surfaces.size() || p >= view.state->surfaces[s].polygons.size()) return;
  const ContactSurface& surface = view.state->surfaces[s];
  Segments under, outline;
  append_edges(surface, surface.polygons[p], kMarkedWidth + 2, pack(scene.look.mark_outline), under);
  append_edges(surface, surface.polygons[p], kMarkedWidth, pack(scene.look.selection), outline);
  const MarkState state{.world_from_model = matrix(view.X_WM), .toward_eye = kBeforeContact};
  scene.segments.draw_lines(under, state);
  scene.segments.draw_lines(outline, state);
}

/// Draws the readings in the colours of the bars, which are looked up for each fragment.
void SensorMarks::draw_skin_readings(const Scene& scene, const SensorView& view) {
  const SensorFields* fields = scene.input.fields ? scene.input.fields->of(view.model) : nullptr;
  if (fields == nullptr || !fields->weights) return;
  const SkinWeights& skin = *fields->weights;
  std::vector<float> values;
  skin.spread(view.state->readings, values);
  std::vector<SurfaceVertex> triangles;
  triangles.reserve(3 * skin.triangles.size());
  for (const auto& corners : skin.triangles)
    for (const int i : corners) {
      const auto k = static_cast<std::size_t>(i);
      triangles.push_back({skin.points[k], values[k]});
    }
  MarkState state{.world_from_model = matrix(view.X_WM), .toward_eye = kPaintOnSkin};
  state.clipped = scene.input.clip.has_value();
  surfaces_.draw(triangles, scene.input.reading_range, state, Seen::front);
}

/// Draws the tractions. Parts that bodies hide are dimmed, because arrows begin on the contact surface and reach into
/// the sensor.
void SensorMarks::draw_tractions(const Scene& scene, const SensorView& view) {
  const TractionMarks marks = traction_marks(view, scene.input.range, scene.look);
  if (view.index == scene.input.selected_sensor) tractions_ = marks.numbers;
  MarkState state{.world_from_model = matrix(view.X_WM), .toward_eye = kBeforeContact};
  MarkState behind = state;
  behind.hidden = true;
  behind.dim = kHiddenRayDim;
  const glm::vec4 outline(glm::vec3(scene.look.mark_outline), kTractionOutline);
  for (const Segments* arrows : {&marks.normal, &marks.friction}) {
    scene.segments.draw_arrows(*arrows, behind, outline);
    scene.segments.draw_arrows(*arrows, state, outline);
  }
}

/// Draws the polygons that were left out. They are in front of all other marks, because they are inside the skin or are
/// slivers.
void SensorMarks::draw_filtered(const Scene& scene, const SensorView& view) {
  const FilteredMarks marks = filtered_marks(view.state->surfaces);
  const MarkState state{.world_from_model = matrix(view.X_WM), .toward_eye = kBeforeSkin};
  scene.segments.draw_lines(marks.edges, state);
  const PointStyle dots{.diameter = kSelectedDotDiameter, .outline = scene.look.mark_outline, .outline_width = 0.6f};
  scene.points.draw(marks.dots, dots, state);
}

/// Rays of all responding taxels go behind the contact surface, so that nothing tints its colours. The rays of a
/// selected taxel go in front of it, because the user wants to see them. Marks that solid bodies hide are dimmed.
void SensorMarks::draw_rays(const Scene& scene, const SensorView& view) {
  const double spacing = marks_of(scene, view).sample_spacing() * scene.pixels_per_metre;
  const RayMarks rays = ray_marks(view, scene.input.overlays.all_rays, scene.input.range, scene.look, spacing);
  MarkState state{.world_from_model = matrix(view.X_WM)};
  MarkState behind = state;
  behind.hidden = true;
  behind.dim = kHiddenRayDim;
  PointStyle dots{.diameter = kDotDiameter};
  if (view.selected_taxel >= 0) {
    dots = {.diameter = kSelectedDotDiameter, .outline = scene.look.mark_outline, .outline_width = 0.6f};
  }
  scene.segments.draw_lines(rays.hits, behind);
  scene.segments.draw_lines(rays.misses, state);
  scene.segments.draw_lines(rays.hits, state);
  scene.points.draw(rays.dots, dots, behind);
  state.toward_eye = kBeforeContact;
  scene.points.draw(rays.dots, dots, state);
}

/// Finds the taxels that have arrows, and how they are seen if only few have.
void SensorMarks::mark_taxels(const Scene& scene, const std::vector<SensorView>& views) {
  const std::vector<std::vector<int>> marked = marked_taxels(scene.input, views);
  seen_.clear();
  for (std::size_t v = 0; v < views.size(); ++v) {
    if (scene.input.overlays.taxels) counts_.arrows += static_cast<int>(marked[v].size());
    if (scene.input.overlays.all_taxels) continue;
    for (const int k : marked[v]) {
      if (views[v].selected(k)) continue;  // the selected taxels have arrows of their own
      const Sighting seen = sighting(scene.input, views, views[v], k, scene.camera.eye());
      SeenTaxels& list = seen_[views[v].index];
      (seen == Sighting::clear ? list.clear : list.behind).push_back(k);
    }
  }
}

/// Draws the receptive fields of responding taxels in the colours of their readings. The far side of a transparent skin
/// is dimmed.
void SensorMarks::draw_discs(const Scene& scene, const std::vector<SensorView>& views, const SensorView& view) {
  const DiscMarks discs = disc_marks(scene.input, views, view, scene.camera.eye(), kHiddenDim);
  if (discs.taxels.empty()) return;
  const FieldBuffer& fields = fields_of(scene.input, view);
  if (fields.discs() == nullptr) return;
  counts_.discs += static_cast<int>(discs.taxels.size());
  std::vector<FieldStyle> styles(view.model->layout.taxels.size());
  for (std::size_t i = 0; i < discs.taxels.size(); ++i) styles[at(discs.taxels[i])].fill = discs.fills[i];
  FieldDraw how{.state = {.world_from_model = matrix(view.X_WM), .toward_eye = kPaintOnSkin}, .at_rim = kDiscAtRim};
  how.state.clipped = scene.input.clip.has_value();
  if (scene.input.overlays.sensor_transparent) {
    how.state.dim = kHiddenDim;
    how.side = Side::back;
    fields_.draw(fields, discs.taxels, styles, how);
    how.state.dim = 1;
    how.side = Side::front;
  }
  fields_.draw(fields, discs.taxels, styles, how);
}

void SensorMarks::draw_taxels(const Scene& scene, const SensorView& view, bool towards) {
  const bool all = scene.input.overlays.all_taxels;
  if (!towards && !(all ? far_side_seen(scene.input, view) : scene.input.overlays.sensor_transparent)) return;
  const ModelMarks& marks = marks_of(scene, view);
  const double arrow = taxel_arrow_length(*view.model) * scene.pixels_per_metre;
  const auto size = static_cast<float>(std::clamp(arrow / kFullSizeArrow, kSmallestMark, 1.0));
  MarkState state{.world_from_model = matrix(view.X_WM), .toward_eye = kOnSkin};
  state.clipped = scene.input.clip.has_value();
  if (!towards) state.dim = kHiddenDim;
  const PointStyle dots{
      .diameter = size * kTaxelDiameter, .outline = scene.look.mark_outline, .outline_width = 1.6f * size};
  if (!all) {
    const SeenTaxels& seen = seen_[view.index];
    Segments arrows;
    std::vector<PointMark> centers;
    for (const int k : towards ? seen.clear : seen.behind) marks.append_taxel(k, arrows, centers);
    scene.segments.draw_arrows(arrows, state, scene.look.mark_outline, size);
    scene.points.draw(centers, dots, state);
  }
  state.facing = towards ? Facing::eye : Facing::away;
  if (all) scene.segments.draw_arrows(marks.arrows(), state, scene.look.mark_outline, size);
  scene.segments.draw_arrows(marks.selected().arrows, state, scene.look.mark_outline, size);
  state.toward_eye = kBeforeSkin;
  if (all) scene.points.draw(marks.centers(), dots, state);
  const PointStyle selected{
      .diameter = size * kSelectedDiameter, .outline = scene.look.selection, .outline_width = 2.6f * size};
  scene.points.draw(marks.selected().centers, selected, state);
}

void SensorMarks::draw_forces(const Scene& scene, const std::vector<SensorView>& views) {
  Segments arrows, leaders;
  for (const ForceMark& mark : force_marks_aside(scene.input, views, scene.camera)) {
    arrows.push_back(segment(mark.base_W, mark.tip_W, kForceWidth, pack(scene.look.force)));
    leaders.push_back(segment(mark.center_W, mark.base_W, kLeaderWidth, pack(scene.look.force)));
  }
  counts_.forces = static_cast<int>(arrows.size());
  // An opaque skin would hide the arrow, whose value stays in view.
  const MarkState state{.toward_eye = kBeforeContact, .depth_test = scene.input.overlays.sensor_transparent};
  scene.segments.draw_lines(leaders, state);
  if (!arrows.empty()) scene.segments.draw_arrows(arrows, state, scene.look.mark_outline);
}

/// Draws plans: the painted region below all marks of taxels, and taxels that are not in the layout yet above them.
void SensorMarks::draw_plans(const Scene& scene) {
  if (!scene.input.ghosts) return;
  const double arrow = ghosts_.take(scene.input.ghosts, scene.look) * scene.pixels_per_metre;
  const auto size = static_cast<float>(std::clamp(arrow / kFullSizeArrow, kSmallestMark, 1.0));
  MarkState state{.toward_eye = kOnSkin, .dim = kHiddenDim, .facing = Facing::away};
  const auto sensor = static_cast<std::size_t>(scene.input.ghosts_sensor);
  if (scene.input.frame && scene.input.ghosts_sensor >= 0 && sensor < scene.input.frame->sensors.size())
    state.world_from_model = matrix(scene.input.frame->sensors[sensor].X_WM);
  if (scene.input.overlays.sensor_transparent) scene.segments.draw_lines(ghosts_.rings(), state);
  state.dim = 1;
  state.facing = Facing::eye;
  scene.segments.draw_lines(ghosts_.rings(), state);
  scene.segments.draw_arrows(ghosts_.arrows(), state, scene.look.mark_outline, size);
  state.toward_eye = kBeforeSkin;
  const PointStyle style{
      .diameter = size * kTaxelDiameter, .outline = scene.look.selection, .outline_width = 1.8f * size};
  scene.points.draw(ghosts_.centers(), style, state);
}

}  // namespace taxel::ui
