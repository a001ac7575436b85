// Polygons cut into triangles, and triangles welded into a mesh.

#include "core/mesh/formats/polygon_soup.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/base/math.h"

namespace taxel {
namespace {

constexpr std::size_t kMaxFan = 64;
constexpr std::size_t kMostEars = 4000;  // corners of a polygon that is cut ear by ear
constexpr double kFlat = 1e-10;          // sine of an angle that counts as 0 or 180 degrees

void add_halves(std::span<const int> corners, std::vector<ivec3>& triangles) {
  if (corners.size() < 3) return;
  const std::size_t middle = corners.size() / 2;
  add_halves(corners.subspan(0, middle + 1), triangles);
  triangles.emplace_back(corners.front(), corners[middle], corners.back());
  add_halves(corners.subspan(middle), triangles);
}

void add_fan(std::span<const int> corners, std::vector<ivec3>& triangles) {
  if (corners.size() > kMaxFan) return add_halves(corners, triangles);
  for (std::size_t i = 2; i < corners.size(); ++i) triangles.emplace_back(corners[0], corners[i - 1], corners[i]);
}

/// A polygon seen along its normal.
class FlatPolygon {
 public:
  FlatPolygon(std::span<const dvec3> vertices, std::span<const int> corners)
      : corners_(corners.begin(), corners.end()) {
    dvec3 normal(0);  // Newell's: twice the area along the normal, also of a polygon that is not quite flat
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const dvec3 a = vertices[static_cast<std::size_t>(corners[i])] - vertices[static_cast<std::size_t>(corners[0])];
      const dvec3 b = vertices[static_cast<std::size_t>(corners[(i + 1) % corners.size()])] -
                      vertices[static_cast<std::size_t>(corners[0])];
      normal += glm::cross(a, b);
    }
    const double length = glm::length(normal);
    if (!(length > 0)) return;
    const dvec3 u = any_perpendicular(normal / length), v = glm::cross(normal / length, u);
    for (const int corner : corners) {
      const dvec3 x = vertices[static_cast<std::size_t>(corner)] - vertices[static_cast<std::size_t>(corners[0])];
      x_.emplace_back(glm::dot(u, x), glm::dot(v, x));
    }
  }

  [[nodiscard]] bool has_area() const { return !x_.empty(); }
  /// Returns true if every corner is convex and none is flat.
  [[nodiscard]] bool is_convex() const {
    for (std::size_t i = 0; i < x_.size(); ++i)
      if (!(turn(i, (i + 1) % x_.size(), (i + 2) % x_.size()) > 0)) return false;
    return true;
  }

  /// Adds all triangles, and those of the rest as a fan if there is no ear left.
  void cut_ears(std::vector<ivec3>& triangles) {
    std::size_t misses = 0, at = 0;
    while (corners_.size() > 3 && misses < corners_.size()) {
      const std::size_t n = corners_.size(), before = (at + n - 1) % n, after = (at + 1) % n;
      if (!is_ear(before, at, after)) {
        ++misses;
        at = after;
        continue;
      }
      triangles.emplace_back(corners_[before], corners_[at], corners_[after]);
      corners_.erase(corners_.begin() + static_cast<std::ptrdiff_t>(at));
      x_.erase(x_.begin() + static_cast<std::ptrdiff_t>(at));
      misses = 0;
      at = at == 0 ? corners_.size() - 1 : at - 1;  // only the angles at the two neighbours have changed
    }
    add_fan(corners_, triangles);
  }

 private:
  /// Twice the area of a triangle: positive if it is counterclockwise, 0 if it is flat.
  [[nodiscard]] double turn(std::size_t i, std::size_t j, std::size_t k) const {
    const dvec2 a = x_[j] - x_[i], b = x_[k] - x_[j];
    const double twice = a.x * b.y - a.y * b.x;
    return std::abs(twice) <= kFlat * glm::length(a) * glm::length(b) ? 0 : twice;
  }

  /// Returns true if the corner j is convex and no other corner is in its triangle or on it.
  [[nodiscard]] bool is_ear(std::size_t i, std::size_t j, std::size_t k) const {
    if (!(turn(i, j, k) > 0)) return false;
    for (std::size_t other = 0; other < x_.size(); ++other) {
      if (other == i || other == j || other == k || x_[other] == x_[i] || x_[other] == x_[k]) continue;
      if (turn(i, j, other) >= 0 && turn(j, k, other) >= 0 && turn(k, i, other) >= 0) return false;
    }
    return true;
  }

  std::vector<int> corners_;
  std::vector<dvec2> x_;
};

}  // namespace

void add_polygon_triangles(std::span<const dvec3> vertices, std::span<const int> corners,
                           std::vector<ivec3>& triangles) {
  const auto count = static_cast<int>(vertices.size());
  const bool are_listed = std::all_of(corners.begin(), corners.end(), [&](int corner) { return corner < count; });
  if (are_listed && corners.size() > 3 && corners.size() <= kMostEars) {
    FlatPolygon polygon(vertices, corners);
    if (polygon.has_area() && !polygon.is_convex()) return polygon.cut_ears(triangles);
  }
  add_fan(corners, triangles);
}

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
