// Geodesic distances compared with exhaustive search, closed forms and the properties of any distance.
#include <gtest/gtest.h>

#include <complex>

#include "core/mesh/geodesic.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/counted_new.h"
#include "unit/mesh/geodesic_oracle.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

using test::OnSurface;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::shared_ptr<const UnfoldedMesh> unfolded(const TriMesh& mesh) {
  return std::make_shared<UnfoldedMesh>(std::make_shared<TriMesh>(mesh));
}

/// Returns a random point inside a face, on one of its edges, or at a corner.
OnSurface random_point(const TriMesh& mesh, test::RandomStream& random) {
  dvec3 w(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
  const int kind = random.below(4), corner = random.below(3);
  if (kind == 0) w[corner] = 0.0;
  if (kind == 1) w = dvec3(0.0), w[corner] = 1.0;
  return {random.below(mesh.face_count()), w / (w.x + w.y + w.z)};
}
OnSurface inner_point(const TriMesh& mesh, test::RandomStream& random) {
  const dvec3 w(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
  return {random.below(mesh.face_count()), w / (w.x + w.y + w.z)};
}

double distance(GeodesicDistance& geodesic, const TriMesh& mesh, const OnSurface& a, const OnSurface& b) {
  geodesic.propagate(a.face, a.position(mesh), kInfinity);
  return geodesic.to(b.face, b.position(mesh));
}

/// Returns a sheet of n x n squares over [0, 1]^2 with random inner vertices and heights: an open boundary and many
/// saddle points.
TriMesh random_sheet(int n, double height, std::uint64_t seed) {
  test::RandomStream random(seed);
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i <= n; ++i) {
      const bool inside = i > 0 && j > 0 && i < n && j < n;
      const double shift = inside ? 0.3 : 0.0;
      vertices.emplace_back((i + shift * random.uniform(-1, 1)) / n, (j + shift * random.uniform(-1, 1)) / n,
                            height * random.uniform(-1, 1) / n);
    }
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * (n + 1) + i, b = a + 1, c = a + n + 2, d = a + n + 1;
      if (random.below(2) == 0)
        faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
      else
        faces.insert(faces.end(), {{a, b, d}, {b, c, d}});
    }
  return {std::move(vertices), std::move(faces)};
}

TriMesh scaled(const TriMesh& mesh, const dvec3& by) {
  std::vector<dvec3> vertices = mesh.vertices();
  for (dvec3& v : vertices) v *= by;
  return {std::move(vertices), mesh.faces()};
}

TriMesh without_faces(const TriMesh& mesh, const std::vector<int>& dropped) {
  std::vector<ivec3> faces;
  for (int f = 0; f < mesh.face_count(); ++f)
    if (std::find(dropped.begin(), dropped.end(), f) == dropped.end())
      faces.push_back(mesh.faces()[static_cast<std::size_t>(f)]);
  return {mesh.vertices(), std::move(faces)};
}

void expect_equals_exhaustion(const TriMesh& mesh, double longest, int sources, std::uint64_t seed) {
  test::RandomStream random(seed);
  test::GeodesicOracle oracle(mesh, longest);
  GeodesicDistance geodesic(unfolded(mesh));
  int reached = 0;
  for (int i = 0; i < sources; ++i) {
    const OnSurface from = random_point(mesh, random);
    std::vector<OnSurface> targets;
    for (int t = 0; t < 12; ++t) targets.push_back(random_point(mesh, random));
    const auto expected = oracle.distances(from, targets);
    geodesic.propagate(from.face, from.position(mesh), longest);
    for (std::size_t t = 0; t < targets.size(); ++t) {
      const double d = geodesic.to(targets[t].face, targets[t].position(mesh));
      const auto exact = static_cast<double>(expected[t]);
      if (exact > longest * (1 - 1e-12)) {
        EXPECT_TRUE(d == kInfinity || d > longest * (1 - 1e-9)) << d << " for " << exact;
      } else {
        EXPECT_NEAR(d, exact, 1e-11 * exact + 1e-15) << "source " << i << " target " << t;
        ++reached;
      }
    }
  }
  EXPECT_GT(reached, 2 * sources);
}

TEST(Geodesic, EqualsExhaustiveUnfoldingOnClosedMeshes) {
  expect_equals_exhaustion(test::bumpy_sphere(1), 4.0, 30, 1);
  expect_equals_exhaustion(make_icosphere(1.0, 1), 4.0, 20, 2);
  expect_equals_exhaustion(make_box(dvec3(1.0, 0.6, 0.02)), 3.0, 40, 3);
  expect_equals_exhaustion(test::bumpy_sphere(2), 0.9, 12, 4);
}

TEST(Geodesic, EqualsExhaustiveUnfoldingOnSheetsWithSaddles) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) expect_equals_exhaustion(random_sheet(4, 0.9, seed), 2.0, 10, seed);
  for (std::uint64_t seed = 0; seed < 4; ++seed) expect_equals_exhaustion(random_sheet(4, 0.0, seed), 2.0, 10, seed);
  expect_equals_exhaustion(without_faces(random_sheet(5, 0.7, 9), {12, 13, 26, 27, 8}), 1.6, 20, 10);
}

TEST(Geodesic, EqualsExhaustiveUnfoldingOnNeedles) {
  expect_equals_exhaustion(scaled(random_sheet(4, 0.9, 3), dvec3(1, 0.01, 1)), 1.2, 10, 5);
  expect_equals_exhaustion(scaled(test::bumpy_sphere(1), dvec3(1, 1, 0.003)), 2.5, 10, 6);
}

// Dudeney 1903: in a room of 30 x 12 x 12, the path from below the ceiling to above the floor has the length 40.
TEST(Geodesic, SolvesTheProblemOfTheSpiderAndTheFly) {
  const TriMesh room = make_box(dvec3(15, 6, 6));
  GeodesicDistance geodesic(unfolded(room));
  int pairs = 0;
  for (int f = 0; f < 12; ++f)
    for (int g = 0; g < 12; ++g) {
      const dvec3 spider(-15, 0, 5), fly(15, 0, -5);
      const dvec3 &nf = room.face_normals()[static_cast<std::size_t>(f)],
                  &ng = room.face_normals()[static_cast<std::size_t>(g)];
      if (nf.x > -0.5 || ng.x < 0.5) continue;
      const auto holds = [&](int face, const dvec3& p) {
        const dvec3 &a = room.vertex(face, 0), &b = room.vertex(face, 1), &c = room.vertex(face, 2);
        const dvec3& n = room.face_normals()[static_cast<std::size_t>(face)];
        return glm::dot(glm::cross(b - a, p - a), n) >= 0 && glm::dot(glm::cross(c - b, p - b), n) >= 0 &&
               glm::dot(glm::cross(a - c, p - c), n) >= 0;
      };
      if (!holds(f, spider) || !holds(g, fly)) continue;
      geodesic.propagate(f, spider, kInfinity);
      EXPECT_NEAR(geodesic.to(g, fly), 40.0, 1e-12);
      ++pairs;
    }
  EXPECT_GE(pairs, 1);
}

/// A prism of n sides and some rows without caps. Its distances are those of the unrolled strip.
TEST(Geodesic, EqualsTheUnrolledStripOnAPrism) {
  const int n = 23, rows = 7;
  std::vector<dvec3> vertices;
  std::vector<ivec3> faces;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i < n; ++i) vertices.emplace_back(std::cos(2 * kPi * i / n), std::sin(2 * kPi * i / n), 0.31 * j);
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < n; ++i) {
      const int a = j * n + i, b = j * n + (i + 1) % n;
      faces.insert(faces.end(), {{a, b, b + n}, {a, b + n, a + n}});
    }
  const TriMesh prism(vertices, faces);
  const double side = 2 * std::sin(kPi / n);
  const auto unrolled = [&](const OnSurface& p) {
    dvec2 at(0);
    const int column = p.face / 2 % n;
    for (int c = 0; c < 3; ++c) {
      int i = prism.faces()[static_cast<std::size_t>(p.face)][c] % n;
      if (column == n - 1 && i == 0) i = n;
      at += p.weights[c] * dvec2(side * i, prism.vertex(p.face, c).z);
    }
    return at;
  };
  GeodesicDistance geodesic(unfolded(prism));
  test::RandomStream random(3);
  for (int k = 0; k < 200; ++k) {
    const OnSurface a = random_point(prism, random), b = random_point(prism, random);
    const dvec2 d = glm::abs(unrolled(a) - unrolled(b));
    const double exact = glm::length(dvec2(std::min(d.x, n * side - d.x), d.y));
    EXPECT_NEAR(distance(geodesic, prism, a, b), exact, 1e-12);
  }
}

TEST(Geodesic, IsEuclideanOnAFlatSheet) {
  const TriMesh sheet = random_sheet(9, 0.0, 4);
  GeodesicDistance geodesic(unfolded(sheet));
  test::RandomStream random(5);
  for (int k = 0; k < 300; ++k) {
    const OnSurface a = random_point(sheet, random), b = random_point(sheet, random);
    EXPECT_NEAR(distance(geodesic, sheet, a, b), glm::distance(a.position(sheet), b.position(sheet)), 1e-13);
  }
}

/// Fan of n edges of length 1 around an apex, with the total angle `turn`, open or as a ring. Beyond a full turn the
/// edges rise and fall by `rise`. Paths follow the law of cosines, or lead over the apex if the angle is half a turn or
/// more.
void expect_law_of_cosines(const TriMesh& fan, double step, double turn, bool ring, int least_bent) {
  GeodesicDistance geodesic(unfolded(fan));
  test::RandomStream random(8);
  int bent = 0;
  for (int k = 0; k < 300; ++k) {
    OnSurface points[2];
    double r[2], angle[2];
    for (int i = 0; i < 2; ++i) {
      points[i] = inner_point(fan, random);
      points[i].weights = dvec3(0.7, 0, 0) + 0.3 * points[i].weights;  // no path leaves the fan at its rim
      const std::complex<double> z = points[i].weights.y + points[i].weights.z * std::polar(1.0, step);
      r[i] = std::abs(z), angle[i] = std::arg(z) + step * points[i].face;
    }
    double between = std::abs(angle[0] - angle[1]);
    if (ring) between = std::min(between, turn - between);
    bent += between >= kPi;
    const double exact =
        between >= kPi ? r[0] + r[1] : std::sqrt(r[0] * r[0] + r[1] * r[1] - 2 * r[0] * r[1] * std::cos(between));
    EXPECT_NEAR(distance(geodesic, fan, points[0], points[1]), exact, 1e-13);
  }
  EXPECT_GE(bent, least_bent);
}

TEST(Geodesic, FollowsTheLawOfCosinesOnCones) {
  for (const double turn : {1.5, 3.0, 4.5, 6.0}) {
    const int n = 13;
    const double step = turn / n, radius = std::sin(step / 2) / std::sin(kPi / n),
                 height = std::sqrt(1 - radius * radius);
    std::vector<dvec3> vertices = {dvec3(0)};
    std::vector<ivec3> faces;
    for (int i = 0; i < n; ++i) {
      vertices.emplace_back(radius * std::cos(2 * kPi * i / n), radius * std::sin(2 * kPi * i / n), height);
      faces.emplace_back(0, i + 1, (i + 1) % n + 1);
    }
    expect_law_of_cosines(TriMesh(vertices, faces), step, turn, true, 0);
  }
}

// A disc without a wedge, whose tip is on the boundary.
TEST(Geodesic, BendsPathsAtBoundaryVertices) {
  const int n = 13;
  const double step = 5.0 / n;
  std::vector<dvec3> vertices = {dvec3(0)};
  std::vector<ivec3> faces;
  for (int i = 0; i <= n; ++i) vertices.emplace_back(std::cos(step * i), std::sin(step * i), 0);
  for (int i = 0; i < n; ++i) faces.emplace_back(0, i + 1, i + 2);
  expect_law_of_cosines(TriMesh(vertices, faces), step, 5.0, false, 30);
}

TEST(Geodesic, BendsPathsAtSaddlePoints) {
  const int n = 12;
  std::vector<dvec3> vertices = {dvec3(0)};
  std::vector<ivec3> faces;
  for (int i = 0; i < n; ++i) {
    const double rise = i % 2 == 0 ? 0.7 : -0.7, flat = std::sqrt(1 - rise * rise);
    vertices.emplace_back(flat * std::cos(2 * kPi * i / n), flat * std::sin(2 * kPi * i / n), rise);
    faces.emplace_back(0, i + 1, (i + 1) % n + 1);
  }
  const double step = 2 * std::asin(glm::distance(vertices[1], vertices[2]) / 2);
  ASSERT_GT(n * step, 8.0);
  expect_law_of_cosines(TriMesh(vertices, faces), step, n * step, true, 30);
}

TEST(Geodesic, SatisfiesTheAxiomsOfADistance) {
  for (const TriMesh& mesh : {test::bumpy_sphere(3), make_fingertip(), random_sheet(12, 1.0, 1)}) {
    GeodesicDistance geodesic(unfolded(mesh));
    test::RandomStream random(11);
    for (int k = 0; k < 25; ++k) {
      const OnSurface a = random_point(mesh, random), b = random_point(mesh, random), c = random_point(mesh, random);
      const double ab = distance(geodesic, mesh, a, b), bc = distance(geodesic, mesh, b, c),
                   ac = distance(geodesic, mesh, a, c);
      EXPECT_NEAR(ab, distance(geodesic, mesh, b, a), 1e-12 * ab) << "symmetric";
      EXPECT_LE(ac, (ab + bc) * (1 + 1e-12)) << "triangle inequality";
      EXPECT_GE(ab, glm::distance(a.position(mesh), b.position(mesh)) * (1 - 1e-12)) << "no shorter than straight";
      EXPECT_NEAR(distance(geodesic, mesh, a, a), 0.0, 1e-15);
    }
  }
}

TEST(Geodesic, IsOnlyTruncatedByTheRadius) {
  const TriMesh mesh = test::bumpy_sphere(3);
  GeodesicDistance everywhere(unfolded(mesh)), bounded(unfolded(mesh));
  test::RandomStream random(12);
  int within = 0;
  for (int k = 0; k < 20; ++k) {
    const OnSurface from = random_point(mesh, random);
    const double radius = random.uniform(0.05, 1.0);
    everywhere.propagate(from.face, from.position(mesh), kInfinity);
    bounded.propagate(from.face, from.position(mesh), radius);
    EXPECT_LT(bounded.window_count(), everywhere.window_count());
    for (int t = 0; t < 200; ++t) {
      const OnSurface target = random_point(mesh, random);
      const double d = everywhere.to(target.face, target.position(mesh));
      const double found = bounded.to(target.face, target.position(mesh));
      if (d > radius) {
        EXPECT_EQ(found, kInfinity);
      } else {
        EXPECT_NEAR(found, d, 1e-13);
        const std::vector<int>& reached = bounded.reached_faces();
        EXPECT_EQ(std::count(reached.begin(), reached.end(), target.face), 1);
        ++within;
      }
    }
  }
  EXPECT_GT(within, 200);
}

TEST(Geodesic, DoesNotDependOnTheUnitOfLength) {
  const TriMesh mesh = test::bumpy_sphere(2), tiny = scaled(mesh, dvec3(0x1p-40));
  GeodesicDistance geodesic(unfolded(mesh)), of_tiny(unfolded(tiny));
  test::RandomStream random(13);
  for (int k = 0; k < 50; ++k) {
    const OnSurface a = random_point(mesh, random), b = random_point(mesh, random);
    EXPECT_EQ(distance(geodesic, mesh, a, b) * 0x1p-40, distance(of_tiny, tiny, a, b));
  }
}

/// A source at most a millionth of an edge away from a vertex or an edge reaches all points around it.
TEST(Geodesic, ReachesAllPointsFromSourcesNearVerticesAndEdges) {
  const TriMesh mesh = test::bumpy_sphere(1);
  GeodesicDistance geodesic(unfolded(mesh));
  test::RandomStream random(14);
  for (const double off : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 1e-17, 1e-30, 0.0}) {
    for (int k = 0; k < 30; ++k) {
      OnSurface at = inner_point(mesh, random), beside = at;
      const int corner = random.below(3);
      if (k % 2 == 0) {
        at.weights = dvec3(0.0), at.weights[corner] = 1.0;
      } else {
        at.weights[corner] = 0.0, at.weights /= at.weights.x + at.weights.y + at.weights.z;
      }
      beside.weights = (1 - off) * at.weights + off * beside.weights;
      const OnSurface target = inner_point(mesh, random);
      EXPECT_NEAR(distance(geodesic, mesh, beside, target), distance(geodesic, mesh, at, target), off + 1e-14) << off;
    }
  }
}

TEST(GeodesicMap, KeepsEveryBitOfAPropagation) {
  const TriMesh mesh = random_sheet(12, 0.8, 5);
  const auto prepared = unfolded(mesh);
  GeodesicDistance geodesic(prepared);
  test::RandomStream random(9);
  for (const double radius : {0.2, 0.5, kInfinity}) {
    const OnSurface source = random_point(mesh, random), elsewhere = random_point(mesh, random);
    geodesic.propagate(source.face, source.position(mesh), radius);
    const GeodesicMap map(prepared, geodesic, source.position(mesh));
    std::vector<std::pair<OnSurface, double>> expected;
    int reached = 0;
    for (int i = 0; i < 400; ++i) {
      const OnSurface target =
          i < 5 ? OnSurface{source.face, inner_point(mesh, random).weights} : random_point(mesh, random);
      expected.emplace_back(target, geodesic.to(target.face, target.position(mesh)));
      reached += expected.back().second < kInfinity ? 1 : 0;
    }
    geodesic.propagate(elsewhere.face, elsewhere.position(mesh), radius);  // the map is a copy and does not change
    for (const auto& [target, d] : expected) EXPECT_EQ(map.to(target.face, target.position(mesh)), d);
    EXPECT_GT(reached, 10);
  }
}

TEST(Geodesic, KeepsItsMemory) {
  const TriMesh mesh = test::bumpy_sphere(3);
  GeodesicDistance geodesic(unfolded(mesh));
  const auto pass = [&] {
    double sum = 0.0;
    for (int f = 0; f < mesh.face_count(); f += 40) {
      geodesic.propagate(f, mesh.vertex(f, 0), 0.4);
      for (const int g : geodesic.reached_faces()) sum += std::min(1.0, geodesic.to(g, mesh.vertex(g, 1)));
    }
    return sum;
  };
  const double first = pass();
  const long before = allocation_count();
  const double second = pass();
  EXPECT_EQ(allocation_count(), before);
  EXPECT_EQ(second, first);
}

TEST(Geodesic, DoesNotReachSeparateParts) {
  const TriMesh two = test::together(make_icosphere(1.0, 1), test::moved(make_icosphere(1.0, 1), dvec3(2.5, 0, 0)));
  GeodesicDistance geodesic(unfolded(two));
  geodesic.propagate(0, two.vertex(0, 0), kInfinity);
  EXPECT_LT(geodesic.to(79, two.vertex(79, 1)), 4.0);
  EXPECT_EQ(geodesic.to(80, two.vertex(80, 0)), kInfinity);
}

}  // namespace
}  // namespace taxel
