#include "ui/scene/geometry/shown_fields.h"

#include <algorithm>

#include "ui/scene/color_map.h"

namespace taxel::ui {
namespace {

constexpr float kFieldAlpha = 0.42f, kOnlyAlpha = 0.85f, kCoverageAlpha = 0.92f;
constexpr double kDiffers = 0.01;  // of a field's area

bool is_geodesic(const SensorModelPtr& model) {
  return model->layout.receptive_field.metric == Metric::geodesic;
}

void append_patches(const SensorModel& model, const std::vector<FieldPatch>& patches, std::vector<PaintVertex>& out) {
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const std::uint32_t color = pack(glm::vec4(taxel_color(model.color(static_cast<int>(k))), kFieldAlpha));
    for (const SkinPiece& piece : patches[k].pieces) append_piece(piece, color, out);
  }
}

void compare(const SensorModel& model, FieldGeometry& fields, SensorFields& out) {
  const std::vector<FieldPatch>& geodesic = fields.patches(model, FieldPart::geodesic);
  const std::vector<FieldPatch>& only = fields.patches(model, FieldPart::euclidean_only);
  append_patches(model, geodesic, out.triangles);
  FieldComparison& numbers = out.comparison.emplace();
  const std::uint32_t color = pack(glm::vec4(euclidean_only_color(), kOnlyAlpha));
  for (std::size_t k = 0; k < only.size(); ++k) {
    for (const SkinPiece& piece : only[k].pieces) append_piece(piece, color, out.triangles);
    numbers.geodesic += geodesic[k].area;
    numbers.euclidean_only += only[k].area;
    if (only[k].area > kDiffers * (geodesic[k].area + only[k].area)) ++numbers.differing;
  }
  for (const FieldPatch& patch : fields.patches(model, FieldPart::euclidean)) numbers.euclidean += patch.area;
}

void cover(const SensorModel& model, FieldGeometry& fields, SensorFields& out) {
  const Coverage map = fields.coverage(model);
  out.triangles.reserve(3 * map.pieces.size());
  for (const Coverage::Piece& piece : map.pieces) {
    append_piece(piece.at, pack(glm::vec4(overlap_color(piece.taxels), kCoverageAlpha)), out.triangles);
  }
  out.coverage = CoverageNumbers{map.area_of_overlap, map.area, map.overlap()};
}

}  // namespace

bool FieldsRequest::empty() const {
  return models.empty() ||
         (map == FieldMap::none && !weights && !discs && std::none_of(models.begin(), models.end(), is_geodesic));
}

const SensorFields* ShownFields::of(const SensorModelPtr& model) const {
  const auto found = std::find(request.models.begin(), request.models.end(), model);
  return found == request.models.end() ? nullptr : &sensors[static_cast<std::size_t>(found - request.models.begin())];
}

void FieldMaker::make(const FieldsRequest& request, ShownFields& out) {
  out.request = request;
  for (const SensorModelPtr& model : request.models) {
    FieldGeometry& fields = fields_[out.sensors.size()];
    SensorFields& made = out.sensors.emplace_back();
    if (request.weights) {
      Weights& known = weights_[out.sensors.size() - 1];
      if (known.model != model) known = {model, std::make_shared<const SkinWeights>(skin_weights(*model))};
      made.weights = known.weights;
    }
    if (request.discs) {
      Discs& known = discs_[out.sensors.size() - 1];
      if (known.model != model) {
        const FieldPart part = is_geodesic(model) ? FieldPart::geodesic : FieldPart::euclidean;
        known = {model, std::make_shared<const FieldDiscs>(field_discs(*model, fields.patches(*model, part)))};
      }
      made.discs = known.discs;
    }
    made.rings = std::make_shared<const FieldRings>(fields.rings(*model));
    switch (request.map) {
      case FieldMap::none:
        break;
      case FieldMap::filled:
        append_patches(*model, fields.patches(*model, is_geodesic(model) ? FieldPart::geodesic : FieldPart::euclidean),
                       made.triangles);
        break;
      case FieldMap::compared:
        compare(*model, fields, made);
        break;
      case FieldMap::coverage:
        cover(*model, fields, made);
        break;
    }
  }
}

}  // namespace taxel::ui
