#include "core/mesh/topology/weld.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/base/limits.h"

namespace taxel {
namespace {

void check_soup(const PolygonSoup& soup, const dvec3& scale) {
  if (!is_finite(scale) || scale.x * scale.y * scale.z == 0)
    throw Error(fmt::format("scale ({}, {}, {}) must be finite and not zero", scale.x, scale.y, scale.z));
  const int n = static_cast<int>(soup.vertices.size());
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    for (int c = 0; c < 3; ++c) {
      const int v = soup.triangles[f][c];
      if (v < 0 || v >= n) throw Error(fmt::format("triangle {}: no vertex {} (there are {})", f, v, n));
    }
  }
}

/// Numbers in an open table with linear probing. The table is at most half full, and keeps no keys of its own.
class NumberTable {
 public:
  explicit NumberTable(std::size_t most) : slots_(std::bit_ceil(std::max<std::size_t>(2 * most, 2)), -1) {}

  /// Returns the first number with this hash for which is_equal(number) is true, or adds `number` and returns it.
  template <class IsEqual>
  int find_or_add(std::uint64_t hash, int number, const IsEqual& is_equal) {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t i = hash & mask;; i = (i + 1) & mask) {
      if (slots_[i] < 0) slots_[i] = number;
      if (slots_[i] == number || is_equal(slots_[i])) return slots_[i];
    }
  }

 private:
  std::vector<int> slots_;
};

/// Mixes the bits of a word into a hash (the finaliser of SplitMix64: Steele, Lea, Flood 2014).
std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) + 0x9e3779b97f4a7c15U;
  hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9U;
  hash = (hash ^ (hash >> 27U)) * 0x94d049bb133111ebU;
  return hash ^ (hash >> 31U);
}

/// Returns for each point the number of the first point at the same place. No coordinate is -0.
std::vector<int> first_at_same_place(const std::vector<dvec3>& points) {
  NumberTable table(points.size());
  std::vector<int> first(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const dvec3& p = points[i];
    std::uint64_t hash = 0;
    for (int axis = 0; axis < 3; ++axis) hash = mixed(hash, std::bit_cast<std::uint64_t>(p[axis]));
    first[i] = table.find_or_add(hash, static_cast<int>(i), [&](int other) { return points[at(other)] == p; });
  }
  return first;
}

/// Multiplies the points by the scale. -0 becomes 0. Throws Error naming the first point that is too far away.
void scale_points(std::vector<dvec3>& points, const dvec3& scale) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    points[i] = points[i] * scale + 0.0;
    if (!is_finite(points[i])) throw Error(fmt::format("vertex {}: overflows when scaled", i));
    const dvec3 size = glm::abs(points[i]);
    if (const double farthest = std::max({size.x, size.y, size.z}); farthest > kFarthest)
      throw Error(fmt::format("vertex {}: a coordinate of {:.3g} m, at most {:g} m: is the scale wrong?", i, farthest,
                              kFarthest));
  }
}

/// Returns true if the area of a triangle is so small that rounding of its edges alone can have made it.
bool has_no_area(const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 ab = b - a, ac = c - a, bc = c - b;
  const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
  return !(glm::length(glm::cross(ab, ac)) > 8 * std::numeric_limits<double>::epsilon() * longest);
}

/// Returns the triangle rotated so that its lowest corner is first: equal for equal winding only.
ivec3 rotated(const ivec3& f) {
  if (f.x < f.y && f.x < f.z) return f;
  if (f.y < f.z) return {f.y, f.z, f.x};
  return {f.z, f.x, f.y};
}

/// Number of dropped triangles, and the first of them.
struct Dropped {
  int count = 0, first = -1;
  void add(int face) {
    if (count++ == 0) first = face;
  }
  void note(const char* what, std::vector<std::string>& notes) const {
    if (count > 0) notes.push_back(fmt::format("dropped {} {} (first: triangle {})", count, what, first));
  }
};

std::vector<ivec3> sound_faces(const PolygonSoup& soup, const std::vector<dvec3>& points, const std::vector<int>& same,
                               bool flip, std::vector<std::string>& notes, std::vector<int>* face_of,
                               std::vector<ivec3>& flat_faces) {
  Dropped flat, repeated;
  NumberTable seen(soup.triangles.size());
  std::vector<ivec3> faces;
  faces.reserve(soup.triangles.size());
  if (face_of != nullptr) face_of->reserve(soup.triangles.size());
  const auto is_repeated = [&](const ivec3& face) {
    const ivec3 key = rotated(face);
    std::uint64_t hash = 0;
    for (int c = 0; c < 3; ++c) hash = mixed(hash, static_cast<std::uint64_t>(key[c]));
    const int number = static_cast<int>(faces.size());
    return seen.find_or_add(hash, number, [&](int other) { return rotated(faces[at(other)]) == key; }) != number;
  };
  for (int f = 0; f < static_cast<int>(soup.triangles.size()); ++f) {
    const ivec3& t = soup.triangles[at(f)];
    ivec3 face(same[at(t.x)], same[at(t.y)], same[at(t.z)]);
    if (flip) std::swap(face.y, face.z);
    if (has_no_area(points[at(face.x)], points[at(face.y)], points[at(face.z)])) {
      flat.add(f);
      if (face.x != face.y && face.y != face.z && face.z != face.x) flat_faces.push_back(face);
    } else if (is_repeated(face)) {
      repeated.add(f);
    } else {
      faces.push_back(face);
      if (face_of != nullptr) face_of->push_back(f);
    }
  }
  flat.note("triangles without area", notes);
  repeated.note("repeated triangles", notes);
  return faces;
}

}  // namespace

TriMesh weld(PolygonSoup soup, const dvec3& scale, std::vector<std::string>& notes, std::vector<int>* face_of) {
  check_soup(soup, scale);
  std::vector<dvec3>& points = soup.vertices;  // scaled in place: a copy of a large file's points takes much memory
  scale_points(points, scale);
  std::vector<int> same = first_at_same_place(points);
  int welded = 0;
  for (std::size_t i = 0; i < same.size(); ++i) welded += at(same[i]) != i ? 1 : 0;
  if (welded > 0) notes.push_back(fmt::format("welded {} duplicate vertices", welded));
  if (soup.fanned > 0) notes.push_back(fmt::format("cut {} polygons into triangles", soup.fanned));
  if (soup.skipped > 0) notes.push_back(fmt::format("dropped {} polygons of fewer than three corners", soup.skipped));
  std::vector<ivec3> flat_faces;
  std::vector<ivec3> faces =
      sound_faces(soup, points, same, scale.x * scale.y * scale.z < 0, notes, face_of, flat_faces);
  if (faces.empty()) throw Error("has no triangles");
  faces.shrink_to_fit();
  soup.triangles = {};

  std::vector<int> used(points.size(), -1);
  for (const ivec3& f : faces) used[at(f.x)] = used[at(f.y)] = used[at(f.z)] = 0;
  std::vector<dvec3> vertices;
  int unused = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (used[i] < 0) {
      unused += at(same[i]) == i ? 1 : 0;
      continue;
    }
    used[i] = static_cast<int>(vertices.size());
    vertices.push_back(points[i]);
  }
  if (unused > 0) notes.push_back(fmt::format("dropped {} vertices that no triangle uses", unused));
  for (ivec3& f : faces) f = {used[at(f.x)], used[at(f.y)], used[at(f.z)]};
  // A flat face with a vertex that no other face uses joins no faces.
  std::erase_if(flat_faces,
                [&](const ivec3& f) { return used[at(f.x)] < 0 || used[at(f.y)] < 0 || used[at(f.z)] < 0; });
  for (ivec3& f : flat_faces) f = {used[at(f.x)], used[at(f.y)], used[at(f.z)]};
  points = {};  // memory for the edges
  same = {};
  used = {};
  return {std::move(vertices), std::move(faces), std::move(flat_faces)};
}

}  // namespace taxel
