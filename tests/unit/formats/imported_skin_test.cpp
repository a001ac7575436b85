// Values that a layout takes from its skin: the unit of the mesh, taxels in cells, directions, and the density.
#include "core/layout/file/imported_layout.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/layout/file/taxels_csv.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/complaint.h"

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

/// Returns the complaint about a layout on a box, or "accepted".
std::string complaint_on_box(const ImportedLayout& given, double half = 0.01) {
  return test::complaint_of([&] {
    ImportedLayout imported = given;
    check_lengths(imported, "f");
    put_on_skin(imported, std::make_shared<const TriMesh>(make_box(dvec3(half))), "f");
  });
}

ImportedLayout two_taxels_at(double unit, double radius) {
  ImportedLayout imported = bare_layout({{0, "", dvec3(0, 0, 10) / unit, dvec3(0, 0, 1), radius, {}},
                                         {1, "", dvec3(4, 2, 10) / unit, dvec3(0, 0, 1), radius, {}}});
  imported.has_normals = true;
  return imported;
}

TEST(ImportedSkin, RefusesLengthsInAnotherUnitAndProposesTheUnit) {
  const std::string remedy = "give --unit {0}, or name the unit in the heads of the columns of a table, \"x [{0}]\"";
  EXPECT_EQ(complaint_on_box(two_taxels_at(1000, 0.003)), "accepted");
  EXPECT_EQ(complaint_on_box(two_taxels_at(1, 0.003)),
            "f: lengths are up to 10.95 m, but a sensor is at most 1 m large: they seem to be in mm; " +
                fmt::format(fmt::runtime(remedy), "mm"));
  EXPECT_EQ(complaint_on_box(two_taxels_at(1000, 3)),
            "f: lengths are up to 3 m, but a sensor is at most 1 m large: they seem to be in mm; " +
                fmt::format(fmt::runtime(remedy), "mm"));
  EXPECT_EQ(complaint_on_box(two_taxels_at(10, 0.003)),
            "f: half of the taxels are 1.081 m or more from the mesh, which is 0.02 m large: in cm they are on it; " +
                fmt::format(fmt::runtime(remedy), "cm"));
  EXPECT_EQ(complaint_on_box(two_taxels_at(1000, 0.003), 2).substr(0, 62),
            "f: the mesh is 4 m large, but a sensor is 0.001 m to 1 m large");
  ImportedLayout far = two_taxels_at(1000, 0.003);
  for (Taxel& taxel : far.layout.taxels) taxel.center.x += 0.1;
  EXPECT_NE(complaint_on_box(far).find("is it the mesh of these taxels"), std::string::npos);
  ImportedLayout scaled = two_taxels_at(1000, 0.003);
  scaled.layout.taxels[1].normal *= 0.001;
  EXPECT_EQ(complaint_on_box(scaled).substr(0, 55), "f: taxel 1: the normal must have length 1, has 0.001: a");
}

TEST(ImportedSkin, AppliesTheUnitToCentresAndGivenRadii) {
  ImportedLayout imported = two_taxels_at(1, 3);
  apply_unit(imported, 0.001, "f");
  EXPECT_EQ(complaint_on_box(imported), "accepted");
  EXPECT_EQ(imported.layout.taxels[0].radius, 0.003);
  imported.set_all_radii_missing();
  apply_unit(imported, 10, "f");
  EXPECT_EQ(imported.layout.taxels[0].radius, Taxel().radius);
  imported.has_units = true;
  EXPECT_EQ(test::complaint_of([&] { apply_unit(imported, 1, "f"); }), "f: names its unit itself: leave --unit out");
}

TEST(ImportedSkin, TurnsNormalsOverIfAllPointIntoTheSkin) {
  for (const bool is_one_outward : {false, true}) {
    ImportedLayout imported = two_taxels_at(1000, 0.003);
    imported.layout.taxels[0].normal = {0, 0, -1};
    if (!is_one_outward) imported.layout.taxels[1].normal = {0.1, 0, -0.99};
    put_on_skin(imported, std::make_shared<const TriMesh>(make_box(dvec3(0.01))), "f");
    EXPECT_EQ(imported.layout.taxels[0].normal.z, is_one_outward ? -1 : 1);
    EXPECT_EQ(imported.notes.front() == "all normals point into the skin: they are turned over", !is_one_outward);
  }
}

TEST(ImportedSkin, GivesOnlyTaxelsWithoutANormalThatOfTheSkin) {
  ImportedLayout imported = two_taxels_at(1000, 0.003);
  imported.layout.taxels[0].normal = dvec3(0);
  imported.layout.taxels[1].normal = {0.6, 0, 0.8};
  put_on_skin(imported, std::make_shared<const TriMesh>(make_box(dvec3(0.01))), "f");
  EXPECT_EQ(imported.layout.taxels[0].normal, dvec3(0, 0, 1));
  EXPECT_EQ(imported.layout.taxels[1].normal, dvec3(0.6, 0, 0.8));
  EXPECT_EQ(imported.notes.front(), "1 taxels have the normal 0 0 0: those of the skin are taken");
}

// A table without radii gives a subtaxel the radius of its taxel.
TEST(ImportedSkin, GivesASubtaxelOfATableTheRadiusOfItsTaxel) {
  const CsvTaxels table = parse_taxels_csv("id,x,y,z,parent\n3,0,0,1,\n4,0,0,1,3\n", "f");
  ASSERT_EQ(table.taxels.at(0).subtaxels.size(), 1U);
  EXPECT_EQ(table.taxels[0].subtaxels[0].radius, Taxel().radius);
}

}  // namespace
}  // namespace taxel
