// The samples behind a reading, the samples at back faces, and the edges of the mesh that a contact crossed.
//
// Edges. The force of each polygon acts on the face nearest to its centroid. An edge was crossed if one of its faces
// lost force while the other gained some, if the contact reached or left one of them, or if it is on the way of the
// centre of the pressure, which is halved until two neighbouring points are on faces with a common edge, or with a
// common vertex, of whose edges the most bent one counts. Edges count only within a disc of the taxel's field and if
// they bend. They are sorted by force times bend.
#include "core/sensor/explain/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/layout/field/receptive_field.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel {

std::vector<TaxelSampleReading> samples_behind(const SensorModel& model, const std::vector<RayHit>& hits, int taxel) {
  if (taxel < 0 || taxel >= model.taxel_count())
    throw Error(fmt::format("there is no taxel {}, the layout has {}", taxel, model.taxel_count()));
  const bool omit_misses = model.layout.readout.misses == Misses::omit;
  const AggregateSpec& spec = aggregate_spec(model.layout.readout.aggregate);

  std::vector<TaxelSampleReading> rows;
  double best = -std::numeric_limits<double>::infinity();
  std::optional<std::size_t> picked;
  for (int e = model.fields.first[at(taxel)]; e < model.fields.first[at(taxel) + 1]; ++e) {
    const ReceptiveFields::Entry& entry = model.fields.entries[at(e)];
    const RayHit& hit = hits[at(model.readout_table.ray_of_entry[at(e)])];
    const SampleUse use{entry.weight, model.sample_share(entry.sample), entry.distance, hit.pressure};
    rows.push_back({entry.sample, hit.hit(), hit.depth, hit.pressure, entry.weight, 0.0});
    if (spec.contribution != nullptr) {
      rows.back().share = spec.contribution(use);
    } else if (const double rank = spec.rank(use); (hit.hit() || !omit_misses) && rank > best) {
      best = rank, picked = rows.size() - 1;
    }
  }
  if (picked) rows[*picked].share = rows[*picked].pressure;

  double total = 0.0;
  for (const TaxelSampleReading& r : rows) total += r.share;
  if (total > 0.0)
    for (TaxelSampleReading& r : rows) r.share /= total;
  return rows;
}

namespace {

/// Returns true if the segment from `from` along `way` to the depth `end` [m] meets the convex polygon.
bool meets(const dvec3& from, const dvec3& way, double end, std::span<const dvec3> polygon) {
  dvec3 normal(0);  // twice the area along the unit normal
  for (std::size_t i = 2; i < polygon.size(); ++i)
    normal += glm::cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]);
  const double along = glm::dot(normal, way);
  if (along == 0) return false;
  const double depth = glm::dot(normal, polygon[0] - from) / along;
  if (!(depth >= 0 && depth < end)) return false;
  const dvec3 x = from + depth * way;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    if (glm::dot(glm::cross(b - a, x - a), normal) < 0) return false;
  }
  return true;
}

}  // namespace

std::string back_faces_text(const Explanation& explanation) {
  if (explanation.samples_at_back_faces == 0) return "";
  return fmt::format(
      "Back face left out: {} of {} samples would read a face that opposes the pressure, such as the far face of a "
      "thin body. It does not count, or in part (material/faces).",
      explanation.samples_at_back_faces, explanation.samples.size());
}

int count_samples_at_back_faces(const SensorModel& model, int taxel, const SensorStep& step) {
  std::vector<std::span<const dvec3>> back_faces;
  for (const ContactSurface& surface : step.surfaces)
    for (const FilteredPolygon& one : surface.filtered)
      if (one.reason == Rejection::back_face)
        back_faces.push_back(std::span(surface.filtered_vertices).subspan(at(one.first), at(one.count)));
  int count = 0;
  for (int e = model.fields.first[at(taxel)]; e < model.fields.first[at(taxel) + 1]; ++e) {
    const std::size_t number = at(model.readout_table.ray_of_entry[at(e)]);
    const SensorRay& ray = model.rays[number];
    const RayHit& hit = step.hits[number];
    const bool is_partial = hit.hit() && step.surfaces[at(hit.surface)].polygons[at(hit.polygon)].weight < 1;
    const double end = hit.hit() ? hit.depth : ray.max_depth;
    if (is_partial || std::any_of(back_faces.begin(), back_faces.end(), [&](std::span<const dvec3> polygon) {
          return meets(ray.origin, ray.direction, end, polygon);
        }))
      ++count;
  }
  return count;
}

namespace {

/// Number of halvings of the way of the centre of the pressure until two faces share an edge.
constexpr int kMaxHalvings = 12;

/// The force of one step on the faces of the skin.
struct FaceLoads {
  std::map<int, double> force;  ///< force by face of the skin [N]
  dvec3 moment{0};              ///< sum of force times place inside of the field [N m]
  double in_field = 0;          ///< force inside of the field [N]
  [[nodiscard]] double on(int face) const {
    const auto found = force.find(face);
    return found != force.end() ? found->second : 0.0;
  }
};

/// Returns the distance of a point from the segment between two points.
double distance_to_segment(const dvec3& p, const dvec3& a, const dvec3& b) {
  const dvec3 along = b - a;
  const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::distance(p, a + t * along);
}

/// The edges that a contact crossed, by half-edge.
class Crossings {
 public:
  Crossings(const SensorModel& model, int taxel)
      : model_(model), skin_(model.skin->mesh()), discs_(discs_of(model.layout.taxels[at(taxel)])) {}

  [[nodiscard]] FaceLoads loads_of(const SensorStep& step) const {
    FaceLoads loads;
    for (const ContactSurface& surface : step.surfaces) {
      for (const ContactPolygon& p : surface.polygons) {
        const SurfacePoint near = model_.skin->closest_point(p.centroid);
        const double force = p.area * p.pressure;
        loads.force[near.face] += force;
        if (!in_field(near.position)) continue;
        loads.moment += force * near.position;
        loads.in_field += force;
      }
    }
    return loads;
  }

  /// Adds the edges between faces of which one lost force to the other, or which the contact reached or left.
  void add_exchanges(const FaceLoads& before, const FaceLoads& now) {
    for (const FaceLoads* loads : {&before, &now}) {
      for (const auto& [face, force] : loads->force) {
        for (int h = 3 * face; h < 3 * face + 3; ++h) {
          const int other = skin_.topology().face_across(h);
          if (other >= 0) add(h, exchanged(face, other, before, now));
        }
      }
    }
  }

  /// Adds the edges on the way of the centre of the pressure in the field.
  void add_way(const FaceLoads& before, const FaceLoads& now) {
    if (!(before.in_field > 0 && now.in_field > 0)) return;
    const dvec3 from = before.moment / before.in_field, to = now.moment / now.in_field;
    force_ = std::min(before.in_field, now.in_field);
    walk(from, model_.skin->closest_point(from).face, to, model_.skin->closest_point(to).face, kMaxHalvings);
  }

  [[nodiscard]] std::vector<CrossedEdge> result() const {
    std::vector<CrossedEdge> edges;
    for (const auto& [h, force] : force_of_) {
      const int f = h / 3, g = skin_.topology().face_across(h);
      CrossedEdge edge;
      edge.faces = {model_.skin_face_of[at(f)], model_.skin_face_of[at(g)]};
      std::sort(edge.faces.begin(), edge.faces.end());
      edge.bend_deg = bend(h);
      edge.distance = distance(h);
      edge.force = force;
      edges.push_back(edge);
    }
    const auto effect = [](const CrossedEdge& e) { return e.force * e.bend_deg; };
    std::stable_sort(edges.begin(), edges.end(), [&](const auto& a, const auto& b) { return effect(a) > effect(b); });
    if (edges.size() > kMaxCrossedEdges) edges.resize(kMaxCrossedEdges);
    return edges;
  }

 private:
  [[nodiscard]] bool in_field(const dvec3& p) const {
    return std::any_of(discs_.begin(), discs_.end(),
                       [&](const FieldDisc& disc) { return glm::distance(disc.center, p) <= disc.radius; });
  }
  [[nodiscard]] double to_edge(const FieldDisc& disc, int h) const {
    const EdgeTopology& edges = skin_.topology();
    return distance_to_segment(disc.center, skin_.vertices()[at(edges.from(h))], skin_.vertices()[at(edges.to(h))]);
  }
  /// Returns the smallest distance of an edge from the centre of a disc.
  [[nodiscard]] double distance(int h) const {
    double least = std::numeric_limits<double>::infinity();
    for (const FieldDisc& disc : discs_) least = std::min(least, to_edge(disc, h));
    return least;
  }
  [[nodiscard]] double bend(int h) const {
    const int other = skin_.topology().face_across(h);
    return angle_deg(skin_.face_normals()[at(h / 3)], skin_.face_normals()[at(other)]);
  }

  static double exchanged(int f, int g, const FaceLoads& before, const FaceLoads& now) {
    const double on_f = now.on(f) - before.on(f), on_g = now.on(g) - before.on(g);
    if (on_f * on_g < 0) return std::min(std::abs(on_f), std::abs(on_g));
    const bool both_f = before.on(f) > 0 && now.on(f) > 0, both_g = before.on(g) > 0 && now.on(g) > 0;
    if (both_f == both_g) return 0.0;
    return std::abs(both_f ? on_g : on_f);
  }

  void add(int h, double force) {
    if (!(force > 0) || !(bend(h) > kFlatEdge)) return;
    const bool reached = std::any_of(discs_.begin(), discs_.end(),
                                     [&](const FieldDisc& disc) { return to_edge(disc, h) <= disc.radius; });
    if (!reached) return;
    double& most = force_of_[std::min(h, skin_.topology().twin(h))];
    most = std::max(most, force);
  }

  /// Adds the most bent edge at the vertex that two faces share, over which the way leads.
  void add_at_vertex(int face_from, int face_to) {
    const EdgeTopology& edges = skin_.topology();
    const ivec3& other = skin_.faces()[at(face_to)];
    for (int first = 3 * face_from; first < 3 * face_from + 3; ++first) {
      const int vertex = edges.from(first);
      if (vertex != other[0] && vertex != other[1] && vertex != other[2]) continue;
      int most = first, h = first;
      do {
        if (edges.twin(h) >= 0 && (edges.twin(most) < 0 || bend(h) > bend(most))) most = h;
        h = edges.twin(previous_edge(h));
      } while (h >= 0 && h != first);
      if (edges.twin(most) >= 0) add(most, force_);
    }
  }

  void walk(const dvec3& from, int face_from, const dvec3& to, int face_to, int halvings) {
    if (face_from == face_to) return;
    for (int h = 3 * face_from; h < 3 * face_from + 3; ++h)
      if (skin_.topology().face_across(h) == face_to) return add(h, force_);
    if (halvings == 0) return add_at_vertex(face_from, face_to);
    const dvec3 middle = 0.5 * (from + to);
    const int face = model_.skin->closest_point(middle).face;
    walk(from, face_from, middle, face, halvings - 1);
    walk(middle, face, to, face_to, halvings - 1);
  }

  const SensorModel& model_;
  const TriMesh& skin_;
  std::vector<FieldDisc> discs_;
  double force_ = 0;                // force on the way of the centre of the pressure [N]
  std::map<int, double> force_of_;  // force that crossed each edge, by its lower half-edge
};

}  // namespace

std::vector<CrossedEdge> crossed_edges(int taxel, const SensorStep& before, const SensorStep& now) {
  Crossings crossings(*now.model, taxel);
  const FaceLoads loads_before = crossings.loads_of(before), loads_now = crossings.loads_of(now);
  crossings.add_exchanges(loads_before, loads_now);
  crossings.add_way(loads_before, loads_now);
  return crossings.result();
}

}  // namespace taxel
