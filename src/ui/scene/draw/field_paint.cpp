#include "ui/scene/draw/field_paint.h"

#include "core/base/angle.h"
#include "ui/scene/color_map.h"

namespace taxel::ui {
namespace {

constexpr float kFieldAlpha = 0.42f, kOnlyAlpha = 0.85f, kCoverageAlpha = 0.92f;
constexpr double kDiffers = 0.01;  // of a field's area
constexpr float kArrowWidth = 3.0f, kSkinWidth = 1.4f;
constexpr double kSkinPart = 1.15;  // of the arrow's length

void append_patches(const SensorModel& model, const std::vector<FieldPatch>& patches, std::vector<PaintVertex>& out) {
  for (std::size_t k = 0; k < patches.size(); ++k) {
    const std::uint32_t color = pack(glm::vec4(taxel_color(model.color(static_cast<int>(k))), kFieldAlpha));
    for (const SkinPiece& piece : patches[k].pieces) append_piece(piece, color, out);
  }
}

}  // namespace

const PaintBuffer& FieldPaint::filled() {
  if (filled_) return *filled_;
  const bool geodesic = model_->layout.receptive_field.metric == Metric::geodesic;
  std::vector<PaintVertex> triangles;
  append_patches(*model_, fields_.patches(*model_, geodesic ? FieldPart::geodesic : FieldPart::euclidean), triangles);
  filled_.emplace().upload(triangles);
  return *filled_;
}

const PaintBuffer& FieldPaint::compared() {
  if (compared_) return *compared_;
  std::vector<PaintVertex> triangles;
  const std::vector<FieldPatch>& geodesic = fields_.patches(*model_, FieldPart::geodesic);
  const std::vector<FieldPatch>& only = fields_.patches(*model_, FieldPart::euclidean_only);
  append_patches(*model_, geodesic, triangles);
  comparison_.emplace();
  for (std::size_t k = 0; k < only.size(); ++k) {
    for (const SkinPiece& piece : only[k].pieces) {
      append_piece(piece, pack(glm::vec4(euclidean_only_color(), kOnlyAlpha)), triangles);
    }
    comparison_->geodesic += geodesic[k].area;
    comparison_->euclidean_only += only[k].area;
    if (only[k].area > kDiffers * (geodesic[k].area + only[k].area)) ++comparison_->differing;
  }
  for (const FieldPatch& patch : fields_.patches(*model_, FieldPart::euclidean)) comparison_->euclidean += patch.area;
  compared_.emplace().upload(triangles);
  return *compared_;
}

const PaintBuffer& FieldPaint::coverage() {
  if (coverage_) return *coverage_;
  const Coverage map = fields_.coverage(*model_);
  std::vector<PaintVertex> triangles;
  triangles.reserve(3 * map.pieces.size());
  for (const Coverage::Piece& piece : map.pieces) {
    append_piece(piece.at, pack(glm::vec4(overlap_color(piece.taxels), kCoverageAlpha)), triangles);
  }
  coverage_numbers_ = CoverageNumbers{map.area_of_overlap, map.area, map.overlap()};
  coverage_.emplace().upload(triangles);
  return *coverage_;
}

const FieldPaint::Normals& FieldPaint::normals(double length, std::uint32_t skin_rgba) {
  if (normals_ && normals_rgba_ == skin_rgba) return *normals_;
  NormalNumbers numbers;
  numbers.limit_deg = model_->layout.receptive_field.max_angle_deg;
  Segments arrows, skin;
  for (int k = 0; k < model_->taxel_count(); ++k) {
    const Taxel& taxel = model_->layout.taxels[static_cast<std::size_t>(k)];
    const SurfacePoint nearest = model_->skin->closest_point(taxel.center);
    const dvec3& below = model_->skin->mesh().face_normals()[static_cast<std::size_t>(nearest.face)];
    const dvec3 normal = glm::normalize(taxel.normal);
    const double angle = angle_deg(normal, below);
    numbers.mean_deg += angle / model_->taxel_count();
    if (numbers.largest_taxel < 0 || angle > numbers.largest_deg) {
      numbers.largest_deg = angle;
      numbers.largest_taxel = k;
    }
    const std::uint32_t color = pack(normal_color(angle, numbers.limit_deg));
    arrows.push_back(segment(taxel.center, taxel.center + length * normal, kArrowWidth, color, normal));
    skin.push_back(segment(taxel.center, taxel.center + kSkinPart * length * below, kSkinWidth, skin_rgba, normal));
  }
  normal_numbers_ = numbers;
  normals_.emplace();
  normals_->arrows.upload(std::span<const Segment>(arrows), GL_STATIC_DRAW);
  normals_->skin.upload(std::span<const Segment>(skin), GL_STATIC_DRAW);
  normals_rgba_ = skin_rgba;
  return *normals_;
}

}  // namespace taxel::ui
