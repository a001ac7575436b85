// Taxels that are not in the layout yet: centres, arrows and, unless there are too many to distinguish, fields as
// circles in their tangent planes.
#pragma once

#include <memory>

#include "core/layout/layout.h"
#include "ui/scene/paint/points.h"
#include "ui/scene/paint/segments.h"
#include "ui/scene/passes/look.h"

namespace taxel::ui {

/// Colour of the marks, sRGB.
inline constexpr glm::vec4 kGhostColor{1.00f, 0.78f, 0.24f, 1.0f};

class GhostMarks {
 public:
  /// Builds the marks again if the taxels differ from the last call's. Returns the length of the arrows [m].
  double take(const std::shared_ptr<const std::vector<Taxel>>& taxels, const Look& look);

  [[nodiscard]] const gl::Buffer& rings() const { return rings_; }
  [[nodiscard]] const gl::Buffer& arrows() const { return arrows_; }
  [[nodiscard]] const PointBuffer& centers() const { return centers_; }

 private:
  std::shared_ptr<const std::vector<Taxel>> taxels_;
  const Look* look_ = nullptr;
  gl::Buffer rings_, arrows_;
  PointBuffer centers_;
  double arrow_ = 0;
};

}  // namespace taxel::ui
