// Connected shells of a draft, and crossing faces, which are cut out of a shell before the holes are filled.
//
// 1. The faces that cross are removed, parts that this has separated are dropped if they are small, and the holes are
//    filled.
// 2. If faces still cross, or edges are open, the faces at these places are removed too, up to four rounds and a tenth
//    of the area.
// 3. The best trial is accepted if it is closed and has few crossings, and if new faces are near the old ones and the
//    old ones near the new shell or inside of it. Otherwise the shell remains as it was, for a wrap.
//
// Faces outside of the cuts keep their points, bit for bit, which a wrap cannot promise. Cost: only pairs with a new
// face are searched again. Where most faces cross others, a list of all pairs would take long, so shells with crossings
// on more than a tenth of their area are found by faces first and not listed.
#include <limits>
#include <memory>
#include <optional>

#include "core/mesh/query/closest_point.h"
#include "core/mesh/query/disjoint_sets.h"
#include "core/mesh/query/self_intersection.h"
#include "core/mesh/repair/steps.h"
#include "core/mesh/repair/topology.h"

namespace taxel {

FaceShells find_shells(const Draft& draft) {
  DisjointSets sets(draft.points.size());
  for (const ivec3& f : draft.faces) {
    sets.unite(f.x, f.y);
    sets.unite(f.x, f.z);
  }
  FaceShells shells;
  std::vector<int> number(draft.points.size(), -1);
  for (int f = 0; f < draft.face_count(); ++f) {
    int& shell = number[at(sets.find(draft.faces[at(f)].x))];
    if (shell < 0) {
      shell = static_cast<int>(shells.faces.size());
      shells.faces.emplace_back();
    }
    shells.faces[at(shell)].push_back(f);
    shells.of_face.push_back(shell);
  }
  return shells;
}

double volume_of(const Draft& draft, const std::vector<int>& faces) {
  const dvec3 apex = draft.corner(faces.front(), 0);
  double volume = 0;
  for (const int f : faces) {
    volume +=
        glm::dot(draft.corner(f, 0) - apex, glm::cross(draft.corner(f, 1) - apex, draft.corner(f, 2) - apex)) / 6.0;
  }
  return volume;
}

Draft extract_faces(const Draft& draft, const std::vector<int>& faces) {
  std::vector<int> points;
  points.reserve(3 * faces.size());
  for (const int f : faces)
    for (int c = 0; c < 3; ++c) points.push_back(draft.faces[at(f)][c]);
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  Draft part;
  for (const int v : points) part.points.push_back(draft.points[at(v)]);
  const auto number = [&](int v) {
    return static_cast<int>(std::lower_bound(points.begin(), points.end(), v) - points.begin());
  };
  for (const int f : faces) {
    const ivec3& face = draft.faces[at(f)];
    part.add({number(face.x), number(face.y), number(face.z)}, draft.loaded[at(f)]);
  }
  return part;
}

void append(Draft& draft, const Draft& other) {
  const int first = draft.point_count();
  draft.points.insert(draft.points.end(), other.points.begin(), other.points.end());
  for (int f = 0; f < other.face_count(); ++f) draft.add(other.faces[at(f)] + first, other.loaded[at(f)]);
}

BoxTree tree_of_faces(const Draft& draft) {
  std::vector<Aabb> boxes(draft.faces.size());
  for (int f = 0; f < draft.face_count(); ++f)
    for (int c = 0; c < 3; ++c) boxes[at(f)].include(draft.corner(f, c));
  return BoxTree(boxes, Bvh::Effort::few_queries);
}

std::vector<std::pair<int, int>> find_crossing_pairs(const Draft& draft) {
  return find_crossing_pairs(draft, std::vector<char>(draft.faces.size(), 1));
}

std::vector<std::pair<int, int>> find_crossing_pairs(const Draft& draft, const std::vector<char>& chosen) {
  return find_crossing_pairs(draft.points, draft.faces, chosen);
}

int few_pairs(int faces) {
  constexpr double kFew = 1e-3;
  constexpr int kAlwaysFew = 3;
  return std::max(kAlwaysFew, static_cast<int>(kFew * faces));
}

namespace {

using FaceFlags = std::vector<char>;  ///< a nonzero entry for each chosen face
constexpr double kMaxCutPart = 0.1;   // largest replaced part of the area of a shell

double area_of(const Draft& draft, const FaceFlags& chosen) {
  double area = 0;
  for (int f = 0; f < draft.face_count(); ++f) area += chosen[at(f)] != 0 ? draft.area(f) : 0;
  return area;
}

/// Removes parts that a cut has separated from the largest one and that have less than 2 % of all area.
void remove_islands(Draft& draft) {
  constexpr double kIsland = 0.02;
  std::vector<int> patch_of_face;
  std::vector<double> areas(at(find_patches(draft, twin_pairs(draft.edges()), patch_of_face)), 0);
  if (areas.size() < 2) return;
  double area = 0;
  for (int f = 0; f < draft.face_count(); ++f) {
    areas[at(patch_of_face[at(f)])] += draft.area(f);
    area += draft.area(f);
  }
  const double least = std::min(kIsland * area, *std::max_element(areas.begin(), areas.end()));
  FaceFlags removed(draft.faces.size(), 0);
  for (int f = 0; f < draft.face_count(); ++f) removed[at(f)] = areas[at(patch_of_face[at(f)])] < least ? 1 : 0;
  remove_faces(draft, removed);
}

/// A shell without some of its faces, with its holes filled. `loaded` has numbers of the shell's faces.
struct Trial {
  Draft draft;
  int holes = 0;
};

Trial refill(const Draft& shell, const FaceFlags& cut, const RepairLimits& limits) {
  Trial trial{shell, 0};
  for (int f = 0; f < shell.face_count(); ++f) trial.draft.loaded[at(f)] = f;
  remove_faces(trial.draft, cut);
  if (trial.draft.faces.empty()) return trial;
  remove_islands(trial.draft);
  trial.holes = fill_holes(trial.draft, limits).count;
  turn_flat_faces(trial.draft);
  RepairChanges unused;
  part_touching(trial.draft, unused);
  return trial;
}

/// A nonzero entry for each face of a trial that is not a face of the shell at the same place.
FaceFlags find_new_faces(const Draft& shell, const Draft& trial) {
  FaceFlags is_new(trial.faces.size(), 0);
  for (int f = 0; f < trial.face_count(); ++f) {
    const int from = trial.loaded[at(f)];
    bool is_same = from >= 0;
    for (int c = 0; is_same && c < 3; ++c) is_same = trial.corner(f, c) == shell.corner(from, c);
    is_new[at(f)] = is_same ? 0 : 1;
  }
  return is_new;
}

/// The faults that a trial still has.
struct Faults {
  std::size_t pairs = 0;     ///< pairs of faces that cross
  bool is_open = false;      ///< it has open edges
  std::vector<char> points;  ///< a nonzero entry for each point of the shell at a fault
};

/// The faces that a shell keeps do not cross, so pairs without a new face are not searched.
Faults find_faults(const Draft& shell, const Draft& trial) {
  Faults faults;
  faults.points.resize(std::max(shell.points.size(), trial.points.size()), 0);
  for (const auto& [f, g] : find_crossing_pairs(trial, find_new_faces(shell, trial))) {
    ++faults.pairs;
    for (const int face : {f, g})
      for (int c = 0; c < 3; ++c) faults.points[at(trial.faces[at(face)][c])] = 1;
  }
  const EdgeTopology edges = trial.edges();
  for (int h = 0; h < edges.half_edge_count(); ++h) {
    if (edges.twin(h) >= 0) continue;
    faults.is_open = true;
    faults.points[at(edges.from(h))] = faults.points[at(edges.to(h))] = 1;
  }
  faults.points.resize(shell.points.size());
  return faults;
}

/// Chooses the faces at faulty points as well. Returns false if all of these are chosen already.
bool grow(const Draft& shell, const std::vector<char>& faulty, FaceFlags& cut) {
  bool has_grown = false;
  for (int f = 0; f < shell.face_count(); ++f) {
    const ivec3& face = shell.faces[at(f)];
    if (cut[at(f)] != 0 || (faulty[at(face.x)] | faulty[at(face.y)] | faulty[at(face.z)]) == 0) continue;
    cut[at(f)] = 1;
    has_grown = true;
  }
  return has_grown;
}

/// Calls accepts(point) for points of a face at most `spacing` apart, up to a number. Returns false if it does once.
template <class Accepts>
bool accepts_all(const Draft& draft, int face, double spacing, const Accepts& accepts) {
  constexpr double kMaxIntervals = 24;
  const dvec3 a = draft.corner(face, 0), u = draft.corner(face, 1) - a, v = draft.corner(face, 2) - a;
  const double longest = std::max({glm::length(u), glm::length(v), glm::length(u - v)});
  const int n = static_cast<int>(std::clamp(std::ceil(longest / spacing), 2.0, kMaxIntervals));
  for (int i = 0; i <= n; ++i)
    for (int j = 0; i + j <= n; ++j)
      if (!accepts(a + (static_cast<double>(i) * u + static_cast<double>(j) * v) / static_cast<double>(n)))
        return false;
  return true;
}

/// Index of the faces that may be within `reach` of the box.
std::unique_ptr<MeshIndex> index_near(const Draft& draft, Aabb box, double reach) {
  box.lo -= reach;
  box.hi += reach;
  std::vector<int> near;
  for (int f = 0; f < draft.face_count(); ++f) {
    Aabb of_face;
    for (int c = 0; c < 3; ++c) of_face.include(draft.corner(f, c));
    if (of_face.overlaps(box) && draft.area(f) > 0) near.push_back(f);
  }
  if (near.empty()) return nullptr;
  Draft part = extract_faces(draft, near);
  return std::make_unique<MeshIndex>(std::make_shared<const TriMesh>(std::move(part.points), std::move(part.faces)));
}

Aabb bounds_of(const Draft& draft, const FaceFlags& chosen) {
  Aabb box;
  for (int f = 0; f < draft.face_count(); ++f)
    for (int c = 0; c < 3 && chosen[at(f)] != 0; ++c) box.include(draft.corner(f, c));
  return box;
}

/// Returns true if all new faces are near the old ones, and all old ones near the new shell or inside of it.
bool stays_near(const Draft& shell, const Draft& trial, const FaceFlags& removed, double reach) {
  const FaceFlags is_new = find_new_faces(shell, trial);
  const auto before = index_near(shell, bounds_of(trial, is_new), reach);
  for (int f = 0; f < trial.face_count(); ++f) {
    const auto is_near = [&](const dvec3& p) { return before != nullptr && before->closest_point(p, reach).face >= 0; };
    if (is_new[at(f)] != 0 && !accepts_all(trial, f, reach, is_near)) return false;
  }
  const Aabb box = bounds_of(shell, removed);
  const auto after = index_near(trial, box, reach);
  std::unique_ptr<MeshIndex> all;  // most points are near, and then it is not needed
  for (int f = 0; f < shell.face_count(); ++f) {
    const auto is_near_or_inside = [&](const dvec3& p) {
      if (after != nullptr && after->closest_point(p, reach).face >= 0) return true;
      if (all == nullptr) all = index_near(trial, box, std::numeric_limits<double>::infinity());
      return all->signed_distance(p) < 0;
    };
    if (removed[at(f)] != 0 && !accepts_all(shell, f, reach, is_near_or_inside)) return false;
  }
  return true;
}

/// A nonzero entry for each face of the shell that a trial does not have.
FaceFlags find_removed(const Draft& shell, const Draft& trial) {
  FaceFlags removed(shell.faces.size(), 1);
  for (const int from : trial.loaded)
    if (from >= 0) removed[at(from)] = 0;
  return removed;
}

void count_changes(const Draft& shell, const Trial& trial, const FaceFlags& removed, RepairStep& step) {
  const auto first = std::find_if(removed.begin(), removed.end(), [](char g) { return g != 0; });
  if (step.count == 0 && first != removed.end()) step.place = shell.center(static_cast<int>(first - removed.begin()));
  step.count += trial.holes;
  step.faces += static_cast<int>(std::count_if(removed.begin(), removed.end(), [](char g) { return g != 0; }));
  step.area += area_of(shell, removed);
}

/// A nonzero entry for each shell that has more than a few crossings, on more than the part of its area that may be cut
/// out. More crossing faces never make a hopeless shell hopeful.
std::vector<char> find_hopeless(const Draft& draft, const FaceShells& shells, const FaceFlags& crosses) {
  std::vector<char> is_hopeless;
  for (const std::vector<int>& faces : shells.faces) {
    double area = 0, cut = 0;
    int count = 0;
    for (const int f : faces) {
      area += draft.area(f);
      cut += crosses[at(f)] != 0 ? draft.area(f) : 0;
      count += crosses[at(f)] != 0 ? 1 : 0;
    }
    // Each pair is one of two faces.
    const bool has_many = count > 2 * few_pairs(static_cast<int>(faces.size()));
    is_hopeless.push_back(has_many && cut > kMaxCutPart * area ? 1 : 0);
  }
  return is_hopeless;
}

}  // namespace

bool cut_crossings(Draft& shell, const std::vector<std::pair<int, int>>& pairs, std::size_t allowed,
                   const RepairLimits& limits, RepairStep& step) {
  constexpr int kMaxRounds = 4;        // the crossing faces, then rings of faces around those that still cross
  constexpr double kEdgesOfReach = 2;  // a wrap is as near as this
  FaceFlags cut(shell.faces.size(), 0);
  for (const auto& [f, g] : pairs) cut[at(f)] = cut[at(g)] = 1;
  const double most = kMaxCutPart * area_of(shell, FaceFlags(shell.faces.size(), 1));
  std::optional<Trial> best;
  for (int round = 0; round < kMaxRounds && area_of(shell, cut) <= most; ++round) {
    Trial trial = refill(shell, cut, limits);
    const Faults faults = find_faults(shell, trial.draft);
    if (!faults.is_open && faults.pairs <= allowed && !trial.draft.faces.empty()) {
      best = std::move(trial);
      allowed = faults.pairs;
    }
    const bool is_sound = !faults.is_open && faults.pairs == 0;
    if (is_sound || !grow(shell, faults.points, cut)) break;
  }
  if (!best) return false;
  const FaceFlags removed = find_removed(shell, best->draft);
  if (!stays_near(shell, best->draft, removed, kEdgesOfReach * limits.edge)) return false;
  count_changes(shell, *best, removed, step);
  for (int& from : best->draft.loaded) from = from < 0 ? kFilledFace : shell.loaded[at(from)];
  shell = std::move(best->draft);
  return true;
}

int OwnCrossings::count_all(const Draft& draft) const {
  return count >= 0 ? count : static_cast<int>(find_crossing_pairs(draft).size());
}

OwnCrossings find_own_crossings(const Draft& draft, const FaceShells& shells) {
  constexpr std::size_t kFacesOfAPair = 8;  // fewer have too many pairs to list all
  OwnCrossings own{{}, std::vector<char>(shells.faces.size(), 0), -1};
  own.pairs.resize(shells.faces.size());
  const BoxTree tree = tree_of_faces(draft);
  auto pairs = find_crossing_pairs(draft.points, draft.faces, tree, draft.faces.size() / kFacesOfAPair);
  if (pairs) {
    own.count = static_cast<int>(pairs->size());
  } else {
    const auto are_all_hopeless = [&](const FaceFlags& found) {
      own.is_hopeless = find_hopeless(draft, shells, found);
      return std::find(own.is_hopeless.begin(), own.is_hopeless.end(), 0) == own.is_hopeless.end();
    };
    FaceFlags crosses = find_crossing_faces(draft.points, draft.faces, tree, shells.of_face, are_all_hopeless);
    for (int f = 0; f < draft.face_count(); ++f)
      if (own.is_hopeless[at(shells.of_face[at(f)])] != 0) crosses[at(f)] = 0;
    pairs = find_crossing_pairs(draft, crosses);
  }
  for (const auto& [f, g] : *pairs) {
    const int shell = shells.of_face[at(f)];
    if (shell == shells.of_face[at(g)] && own.is_hopeless[at(shell)] == 0) own.pairs[at(shell)].emplace_back(f, g);
  }
  return own;
}

}  // namespace taxel
