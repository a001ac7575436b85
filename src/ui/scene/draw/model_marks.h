// What is drawn of one sensor model and does not change with the simulation: samples, taxels, receptive fields.
#pragma once

#include <map>

#include "ui/scene/draw/look.h"
#include "ui/scene/draw/points.h"
#include "ui/scene/draw/segments.h"
#include "ui/scene/geometry/field_ring.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {

/// Samples coloured by their nearest taxel; unused ones grey and small, those of a selected taxel largest.
std::vector<PointMark> sample_marks(const SensorModel& model, int selected_taxel, const Look& look);

class ModelMarks {
 public:
  ModelMarks(SensorModelPtr model, int selected_taxel, const Look& look);

  [[nodiscard]] const PointBuffer& samples() const { return samples_; }
  [[nodiscard]] double sample_spacing() const { return spacing_; }  ///< between neighbours on the skin, about [m]
  /// Rings (frame M) whose face looks towards `eye_M`, or away from it.
  void append_rings(const dvec3& eye_M, bool towards, Segments& out) const;
  [[nodiscard]] bool is_for(const SensorModelPtr& model, int selected_taxel, const Look& look) const;

 private:
  struct Ring {
    Segment segment;
    int face;
  };
  SensorModelPtr model_;
  int selected_;
  const Look* look_;
  PointBuffer samples_;
  std::vector<Ring> rings_;
  double spacing_ = 0;
};

/// Normals of the samples, as short lines (frame M).
void append_sample_normals(const SensorModel& model, double length, std::uint32_t rgba, Segments& out);

/// Centres and normal arrows of the taxels that face the eye, or of those that do not (frame M). `size` scales widths.
struct TaxelMarks {
  std::vector<PointMark> centers, selected_center;
  Segments arrows;
};
TaxelMarks taxel_marks(const SensorView& view, const dvec3& eye_M, bool towards, float size);

/// Length of a taxel's arrow. [m]
double taxel_arrow_length(const SensorModel& model);

}  // namespace taxel::ui
