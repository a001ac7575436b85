// Values that a layout takes from its skin: the unit of the mesh, taxels in cells, directions, and the density.
#include "core/layout/file/imported_skin.h"

#include <gtest/gtest.h>

#include "core/layout/file/taxels_csv.h"
#include "core/mesh/make/primitives.h"

namespace taxel {
namespace {

/// Returns a layout that has only these taxels.
ImportedLayout bare_layout(std::vector<Taxel> taxels = {}) {
  ImportedLayout imported;
  imported.layout.taxels = std::move(taxels);
  imported.has_normals = imported.has_density = imported.has_material = imported.has_frame = false;
  return imported;
}

// A box of 20 mm in each unit that is tried, with a taxel in metres on it.
TEST(ImportedSkin, GuessesTheUnitInWhichTheTaxelsAreOnTheMesh) {
  const ImportedLayout imported = bare_layout({{0, "", dvec3(0, 0, 0.01), dvec3(0, 0, 1), 0.002, {}}});
  for (const double scale : {1.0, 0.001, 0.01, 0.0254})
    EXPECT_EQ(guess_scale(imported, make_box(dvec3(0.01 / scale))), scale);
}

// A plate of 6 x 4 mm has 3 x 2 cells of 2 mm, numbered along y first. The array points along its longer side, x, and
// touches along its normal, z.
TEST(ImportedSkin, PutsATaxelInTheMiddleOfEachCell) {
  ImportedLayout imported = bare_layout();
  imported.cell = 0.002;
  put_on_skin(imported, std::make_shared<const TriMesh>(make_box({0.003, 0.002, 0.0005})), "plate");
  ASSERT_EQ(imported.layout.taxels.size(), 6U);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 2; ++row) {
      const Taxel& taxel = imported.layout.taxels[static_cast<std::size_t>(2 * column + row)];
      EXPECT_EQ(taxel.id, 2 * column + row);
      EXPECT_LT(glm::distance(taxel.center, dvec3(0.002 * (column - 1), 0.002 * row - 0.001, 0.0005)), 1e-15);
      EXPECT_EQ(taxel.normal, dvec3(0, 0, 1));
      EXPECT_EQ(taxel.radius, 0.001);
    }
  }
  EXPECT_EQ(imported.layout.frame.distal, dvec3(1, 0, 0));
  EXPECT_EQ(imported.layout.frame.pad, dvec3(0, 0, 1));
}

TEST(ImportedSkin, PointsAnArrayAlongItsLongerSide) {
  ImportedLayout imported = bare_layout();
  imported.cell = 0.002;
  put_on_skin(imported, std::make_shared<const TriMesh>(make_box({0.002, 0.003, 0.0005})), "plate");
  EXPECT_EQ(imported.layout.frame.distal, dvec3(0, 1, 0));
}

TEST(ImportedSkin, KeepsADirectionThatTheFileGives) {
  ImportedLayout imported = bare_layout();
  imported.cell = 0.002;
  imported.has_frame = true;
  put_on_skin(imported, std::make_shared<const TriMesh>(make_box({0.003, 0.002, 0.0005})), "plate");
  EXPECT_EQ(imported.layout.frame, SensorFrame());
}

// 100 000 samples on the 0.052 m^2 of a plate of 200 x 100 x 20 mm are 1.9e6 per m^2; with one digit, 1e6.
TEST(ImportedSkin, LimitsTheDensityOfALargeSkin) {
  const auto plate = std::make_shared<const TriMesh>(make_box({0.1, 0.05, 0.01}));
  for (const bool has_density : {false, true}) {
    ImportedLayout imported = bare_layout({{0, "", dvec3(0, 0, 0.01), dvec3(0, 0, 1), 0.002, {}}});
    imported.has_density = has_density;
    put_on_skin(imported, plate, "plate");
    EXPECT_EQ(imported.layout.sampling.density, has_density ? Sampling().density : 1e6);
  }
}

// A table without radii gives a subtaxel the radius of its taxel.
TEST(ImportedSkin, GivesASubtaxelOfATableTheRadiusOfItsTaxel) {
  const CsvTaxels table = parse_taxels_csv("id,x,y,z,parent\n3,0,0,1,\n4,0,0,1,3\n", "f");
  ASSERT_EQ(table.taxels.at(0).subtaxels.size(), 1U);
  EXPECT_EQ(table.taxels[0].subtaxels[0].radius, Taxel().radius);
}

}  // namespace
}  // namespace taxel
