// Receptive fields as functions on the faces of the skin, and the prisms of rays behind the faces.
//
// For each face, the discs of the taxels that may reach it are listed once, in the plane of the face: distances from a
// point of the face are then a loop over arrays. With interpolated normals the cosine of the angle is linear over the
// face, before it is divided by the length of the normal.
//
// All rays from one face form a prism. The prisms that each tet of the body may intersect are listed once, as the rays
// of each tet are (tet_table.h), so a contact polygon finds its prisms without a search. Rays may end before the
// allowed depth, in the middle of a thin wall: a prism knows a depth up to which none of four tried rays ends, less a
// margin, and only deeper points are checked one by one.
//
// Pitfalls: polygons reach a little beyond their tets, so prisms are compared with a margin; subtaxels of one taxel
// count once at a point, the nearest one. Theory: docs/theory/sensor.md, "Exact means".
#include "core/sensor/reference/skin_fields.h"

#include <algorithm>
#include <limits>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/mesh/query/triangle.h"

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

namespace {

FaceLine line_through(const dvec2& from, const dvec2& to) {
  const dvec2 along = glm::normalize(to - from), normal(-along.y, along.x);
  return {normal, -glm::dot(normal, from)};
}

/// Returns false only if the tet is surely outside of the prism: all corners are outside of one of its planes.
bool may_intersect(const PressureField& field, const Tet& tet, const RayPrism& prism, double depth, double lead) {
  std::array<double, 5> most;
  most.fill(-std::numeric_limits<double>::infinity());
  for (int i = 0; i < 4; ++i) {
    const dvec3& x = field.vertices()[at(tet.vertices[i])];
    const dvec2 q = prism.plane.project(x);
    const double below = -glm::dot(x - prism.plane.origin, prism.plane.outward);
    for (std::size_t e = 0; e < 3; ++e) most[e] = std::max(most[e], prism.edges[e](q));
    most[3] = std::max(most[3], below + lead);
    most[4] = std::max(most[4], depth - below);
  }
  const double reach = -1e-5 * tet.size;  // polygons may reach a little beyond their tets
  return std::all_of(most.begin(), most.end(), [&](double value) { return value > reach; });
}

}  // namespace

RayPrisms::RayPrisms(const SensorSkin& skin, const std::vector<int>& region, const FaceFields& fields,
                     const HydroBody& body, double depth)
    : skin_(skin), soft_(body.soft()), depth_(depth) {
  for (int f = 0; f < fields.face_count(); ++f) {
    const bool sampled = region.empty() || std::binary_search(region.begin(), region.end(), skin.face_of[at(f)]);
    if (sampled && fields.range(f).count() > 0) add(fields, f);
  }
  lead_ = soft_ ? 0.0 : 2e-6 * skin.mesh->bounds().diagonal();
  parallel_chunks(static_cast<int>(prisms_.size()), 32, [&](int begin, int end) {
    constexpr double kAll = 1 - 1e-9, kSafe = 0.7;  // rays between the tested ones may end earlier
    for (int i = begin; i < end; ++i) {
      RayPrism& prism = prisms_[at(i)];
      const dvec2 b(prism.plane.second, 0), &c = prism.plane.third;
      prism.free_depth = end_of_ray(prism, (b + c) / 3.0);
      for (const dvec2& corner : {dvec2(0), b, c})
        prism.free_depth = std::min(prism.free_depth, end_of_ray(prism, 0.9 * corner + 0.1 * (b + c) / 3.0));
      prism.free_depth = prism.free_depth < kAll * depth_ ? kSafe * prism.free_depth : depth_;
    }
  });
  std::vector<Aabb> boxes;
  for (const RayPrism& prism : prisms_) {
    Aabb& box = boxes.emplace_back();
    for (const dvec2& corner : {dvec2(0), dvec2(prism.plane.second, 0), prism.plane.third}) {
      box.include(prism.plane.point(corner) + lead_ * prism.plane.outward);
      box.include(prism.plane.point(corner) - depth_ * prism.plane.outward);
    }
  }
  tree_.build(boxes, 2);
  const Aabb& bounds = skin.mesh->bounds();
  slack_ = 1e-6 * (glm::length(bounds.lo) + glm::length(bounds.hi) + depth_);
  if (const auto* with_tets = std::get_if<SoftBody>(&body.geometry)) fill(*with_tets->field);
}

void RayPrisms::add(const FaceFields& fields, int face) {
  RayPrism& prism = prisms_.emplace_back();
  prism.face = face;
  prism.plane = fields.plane(face);
  const dvec2 a(0), b(prism.plane.second, 0), &c = prism.plane.third;
  prism.edges = {line_through(a, b), line_through(b, c), line_through(c, a)};
}

double RayPrisms::end_of_ray(const RayPrism& prism, const dvec2& q) const {
  SensorRay ray{0, prism.plane.point(q), -prism.plane.outward, 0.0};
  limit_ray(skin_, prism.face, soft_, depth_, ray);
  return ray.max_depth;
}

RayPrisms::InTet RayPrisms::in_tet(std::int32_t number) const {
  const RayPrism& prism = prisms_[at(number)];
  InTet out;
  out.prism = number;
  for (std::size_t e = 0; e < 3; ++e) {
    const FaceLine& edge = prism.edges[e];
    const dvec3 normal = edge.normal.x * prism.plane.e1 + edge.normal.y * prism.plane.e2;
    const double offset = edge.offset - glm::dot(normal, prism.plane.origin);
    const std::array<double, 4> side{normal.x, normal.y, normal.z, offset};
    for (std::size_t i = 0; i < 4; ++i) out.sides[4 * e + i] = static_cast<float>(side[i]);
  }
  return out;
}

/// Lists the prisms of each tet.
void RayPrisms::fill(const PressureField& field) {
  const auto tets = field.tets().size();
  std::vector<std::vector<std::int32_t>> found(tets);
  parallel_chunks(static_cast<int>(tets), 256, [&](int begin, int end) {
    for (int t = begin; t < end; ++t) {
      const Tet& tet = field.tets()[at(t)];
      Aabb box;
      for (int i = 0; i < 4; ++i) box.include(field.vertices()[at(tet.vertices[i])]);
      visit_near(box, [&](std::int32_t i) {
        if (may_intersect(field, tet, prisms_[at(i)], depth_, lead_)) found[at(t)].push_back(i);
      });
      std::sort(found[at(t)].begin(), found[at(t)].end());
    }
  });
  first_.assign(1, 0);
  for (const auto& list : found) {
    for (const std::int32_t number : list) of_tets_.push_back(in_tet(number));
    first_.push_back(of_tets_.size());
  }
}

}  // namespace taxel
