// The surface is taken as a thin shell. Its second moments give three principal axes; its third moment along an axis,
// the skewness, says which end tapers:
//
//    ______________
//   |              `-.     most of the area is near the flat end, a thin tail of it reaches to the round one:
//   |  base      tip  )    the skewness is positive towards the tip. In the same way the pad of a finger is
//   |______________,-'     rounder than its back.

#include "core/layout/sensor_frame.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace taxel {
namespace {

/// Spreads that differ by less than this are alike: the axis is then the one with the clearest tip.
constexpr double kAlikeSpread = 0.85;
/// A smaller skewness says nothing about an end or a side.
constexpr double kMinSkewness = 0.02;
/// A smaller one leaves the end to the file's origin: links of robots have their joint there, which is at the base.
constexpr double kClearSkewness = 0.1;
/// A flat body is no finger if its smallest spread is below this part of the largest.
constexpr double kMinThickness = 0.2;
constexpr double kSnapCosine = 0.906;  // cosine of 25 degrees
/// Mean of the taxels' normals across the finger; shorter, they look all around it.
constexpr double kMinPadNormal = 0.15;

/// The faces of a larger mesh are not cut into parts: they are small, and their parts take much memory.
constexpr int kFineMesh = 500'000;

/// Area and middle of each face, or of its parts.
struct Shell {
  std::vector<dvec3> points;
  std::vector<double> areas;
  double area = 0;
  dvec3 center{0};

  explicit Shell(const TriMesh& mesh) {
    for (const auto& face : mesh.faces()) {
      const dvec3 a = corner(mesh, face[0]), b = corner(mesh, face[1]), c = corner(mesh, face[2]);
      if (mesh.face_count() > kFineMesh) {
        add((a + b + c) / 3.0, 0.5 * glm::length(glm::cross(b - a, c - a)));
        continue;
      }
      // Four parts of equal area: faces of a coarse mesh are long.
      const dvec3 ab = 0.5 * (a + b), bc = 0.5 * (b + c), ca = 0.5 * (c + a);
      const double quarter = 0.125 * glm::length(glm::cross(b - a, c - a));
      for (const dvec3& middle : {(a + ab + ca) / 3.0, (b + bc + ab) / 3.0, (c + ca + bc) / 3.0, (ab + bc + ca) / 3.0})
        add(middle, quarter);
    }
    if (area > 0) center /= area;
  }
  /// Mean of the n-th power of the distance from the centre along an axis.
  [[nodiscard]] double moment(const dvec3& axis, int n) const {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i) sum += areas[i] * std::pow(glm::dot(points[i] - center, axis), n);
    return sum / area;
  }
  [[nodiscard]] double spread(const dvec3& axis) const { return std::sqrt(moment(axis, 2)); }
  [[nodiscard]] double skewness(const dvec3& axis) const {
    const double s = spread(axis);
    return s > 0 ? moment(axis, 3) / (s * s * s) : 0.0;
  }
  /// 1: the file's origin is beyond the middle half along the axis, -1: before it, 0: in it.
  [[nodiscard]] int side_of_origin(const dvec3& axis) const {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const dvec3& point : points) {
      least = std::min(least, glm::dot(point, axis));
      most = std::max(most, glm::dot(point, axis));
    }
    const double part = -least / (most - least);
    return part > 0.75 ? 1 : part < 0.25 ? -1 : 0;
  }
  [[nodiscard]] dmat3 covariance() const {
    dmat3 sum(0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const dvec3 d = points[i] - center;
      sum += areas[i] * glm::outerProduct(d, d);
    }
    return sum / area;
  }

 private:
  void add(const dvec3& middle, double part) {
    points.push_back(middle);
    areas.push_back(part);
    area += part;
    center += part * middle;
  }
  static dvec3 corner(const TriMesh& mesh, int i) { return mesh.vertices()[static_cast<std::size_t>(i)]; }
};

/// Eigenvectors of a symmetric matrix as columns, by Jacobi's rotations (Golub and Van Loan, section 8.5).
dmat3 principal_axes(dmat3 a) {
  dmat3 axes(1);
  constexpr int kSweeps = 20;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (const auto& [p, q] : {std::array{0, 1}, std::array{0, 2}, std::array{1, 2}}) {
      if (a[p][q] == 0) continue;
      const double angle = 0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]);
      dmat3 turn(1);
      turn[p][p] = turn[q][q] = std::cos(angle);
      turn[q][p] = std::sin(angle);
      turn[p][q] = -std::sin(angle);
      a = glm::transpose(turn) * a * turn;
      axes = axes * turn;
    }
  }
  return axes;
}

/// Two directions across `distal`: axes of the file where `distal` is one, otherwise those of `exact` that remain.
std::array<dvec3, 2> axes_across(const dvec3& distal, const std::array<dvec3, 2>& exact) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(distal[k]) < 1) continue;
    dvec3 a(0), b(0);
    a[(k + 1) % 3] = b[(k + 2) % 3] = 1;
    return {a, b};
  }
  return exact;
}

/// The direction of +-a or +-b that is nearest to the mean normal of the taxels; empty if they look all around.
std::optional<dvec3> side_of(std::span<const Taxel> taxels, const dvec3& distal, const dvec3& a, const dvec3& b) {
  dvec3 sum(0);
  for (const Taxel& taxel : taxels) sum += taxel.normal;
  if (taxels.empty()) return std::nullopt;
  const dvec3 mean = sum / static_cast<double>(taxels.size()), across = mean - glm::dot(mean, distal) * distal;
  if (!(glm::length(across) > kMinPadNormal)) return std::nullopt;
  const dvec3 axis = std::abs(glm::dot(across, a)) >= std::abs(glm::dot(across, b)) ? a : b;
  return glm::dot(across, axis) < 0 ? -axis : axis;
}

/// The end along the longest axis that tapers; where several axes are alike, the clearest of their ends. `across` are
/// the two other axes.
std::optional<dvec3> tip_of(const Shell& shell, std::array<dvec3, 2>& across) {
  const dmat3 principal = principal_axes(shell.covariance());
  // Along the file's own axes where they are near: makers cut the base across one of them.
  std::array<dvec3, 3> axes{snapped_to_axis(principal[0]), snapped_to_axis(principal[1]),
                            snapped_to_axis(principal[2])};
  std::sort(axes.begin(), axes.end(),
            [&](const dvec3& a, const dvec3& b) { return shell.spread(a) > shell.spread(b); });
  const double longest = shell.spread(axes[0]);
  if (!(shell.spread(axes[2]) > kMinThickness * longest)) return std::nullopt;
  std::size_t tip = 0;
  for (std::size_t i = 1; i < axes.size(); ++i)
    if (shell.spread(axes[i]) > kAlikeSpread * longest &&
        std::abs(shell.skewness(axes[i])) > std::abs(shell.skewness(axes[tip])))
      tip = i;
  across = {axes[(tip + 1) % 3], axes[(tip + 2) % 3]};
  const double towards = shell.skewness(axes[tip]);
  if (std::abs(towards) < kClearSkewness && shell.spread(axes[1]) < kAlikeSpread * longest)
    if (const int side = shell.side_of_origin(axes[tip]); side != 0) return -static_cast<double>(side) * axes[tip];
  if (std::abs(towards) < kMinSkewness) return std::nullopt;
  return towards < 0 ? -axes[tip] : axes[tip];
}

}  // namespace

dvec3 snapped_to_axis(const dvec3& direction) {
  for (int k = 0; k < 3; ++k) {
    if (std::abs(direction[k]) < kSnapCosine * glm::length(direction)) continue;
    dvec3 axis(0);
    axis[k] = direction[k] < 0 ? -1 : 1;
    return axis;
  }
  return glm::normalize(direction);
}

std::optional<SensorFrame> guess_frame(const TriMesh& mesh, std::span<const Taxel> taxels) {
  const Shell shell(mesh);
  if (!(shell.area > 0)) return std::nullopt;
  std::array<dvec3, 2> across;
  const std::optional<dvec3> tip = tip_of(shell, across);
  if (!tip) return std::nullopt;
  SensorFrame frame;
  frame.distal = snapped_to_axis(*tip);
  const auto [a, b] = axes_across(frame.distal, across);
  const dvec3 rounder = std::abs(shell.skewness(a)) >= std::abs(shell.skewness(b)) ? a : b;
  const double bulge = shell.skewness(rounder);
  if (const std::optional<dvec3> side = side_of(taxels, frame.distal, a, b)) {
    frame.pad = *side;
  } else if (std::abs(bulge) > kMinSkewness || std::abs(glm::dot(frame.pad, frame.distal)) > 0.5) {
    frame.pad = bulge < 0 ? -rounder : rounder;
  }
  frame.pad = glm::normalize(frame.pad - glm::dot(frame.pad, frame.distal) * frame.distal);
  frame.distal += 0.0, frame.pad += 0.0;  // no -0
  return frame;
}

}  // namespace taxel
