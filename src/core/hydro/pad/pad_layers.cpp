// The second layer of a pad's prisms.
//
// Below concave skin the distance of an inner vertex to the skin exceeds its depth below the planes of the faces
// around. The stiffness at the skin asks for the smaller, the field further inside for the larger: one layer of tets
// cannot have both. So offset vectors at which the two differ get a middle vertex near the skin, and the prisms there
// have two layers.
//
// 1. Requested middle vertices have a fixed part of their vector's length. Around them the heights descend at 45
//    degrees or less, over the neighbours, so that prisms are well shaped; where the height reaches the inner vertex's,
//    or the skin is no farther than the faces, there is no middle vertex.
// 2. Prisms and gaps are cut. Sides are cut by the numbers of their offset vectors alone, so neighbours with one and
//    with two layers share their faces.
// 3. A badly shaped tet takes the middle vertices of its offset vectors away, and the cut is repeated. Without any
//    middle vertex the tets are those of the shape, which are sound, so this ends.
//
// Theory: docs/theory/hydro.md, "Two layers".
#include "core/hydro/pad/pad_field.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/base/parallel.h"
#include "core/hydro/fields/tet_geometry.h"

namespace taxel {
namespace {

/// Position of a middle vertex as a fraction of its offset vector's length. It is small, since up to the middle vertex
/// the pressure depends on the planes of the faces and not on the distance to the skin.
constexpr double kMiddle = 0.3;
/// Largest position of a middle vertex as a fraction of its offset vector's length; beyond it there is no room for a
/// second layer.
constexpr double kHighest = 0.8;
/// Largest difference in height of neighbouring middle vertices, divided by their distance.
constexpr double kSlope = 1.0;
/// A middle vertex is useless if the distance to the skin is less than this fraction of the depth below its faces.
constexpr double kOwnDepth = 0.5;

constexpr double kNone = std::numeric_limits<double>::infinity();

}  // namespace

PadLayers::PadLayers(const PadShape& shape, const MeshIndex& index, const std::vector<char>& asked)
    : shape_(shape), mesh_(index.mesh()), middle_(at(shape.offset_count()), -1) {
  single_.reserve(mesh_.faces().size());
  for (int f = 0; f < mesh_.face_count(); ++f) single_.push_back(shape.tets(f));
  if (std::find(asked.begin(), asked.end(), 1) != asked.end()) {
    spread(asked);
    place(index);
  }
  while (!cut()) {
  }
  number();
}

/// Computes the heights, from the requested offset vectors to the offset vectors around them.
void PadLayers::spread(const std::vector<char>& asked) {
  height_.assign(middle_.size(), kNone);
  for (int offset = 0; offset < shape_.offset_count(); ++offset) {
    if (asked[at(offset)] && !shape_.collapsed(offset)) height_[at(offset)] = kMiddle * shape_.length(offset);
  }
  bool changed = true;
  const auto lower = [&](int low, int high, double distance) {
    const double most = height_[at(low)] + kSlope * distance;
    if (!(height_[at(high)] > most * (1 + 1e-9))) return;
    height_[at(high)] = most;
    changed = true;
  };
  while (std::exchange(changed, false)) {
    for (int f = 0; f < mesh_.face_count(); ++f) {
      for (int c = 0; c < 3; ++c) {
        const int next = (c + 1) % 3, a = shape_.offset(f, c), b = shape_.offset(f, next);
        if (height_[at(a)] == height_[at(b)]) continue;
        const double distance = glm::distance(mesh_.vertex(f, c), mesh_.vertex(f, next));
        lower(a, b, distance);
        lower(b, a, distance);
      }
    }
  }
}

/// Chooses the middle vertices, and finds their depths.
void PadLayers::place(const MeshIndex& index) {
  const int first = mesh_.vertex_count() + shape_.offset_count();
  depth_.assign(middle_.size(), 0.0);
  constexpr int kChunk = 64;
  parallel_chunks(shape_.offset_count(), kChunk, [&](int begin, int end) {
    for (int offset = begin; offset < end; ++offset) {
      const double h = height_[at(offset)];
      if (shape_.collapsed(offset) || h > kHighest * shape_.length(offset)) continue;
      const double depth = -index.signed_point(shape_.moved(offset, h), h).signed_distance;
      if (depth < kOwnDepth * shape_.direction(offset).least_cosine * h) continue;
      depth_[at(offset)] = depth;
      middle_[at(offset)] = first + offset;  // number() closes the gaps
    }
  });
}

std::array<dvec3, 4> PadLayers::corners(const ivec4& tet) const {
  const int skin = mesh_.vertex_count(), inner = skin + shape_.offset_count();
  std::array<dvec3, 4> x;
  for (int i = 0; i < 4; ++i) {
    const int v = tet[i];
    x[at(i)] = v < skin    ? mesh_.vertices()[at(v)]
               : v < inner ? shape_.inner_position(v - skin)
                           : shape_.moved(v - inner, height_[at(v - inner)]);
  }
  return x;
}

/// Returns the second layer below a triangle of offset vectors. Sides are split by the indices of the offset vectors.
PrismTets PadLayers::below(const ivec3& offsets) const {
  return split_prism({top(offsets.x), top(offsets.y), top(offsets.z)},
                     {shape_.inner(offsets.x), shape_.inner(offsets.y), shape_.inner(offsets.z)}, offsets);
}

/// Returns true if the prism below a face is well shaped.
bool PadLayers::add_face(int face) {
  const PrismTets& single = single_[at(face)];
  const ivec3 offsets(shape_.offset(face, 0), shape_.offset(face, 1), shape_.offset(face, 2));
  if (single.count == 0 || !(has(offsets.x) || has(offsets.y) || has(offsets.z))) {
    tets_.insert(tets_.end(), single.tets.begin(), single.tets.begin() + single.count);
    return true;
  }
  double outer_height = kNone, inner_height = kNone;
  for (int c = 0; c < 3; ++c) {
    const double whole = shape_.length(offsets[c]), part = height_[at(offsets[c])];
    if (has(offsets[c])) inner_height = std::min(inner_height, whole - part);
    if (!shape_.collapsed(offsets[c])) outer_height = std::min(outer_height, has(offsets[c]) ? part : whole);
  }
  bool good = true;
  const auto add = [&](const PrismTets& layer, double height) {
    for (int i = 0; i < layer.count; ++i) {
      const double least = kMinVolume * 2.0 * mesh_.face_areas()[at(face)] * height;
      good = good && six_volumes(corners(layer.tets[at(i)])) > least;
      tets_.push_back(layer.tets[at(i)]);
    }
  };
  const ivec3& skin = mesh_.faces()[at(face)];
  add(split_prism(skin, {top(offsets.x), top(offsets.y), top(offsets.z)}, skin), outer_height);
  add(below(offsets), inner_height);
  ++two_layer_faces_;
  return good;
}

/// Adds the tets of a gap. Returns true if none of them is flat. `floor` has indices of offset vectors.
bool PadLayers::add_gap(std::vector<ivec4> outer, const std::vector<ivec3>& floor) {
  const std::size_t single = outer.size();
  for (const ivec3& offsets : floor) {
    const PrismTets layer = below(offsets);
    outer.insert(outer.end(), layer.tets.begin(), layer.tets.begin() + layer.count);
  }
  tets_.insert(tets_.end(), outer.begin(), outer.end());
  if (outer.size() == single) return true;
  return std::none_of(outer.begin(), outer.end(), [&](const ivec4& t) { return is_flat(corners(t)); });
}

/// Splits all prisms and gaps. If a tet is badly shaped, its offset vectors lose their middle vertices and the result
/// is false; cut() must then be called again. Without any middle vertex the tets are those of the shape, which are
/// sound.
bool PadLayers::cut() {
  tets_.clear();
  tets_.reserve(3 * mesh_.faces().size());
  two_layer_faces_ = 0;
  std::vector<int> worse;
  for (int f = 0; f < mesh_.face_count(); ++f) {
    if (add_face(f)) continue;
    for (int c = 0; c < 3; ++c) worse.push_back(shape_.offset(f, c));
  }
  std::vector<int> tops = shape_.ends();
  for (int offset = 0; offset < shape_.offset_count(); ++offset) tops[at(offset)] = top(offset);
  for (const PadWedge& wedge : shape_.offsets().wedges) {
    if (add_gap(gap_tets(wedge, tops), gap_floor(wedge))) continue;
    worse.insert(worse.end(), wedge.at_u.begin(), wedge.at_u.end());
    worse.insert(worse.end(), wedge.at_v.begin(), wedge.at_v.end());
  }
  for (const PadCone& cone : shape_.offsets().cones) {
    if (add_gap(gap_tets(cone, tops), gap_floor(cone))) continue;
    worse.insert(worse.end(), cone.rim.begin(), cone.rim.end());
    worse.push_back(cone.center);
  }
  for (const int offset : worse) middle_[at(offset)] = -1;
  return worse.empty();
}

/// Numbers the remaining middle vertices without gaps.
void PadLayers::number() {
  const int first = mesh_.vertex_count() + shape_.offset_count();
  for (int offset = 0; offset < shape_.offset_count(); ++offset) {
    if (!has(offset)) continue;
    middle_[at(offset)] = first + static_cast<int>(offsets_.size());
    offsets_.push_back(offset);
  }
  for (ivec4& t : tets_) {
    for (int i = 0; i < 4; ++i) {
      if (t[i] >= first) t[i] = middle_[at(t[i] - first)];
    }
  }
}

}  // namespace taxel
