#include "core/hydro/back_faces.h"

#include "core/base/index.h"
#include "core/hydro/kernel/front_weight.h"

namespace taxel {
namespace {

bool has_rule(const HydroBody& body) {
  return body.soft() && body.material.faces == FaceRule::along_gradient;
}

/// Computes the factors of the polygons of one pair.
class Weights {
 public:
  Weights(const HydroBody& a, const HydroBody& b, const RigidTransform& X_AB)
      : a_(a), b_(b), X_AB_(X_AB), both_soft_(a.soft() && b.soft()) {}

  /// `slope` is that of DepthWorkspace::slopes, or 0.
  [[nodiscard]] double of(const ContactPolygon& p, double slope) const {
    double weight = 1;
    if (has_rule(a_)) weight = front_weight(p.normal, both_soft_ ? gradient_in_a(p) : p.gradient);
    if (has_rule(b_)) weight *= front_weight(-p.normal, both_soft_ ? gradient_in_b(p, slope) : p.gradient);
    return weight;
  }

 private:
  /// The gradient of A's pressure on a polygon between two soft bodies. Polygons have that of A, unless only B has
  /// tets.
  [[nodiscard]] dvec3 gradient_in_a(const ContactPolygon& p) const {
    return a_.half_space() ? in_half_space(a_) : p.gradient;
  }
  [[nodiscard]] dvec3 gradient_in_b(const ContactPolygon& p, double slope) const {
    if (b_.half_space()) return X_AB_.R * in_half_space(b_);
    if (a_.half_space()) return p.gradient;
    if (p.tet_b >= 0) return X_AB_.R * std::get<SoftBody>(b_.geometry).field->tets()[at(p.tet_b)].gradient;
    return p.gradient - slope * p.normal;  // the normal leads to where A's pressure is the larger one
  }
  static dvec3 in_half_space(const HydroBody& body) {
    return {0, 0, -std::get<SoftHalfSpace>(body.geometry).stiffness};
  }

  const HydroBody &a_, &b_;
  const RigidTransform& X_AB_;
  bool both_soft_;
};

/// Moves polygons to the front of a surface whose later part is left out.
class Compaction {
 public:
  explicit Compaction(ContactSurface& surface) : s_(surface) {}

  /// Keeps polygon `from`, whose pressure is multiplied by `weight`.
  void keep(std::size_t from, double weight) {
    ContactPolygon polygon = s_.polygons[from];
    if (weight < 1) {
      leave_out(polygon, 1 - weight);
      polygon.weight = static_cast<float>(weight);
      polygon.pressure *= weight;
      polygon.gradient *= weight;
    }
    const std::size_t first = at(polygon.first), count = at(polygon.count);
    for (std::size_t i = 0; i < count; ++i) {
      s_.vertices[vertices_ + i] = s_.vertices[first + i];
      s_.pressure[vertices_ + i] = weight < 1 ? weight * s_.pressure[first + i] : s_.pressure[first + i];
    }
    polygon.first = static_cast<int>(vertices_);
    vertices_ += count;
    s_.polygons[polygons_++] = polygon;
  }

  void drop(std::size_t from) {
    const ContactPolygon& polygon = s_.polygons[from];
    leave_out(polygon, 1);
    s_.filtered.push_back({Rejection::back_face, static_cast<int>(s_.filtered_vertices.size()), polygon.count});
    const auto first = s_.vertices.begin() + polygon.first;
    s_.filtered_vertices.insert(s_.filtered_vertices.end(), first, first + polygon.count);
  }

  void finish() {
    s_.polygons.resize(polygons_);
    s_.vertices.resize(vertices_);
    s_.pressure.resize(vertices_);
  }

 private:
  void leave_out(const ContactPolygon& polygon, double part) {
    RejectedPolygons& rejected = s_.rejected[static_cast<std::size_t>(Rejection::back_face)];
    ++rejected.count;
    rejected.area += part * polygon.area;
    rejected.force += part * polygon.area * polygon.pressure;
  }

  ContactSurface& s_;
  std::size_t polygons_ = 0, vertices_ = 0;
};

}  // namespace

void leave_out_back_faces(const HydroBody& a, const HydroBody& b, const RigidTransform& X_AB,
                          std::span<const double> slopes, ContactSurface& surface) {
  if (!has_rule(a) && !has_rule(b)) return;
  const Weights weights(a, b, X_AB);
  Compaction compaction(surface);
  const std::size_t count = surface.polygons.size(), first_slope = count - slopes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double weight = weights.of(surface.polygons[i], i < first_slope ? 0.0 : slopes[i - first_slope]);
    if (weight > 0) {
      compaction.keep(i, weight);
    } else {
      compaction.drop(i);
    }
  }
  compaction.finish();
}

}  // namespace taxel
