// Caps: the stiffness at the skin is E/H, nothing else of the pad changes, and the report describes how a press is
// felt.
#include "core/base/math.h"
#include "core/hydro/pad/pad_field.h"

#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/fields/tet_geometry.h"
#include "fixtures/field_checks.h"
#include "fixtures/pad_meshes.h"
#include "fixtures/rough_meshes.h"

namespace taxel {
namespace {

constexpr double kModulus = 1e5;

/// Returns a pad without caps.
PadTets plain_pad(const MeshIndex& index, double thickness) {
  const PadShape shape(index, thickness);
  const PadDepths depths = pad_depths(index.mesh(), shape, thickness);
  const PadLayers layers(shape, index, diverging_offsets(depths, thickness));
  PadTets pad{index.mesh().vertices(), layers.tets(), pad_pressures(index, shape, layers, depths, kModulus, thickness)};
  for (int offset = 0; offset < shape.offset_count(); ++offset) pad.vertices.push_back(shape.inner_position(offset));
  for (const int offset : layers.offsets()) pad.vertices.push_back(shape.moved(offset, layers.height(offset)));
  return pad;
}

PressureField field_of(const PadTets& pad) {
  FieldReport report;
  report.core = true;
  return {pad.vertices, pad.tets, pad.pressure, report};
}

std::vector<std::pair<TriMeshPtr, double>> uneven_meshes() {
  return {{share(make_rough_ball(1, 0.6, 1)), 0.002},
          {share(make_rough_ball(3, 0.5, 2)), 0.002},
          {share(make_torus(0.02, 0.006, 12, 5)), 0.002},
          {share(make_spool()), 0.003},
          {share(make_cylinder(0.01, 0.02, 0.01)), 0.002}};
}

/// Returns a tet on a face of a large box, with the pressure at its apex multiplied by a factor.
PadTets one_tet(double thickness, double factor) {
  PadTets pad{make_box(dvec3(0.02)).vertices(), {}, std::vector<double>(8, 0.0)};
  const ivec3 face = make_box(dvec3(0.02)).faces()[0];
  const dvec3 a = pad.vertices[at(face.x)], b = pad.vertices[at(face.y)], c = pad.vertices[at(face.z)];
  const dvec3 outward = glm::normalize(glm::cross(b - a, c - a));
  pad.vertices.push_back((a + b + c) / 3.0 - 0.8 * thickness * outward);
  pad.pressure.push_back(0.8 * kModulus * factor);
  pad.tets.emplace_back(face.x, face.z, face.y, 8);
  return pad;
}

TEST(PadTents, SplitATetIntoFourThatAreExactAtTheSkin) {
  constexpr double kThickness = 0.004;
  const MeshIndex index(share(make_box(dvec3(0.02))));
  for (const double factor : {0.4, 0.97, 1.03, 1.7}) {
    PadTets pad = one_tet(kThickness, factor);
    const double volume = field_volume(field_of(pad));
    EXPECT_EQ(split_by_caps(index, pad, kModulus, kThickness), 1);
    const PressureField field = field_of(pad);
    ASSERT_EQ(field.tets().size(), 4U);
    expect_sound(field);
    EXPECT_EQ(field.report().inverted, 0);
    EXPECT_NEAR(field_volume(field), volume, 1e-14 * volume);
    EXPECT_NEAR(field.report().stiffness_mean, kModulus / kThickness, 1e-12 * kModulus / kThickness);
    // The vertex is on the line from the incentre, where the distances to the edges are equal, at 0.35 of the height.
    const dvec3 m = pad.vertices.back(), x = pad.vertices[8];
    const double height = 0.02 - std::max({std::abs(m.x), std::abs(m.y), std::abs(m.z)});
    EXPECT_NEAR(height, 0.35 * 0.8 * kThickness, 1e-15);
    EXPECT_NEAR(pad.pressure.back(), kModulus * 0.35 * 0.8, 1e-9);
    const dvec3 incentre = (m - 0.35 * x) / 0.65;
    const ivec3 face = index.mesh().faces()[0];
    const auto distance_to_edge = [&](int i, int j) {
      const dvec3 &p = pad.vertices[at(face[i])], &q = pad.vertices[at(face[j])];
      return glm::length(glm::cross(incentre - p, glm::normalize(q - p)));
    };
    const double offset = 0.04, radius = offset * (2 - std::sqrt(2.0)) / 2;  // sides of a right isosceles triangle
    EXPECT_NEAR(distance_to_edge(0, 1), radius, 1e-15);
    EXPECT_NEAR(distance_to_edge(1, 2), radius, 1e-15);
    EXPECT_NEAR(distance_to_edge(2, 0), radius, 1e-15);
  }
}

TEST(PadTents, LeaveTetsThatAreExactToTwoPercent) {
  const MeshIndex index(share(make_box(dvec3(0.02))));
  for (const double factor : {0.981, 1.0, 1.019}) {
    PadTets pad = one_tet(0.004, factor);
    const PadTets before = pad;
    EXPECT_EQ(split_by_caps(index, pad, kModulus, 0.004), 0);
    EXPECT_EQ(pad.vertices, before.vertices);
    EXPECT_EQ(pad.pressure, before.pressure);
    EXPECT_EQ(pad.tets, before.tets);
  }
}

/// Uniform pads are unchanged, bit for bit.
TEST(PadTents, LeaveUniformPadsUnchanged) {
  for (const auto& [mesh, thickness] :
       std::vector<std::pair<TriMeshPtr, double>>{{share(make_fingertip()), 0.002},
                                                  {share(make_icosphere(0.02, 1)), 0.004},
                                                  {share(make_box(dvec3(0.02, 0.03, 0.01))), 0.003},
                                                  {share(make_torus(0.02, 0.006, 30, 12)), 0.002},
                                                  {share(make_l_block(0.005, 8)), 0.003},
                                                  {share(make_sharp_plate(0.03, 0.006, 0.004)), 0.002}}) {
    const PadTets plain = plain_pad(MeshIndex(mesh), thickness);
    const PressureFieldPtr field = make_pad_field(mesh, kModulus, thickness);
    EXPECT_EQ(field->report().caps, 0);
    EXPECT_EQ(field->vertices(), plain.vertices);
    EXPECT_EQ(field->vertex_pressure(), plain.pressure);
    ASSERT_EQ(field->tets().size(), plain.tets.size());
    for (std::size_t t = 0; t < plain.tets.size(); ++t) EXPECT_EQ(field->tets()[t].vertices, plain.tets[t]);
  }
}

TEST(PadTents, KeepVolumeAndFacesOfTheBoundary) {
  for (const auto& [mesh, thickness] : uneven_meshes()) {
    const MeshIndex index(mesh);
    PadTets pad = plain_pad(index, thickness);
    const std::size_t vertices = pad.vertices.size(), tets = pad.tets.size();
    const PressureField plain = field_of(pad);
    const int count = split_by_caps(index, pad, kModulus, thickness);
    EXPECT_GT(count, 5);
    EXPECT_EQ(pad.vertices.size(), vertices + at(count));
    EXPECT_EQ(pad.tets.size(), tets + 3 * at(count));
    const PressureField field = field_of(pad);
    expect_sound(field, 1e-12);
    EXPECT_EQ(field.report().inverted, 0);
    EXPECT_EQ(boundary_faces(field), boundary_faces(plain));
    EXPECT_NEAR(field_volume(field), field_volume(plain), 1e-12 * field_volume(plain));
    EXPECT_LT(field.report().stiffness_cv, 0.01);
    EXPECT_GT(field.report().stiffness_min, 0.98 * kModulus / thickness * (1 - 1e-9));
    EXPECT_LT(field.report().stiffness_max, 1.02 * kModulus / thickness * (1 + 1e-9));
  }
}

/// The vertex of a cap is nearer to its own face than to any other part of the skin, within 3 %.
TEST(PadTents, AreNoHigherThanTheDepthOfTheBody) {
  for (const auto& [mesh, thickness] : uneven_meshes()) {
    const MeshIndex index(mesh);
    PadTets pad = plain_pad(index, thickness);
    const std::size_t first = pad.vertices.size();
    split_by_caps(index, pad, kModulus, thickness);
    for (std::size_t v = first; v < pad.vertices.size(); ++v) {
      const double depth = -index.signed_distance(pad.vertices[v]), height = pad.pressure[v] * thickness / kModulus;
      EXPECT_GE(depth, 0.97 * height * (1 - 1e-9));
      EXPECT_LE(height, thickness);
    }
  }
}

/// A cube whose face 0 has lost its tets. The mitres around the face leave 45 degrees, so the cap is r tan(22.5
/// degrees) high.
TEST(PadTents, FillFacesWithoutTetsByTheAngleAround) {
  constexpr double kThickness = 0.012;
  const TriMeshPtr cube = share(make_box(dvec3(0.02)));
  const MeshIndex index(cube);
  PadTets pad = plain_pad(index, kThickness);
  pad.tets.erase(pad.tets.begin(), pad.tets.begin() + 3);
  std::vector<char> bare(12, 0);
  bare[0] = 1;
  const PadTets before = pad;
  EXPECT_EQ(add_own_caps(index, pad, bare, kModulus, kThickness), 1);
  EXPECT_EQ(bare, std::vector<char>(12, 0));
  ASSERT_EQ(pad.tets.size(), before.tets.size() + 1);
  const double radius = 0.04 * (2 - std::sqrt(2.0)) / 2, height = radius * std::tan(kPi / 8);
  const dvec3 m = pad.vertices.back();
  EXPECT_NEAR(0.02 - std::max({std::abs(m.x), std::abs(m.y), std::abs(m.z)}), height, 1e-12);
  EXPECT_NEAR(pad.pressure.back(), kModulus * height / kThickness, 1e-6);
  const PressureField field = field_of(pad);
  expect_sound(field);
  EXPECT_LT(field.report().stiffness_cv, 1e-12);
  const auto corners = [&](const ivec4& t) {
    return std::array<dvec3, 4>{pad.vertices[at(t[0])], pad.vertices[at(t[1])], pad.vertices[at(t[2])],
                                pad.vertices[at(t[3])]};
  };
  for (const ivec4& t : before.tets) EXPECT_FALSE(tets_overlap(corners(pad.tets.back()), corners(t)));
}

TEST(PadTents, FillNoFaceThatTetsCover) {
  const MeshIndex index(share(make_box(dvec3(0.02))));
  PadTets pad = plain_pad(index, 0.004);
  std::vector<char> bare(12, 1);  // wrong, because all faces have tets
  EXPECT_EQ(add_own_caps(index, pad, bare, kModulus, 0.004), 0);
  EXPECT_EQ(bare, std::vector<char>(12, 1));
}

TEST(TetOverlap, IsFalseForTetsThatOnlyTouch) {
  const std::array<dvec3, 4> a{dvec3(0), dvec3(1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1)};
  const auto moved = [&](const dvec3& d) {
    std::array<dvec3, 4> b = a;
    for (dvec3& x : b) x += d;
    return b;
  };
  EXPECT_TRUE(tets_overlap(a, a));
  EXPECT_FALSE(tets_overlap(a, moved({1, 0, 0})));      // touch at a vertex
  EXPECT_FALSE(tets_overlap(a, moved({0.5, 0.5, 0})));  // touch at an edge
  EXPECT_TRUE(tets_overlap(a, moved({0.49, 0.49, 0})));
  EXPECT_FALSE(tets_overlap(a, {dvec3(0), dvec3(0, 1, 0), dvec3(1, 0, 0), dvec3(0, 0, -1)}));  // touch at a face
  // Edges that cross at a distance: no face separates them.
  const std::array<dvec3, 4> low{dvec3(-1, 0, 0), dvec3(1, 0, 0), dvec3(0, -0.2, -1), dvec3(0, 0.2, -1)};
  const auto high = [](double z) {
    return std::array<dvec3, 4>{dvec3(0, -1, z), dvec3(0, 1, z), dvec3(-0.2, 0, 1 + z), dvec3(0.2, 0, 1 + z)};
  };
  EXPECT_FALSE(tets_overlap(low, high(1e-3)));
  EXPECT_TRUE(tets_overlap(low, high(-1e-3)));
}

/// Random tets against random points in them: a point in both tets proves an overlap.
TEST(TetOverlap, AgreesWithRandomPoints) {
  const CounterRng rng(9);
  std::uint64_t n = 0;
  const auto random = [&] {
    n += 3;
    return dvec3(rng.uniform(n - 3), rng.uniform(n - 2), rng.uniform(n - 1));
  };
  int proofs = 0, apart = 0;
  for (int round = 0; round < 300; ++round) {
    std::array<dvec3, 4> a, b;
    for (dvec3& x : a) x = random();
    for (dvec3& x : b) x = random() + dvec3(0.3, 0, 0);
    const auto inside = [](const std::array<dvec3, 4>& t, const dvec3& x) {
      const auto volume = [](const dvec3& p, const dvec3& q, const dvec3& r, const dvec3& s) {
        return glm::dot(glm::cross(q - p, r - p), s - p);
      };
      const double whole = volume(t[0], t[1], t[2], t[3]);
      return volume(x, t[1], t[2], t[3]) / whole > 0 && volume(t[0], x, t[2], t[3]) / whole > 0 &&
             volume(t[0], t[1], x, t[3]) / whole > 0 && volume(t[0], t[1], t[2], x) / whole > 0;
    };
    bool proof = false;
    for (int i = 0; i < 400 && !proof; ++i) {
      const dvec3 u = random() + 1e-9;
      const double sum = u.x + u.y + u.z + 0.5;
      const dvec3 x = (u.x * a[0] + u.y * a[1] + u.z * a[2] + 0.5 * a[3]) / sum;
      proof = inside(b, x);
    }
    proofs += proof ? 1 : 0;
    if (proof) {
      EXPECT_TRUE(tets_overlap(a, b));
    }
    apart += tets_overlap(a, b) ? 0 : 1;
    EXPECT_EQ(tets_overlap(a, b), tets_overlap(b, a));
  }
  EXPECT_GT(proofs, 50);
  EXPECT_GT(apart, 50);
}

TEST(PadPress, IsExactForACube) {
  constexpr double kThickness = 0.005;
  const TriMeshPtr cube = share(make_box(dvec3(0.02)));
  const std::vector<FieldReport::PressError> errors = make_pad_field(cube, kModulus, kThickness)->report().press_errors;
  ASSERT_EQ(errors.size(), 4U);
  for (const FieldReport::PressError& error : errors) {
    EXPECT_NEAR(error.mean, 1, 1e-12);
    EXPECT_NEAR(error.deviation, 0, 1e-6);
    EXPECT_EQ(error.without_tets, 0);
  }
  EXPECT_EQ(errors[0].part, 0.1);
  EXPECT_EQ(errors[1].part, 0.25);
  EXPECT_EQ(errors[2].part, 0.5);
  EXPECT_EQ(errors[3].part, 1);
}

/// A pad that is a tenth too stiff everywhere and lacks the tets of one side. The gap is a sixth of the skin, and next
/// to it a strip of the other sides as wide as the press is deep, without its corners, where the way inward leads
/// across the mitre.
TEST(PadPress, FindsErrorsAndGaps) {
  constexpr double kThickness = 0.005, kEdge = 0.04;
  const TriMeshPtr cube = share(make_box(dvec3(0.5 * kEdge)));
  const MeshIndex index(cube);
  PadTets pad = plain_pad(index, kThickness);
  for (double& p : pad.pressure) p *= 1.1;
  const dvec3 side = cube->face_normals()[0];
  std::vector<ivec4> kept;
  for (int f = 0; f < 12; ++f) {
    const auto first = pad.tets.begin() + 3 * f;
    if (glm::dot(cube->face_normals()[at(f)], side) < 0.5) kept.insert(kept.end(), first, first + 3);
  }
  ASSERT_EQ(kept.size(), 30U);
  pad.tets = kept;
  const std::vector<FieldReport::PressError> errors = press_errors(index, field_of(pad), kModulus, kThickness);
  for (const FieldReport::PressError& error : errors) {
    const double strip = error.part * kThickness / kEdge;
    EXPECT_NEAR(error.without_tets, (1 + 4 * (strip - strip * strip)) / 6, 0.006) << error.part;
  }
  EXPECT_NEAR(errors[0].mean, 1.1, 1e-12);
  EXPECT_NEAR(errors[1].mean, 1.1, 1e-12);
  EXPECT_NEAR(errors[0].deviation, 0, 1e-6);
}

TEST(FieldReportOfPads, NamesTentsPressesAndSkinForDepthPieces) {
  const auto text = [](const TriMesh& mesh, double thickness) {
    return field_problems(make_pad_field(share(mesh), kModulus, thickness)->report(), "", "").front().message;
  };
  EXPECT_EQ(text(make_box(dvec3(0.02)), 0.004).find("tents"), std::string::npos);
  EXPECT_EQ(text(make_box(dvec3(0.02)), 0.004).find("no tets"), std::string::npos);
  const std::string disc = text(make_cylinder(0.02, 0.001, 0.002), 0.004);
  EXPECT_NE(disc.find("; tents above 180 faces; "), std::string::npos) << disc;
  EXPECT_NE(disc.find(" times E depth/H; no tets 0.25 H below "), std::string::npos) << disc;
  EXPECT_NE(disc.find(" 1 H below "), std::string::npos) << disc;
}

}  // namespace
}  // namespace taxel
