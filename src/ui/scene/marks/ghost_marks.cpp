// Marks of taxels that are not in the layout yet.
#include "ui/scene/marks/marks.h"

#include <algorithm>
#include <cmath>

#include "core/base/math.h"

namespace taxel::ui {

namespace {

constexpr float kGhostRingWidth = 1.8f, kGhostArrowWidth = 2.6f;
constexpr double kGhostArrowOfRadius = 0.5;   // fraction of the taxel's radius
constexpr double kGhostArrowOfSpacing = 0.6;  // fraction of the approximate distance between taxels
constexpr int kMaxRingPieces = 48, kMinRingPieces = 12, kAllPieces = 12'000;
constexpr int kMaxRings = 600;  // more rings would be indistinguishable

void append_ring(const Taxel& taxel, int pieces, Segments& out) {
  const dvec3 n = glm::normalize(taxel.normal), u = any_perpendicular(n), v = glm::cross(n, u);
  const auto at = [&](int i) {
    const double angle = 2 * kPi * i / pieces;
    return taxel.center + taxel.radius * (std::cos(angle) * u + std::sin(angle) * v);
  };
  for (int i = 0; i < pieces; ++i) out.push_back(segment(at(i), at(i + 1), kGhostRingWidth, pack(kGhostColor), n));
}

}  // namespace

double GhostMarks::take(const std::shared_ptr<const std::vector<Taxel>>& taxels, const Look& look) {
  if (taxels == taxels_ && &look == look_) return arrow_;
  const int count = static_cast<int>(taxels->size());
  const int pieces = std::clamp(kAllPieces / std::max(1, count), kMinRingPieces, kMaxRingPieces);
  Segments rings, arrows;
  std::vector<PointMark> centers;
  Aabb box;
  arrow_ = 0;
  for (const Taxel& taxel : *taxels) {
    box.include(taxel.center);
    arrow_ = std::max(arrow_, kGhostArrowOfRadius * taxel.radius);
  }
  if (count > 1) arrow_ = std::min(arrow_, kGhostArrowOfSpacing * box.diagonal() / std::sqrt(count));
  for (const Taxel& taxel : *taxels) {
    const dvec3 n = glm::normalize(taxel.normal);
    if (count <= kMaxRings) append_ring(taxel, pieces, rings);
    arrows.push_back(segment(taxel.center, taxel.center + arrow_ * n, kGhostArrowWidth, pack(kGhostColor), n));
    centers.push_back(point_mark(taxel.center, n, 1.0, pack(kGhostColor)));
  }
  rings_.upload(std::span<const Segment>(rings), GL_STATIC_DRAW);
  arrows_.upload(std::span<const Segment>(arrows), GL_STATIC_DRAW);
  centers_.upload(std::span<const PointMark>(centers), GL_STATIC_DRAW);
  taxels_ = taxels;
  look_ = &look;
  return arrow_;
}

}  // namespace taxel::ui
