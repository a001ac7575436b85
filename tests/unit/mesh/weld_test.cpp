// Welding against an oracle that compares all pairs of points and all pairs of faces.
#include "core/mesh/formats/polygon_soup.h"

#include <gtest/gtest.h>

#include <bit>

#include "core/base/math.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

/// The vertices and faces that weld() should return, found by comparing each with each.
struct Welded {
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  std::vector<int> face_of;
};

ivec3 turned(const ivec3& f, int turns) {
  return {f[turns % 3], f[(turns + 1) % 3], f[(turns + 2) % 3]};
}

/// The faces of the soups here either have an area or have two corners at one place.
Welded weld_by_pairs(const PolygonSoup& soup) {
  const auto first = [&](int v) {
    int i = 0;
    while (soup.vertices[at(i)] != soup.vertices[at(v)]) ++i;  // -0 equals 0
    return i;
  };
  Welded welded;
  std::vector<ivec3> kept;
  for (int f = 0; f < static_cast<int>(soup.triangles.size()); ++f) {
    const ivec3& t = soup.triangles[at(f)];
    const ivec3 face(first(t.x), first(t.y), first(t.z));
    if (face.x == face.y || face.y == face.z || face.z == face.x) continue;
    const auto is_same = [&](const ivec3& other) {
      return other == face || turned(other, 1) == face || turned(other, 2) == face;
    };
    if (std::any_of(kept.begin(), kept.end(), is_same)) continue;
    kept.push_back(face);
    welded.face_of.push_back(f);
  }
  std::vector<int> number(soup.vertices.size(), -1);
  for (int v = 0; v < static_cast<int>(soup.vertices.size()); ++v) {
    const auto uses = [&](const ivec3& f) { return f.x == v || f.y == v || f.z == v; };
    if (std::none_of(kept.begin(), kept.end(), uses)) continue;
    number[at(v)] = static_cast<int>(welded.vertices.size());
    welded.vertices.push_back(soup.vertices[at(v)]);
  }
  for (const ivec3& f : kept) welded.faces.emplace_back(number[at(f.x)], number[at(f.y)], number[at(f.z)]);
  return welded;
}

void expect_as_by_pairs(const PolygonSoup& soup) {
  const Welded expected = weld_by_pairs(soup);
  std::vector<std::string> notes;
  std::vector<int> face_of;
  const TriMesh mesh = weld(soup, dvec3(1), notes, &face_of);
  EXPECT_EQ(mesh.vertices(), expected.vertices);
  EXPECT_EQ(mesh.faces(), expected.faces);
  EXPECT_EQ(face_of, expected.face_of);
  for (const dvec3& v : mesh.vertices()) EXPECT_FALSE(std::signbit(v.x) && v.x == 0) << "-0 becomes 0";
}

/// Triangles over points of a small grid: most points are at places of other points, and zeros have either sign.
PolygonSoup grid_soup(std::uint64_t seed, int triangles, int side, double step) {
  test::RandomStream random(seed);
  PolygonSoup soup;
  while (static_cast<int>(soup.triangles.size()) < triangles) {
    std::array<dvec3, 3> corners;
    for (dvec3& p : corners) {
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = step * random.below(side);
        if (p[axis] == 0 && random.below(2) == 0) p[axis] = -0.0;
      }
    }
    const bool twice = corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0];
    const double area = glm::length(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
    if (!twice && area < 1e-3 * step * step) continue;  // three places on a line
    const int n = static_cast<int>(soup.vertices.size());
    soup.vertices.insert(soup.vertices.end(), corners.begin(), corners.end());
    soup.triangles.push_back(turned({n, n + 1, n + 2}, random.below(3)));
  }
  return soup;
}

TEST(Weld, EqualsAComparisonOfAllPairs) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    // 3^3 places have many repeated faces, 9^3 have few.
    expect_as_by_pairs(grid_soup(seed, 150, 3, 0.25));
    expect_as_by_pairs(grid_soup(seed, 150, 9, 1e-3));
  }
}

TEST(Weld, KeepsPlacesApartThatDifferInTheLastBit) {
  PolygonSoup soup;
  double x = 1;
  for (int i = 0; i < 200; ++i) {  // numbers that differ in their lowest bits alone
    soup.vertices.insert(soup.vertices.end(), {{x, 0, 0}, {x, 1, 0}, {x, 0, 1}});
    soup.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    if (i % 2 == 1) x = std::nextafter(x, 2.0);
  }
  expect_as_by_pairs(soup);
  std::vector<std::string> notes;
  EXPECT_EQ(weld(soup, dvec3(1), notes).face_count(), 100) << "every face is there twice";
}

/// Returns the factor that undoes a multiplication by an odd number, modulo 2^64.
std::uint64_t inverse(std::uint64_t odd) {
  std::uint64_t x = odd;
  for (int i = 0; i < 6; ++i) x *= 2 - odd * x;  // Newton's method: each step doubles the number of right bits
  return x;
}

std::uint64_t undo_shift(std::uint64_t hash, unsigned bits) {
  return hash ^ (hash >> bits) ^ (hash >> (2 * bits));
}

std::uint64_t undo_mixing(std::uint64_t hash) {
  hash = undo_shift(hash, 31) * inverse(0x94d049bb133111ebU);
  hash = undo_shift(hash, 27) * inverse(0xbf58476d1ce4e5b9U);
  return undo_shift(hash, 30) - 0x9e3779b97f4a7c15U;
}

std::uint64_t mix(std::uint64_t hash, double x) {
  hash = (hash ^ std::bit_cast<std::uint64_t>(x)) + 0x9e3779b97f4a7c15U;
  hash = (hash ^ (hash >> 30U)) * 0xbf58476d1ce4e5b9U;
  hash = (hash ^ (hash >> 27U)) * 0x94d049bb133111ebU;
  return hash ^ (hash >> 31U);
}

TEST(Weld, KeepsPointsOfEqualHashesApart) {
  test::RandomStream random(5);
  std::vector<dvec3> places;
  while (places.size() < 300) {  // z is chosen such that all three numbers give the hash 0
    const double x = random.uniform(1, 2), y = random.uniform(1, 2);
    const std::uint64_t before = mix(mix(0, x), y);
    const double z = std::bit_cast<double>(undo_mixing(0) ^ before);
    if (std::isfinite(z) && std::abs(z) < 1e3) places.emplace_back(x, y, z);
    if (std::isfinite(z)) {
      ASSERT_EQ(mix(before, z), 0U);
    }
  }
  PolygonSoup soup;
  for (int i = 0; i < 900; ++i) {
    ivec3 corners;
    do {
      for (int c = 0; c < 3; ++c) corners[c] = random.below(300);
    } while (corners.x == corners.y || corners.y == corners.z || corners.z == corners.x);
    for (int c = 0; c < 3; ++c) soup.vertices.push_back(places[at(corners[c])]);
    soup.triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  }
  expect_as_by_pairs(soup);
}

TEST(Weld, IsFastForPointsThatAreAllTheSame) {
  PolygonSoup soup;
  const int n = 300000;
  soup.vertices.assign(at(n), dvec3(0.5));
  soup.vertices.insert(soup.vertices.end(), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  for (int i = 0; i < n; ++i) soup.triangles.emplace_back(n, n + 1, n + 2);
  soup.triangles.emplace_back(0, n + 1, n + 2);
  std::vector<std::string> notes;
  const TriMesh mesh = weld(soup, dvec3(1), notes);
  EXPECT_EQ(mesh.face_count(), 2);
  EXPECT_EQ(mesh.vertex_count(), 4);
}

}  // namespace
}  // namespace taxel
