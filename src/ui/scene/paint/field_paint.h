// Map of the receptive fields on the skin, and taxel normals compared with the skin's normals; stored in GPU memory.
#pragma once

#include <optional>

#include "ui/scene/field_numbers.h"
#include "ui/scene/geometry/shown_fields.h"
#include "ui/scene/paint/paint.h"
#include "ui/scene/paint/segments.h"

namespace taxel::ui {

class FieldPaint {
 public:
  explicit FieldPaint(SensorModelPtr model) : model_(std::move(model)) {}
  [[nodiscard]] const SensorModelPtr& model() const { return model_; }

  /// Returns the map of the model in `fields`.
  const PaintBuffer& map(const ShownFieldsPtr& fields);
  /// Taxel normals in the colour of their angle to the skin's normals, and the skin's normals.
  struct Normals {
    gl::Buffer arrows, skin;
  };
  const Normals& normals(double length, std::uint32_t skin_rgba);

  [[nodiscard]] const std::optional<NormalNumbers>& normal_numbers() const { return normal_numbers_; }

 private:
  SensorModelPtr model_;
  ShownFieldsPtr fields_;
  PaintBuffer map_;  // fields of `map_`
  std::optional<Normals> normals_;
  std::uint32_t normals_rgba_ = 0;
  std::optional<NormalNumbers> normal_numbers_;
};

}  // namespace taxel::ui
