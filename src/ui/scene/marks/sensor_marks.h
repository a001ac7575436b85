// Draws all marks of a sensor in addition to its skin: samples, receptive fields, contact surface, rays, taxels, force.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "ui/scene/marks/ghost_marks.h"
#include "ui/scene/marks/model_marks.h"
#include "ui/scene/marks/repair_marks.h"
#include "ui/scene/paint/field_paint.h"
#include "ui/scene/paint/region_paint.h"
#include "ui/scene/paint/surfaces.h"
#include "ui/scene/pick/camera.h"

namespace taxel::ui {

class SensorMarks {
 public:
  explicit SensorMarks(const gl::ShaderReader& read) : surfaces_(read), paint_(read) {}

  /// Draws marks in exact colours over the lit frame of `height` pixels. The frame's perspective must be bound.
  void draw(const SceneInput& input, const Camera& camera, const Look& look, int height, SegmentPass& segments,
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
  std::shared_ptr<const FieldRings> rings_of(const SceneInput& input, const SensorView& view);
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
  PaintPass paint_;
  struct StraightRings {  // rings by Euclidean distance, computed at once
    SensorModelPtr model;
    FieldGeometry geometry;
    std::shared_ptr<const FieldRings> rings;
  };
  std::map<int, StraightRings> straight_;  // keyed by sensor, like all maps here
  std::map<int, std::unique_ptr<FieldPaint>> field_paint_;
  RegionPaint region_;
  RepairMarks repair_;
  GhostMarks ghosts_;
  FieldNumbers numbers_;
  std::map<int, std::unique_ptr<ModelMarks>> marks_;
};

}  // namespace taxel::ui
