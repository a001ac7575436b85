// The findings about a mesh and their explanations.
#include "core/mesh/topology/mesh_check.h"

#include <gtest/gtest.h>

#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

/// Returns a box without two opposite faces.
TriMesh with_two_holes() {
  TriMesh box = make_box(dvec3(0.1));
  std::vector<ivec3> faces;
  for (int f = 0; f < box.face_count(); ++f) {
    if (std::abs(box.face_normals()[static_cast<std::size_t>(f)].z) < 0.5)
      faces.push_back(box.faces()[static_cast<std::size_t>(f)]);
  }
  return {box.vertices(), std::move(faces)};
}

TEST(MeshReport, IsEmptyForASoundMesh) {
  EXPECT_TRUE(mesh_report(make_icosphere(0.01, 3), {}).empty());
  EXPECT_EQ(count_findings({}), "");
}

TEST(MeshReport, CountsHolesAndExplainsThem) {
  const MeshFindings findings = mesh_report(with_two_holes(), {"welded 4 duplicate vertices"});
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].code, "mesh_open");
  EXPECT_NE(findings[0].what.find("8 open edges around 2 holes"), std::string::npos) << findings[0].what;
  EXPECT_NE(findings[0].meaning.find("A repair closes it"), std::string::npos) << findings[0].meaning;
  EXPECT_EQ(findings[1].what, "welded 4 duplicate vertices") << "repairs come last";
  EXPECT_EQ(count_findings(findings), "1 warning, 1 note");
}

TEST(MeshReport, ListsTheMostSevereFirstWithExplanations) {
  std::vector<ivec3> faces = with_two_holes().faces();
  std::swap(faces[0].x, faces[0].y);
  const MeshFindings findings = mesh_report(TriMesh(with_two_holes().vertices(), faces), {});
  ASSERT_GE(findings.size(), 2U);
  EXPECT_EQ(findings.front().severity, Severity::error);
  for (const MeshFinding& finding : findings) EXPECT_FALSE(finding.meaning.empty()) << finding.code;
  for (const TriMesh& mesh : {flipped(make_box(dvec3(0.1))), make_box(dvec3(20))})
    for (const MeshFinding& finding : mesh_report(mesh, {})) EXPECT_FALSE(finding.meaning.empty()) << finding.code;
}

}  // namespace
}  // namespace taxel
