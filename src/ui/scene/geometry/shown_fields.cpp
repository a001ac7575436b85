#include "ui/scene/geometry/shown_fields.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "ui/scene/color_map.h"

namespace taxel::ui {
namespace {
constexpr glm::vec3 kWarning(0.90f, 0.16f, 0.45f);  // a colour that no map has
}

glm::vec3 overlap_color(int taxels) {
  return kUncoveredColor * glm::pow(kCoveredTint, glm::vec3(static_cast<float>(std::max(taxels, 0))));
}

glm::vec3 euclidean_only_color() {
  return kWarning;
}

glm::vec3 normal_color(double angle_deg, double limit_deg) {
  return angle_deg > limit_deg ? kWarning
                               : kColorMaps.front().at(limit_deg > 0 ? 0.2 + 0.8 * angle_deg / limit_deg : 0.2);
}

namespace {

constexpr double kFineness = 6;                       // smallest radius divided by the length of edges
constexpr double kMinPieces = 4e3, kMaxPieces = 6e4;  // number of pieces of the whole skin
constexpr double kInside = 0.02;                      // weights at a cut are computed this fraction of the edge inside

double pieces_of(const SensorModel& model) {
  double radius = std::numeric_limits<double>::infinity();
  for (const Taxel& taxel : model.layout.taxels)
    for (const FieldDisc& disc : discs_of(taxel)) radius = std::min(radius, disc.radius);
  const double edge = radius / kFineness;
  return std::clamp(2 * model.skin->mesh().area() / (edge * edge), kMinPieces, kMaxPieces);
}

class Spreader {
 public:
  Spreader(const SensorModel& model, const FieldWeights& fields)
      : mesh_(model.skin->mesh()), fields_(fields), pieces_(pieces_of(model)) {}

  void append_face(int face, SkinWeights& out) {
    const dvec3 &a = mesh_.vertex(face, 0), &b = mesh_.vertex(face, 1), &c = mesh_.vertex(face, 2);
    const dvec3 middle = (a + b + c) / 3.0;
    const double reach = std::max({glm::distance(a, middle), glm::distance(b, middle), glm::distance(c, middle)});
    fields_.near(middle, reach, discs_);
    if (discs_.empty()) return;
    face_ = face;
    const int n =
        std::max(1, static_cast<int>(std::ceil(std::sqrt(pieces_ * mesh_.face_areas()[at(face)] / mesh_.area()))));
    const auto point = [&](int i, int j) { return a + (double(i) * (b - a) + double(j) * (c - a)) / double(n); };
    corners_.clear();
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j) corners_.push_back(weigh(point(i, j), out));
    const auto corner = [n](int i, int j) { return at(i * (n + 1) - i * (i - 1) / 2 + j); };
    for (int i = 0; i < n; ++i) {
      for (int j = 0; i + j < n; ++j) {
        append_piece(corner(i, j), corner(i + 1, j), corner(i, j + 1), out);
        if (i + j + 1 < n) append_piece(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1), out);
      }
    }
  }

 private:
  struct Corner {
    dvec3 p{0};
    double margin = 0;  // distance inside the union of all fields; negative outside [m]
    int point = -1;     // index in the output, or -1 outside
  };

  Corner weigh(const dvec3& p, SkinWeights& out) {
    fields_.at(face_, p, discs_, here_);
    Corner corner{p, here_.margin, -1};
    double sum = 0;
    for (const FieldWeights::Weight& w : here_.weights) sum += w.value;
    if (!(sum > 0)) {
      corner.margin = std::min(corner.margin, 0.0);
      return corner;
    }
    corner.point = static_cast<int>(out.points.size());
    out.points.emplace_back(p);
    for (const FieldWeights::Weight& w : here_.weights)
      out.weights.push_back({w.taxel, static_cast<float>(w.value / sum)});
    out.first.push_back(static_cast<int>(out.weights.size()));
    return corner;
  }

  /// Adds the point where the fields end between a corner inside and a corner outside, with linear margins. Returns its
  /// index.
  int cut(const Corner& within, const Corner& outside, SkinWeights& out) {
    const double span = within.margin - outside.margin;
    const double t = std::isfinite(span) && span > 0 ? std::clamp(within.margin / span, 0.0, 1.0) : 0.0;
    for (const double inside : {kInside, 0.25}) {
      const Corner weighed = weigh(glm::mix(within.p, outside.p, std::max(0.0, t - inside)), out);
      if (weighed.point < 0) continue;
      out.points.back() = glm::mix(within.p, outside.p, t);
      return weighed.point;
    }
    return within.point;
  }

  void append_piece(std::size_t i, std::size_t j, std::size_t k, SkinWeights& out) {
    const std::array<Corner, 3> corners{corners_[i], corners_[j], corners_[k]};
    std::vector<int> ring;
    for (std::size_t e = 0; e < 3; ++e) {
      const Corner &from = corners[e], &to = corners[(e + 1) % 3];
      if (from.point >= 0) ring.push_back(from.point);
      if ((from.point >= 0) != (to.point >= 0))
        ring.push_back(from.point >= 0 ? cut(from, to, out) : cut(to, from, out));
    }
    for (std::size_t e = 2; e < ring.size(); ++e) out.triangles.push_back({ring[0], ring[e - 1], ring[e]});
  }

  const TriMesh& mesh_;
  const FieldWeights& fields_;
  double pieces_;
  int face_ = 0;
  std::vector<int> discs_;
  std::vector<Corner> corners_;
  FieldWeights::AtPoint here_;
};

}  // namespace

void SkinWeights::spread(std::span<const double> readings, std::vector<float>& at_points) const {
  at_points.assign(points.size(), 0.0f);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum = 0;
    for (int w = first[i]; w < first[i + 1]; ++w)
      if (at(weights[at(w)].taxel) < readings.size())
        sum += static_cast<double>(weights[at(w)].share) * readings[at(weights[at(w)].taxel)];
    at_points[i] = static_cast<float>(sum);
  }
}

SkinWeights skin_weights(const SensorModel& model) {
  SkinWeights out;
  if (model.layout.taxels.empty()) return out;
  std::optional<FieldWeights> own;
  const FieldWeights& fields = model.skin_fields ? *model.skin_fields->weights : own.emplace(model.layout, *model.skin);
  Spreader spreader(model, fields);
  for (int face = 0; face < model.skin->mesh().face_count(); ++face) spreader.append_face(face, out);
  return out;
}

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

std::shared_ptr<const FieldDiscs> FieldGeometry::discs(const SensorModel& model) {
  const bool geodesic = model.layout.receptive_field.metric == Metric::geodesic;
  const std::vector<FieldShape>& shapes =
      shapes_.update(model, 0, [&](const std::vector<int>& missing, std::vector<FieldShape>& values) {
        const FieldShapes maker(model, geodesic ? unfolded(model) : nullptr);
        parallel_chunks(static_cast<int>(missing.size()), 8, [&](int begin, int end) {
          for (int i = begin; i < end; ++i)
            values[at(missing[at(i)])] = maker.of(model.layout.taxels[at(missing[at(i)])]);
        });
      });
  return std::make_shared<const FieldDiscs>(join_shapes(model, shapes));
}

namespace {

constexpr float kFieldAlpha = 0.42f, kOnlyAlpha = 0.85f;
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
  out.coverage = CoverageNumbers{map.area_of_overlap, map.area, map.overlap()};
}

}  // namespace

bool FieldsRequest::empty() const {
  return models.empty() ||
         (map == FieldMap::none && !weights && std::none_of(models.begin(), models.end(), is_geodesic));
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
      Weights& cached = weights_[out.sensors.size() - 1];
      if (cached.model != model) cached = {model, std::make_shared<const SkinWeights>(skin_weights(*model))};
      made.weights = cached.weights;
    }
    made.rings = std::make_shared<const FieldRings>(fields.rings(*model));
    made.discs = fields.discs(*model);
    switch (request.map) {
      case FieldMap::none:
      case FieldMap::filled:  // drawn by the discs
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
