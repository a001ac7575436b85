#include "ui/scene/geometry/shown_fields.h"

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "ui/scene/color_map.h"

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

namespace {

constexpr double kLargestAlpha = 0.92;
constexpr float kAtRim = 0.45f;  // opacity at the rim as a fraction of that in the middle: the rim stays visible

/// Returns the distance of a point from the nearest disc of a taxel as a fraction of the disc's radius, at most 1.
double distance_part(const std::vector<FieldDisc>& discs, const dvec3& p) {
  double least = 1;
  for (const FieldDisc& disc : discs) least = std::min(least, glm::length(p - disc.center) / disc.radius);
  return least;
}

}  // namespace

FieldDiscs field_discs(const SensorModel& model, const std::vector<FieldPatch>& patches) {
  FieldDiscs out;
  for (std::size_t k = 0; k < patches.size() && k < model.layout.taxels.size(); ++k) {
    const std::vector<FieldDisc> discs = discs_of(model.layout.taxels[k]);
    for (const SkinPiece& piece : patches[k].pieces) {
      const dvec3 middle = (piece.a + piece.b + piece.c) / 3.0;
      out.triangles.push_back({glm::vec3(piece.a), glm::vec3(piece.b), glm::vec3(piece.c),
                               static_cast<float>(distance_part(discs, middle))});
    }
    out.first.push_back(static_cast<int>(out.triangles.size()));
  }
  return out;
}

float disc_alpha(double part, float away) {
  if (!(part > 0)) return 0;  // NaN too
  const auto middle = static_cast<float>(kLargestAlpha * std::sqrt(std::min(part, 1.0)));
  return middle * (1 - (1 - kAtRim) * away * away);
}

void append_disc(const FieldDiscs& discs, int taxel, const glm::vec3& color, double part, float dim,
                 std::vector<PaintVertex>& out) {
  const auto k = static_cast<std::size_t>(taxel);
  if (k + 1 >= discs.first.size()) return;
  for (int i = discs.first[k]; i < discs.first[k + 1]; ++i) {
    const FieldDiscs::Triangle& t = discs.triangles[static_cast<std::size_t>(i)];
    const std::uint32_t rgba = pack(glm::vec4(color, dim * disc_alpha(part, t.away)));
    for (const glm::vec3& corner : {t.a, t.b, t.c}) out.push_back({corner, rgba});
  }
}

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
