#include "core/sensor/integral/ray_prisms.h"

#include <algorithm>

#include "core/base/index.h"
#include "core/base/parallel.h"

namespace taxel {
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
