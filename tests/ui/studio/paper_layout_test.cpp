// The paper's twelve taxels, made by hand on the bare mesh, as a user would.
#include <gtest/gtest.h>

#include "core/mesh/closest_point.h"
#include "core/mesh/mesh_io.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

/// Centres of the paper's six taxels on the +x side [mm].
const std::vector<dvec3> kPaperTaxels{{4.1518, -6.1507, 14.6462}, {8.6195, 0.4629, 13.1657}, {8.3022, 0.7405, 19.4511},
                                      {3.5417, -5.0062, 23.8569}, {2.6699, 0.5571, 30.2862}, {7.1384, 0.9784, 25.8859}};

TEST(PaperLayout, MadeByHandFromAnEmptyWindow) {
  const StudioProgram studio;
  const std::string file = (studio.folder() / "twelve.taxels.json").string();
  Lines script{kIdle, R"({"event": "drop", "files": [")" + kMeshFile + R"("]})", kIdle};
  const MeshIndex skin(load_mesh(kMeshFile).mesh);
  for (const dvec3& center : kPaperTaxels) {
    // The measured ones lie up to 0.8 mm off the mesh: what one sees, and clicks, is the skin there.
    const dvec3 p = skin.closest_point(1e-3 * center).position;
    const std::string at = std::to_string(p.x) + ", " + std::to_string(p.y) + ", " + std::to_string(p.z);
    script.insert(script.end(), {click(R"({"world": [)" + at + "]}", kCtrl), kIdle});
  }
  const Lines rest{key("a"), kIdle,           key("f"), type("6"),         key("Enter"),    kIdle, key("n", kShift),
                   kIdle,    key("m", kCtrl), kIdle,    dump("made.json"), key("e", kCtrl), kIdle, type(file),
                   kIdle,    key("Enter"),    kIdle};
  script.insert(script.end(), rest.begin(), rest.end());
  studio.play(script, {"--empty"});
  const Json taxels = studio.state("made.json")["document"]["layout"]["taxels"];
  ASSERT_EQ(taxels.size(), 12U);
  for (std::size_t i = 0; i < 6; ++i) {
    const dvec3 center = vector_of(taxels[i]["center"]);
    EXPECT_LT(glm::distance(center, 1e-3 * kPaperTaxels[i]), 1.2e-3) << i;
    EXPECT_EQ(vector_of(taxels[i + 6]["center"]), center * dvec3(-1, 1, 1)) << i;
    EXPECT_EQ(taxels[i]["radius"], 6e-3);
  }
#ifdef TAXEL_PROGRAM
  const Outcome check = run_program(TAXEL_PROGRAM, {"check", file}, studio.folder());
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_EQ(check.out.find(": warning:"), std::string::npos) << check.out;
  EXPECT_EQ(run_program(TAXEL_PROGRAM, {"sweep", "--layout", file, "--out", "sweep"}, studio.folder()).status, 0);
#endif
}

}  // namespace
}  // namespace taxel::test
