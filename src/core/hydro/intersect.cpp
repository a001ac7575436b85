// The contact surface of two bodies: the kernel of the pair, depth pieces, and back faces.
//
// Each pair of shapes has its kernel in core/hydro/kernel. A kernel works in the frame of a soft body, whose trees and
// planes then never change; SurfaceWriter turns the polygons to frame A.
//
// Back faces. A plate that is thinner than its depth is inside of the field with both faces, and their pressures would
// nearly cancel. So each polygon counts by a factor of the angle between its normal and the gradient of the pressure, 1
// up to 102.7 degrees and 0 from 122.7 degrees on (front_weight()); between two soft bodies by the product of both
// factors. Pressure and gradient contain the factor, so everything that follows uses the same polygons. Polygons with
// the factor 0 are kept apart, with the reason back_face.
//
// Pitfall: the factor is applied after all polygons are made. Inside of the kernels it would break their checks, which
// compare the areas of polygons with those of facets. Theory: docs/theory/hydro.md, "Back faces".
#include "core/hydro/intersect.h"

#include <fmt/format.h>

#include <span>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/hydro/contact_surface.h"
#include "core/hydro/hydro_body.h"
#include "core/hydro/kernel/depth_march.h"
#include "core/hydro/kernel/depth_pieces.h"
#include "core/hydro/kernel/kernels.h"
#include "core/hydro/kernel/law_match.h"
#include "core/hydro/kernel/law_pass.h"
#include "core/hydro/kernel/surface_writer.h"
#include "core/hydro/kernel/workspace.h"

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

/// Multiplies the pressure of each polygon by its factors for the soft bodies whose material asks for it, and moves
/// polygons without pressure to those that are left out, with the reason back_face. X_AB is the pose of b in a.
/// `slopes` are those of the last polygons, which two soft bodies have beyond their tets (DepthWorkspace::slopes).
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

void check_pose(const HydroBody& body, const Pose& X_W) {
  constexpr double kUnit = 1e-6;  // error of quaternions from single-precision files and drifting integrators
  const double length = glm::length(X_W.q);
  if (!is_finite(X_W.p) || !(std::abs(length - 1) <= kUnit))
    throw Error(fmt::format("'{}' has no valid pose: position {} {} {}, quaternion of length {}", body.name, X_W.p.x,
                            X_W.p.y, X_W.p.z, length));
}

void check_pair(const HydroBody& a, const HydroBody& b) {
  if (!a.soft() && !b.soft()) {
    throw Error(
        fmt::format("'{}' and '{}' are both rigid: a contact surface needs at least one soft body", a.name, b.name));
  }
  if (a.half_space() && b.half_space())
    throw Error(fmt::format("'{}' and '{}' are both half-spaces: their contact surface has no end", a.name, b.name));
}

/// The plane z = 0 of the frame with pose X_SR, in S: normal . x + offset.
struct Plane {
  dvec3 normal;
  double offset;
};
Plane ground(const RigidTransform& X_SR) {
  return {X_SR.R[2], -glm::dot(X_SR.R[2], X_SR.p)};
}

RigidTransform inverse(const RigidTransform& X) {
  RigidTransform out;
  out.R = glm::transpose(X.R);
  out.p = -(out.R * X.p);
  return out;
}

/// A soft body in a pair: its tets, and the function to the linear pressures of the other body. The body and the match
/// must outlive it.
struct SoftOfPair {
  const SoftBody& body;
  const LawMatch* match = nullptr;            ///< stays null if the pressures remain
  std::shared_ptr<const MatchedField> field;  ///< stays null without a match

  [[nodiscard]] const FieldIndex& index() const { return field ? *field->index : *body.index; }
  [[nodiscard]] PressureAt pressure(const RigidTransform& X_BL) const {
    return {body.depth.get(), index(), X_BL, match};
  }
};

/// Two soft bodies with tets. The normal is that of growing pB - pA: it leads into B.
void intersect_fields(const SoftOfPair& a, const SoftOfPair& b, const Pose& X_AB, SurfaceWriter& writer,
                      KernelMemory& memory) {
  const RigidTransform X_AB_full(X_AB);
  const bool goes_on = a.body.depth || b.body.depth;
  if (goes_on) writer.list_core_points(memory.depth.core_points);
  intersect_tets(a.index(), b.index(), X_AB_full, writer, memory);
  if (!goes_on) return;
  if (writer.core_count() == 0 && (writer.polygon_count() > 0 || !reaches_core(a.index(), b.index(), X_AB_full)))
    return;
  writer.clear_core();
  const RigidTransform X_AL = frame_between(X_AB), X_BL = frame_between(X_AB.inverse());
  const PressureAt first = a.pressure(X_AL), second = b.pressure(X_BL);
  add_march(first, second, first, X_AL, memory.piece_size, writer, memory.depth);
}

/// One soft body with tets and a half-space or a rigid body. Computed in the frame S of the tets, whose trees and
/// planes never change.
void intersect_field(const SoftOfPair& soft, const HydroBody& other, const RigidTransform& X_SO, SurfaceWriter& writer,
                     KernelMemory& memory) {
  const SoftBody& body = soft.body;
  const FieldIndex& field = soft.index();
  if (const auto* mesh = std::get_if<RigidMesh>(&other.geometry)) {
    intersect_facets(field, *mesh->tree, X_SO, writer, memory);
    if (!body.depth) return;
    writer.clear_core();
    add_depth_pieces(body.depth, field, *mesh->tree, X_SO, memory.piece_size, writer, memory.depth);
    return;
  }
  const Plane plane = ground(X_SO);
  if (const auto* space = std::get_if<SoftHalfSpace>(&other.geometry)) {
    const LinearPressure pressure{-space->stiffness * plane.normal, -space->stiffness * plane.offset};
    if (body.depth) writer.list_core_points(memory.depth.core_points);
    intersect_soft_half_space(field, pressure, writer, memory);
    if (!body.depth || writer.core_count() == 0) return;
    writer.clear_core();
    const PressureAt in_space(space->stiffness, space->thickness, inverse(X_SO));
    const PressureAt pad = soft.pressure(RigidTransform());
    add_march(in_space, pad, pad, RigidTransform(), memory.piece_size, writer, memory.depth);
  } else {
    intersect_plane(field, plane.normal, plane.offset, writer, memory);
    if (!body.depth || writer.core_count() == 0) return;
    writer.clear_core();
    add_depth_pieces(body.depth, field, X_SO, memory.piece_size, writer, memory.depth);
  }
}

/// The laws of a pair. The surface is computed with linear pressures; those of one of two soft bodies are matched to
/// the other one, whose law then gives the pressures.
class PairLaws {
 public:
  PairLaws(const HydroBody& a, const HydroBody& b)
      : a_(a), b_(b), is_a_matched_(matches_a(a, b)), match_(matched().material, scale().material) {}

  /// Returns a body with tets as it is in the pair. This object must outlive the result.
  [[nodiscard]] SoftOfPair soft(const HydroBody& body) const {
    const auto& geometry = std::get<SoftBody>(body.geometry);
    if (!is_pair() || &body != &matched() || match_.is_identity()) return {geometry, nullptr, nullptr};
    const TriMesh* skin = geometry.depth ? geometry.depth->skin().get() : nullptr;
    return {geometry, &match_, geometry.matched->get(*geometry.field, skin, matched().material, scale().material)};
  }

  /// Gives the polygons the pressures of the laws, and the tets of the bodies' own fields. `first` is the body of the
  /// polygons' `tet`, `second` that of `tet_b`; null if there is none.
  void finish(const SoftOfPair* first, const SoftOfPair* second, const RigidTransform& X_AB, KernelMemory& memory,
              ContactSurface& out) const {
    const SoftOfPair* changed = first != nullptr && first->field ? first : second;
    const bool is_changed = changed != nullptr && changed->field;
    if (!is_changed && scale().law_levels.empty()) return;
    LawMemory& m = memory.law;
    LawsOfSurface laws{scaled(scale())};
    m.levels.clear();
    for (const double strain : scale().law_levels) m.levels.push_back(scale().material.modulus * strain);
    if (is_changed) {
      laws.matched = scaled(matched());
      laws.pieces = {&changed->field->pieces, matched().material.modulus};
      for (const LawPoint& point : laws.pieces.law->table) m.levels.push_back(laws.pieces.modulus * point.pressure);
      std::sort(m.levels.begin(), m.levels.end());
      find_ratios(second, X_AB, memory, out);
      laws.ratios = m.ratios;
    }
    laws.levels = m.levels;
    follow_laws(laws, out, memory.depth.slopes, m);
    if (is_changed) {
      for (ContactPolygon& polygon : out.polygons) {
        int& tet = changed == first ? polygon.tet : polygon.tet_b;
        if (tet >= 0) tet = changed->field->parents[at(tet)];
      }
    }
  }

 private:
  [[nodiscard]] bool is_pair() const { return a_.soft() && b_.soft(); }
  /// Whether A is the body whose pressures are matched: not a half-space, and the same body whichever is first.
  static bool matches_a(const HydroBody& a, const HydroBody& b) {
    if (!a.soft() || !b.soft()) return !a.soft();
    if (a.half_space() || b.half_space()) return b.half_space();
    const auto order = [](const HydroBody& body) {
      return std::pair(body.material.law.slopes().most, body.material.modulus);
    };
    return order(a) >= order(b);
  }
  [[nodiscard]] const HydroBody& matched() const { return is_a_matched_ ? a_ : b_; }
  static ScaledLaw scaled(const HydroBody& body) { return {&body.material.law, body.material.modulus}; }

  /// Finds the ratios of the slopes of the kernel's pressures along the normals, of the other body and the matched one.
  void find_ratios(const SoftOfPair* second, const RigidTransform& X_AB, KernelMemory& memory,
                   const ContactSurface& out) const {
    const std::size_t count = out.polygons.size(), first_slope = count - memory.depth.slopes.size();
    memory.law.ratios.clear();
    for (std::size_t i = 0; i < count; ++i) {
      const ContactPolygon& p = out.polygons[i];
      // Polygons have the gradient of A, or that of the only body with tets.
      double a = glm::dot(p.gradient, p.normal), b = 0;
      if (a_.half_space() || b_.half_space()) {
        const HydroBody& space = a_.half_space() ? a_ : b_;
        const dvec3 up = a_.half_space() ? dvec3(0, 0, 1) : X_AB.R[2];
        b = -std::get<SoftHalfSpace>(space.geometry).stiffness * glm::dot(up, p.normal);
        if (a_.half_space()) std::swap(a, b);
      } else if (p.tet_b >= 0) {
        b = glm::dot(X_AB.R * second->index().field().gradients()[at(p.tet_b)], p.normal);
      } else {
        b = a - (i < first_slope ? 0.0 : memory.depth.slopes[i - first_slope]);
      }
      const double own = std::abs(is_a_matched_ ? a : b), other = std::abs(is_a_matched_ ? b : a);
      constexpr double kLeast = 1e-9;  // of the other slope: a surface along a gradient
      memory.law.ratios.push_back(other / std::max(own, kLeast * other + std::numeric_limits<double>::min()));
    }
  }
  /// The body whose law gives the pressures.
  [[nodiscard]] const HydroBody& scale() const { return is_a_matched_ ? b_ : a_; }

  const HydroBody &a_, &b_;
  bool is_a_matched_;
  LawMatch match_;
};

/// `first` is the body of the polygons' `tet`, `second` that of `tet_b`; null if there is none.
void finish(SurfaceWriter& writer, const PairLaws& laws, const SoftOfPair* first, const SoftOfPair* second,
            const HydroBody& a, const HydroBody& b, const RigidTransform& X_AB, KernelMemory& memory,
            ContactSurface& out) {
  writer.finish();
  laws.finish(first, second, X_AB, memory, out);
  if (writer.back_faces().any) leave_out_back_faces(a, b, X_AB, memory.depth.slopes, out);
}

}  // namespace

IntersectWorkspace::IntersectWorkspace() : kernel(std::make_unique<KernelMemory>()) {}
IntersectWorkspace::~IntersectWorkspace() = default;

void intersect(const HydroBody& a, const HydroBody& b, const Pose& X_WA, const Pose& X_WB, ContactSurface& out,
               IntersectWorkspace& workspace) {
  check_pair(a, b);
  check_pose(a, X_WA);
  check_pose(b, X_WB);
  const auto *field_a = std::get_if<SoftBody>(&a.geometry), *field_b = std::get_if<SoftBody>(&b.geometry);
  KernelMemory& memory = *workspace.kernel;
  memory.depth.slopes.clear();
  const RigidTransform X_AB(X_WA.inverse() * X_WB), X_BA(X_WB.inverse() * X_WA);
  const PairLaws laws(a, b);
  // Triangles have the normal that leads into the body with tets: the surface pushes that body along it, the other one
  // against it. A rigid mesh in a soft half-space has normals that lead into the half-space.
  if (field_a != nullptr && field_b != nullptr) {
    SurfaceWriter writer(out, RigidTransform(), true, BodyOfPair::a);
    const SoftOfPair soft_a = laws.soft(a), soft_b = laws.soft(b);
    intersect_fields(soft_a, soft_b, X_WA.inverse() * X_WB, writer, memory);
    finish(writer, laws, &soft_a, &soft_b, a, b, X_AB, memory, out);
  } else if (field_a != nullptr) {
    SurfaceWriter writer(out, RigidTransform(), false, BodyOfPair::a);
    const SoftOfPair soft = laws.soft(a);
    intersect_field(soft, b, X_AB, writer, memory);
    finish(writer, laws, &soft, nullptr, a, b, X_AB, memory, out);
  } else if (field_b != nullptr) {
    SurfaceWriter writer(out, X_AB, true, BodyOfPair::b);
    const SoftOfPair soft = laws.soft(b);
    intersect_field(soft, a, X_BA, writer, memory);
    finish(writer, laws, &soft, nullptr, a, b, X_AB, memory, out);
  } else {
    const bool soft_is_a = a.soft();
    const auto& soft = std::get<SoftHalfSpace>((soft_is_a ? a : b).geometry);
    const auto& rigid = std::get<RigidMesh>((soft_is_a ? b : a).geometry);
    const BodyOfPair field = soft_is_a ? BodyOfPair::a : BodyOfPair::b;
    SurfaceWriter writer(out, soft_is_a ? RigidTransform() : X_AB, !soft_is_a, field);
    intersect_half_space(soft.stiffness, *rigid.tree, soft_is_a ? X_AB : X_BA, writer, memory);
    finish(writer, laws, nullptr, nullptr, a, b, X_AB, memory, out);
  }
}

}  // namespace taxel
