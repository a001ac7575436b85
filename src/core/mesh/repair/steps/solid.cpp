// Solids of the Manifold library, and the union of shells that overlap, touch along faces or are inside each other:
// walls inside a body are removed.
//
// Only shells that may share space are united, since a union costs far more than the tests: those with faces whose
// boxes come near each other, and those inside of another one by their winding number. A group is the union of its
// outward shells minus its cavities. A union that changes neither area nor volume is not used, so sound meshes keep
// their faces. Each face carries its number through all operations, by which it still knows its loaded face.
#include "core/mesh/repair/steps.h"

#include <manifold/manifold.h>

#include <map>

#include "core/mesh/query/bvh.h"
#include "core/mesh/query/disjoint_sets.h"
#include "core/mesh/query/winding_number.h"

namespace taxel {

manifold::Manifold make_solid(const Draft& draft, const std::vector<int>& faces, SolidFaces kind) {
  manifold::MeshGL64 mesh;
  std::vector<int> points;
  for (const int f : faces)
    for (int c = 0; c < 3; ++c) points.push_back(draft.faces[at(f)][c]);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  for (const int v : points) {
    const dvec3& p = draft.points[at(v)];
    mesh.vertProperties.insert(mesh.vertProperties.end(), {p.x, p.y, p.z});
  }
  using Index = decltype(mesh.triVerts)::value_type;
  for (const int f : faces) {
    ivec3 face = draft.faces[at(f)];
    if (kind == SolidFaces::inside_out) std::swap(face.y, face.z);
    for (int c = 0; c < 3; ++c)
      mesh.triVerts.push_back(
          static_cast<Index>(std::lower_bound(points.begin(), points.end(), face[c]) - points.begin()));
    if (kind != SolidFaces::mergeable) mesh.faceID.push_back(static_cast<Index>(f));
  }
  mesh.runOriginalID.push_back(manifold::Manifold::ReserveIDs(1));
  mesh.runIndex = {0, static_cast<Index>(mesh.triVerts.size())};
  return manifold::Manifold(mesh);
}

namespace {

template <class LoadedOf>
void append(Draft& draft, const manifold::Manifold& solid, const LoadedOf& loaded_of) {
  const manifold::MeshGL64 mesh = solid.GetMeshGL64();
  const int first = draft.point_count();
  const auto points = static_cast<std::size_t>(mesh.NumVert());
  std::vector<int> number(points);
  for (std::size_t v = 0; v < points; ++v) {
    number[v] = first + static_cast<int>(v);
    const auto p = mesh.GetVertPos(v);
    draft.points.emplace_back(p.x, p.y, p.z);
  }
  for (std::size_t i = 0; i < mesh.mergeFromVert.size(); ++i)
    number[mesh.mergeFromVert[i]] = number[mesh.mergeToVert[i]];
  for (std::size_t t = 0; t < static_cast<std::size_t>(mesh.NumTri()); ++t) {
    const ivec3 face(number[mesh.triVerts[3 * t]], number[mesh.triVerts[3 * t + 1]], number[mesh.triVerts[3 * t + 2]]);
    draft.add(face, loaded_of(static_cast<std::size_t>(mesh.faceID[t])));
  }
}

}  // namespace

void append_solid(Draft& draft, const manifold::Manifold& solid, const std::vector<int>& source_loaded) {
  append(draft, solid, [&](std::size_t number) { return source_loaded[number]; });
}

void append_wrapped(Draft& draft, const manifold::Manifold& solid) {
  append(draft, solid, [](std::size_t) { return kWrappedFace; });
}

namespace {

struct ShellData {
  Aabb box;
  double volume = 0, area = 0;
};

bool encloses(const Aabb& outer, const Aabb& inner) {
  return glm::all(glm::lessThanEqual(outer.lo, inner.lo)) && glm::all(glm::lessThanEqual(inner.hi, outer.hi));
}

/// Shells in groups whose members may share space.
class ShellGroups {
 public:
  ShellGroups(const Draft& draft, double near_distance)
      : draft_(draft), shells_(find_shells(draft)), data_(shells_.faces.size()), sets_(shells_.faces.size()) {
    for (std::size_t s = 0; s < data_.size(); ++s) {
      data_[s].volume = volume_of(draft, shells_.faces[s]);
      for (const int f : shells_.faces[s]) {
        data_[s].area += draft.area(f);
        for (int c = 0; c < 3; ++c) data_[s].box.include(draft.corner(f, c));
      }
    }
    if (outward_count() < 2) return;
    join_near_faces(near_distance);
    join_nested();
  }

  [[nodiscard]] int outward_count() const {
    return static_cast<int>(std::count_if(data_.begin(), data_.end(), [](const ShellData& s) { return s.volume > 0; }));
  }
  [[nodiscard]] const ShellData& data(int shell) const { return data_[at(shell)]; }
  [[nodiscard]] const std::vector<int>& faces(int shell) const { return shells_.faces[at(shell)]; }

  /// Groups of at least two outward shells, by their lowest shell.
  std::vector<std::vector<int>> groups() {
    std::map<int, std::vector<int>> by_root;
    for (int s = 0; s < static_cast<int>(data_.size()); ++s) by_root[sets_.find(s)].push_back(s);
    std::vector<std::vector<int>> found;
    for (auto& [root, members] : by_root) {
      const auto outward =
          std::count_if(members.begin(), members.end(), [&](int s) { return data_[at(s)].volume > 0; });
      if (outward >= 2) found.push_back(std::move(members));
    }
    return found;
  }

 private:
  /// Joins shells with faces whose boxes come near each other.
  void join_near_faces(double near_distance) {
    std::vector<Aabb> boxes(draft_.faces.size());
    for (int f = 0; f < draft_.face_count(); ++f) {
      for (int c = 0; c < 3; ++c) {
        boxes[at(f)].include(draft_.corner(f, c) - near_distance);
        boxes[at(f)].include(draft_.corner(f, c) + near_distance);
      }
    }
    const Bvh bvh(boxes);
    for (int f = 0; f < draft_.face_count(); ++f) {
      const int own = shells_.of_face[at(f)];
      bvh.visit([&](const Aabb& box) { return box.overlaps(boxes[at(f)]); },
                [&](int g) {
                  const int other = shells_.of_face[at(g)];
                  if (other < own && boxes[at(g)].overlaps(boxes[at(f)])) sets_.unite(own, other);
                });
    }
  }

  /// Joins each shell inside another one with those around it. Cavities of a single body join it as well.
  void join_nested() {
    const WindingNumber winding(draft_.points, draft_.faces);
    for (int inner = 0; inner < static_cast<int>(data_.size()); ++inner) {
      const int face = shells_.faces[at(inner)].front();
      // Half of the own shell winds around a point on it.
      const double own = data_[at(inner)].volume > 0 ? 0.5 : -0.5;
      if (winding(draft_.center(face)) - own < 0.4) continue;
      for (int outer = 0; outer < static_cast<int>(data_.size()); ++outer) {
        if (outer != inner && data_[at(outer)].volume > 0 && encloses(data_[at(outer)].box, data_[at(inner)].box))
          sets_.unite(inner, outer);
      }
    }
  }

  const Draft& draft_;
  FaceShells shells_;
  std::vector<ShellData> data_;
  DisjointSets sets_;
};

/// The union of the outward shells of a group minus its cavities.
manifold::Manifold unite(const Draft& draft, const ShellGroups& groups, const std::vector<int>& group) {
  std::vector<manifold::Manifold> bodies, cavities;
  for (const int s : group) {
    const bool is_cavity = groups.data(s).volume < 0;
    const SolidFaces kind = is_cavity ? SolidFaces::inside_out : SolidFaces::numbered;
    (is_cavity ? cavities : bodies).push_back(make_solid(draft, groups.faces(s), kind));
  }
  manifold::Manifold solid = manifold::Manifold::BatchBoolean(bodies, manifold::OpType::Add);
  if (!cavities.empty()) solid -= manifold::Manifold::BatchBoolean(cavities, manifold::OpType::Add);
  return solid;
}

}  // namespace

RepairStep unite_shells(Draft& draft, const RepairLimits& limits) {
  constexpr double kNear = 1e-7;       // of the diagonal
  constexpr double kUnchanged = 1e-6;  // largest relative change of area and volume
  RepairStep step = start_step("repair_united");
  ShellGroups groups(draft, kNear * limits.diagonal);
  if (groups.outward_count() < 2) return step;
  std::vector<char> removed(draft.faces.size(), 0);
  Draft united;
  for (const std::vector<int>& group : groups.groups()) {
    double area = 0, volume = 0;
    for (const int s : group) {
      area += groups.data(s).area;
      volume += groups.data(s).volume;
    }
    const manifold::Manifold solid = unite(draft, groups, group);
    if (solid.Status() != manifold::Manifold::Error::NoError || solid.IsEmpty()) continue;
    const double area_inside = area - solid.SurfaceArea();
    if (std::abs(area_inside) < kUnchanged * area && std::abs(solid.Volume() - volume) < kUnchanged * volume) continue;
    for (const int s : group) {
      step.place = step.count == 0 ? draft.center(groups.faces(s).front()) : step.place;
      step.count += groups.data(s).volume > 0 ? 1 : 0;
      for (const int f : groups.faces(s)) removed[at(f)] = 1;
    }
    append_solid(united, solid, draft.loaded);
    step.area += area_inside;
  }
  step.faces = united.face_count();
  if (step.count == 0) return step;
  remove_faces(draft, removed);
  append(draft, united);
  return step;
}

}  // namespace taxel
