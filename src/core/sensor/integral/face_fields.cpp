#include "core/sensor/integral/face_fields.h"

#include <limits>

#include "core/base/index.h"
#include "core/mesh/query/point_triangle.h"

namespace taxel {

FacePlane face_plane(const TriMesh& mesh, int face) {
  const dvec3 &a = mesh.vertex(face, 0), ab = mesh.vertex(face, 1) - a, ac = mesh.vertex(face, 2) - a;
  FacePlane plane;
  plane.origin = a;
  plane.outward = mesh.face_normals()[at(face)];
  plane.second = glm::length(ab);
  plane.e1 = ab / plane.second;
  plane.e2 = glm::cross(plane.outward, plane.e1);
  plane.third = {glm::dot(ac, plane.e1), glm::dot(ac, plane.e2)};
  return plane;
}

FaceFields::FaceFields(std::shared_ptr<const FieldWeights> weights, const TriMesh& skin)
    : weights_(std::move(weights)),
      geodesic_(weights_->geodesic()),
      interpolated_(weights_->normals() == FieldNormals::interpolated) {
  std::vector<int> near;
  for (int f = 0; f < skin.face_count(); ++f) add_face(skin, f, near);
}

/// Adds a face with the discs that may reach it. `near` is scratch memory.
void FaceFields::add_face(const TriMesh& skin, int face, std::vector<int>& near) {
  const dvec3 &a = skin.vertex(face, 0), &b = skin.vertex(face, 1), &c = skin.vertex(face, 2);
  const FacePlane& plane = planes_.emplace_back(face_plane(skin, face));
  Range range;
  range.first = static_cast<std::uint32_t>(taxel_.size());
  range.least_radius = std::numeric_limits<double>::infinity();
  const dvec3 middle = (a + b + c) / 3.0;
  weights_->near(middle, std::max({glm::distance(middle, a), glm::distance(middle, b), glm::distance(middle, c)}),
                 near);
  std::array<dvec3, 3> normals{};
  if (interpolated_) {
    const ivec3& corners = skin.faces()[taxel::at(face)];
    for (std::size_t i = 0; i < 3; ++i) normals[i] = skin.vertex_normals()[taxel::at(corners[static_cast<int>(i)])];
    normals_.push_back(slopes_of(plane, normals));
  }
  for (const int number : near) {
    const FieldWeights::Disc& disc = weights_->disc(number);
    const double facing = interpolated_ ? 1.0 : weights_->angle().factor(glm::dot(plane.outward, disc.disc.normal));
    if (!(facing > 0) ||
        nearest_on_triangle(disc.origin, a, b, c).squared_distance > disc.disc.radius * disc.disc.radius)
      continue;
    const dvec2 q = plane.project(disc.origin);
    const double height = glm::dot(disc.origin - plane.origin, plane.outward);
    if (taxel_.size() > range.first && taxel_.back() == disc.taxel) range.subtaxels = true;
    u_.push_back(q.x), v_.push_back(q.y), height2_.push_back(height * height);
    radius_.push_back(disc.disc.radius), facing_.push_back(facing);
    taxel_.push_back(disc.taxel), disc_.push_back(number);
    if (interpolated_) {
      const std::array<dvec3, 3>& n = normals_.back();
      const dvec3& m = disc.disc.normal;
      slope_.push_back({glm::dot(n[0], m), glm::dot(n[1], m), glm::dot(n[2], m)});
    }
    range.least_radius = std::min(range.least_radius, disc.disc.radius);
  }
  range.end = static_cast<std::uint32_t>(taxel_.size());
  ranges_.push_back(range);
}

/// Returns n(u, v) = [0] + [1] u + [2] v, which is linear between the normals of the corners.
std::array<dvec3, 3> FaceFields::slopes_of(const FacePlane& plane, const std::array<dvec3, 3>& normals) {
  const dvec3 along_u = (normals[1] - normals[0]) / plane.second;
  return {normals[0], along_u, (normals[2] - normals[0] - plane.third.x * along_u) / plane.third.y};
}

bool FaceFields::is_nearest(const Range& range, std::size_t i, const AtPoint& at) const {
  for (std::size_t k = 0; k < range.count(); ++k) {
    if (k == i || taxel_[range.first + k] != taxel_[range.first + i]) continue;
    if (!(at.facing[k] > 0 && at.away[k] <= radius_[range.first + k])) continue;
    if (at.away[k] < at.away[i] || (at.away[k] == at.away[i] && k < i)) return false;
  }
  return true;
}

void FaceFields::at(int face, const dvec2& q, AtPoint& out) const {
  const Range& range = ranges_[taxel::at(face)];
  const std::size_t count = range.count(), first = range.first;
  if (out.away.size() < count) out.away.resize(count), out.facing.resize(count);
  double* away = out.away.data();
  if (geodesic_) {
    const dvec3 x = planes_[taxel::at(face)].point(q);
    for (std::size_t i = 0; i < count; ++i) away[i] = weights_->distance(disc_[first + i], face, x);
  } else {
    const double *u = u_.data() + first, *v = v_.data() + first, *height2 = height2_.data() + first;
    for (std::size_t i = 0; i < count; ++i) {
      const double du = q.x - u[i], dv = q.y - v[i];
      away[i] = std::sqrt(du * du + dv * dv + height2[i]);
    }
  }
  double* facing = out.facing.data();
  if (!interpolated_) {
    std::copy_n(facing_.data() + first, count, facing);
    return;
  }
  const auto& n = normals_[taxel::at(face)];
  const double length = glm::length(n[0] + q.x * n[1] + q.y * n[2]);
  for (std::size_t i = 0; i < count; ++i) {
    const Slope& s = slope_[first + i];
    facing[i] = weights_->angle().factor((s.a + s.b * q.x + s.c * q.y) / length);
  }
}

}  // namespace taxel
