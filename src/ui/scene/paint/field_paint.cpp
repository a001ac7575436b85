#include "ui/scene/paint/field_paint.h"

#include "core/base/angle.h"

namespace taxel::ui {
namespace {

constexpr float kRegionArrowWidth = 3.0f, kSkinWidth = 1.4f;
constexpr double kSkinPart = 1.15;  // of the arrow's length

}  // namespace

const PaintBuffer& FieldPaint::map(const ShownFieldsPtr& fields) {
  if (fields_ != fields) map_.upload(fields->of(model_)->triangles);
  fields_ = fields;
  return map_;
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
    arrows.push_back(segment(taxel.center, taxel.center + length * normal, kRegionArrowWidth, color, normal));
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
