// The receptive fields of the sensors in a picture: what is wished, and what came of it. Worked out of models alone, in
// any thread, since a map of many geodesic fields takes longer than a picture may.
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "ui/scene/field_numbers.h"
#include "ui/scene/geometry/field_geometry.h"
#include "ui/scene/geometry/skin_paint.h"
#include "ui/scene/geometry/skin_weights.h"

namespace taxel::ui {

/// What is drawn on the skin, one at a time.
enum class FieldMap {
  none,
  filled,    ///< by the layout's metric, in the colours of the taxels
  compared,  ///< what both metrics reach in the colours of the taxels, what only the straight distance does in its own
  coverage   ///< every spot in the colour of the number of taxels that see it
};

struct FieldsWish {
  std::vector<SensorModelPtr> models;  ///< of the sensors, in order
  FieldMap map = FieldMap::none;
  bool weights = false;  ///< to spread readings over the skin
  /// Whether anything of it takes long: straight rings alone do not.
  [[nodiscard]] bool empty() const;
  bool operator==(const FieldsWish&) const = default;
};

using FieldRings = std::vector<std::vector<RingPiece>>;  ///< by taxel, in layout order

/// Of one sensor.
struct SensorFields {
  std::shared_ptr<const FieldRings> rings;     ///< by the layout's metric; never null
  std::vector<PaintVertex> triangles;          ///< of the map, frame M
  std::shared_ptr<const SkinWeights> weights;  ///< null unless wished
  std::optional<FieldComparison> comparison;
  std::optional<CoverageNumbers> coverage;
};

struct ShownFields {
  FieldsWish wish;
  std::vector<SensorFields> sensors;  ///< parallel to wish.models
  /// Null where it is not one of the models.
  [[nodiscard]] const SensorFields* of(const SensorModelPtr& model) const;
};
using ShownFieldsPtr = std::shared_ptr<const ShownFields>;

/// Keeps what it worked out of each taxel for the next wish, which after an edit is much the same. From any thread.
class FieldMaker {
 public:
  ShownFieldsPtr make(const FieldsWish& wish);

 private:
  std::mutex making_;                            // guards the rest: one wish at a time
  std::map<std::size_t, FieldGeometry> fields_;  // by sensor
  struct Weights {
    SensorModelPtr model;
    std::shared_ptr<const SkinWeights> weights;
  };
  std::map<std::size_t, Weights> weights_;  // likewise
};

}  // namespace taxel::ui
