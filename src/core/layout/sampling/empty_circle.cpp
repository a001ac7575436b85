#include "core/layout/sampling/empty_circle.h"

#include <limits>

namespace taxel {
namespace {

double squared(const dvec2& v) {
  return glm::dot(v, v);
}

/// The first of the least values. Two passes: the first one has no branches.
std::size_t least_of(const std::vector<double>& values) {
  double least = std::numeric_limits<double>::infinity();
  for (const double v : values) least = v < least ? v : least;
  std::size_t i = 0;
  while (i + 1 < values.size() && values[i] != least) ++i;
  return i;
}

}  // namespace

double HoleFinder::clearance(const dvec2& at) const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < x_.size(); ++j) least = std::min(least, squared(at - point(j)));
  return least;
}

Hole HoleFinder::climb(const dvec2& start, double reach) {
  const int stretches = 8;  // a climb takes three or four
  at_ = start;
  value_.resize(x_.size());
  for (std::size_t j = 0; j < x_.size(); ++j) {
    const double dx = at_.x - x_[j], dy = at_.y - y_[j];
    value_[j] = dx * dx + dy * dy;
  }
  active_[0] = least_of(value_);
  count_ = 1;
  for (int i = 0; i < stretches; ++i)
    if (!advance(reach) || squared(at_ - start) > reach * reach) break;
  return {at_, squared(at_ - point(active_[0]))};
}

bool HoleFinder::advance(double reach) {
  dvec2 up;
  if (!uphill(up)) return false;
  // |x + t u - q|^2 = |x + t u - a|^2 is linear in t: the first q to become as near as the active point a.
  const dvec2 a = point(active_[0]);
  const double radius = squared(at_ - a), along = glm::dot(up, a);
  const double never = std::numeric_limits<double>::infinity();
  for (std::size_t j = 0; j < x_.size(); ++j) {
    const double dx = at_.x - x_[j], dy = at_.y - y_[j];
    const double closing = 2.0 * (up.x * x_[j] + up.y * y_[j] - along);
    const double t = (dx * dx + dy * dy - radius) / closing;
    value_[j] = closing > 0.0 ? t : never;
  }
  for (std::size_t k = 0; k < count_; ++k) value_[active_[k]] = never;
  const std::size_t met = least_of(value_);
  const bool stops = value_[met] < reach;
  at_ += (stops ? std::max(0.0, value_[met]) : reach) * up;
  if (stops) active_[count_++] = met;
  return stops;
}

/// The unit direction in which all active distances grow: away from one, along the bisector of two; of three the pair
/// whose bisector leads away from the third. False where there is none: the top.
bool HoleFinder::uphill(dvec2& up) {
  if (count_ == 1) {
    const dvec2 away = at_ - point(active_[0]);
    const double length = glm::length(away);
    up = length > 0.0 ? away / length : dvec2(1, 0);
    return true;
  }
  if (count_ == 2) return along_bisector(active_[0], active_[1], up);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t p = active_[(k + 1) % 3], q = active_[(k + 2) % 3], left = active_[k];
    if (!along_bisector(p, q, up) || !(glm::dot(up, point(p) - point(left)) > 0.0)) continue;
    active_ = {p, q, left};
    count_ = 2;
    return true;
  }
  return false;
}

bool HoleFinder::along_bisector(std::size_t p, std::size_t q, dvec2& up) const {
  const dvec2 edge = point(q) - point(p);
  const double length = glm::length(edge);
  if (!(length > 0.0)) return false;
  up = dvec2(-edge.y, edge.x) / length;
  if (glm::dot(up, at_ - point(p)) < 0.0) up = -up;
  return true;
}

}  // namespace taxel
