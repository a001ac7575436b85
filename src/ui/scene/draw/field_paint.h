// Receptive fields filled on the skin, how they cover it, and taxel normals beside the skin's: made when first shown,
// kept on the card.
#pragma once

#include <optional>

#include "ui/scene/draw/paint.h"
#include "ui/scene/draw/segments.h"
#include "ui/scene/field_numbers.h"
#include "ui/scene/geometry/field_geometry.h"

namespace taxel::ui {

class FieldPaint {
 public:
  /// `fields`, of this sensor, lives longer.
  FieldPaint(SensorModelPtr model, FieldGeometry& fields) : model_(std::move(model)), fields_(fields) {}
  [[nodiscard]] const SensorModelPtr& model() const { return model_; }

  /// By the layout's metric, in the colours of the taxels.
  const PaintBuffer& filled();
  /// What both metrics reach in the colours of the taxels, what only the straight distance does in its own.
  const PaintBuffer& compared();
  /// Every spot in the colour of the number of taxels that see it.
  const PaintBuffer& coverage();
  /// Taxel normals in the colour of their angle to the skin's, and the skin's normals beside them.
  struct Normals {
    gl::Buffer arrows, skin;
  };
  const Normals& normals(double length, std::uint32_t skin_rgba);

  /// Of what was made.
  [[nodiscard]] const std::optional<FieldComparison>& comparison() const { return comparison_; }
  [[nodiscard]] const std::optional<CoverageNumbers>& coverage_numbers() const { return coverage_numbers_; }
  [[nodiscard]] const std::optional<NormalNumbers>& normal_numbers() const { return normal_numbers_; }

 private:
  SensorModelPtr model_;
  FieldGeometry& fields_;
  std::optional<PaintBuffer> filled_, compared_, coverage_;
  std::optional<Normals> normals_;
  std::uint32_t normals_rgba_ = 0;
  std::optional<FieldComparison> comparison_;
  std::optional<CoverageNumbers> coverage_numbers_;
  std::optional<NormalNumbers> normal_numbers_;
};

}  // namespace taxel::ui
