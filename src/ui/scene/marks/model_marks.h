// Marks of one sensor model that do not change with the simulation: samples, taxels, receptive fields.
#pragma once

#include <algorithm>
#include <optional>

#include "ui/scene/geometry/shown_fields.h"
#include "ui/scene/paint/points.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"
#include "ui/scene/sensor_view.h"

namespace taxel::ui {

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
  [[nodiscard]] const gl::Buffer& rings() const { return rings_; }
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
  gl::Buffer rings_, arrows_;
  std::optional<gl::Buffer> sample_normals_;
  Selected selected_marks_;
  std::optional<std::vector<int>> selected_;
  double spacing_ = 0;
};

/// Returns the length of a taxel's arrow [m], at most the distance between taxels.
double taxel_arrow_length(const SensorModel& model);

}  // namespace taxel::ui
