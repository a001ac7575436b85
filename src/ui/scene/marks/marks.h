// The marks of the 3-D view, one source for each kind, the taxels that have marks, and the drawing of all marks of a
// sensor in addition to its skin.
#pragma once

#include <glm/glm.hpp>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/hydro/contact_surface.h"
#include "core/layout/layout.h"
#include "core/mesh/repair/repair.h"
#include "core/sensor/surface_motion.h"
#include "ui/scene/camera.h"
#include "ui/scene/color_map.h"
#include "ui/scene/geometry/field_patch.h"
#include "ui/scene/geometry/shown_fields.h"
#include "ui/scene/paint/field_pass.h"
#include "ui/scene/paint/mark_pass.h"
#include "ui/scene/paint/paint.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/scene_input.h"
#include "ui/scene/scene_parts.h"

namespace taxel::ui {

/// Length of an arrow that the legend names [m].
inline constexpr double kNamedArrow = 0.01;

/// The arrow of one sensor's net force.
struct ForceMark {
  int sensor = 0;
  dvec3 center_W{0};          ///< centroid of the pressure, where the force acts [m]
  dvec3 base_W{0}, tip_W{0};  ///< ends of the arrow [m]
  double force = 0;           ///< [N]
};

/// Returns the force [N] that an arrow of kNamedArrow means: 1 N, or the smallest larger power of ten at which no
/// arrow of the frame is longer than 0.8 of the diagonal of its sensor.
[[nodiscard]] double force_of_named_arrow(const std::vector<SensorView>& views);

/// Returns the arrows of all sensors in contact, from the centroid of the pressure, or none if the contact surface is
/// not drawn. Lengths are proportional to forces.
[[nodiscard]] std::vector<ForceMark> force_marks(const SceneInput& input, const std::vector<SensorView>& views);
/// Returns force_marks() moved across the line of sight, to the right of the force, so that no arrow covers its contact
/// in the image.
[[nodiscard]] std::vector<ForceMark> force_marks_aside(const SceneInput& input, const std::vector<SensorView>& views,
                                                       const Camera& camera);

/// Returns the text at the tip of an arrow: "0.84 N".
[[nodiscard]] std::string force_text(double force);

/// Marks of the rays of a reading: hits at full length with a dot at the hit, misses as faint stubs.
struct RayMarks {
  Segments hits, misses;        ///< lines in frame M
  std::vector<PointMark> dots;  ///< dots at the hits, coloured by pressure
};

/// Returns the rays of the selected taxel, or of all taxels with readings above 0 if none is selected, or all rays if
/// `all` is true. If there are too many to distinguish, they are thinned evenly and always in the same way. `spacing`
/// is the distance of samples on the screen [pixel].
RayMarks ray_marks(const SensorView& view, bool all, const PressureRange& range, const Look& look, double spacing);

/// Two arrows from the centroid of each polygon, with the values of traction(): p n, the pressure with damping along
/// the normal that pushes the sensor, and the friction t: in the plane of the polygon, or that of the bristles if it
/// sticks. Frame M.
struct TractionMarks {
  Segments normal, friction;
  TractionNumbers numbers;
};
/// Builds the arrows. The length of an arrow for the largest pressure of the range is a seventh of the sensor's
/// diagonal.
TractionMarks traction_marks(const SensorView& view, const PressureRange& range, const Look& look);

// The polygons that were left out of contact surfaces, in the colour of the reason.

/// The outline of each polygon, and a dot at its centre, because many of them have almost no area. Frame M.
struct FilteredMarks {
  Segments edges;
  std::vector<PointMark> dots;
};
FilteredMarks filtered_marks(std::span<const ContactSurface> surfaces);

/// Returns the drawn path in the world [m]: the edited one, or that of the frame; empty without a path.
[[nodiscard]] std::vector<dvec3> drawn_path(const SceneInput& input);

/// Draws the path of the finger, with the waypoints of an edited path in front of everything else.
void draw_path_marks(const SceneInput& input, const Look& look, SegmentPass& segments, PointPass& points);

/// Draws the measured path on the skin as a thick line, and the straight distance as a thin line.
void draw_measure_marks(const SceneInput& input, const Look& look, SegmentPass& segments, PointPass& points);

/// Draws an arrow from the grabbed point to the pointer, or an arc as wide as the rotation, and lines between
/// constraint points.
void draw_hand_marks(const SceneInput& input, const Camera& camera, const Look& look, SegmentPass& segments,
                     PointPass& points);

/// Draws x red, y green and z blue, with the lengths that MuJoCo uses and twice this length for the world. Axes inside
/// bodies are dimmed.
void draw_frame_marks(const SceneInput& input, const Look& look, SegmentPass& segments);

/// Draws over the present content. The frame must be a pixel_frame(), of a view of this size in pixels of marks.
void draw_gizmo(SegmentPass& segments, PointPass& points, const Camera& camera, const Look& look, const dvec2& view);

/// Colour of the marks, sRGB.
inline constexpr glm::vec4 kGhostColor{1.00f, 0.78f, 0.24f, 1.0f};

/// Taxels that are not in the layout yet: centres, arrows and, unless there are too many to distinguish, fields as
/// circles in their tangent planes.
class GhostMarks {
 public:
  /// Builds the marks again if the taxels differ from the last call's. Returns the length of the arrows [m].
  double take(const std::shared_ptr<const std::vector<Taxel>>& taxels, const Look& look);

  [[nodiscard]] const gl::Buffer& rings() const { return rings_; }
  [[nodiscard]] const gl::Buffer& arrows() const { return arrows_; }
  [[nodiscard]] const PointBuffer& centers() const { return centers_; }

 private:
  std::shared_ptr<const std::vector<Taxel>> taxels_;
  const Look* look_ = nullptr;
  gl::Buffer rings_, arrows_;
  PointBuffer centers_;
  double arrow_ = 0;
};

/// Colours of the changes by a repair, sRGB, 0 to 1.
inline constexpr glm::vec3 kFilledColor{0.20f, 0.74f, 0.30f}, kRemovedColor{0.90f, 0.20f, 0.16f},
    kPartedColor{0.98f, 0.82f, 0.10f};

/// The largest distance between a wrapped surface and the loaded faces [m]; 0 if nothing was wrapped.
inline double largest_distance(const RepairChanges& changes) {
  return changes.distance.empty()
             ? 0.0
             : static_cast<double>(*std::max_element(changes.distance.begin(), changes.distance.end()));
}

/// Returns the colour of a wrapped vertex at a distance [m], on a scale from 0 to `largest` [m].
inline glm::vec3 distance_color(double distance, double largest) {
  return kColorMaps.front().at(largest > 0 ? distance / largest : 0.0);
}

/// Changes of a mesh by its repair, drawn over its skin: filled faces, removed faces, separated edges, distances of a
/// wrap.
class RepairMarks {
 public:
  /// Draws the changes from the loaded to the repaired mesh, in the frame of `state`.
  void draw(const RepairedMeshPtr& repaired, const TriMeshPtr& loaded, const PaintPass& paint, SegmentPass& segments,
            const MarkState& state);

 private:
  void make(const TriMesh& loaded);

  RepairedMeshPtr repaired_;
  PaintBuffer faces_;
  Segments removed_, parted_;
};

// The marks of one sensor model that do not change with the simulation: samples, taxels, receptive fields.

/// Returns marks of the samples, coloured by their nearest taxel; unused samples are grey and small, those of selected
/// taxels largest. Their order is such that the first n marks are spread over the whole skin for any n.
std::vector<PointMark> sample_marks(const SensorModel& model, const std::vector<int>& selected, const Look& look);

/// Marks in GPU memory, built once for a model; marks that show the selection are rebuilt when it changes.
class ModelMarks {
 public:
  /// `hidden` has the taxels that are left out, ascending. `rings` has the boundary of each taxel's field, or is null
  /// if unknown.
  ModelMarks(SensorModelPtr model, std::vector<int> hidden, const Look& look, std::shared_ptr<const FieldRings> rings);
  [[nodiscard]] bool is_for(const SensorModelPtr& model, const std::vector<int>& hidden, const Look& look,
                            const std::shared_ptr<const FieldRings>& rings) const {
    return model == model_ && hidden == hidden_ && &look == look_ && rings == ring_pieces_;
  }
  /// Sets the selected taxels, ascending.
  void select(const std::vector<int>& taxels);

  [[nodiscard]] SurfacePoints& samples() { return samples_; }
  [[nodiscard]] int sample_count() const { return static_cast<int>(model_->samples.size()); }
  [[nodiscard]] double sample_spacing() const { return spacing_; }  ///< approximate distance of samples [m]
  /// Returns the normals of the samples as short lines. They are built at the first call.
  const gl::Buffer& sample_normals();

  // The marks have the normals of faces and taxels, so that marks that look away can be drawn separately.
  [[nodiscard]] const gl::Buffer& arrows() const { return arrows_; }
  [[nodiscard]] const PointBuffer& centers() const { return centers_; }
  /// Appends the arrow and the centre of a taxel.
  void append_taxel(int taxel, Segments& arrows, std::vector<PointMark>& centers) const;
  /// Appends the rim of a taxel's receptive field.
  void append_rim(int taxel, Segments& rims) const;
  struct Selected {
    gl::Buffer rings, arrows;
    PointBuffer centers;
  };
  [[nodiscard]] const Selected& selected() const { return selected_marks_; }

 private:
  [[nodiscard]] bool hides(int taxel) const { return std::binary_search(hidden_.begin(), hidden_.end(), taxel); }
  void append_ring(int taxel, float width, std::uint32_t color, Segments& out) const;
  [[nodiscard]] Segment arrow_segment(int taxel, float width) const;
  [[nodiscard]] PointMark center_mark(int taxel) const;

  SensorModelPtr model_;
  std::vector<int> hidden_;
  const Look* look_;
  std::shared_ptr<const FieldRings> ring_pieces_;
  SurfacePoints samples_;
  PointBuffer centers_;
  gl::Buffer arrows_;
  std::optional<gl::Buffer> sample_normals_;
  Selected selected_marks_;
  std::optional<std::vector<int>> selected_;
  double spacing_ = 0;
};

/// Returns the length of a taxel's arrow [m], at most the distance between taxels.
double taxel_arrow_length(const SensorModel& model);

// The taxels that have an arrow and an id in the view.

/// Largest number of taxels with an arrow while overlays.all_taxels is off. More arrows than these hide the contact.
inline constexpr int kMaxMarkedTaxels = 60;
/// Smallest reading of a responding taxel, as a fraction of the range of the readings.
inline constexpr double kRespondingPart = 0.02;
/// Height above a taxel's centre of the point that decides how the taxel is seen, in parts of its radius.
inline constexpr double kSightLift = 0.2;

/// Returns whether the reading of a taxel is large enough to be seen.
[[nodiscard]] bool is_responding(const SceneInput& input, const SensorView& view, int taxel);
/// Returns whether the pointer is on a taxel.
[[nodiscard]] bool is_hovered(const SceneInput& input, const SensorView& view, int taxel);

/// Returns the taxels with an arrow and an id, ascending, one list for each view. Hidden taxels have none. With
/// overlays.all_taxels these are all others. Otherwise these are the hovered, the selected and the responding ones, at
/// most kMaxMarkedTaxels of all sensors together: first the hovered and the selected ones, then those with the largest
/// readings; equal readings in the order of the taxels.
[[nodiscard]] std::vector<std::vector<int>> marked_taxels(const SceneInput& input,
                                                          const std::vector<SensorView>& views);

/// How a taxel is seen from the eye.
enum class Sighting {
  clear,   ///< nothing is in front of the taxel, and it faces the eye
  behind,  ///< the taxel faces away, or a transparent skin is in front of it
  hidden   ///< a solid body is in front of it, or an opaque skin
};
/// Returns how a taxel is seen, at a point just above its centre, which may lie a little below the skin. Cost: one ray
/// through all skins and solid bodies.
[[nodiscard]] Sighting sighting(const SceneInput& input, const std::vector<SensorView>& views, const SensorView& view,
                                int taxel, const dvec3& eye_W);

/// The receptive fields of responding taxels as discs on the skin that glow in the colours of their readings.
struct DiscMarks {
  std::vector<int> taxels;           ///< taxels with a disc, the largest reading last
  std::vector<std::uint32_t> fills;  ///< colour of each disc, parallel to `taxels`
};

/// Returns the discs of one sensor. There are none without overlays.receptive_fields and overlays.reading_discs, and of
/// sensors whose readings have another unit than those of the selected sensor, whose range colours them. Discs that
/// face the eye behind the skin of another sensor have `dim` times the opacity of other discs.
[[nodiscard]] DiscMarks disc_marks(const SceneInput& input, const std::vector<SensorView>& views,
                                   const SensorView& view, const dvec3& eye_W, float dim);

/// Draws all marks of a sensor in addition to its skin: samples, receptive fields, contact surface, rays, taxels,
/// force.
class SensorMarks {
 public:
  explicit SensorMarks(const gl::ShaderReader& read) : surfaces_(read), fields_(read), paint_(read) {}

  // Marks have exact colours and are drawn over the lit frame of `height` pixels, whose perspective must be bound.

  /// Draws the marks on the skin: fields, samples, and taxels of the far side.
  void draw_on_skin(const SceneInput& input, const Camera& camera, const Look& look, int height, SegmentPass& segments,
                    PointPass& points);
  /// Draws all other marks, after draw_on_skin().
  void draw_above(const SceneInput& input, const Camera& camera, const Look& look, int height, SegmentPass& segments,
                  PointPass& points);
  /// Numbers of the overlays of the last frame.
  [[nodiscard]] const FieldNumbers& numbers() const { return numbers_; }

 private:
  struct Scene {  // input of one frame
    const SceneInput& input;
    const Camera& camera;
    const Look& look;
    double pixels_per_metre;  // pixels of marks per metre, at the camera's target
    SegmentPass& segments;
    PointPass& points;
  };
  ModelMarks& marks_of(const Scene& scene, const SensorView& view);
  FieldPaint& paint_of(const SensorView& view);
  struct StraightFields {  // fields by Euclidean distance, computed at once
    SensorModelPtr model;
    FieldGeometry geometry;
    std::shared_ptr<const FieldRings> rings;
    std::shared_ptr<const FieldDiscs> discs;
    /// Computes the fields if the model is not that of the last call.
    void take(const SensorModelPtr& of);
  };
  std::shared_ptr<const FieldRings> rings_of(const SceneInput& input, const SensorView& view);
  const FieldBuffer& fields_of(const SceneInput& input, const SensorView& view);
  void draw_thin_rings(const Scene& scene, const SensorView& view, bool towards);
  void draw_paint(const Scene& scene, const SensorView& view);
  void draw_normals(const Scene& scene, const SensorView& view);
  void note_numbers(const SceneInput& input, const std::vector<SensorView>& views);
  void draw_rings(const Scene& scene, const SensorView& view, bool towards);
  void draw_fields(const Scene& scene, const SensorView& view);
  void draw_contact(const Scene& scene, const SensorView& view);
  void draw_explained(const Scene& scene, const SensorView& view);
  void draw_skin_readings(const Scene& scene, const SensorView& view);
  void draw_tractions(const Scene& scene, const SensorView& view);
  void draw_filtered(const Scene& scene, const SensorView& view);
  void draw_rays(const Scene& scene, const SensorView& view);
  void draw_taxels(const Scene& scene, const SensorView& view, bool towards);
  void mark_taxels(const Scene& scene, const std::vector<SensorView>& views);
  void draw_discs(const Scene& scene, const std::vector<SensorView>& views, const SensorView& view);
  void draw_forces(const Scene& scene, const std::vector<SensorView>& views);
  void draw_plans(const Scene& scene);

  SurfacePass surfaces_;
  std::optional<TractionNumbers> tractions_;  // numbers of the last frame
  MarkCounts counts_;                         // numbers of the last frame
  struct SeenTaxels {                         // taxels with arrows that are not selected
    std::vector<int> clear, behind;           // in front, and behind the skin or another body
  };
  std::map<int, SeenTaxels> seen_;
  FieldPass fields_;
  PaintPass paint_;
  std::map<int, StraightFields> straight_;  // keyed by sensor, like all maps here
  std::map<int, FieldBuffer> field_buffers_;
  std::map<int, std::unique_ptr<FieldPaint>> field_paint_;
  RegionPaint region_;
  RepairMarks repair_;
  GhostMarks ghosts_;
  FieldNumbers numbers_;
  std::map<int, std::unique_ptr<ModelMarks>> marks_;
};

}  // namespace taxel::ui
