#include "ui/scene/geometry/field_geometry.h"

#include "core/base/parallel.h"

namespace taxel::ui {
namespace {

constexpr int kManyFieldRings = 200;  // from which on rings have fewer pieces
constexpr int kFineStepDeg = 6, kCoarseStepDeg = 20;

}  // namespace

const std::shared_ptr<const UnfoldedMesh>& FieldGeometry::unfolded(const SensorModel& model) {
  if (!unfolded_ || &unfolded_->mesh() != &model.skin->mesh()) unfolded_ = unfolded_skin(model);
  return unfolded_;
}

const std::vector<std::vector<RingPiece>>& FieldGeometry::rings(const SensorModel& model) {
  using Rings = std::vector<std::vector<RingPiece>>;
  if (model.layout.receptive_field.metric == Metric::geodesic) {
    const std::vector<FieldPatch>& fields = patches(model, FieldPart::geodesic);
    return rings_.update(model, field_fineness(model), [&](const std::vector<int>& missing, Rings& rings) {
      for (const int k : missing) rings[static_cast<std::size_t>(k)] = fields[static_cast<std::size_t>(k)].boundary;
    });
  }
  const int step = model.taxel_count() > kManyFieldRings ? kCoarseStepDeg : kFineStepDeg;
  return rings_.update(model, step, [&](const std::vector<int>& missing, Rings& rings) {
    parallel_chunks(static_cast<int>(missing.size()), 16, [&](int begin, int end) {
      for (int i = begin; i < end; ++i) {
        const auto k = static_cast<std::size_t>(missing[static_cast<std::size_t>(i)]);
        rings[k] = taxel_rings(*model.skin, model.layout.taxels[k], model.layout.receptive_field, step);
      }
    });
  });
}

const std::vector<FieldPatch>& FieldGeometry::patches(const SensorModel& model, FieldPart part) {
  return patches_[static_cast<std::size_t>(part)].update(
      model, field_fineness(model), [&](const std::vector<int>& missing, std::vector<FieldPatch>& fields) {
        cut_patches(model, part, unfolded(model), missing, fields);
      });
}

}  // namespace taxel::ui
