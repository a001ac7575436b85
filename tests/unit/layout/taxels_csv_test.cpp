// Taxels as tables: round trip, tables of other programs, and the line and column of each mistake.
#include "core/layout/file/taxels_csv.h"

#include <gtest/gtest.h>

#include <limits>

#include "fixtures/complaint.h"

namespace taxel {
namespace {

std::vector<Taxel> some() {
  return {
      {7, "left, \"1\"", dvec3(1e-9, -2, 0.1 + 0.2), dvec3(0, 1, 0), 0.006, {}},
      {2, "", dvec3(0.1), dvec3(1e20, 0, 0), 5e-324, {{dvec3(1, 2, 3), dvec3(0, 0, 1), 0.5}, {dvec3(4), dvec3(1), 2}}},
      {3, "end", dvec3(0), dvec3(0, 0, 1), 1, {}}};
}

TEST(TaxelsCsv, KeepsTaxelsInARoundTrip) {
  const std::string text = taxels_to_csv(some());
  EXPECT_EQ(text.substr(0, text.find('\n', 60) + 1),
            "Index,X,Y,Z,NormX,NormY,NormZ,Radius,Parent,Name\n"
            "7,1e-09,-2,0.30000000000000004,0,1,0,0.006,-1,\"left, \"\"1\"\"\"\n");
  EXPECT_NE(text.find("\n8,1,2,3,0,0,1,0.5,2,\n9,"), std::string::npos) << text;
  const CsvTaxels read = parse_taxels_csv(text);
  EXPECT_EQ(read.taxels, some());
  EXPECT_TRUE(read.normals);
  EXPECT_TRUE(read.radii);
}

TEST(TaxelsCsv, ReadsOtherTables) {
  const CsvTaxels named = parse_taxels_csv("name;Z;y;x;extra\ntip;3;2;+1;?\n;6;5;4;\n", "", 0.001);
  ASSERT_EQ(named.taxels.size(), 2U);
  EXPECT_EQ(named.taxels[0].center, 0.001 * dvec3(1, 2, 3));
  EXPECT_EQ(named.taxels[0].name, "tip");
  EXPECT_EQ(named.taxels[1].id, 1);
  EXPECT_FALSE(named.normals);
  EXPECT_FALSE(named.radii);
  EXPECT_EQ(named.taxels[0].radius, Taxel().radius) << "metres already";

  const CsvTaxels bare = parse_taxels_csv("1 , 2, 3, 0, 1, 0\n4,5,6,1,0,0\n", "", 0.5);
  EXPECT_EQ(bare.taxels[1].center, dvec3(2, 2.5, 3));
  EXPECT_EQ(bare.taxels[1].normal, dvec3(1, 0, 0));
  EXPECT_TRUE(bare.normals);
  EXPECT_EQ(parse_taxels_csv("1,2,3\n").taxels.size(), 1U);
}

TEST(TaxelsCsv, ReadsTheUnitsInTheHeadsOfColumns) {
  for (const char* head : {"id,x [mm],y [mm],z [mm],nx,ny,nz,radius [mm]", "id,x_mm,y_mm,z_mm,nx,ny,nz,r_mm",
                           "id,X (mm),y mm,z [mm],nx,ny,nz,Radius_mm"}) {
    const CsvTaxels read = parse_taxels_csv(std::string(head) + "\n0,37,-17,60,0,0,1,3\n");
    EXPECT_EQ(read.taxels[0].center, dvec3(0.037, -0.017, 0.06)) << head;
    EXPECT_EQ(read.taxels[0].radius, 0.003) << head;
    EXPECT_TRUE(read.has_units && read.unread.empty()) << head;
  }
  const CsvTaxels mixed = parse_taxels_csv("x [in],y_cm,z,radius\n1,2,0.3,0.003\n");
  EXPECT_EQ(mixed.taxels[0].center, dvec3(0.0254, 0.02, 0.3));
  EXPECT_EQ(mixed.taxels[0].radius, 0.003);
  EXPECT_EQ(test::complaint_of([] { parse_taxels_csv("x [kg],y,z\n1,2,3\n", "t.csv"); }),
            "t.csv: line 1, column X: unit must be a length such as mm, is \"kg\"");
}

TEST(TaxelsCsv, ReadsDecimalCommasQuaternionsAndUtf16) {
  const CsvTaxels commas = parse_taxels_csv("id;x;y;z;radius\n4;0,037;-0,017;0,06;0,003\n");
  EXPECT_EQ(commas.taxels[0].center, dvec3(0.037, -0.017, 0.06));
  EXPECT_EQ(commas.taxels[0].id, 4);
  const CsvTaxels turned = parse_taxels_csv("px,py,pz,qx,qy,qz,qw,kind\n1,2,3,1,0,0,0,a\n");
  EXPECT_EQ(turned.taxels[0].normal, dvec3(0, 0, -1));
  EXPECT_TRUE(turned.normals);
  EXPECT_EQ(turned.unread, (std::vector<std::string>{"kind"}));
  EXPECT_EQ(test::complaint_of([] { parse_taxels_csv("x,y,z,qx,qy,qz,qw\n1,2,3,1,1,0,0\n", "t.csv"); }),
            "t.csv: line 2, column QX: the quaternion must have length 1, has 1.414");
  std::string wide = "\xFE\xFF";
  for (const char c : std::string("x,y,z\n1,2,3\n")) wide += '\0', wide += c;
  EXPECT_EQ(parse_taxels_csv(wide).taxels[0].center, dvec3(1, 2, 3));
}

TEST(TaxelsCsv, NamesLineAndColumn) {
  const auto complaint = [](const std::string& text) {
    return test::complaint_of([&] { parse_taxels_csv(text, "t.csv"); });
  };
  EXPECT_EQ(complaint(""), "t.csv: holds no table");
  EXPECT_EQ(complaint("x,y,z\n"), "t.csv: holds no taxel");
  EXPECT_EQ(complaint("x,y\n1,2"), "t.csv: line 1, column Z: is missing");
  EXPECT_EQ(complaint("1,2\n"), "t.csv: line 1, column Z: is missing");
  EXPECT_EQ(complaint("x,y,z,nx\n"), "t.csv: line 1, column NormY: is missing: a normal has three");
  EXPECT_EQ(complaint("x,X,y,z\n"), "t.csv: line 1, column X: is in the header twice");
  EXPECT_EQ(complaint("x,y,z\n1,2,3\n\n1,2"), "t.csv: line 4, column Z: is missing");
  EXPECT_EQ(complaint("x,y,z\n1,\"2,5\",3"), "t.csv: line 2, column Y: must be a number, is \"2,5\"");
  EXPECT_EQ(complaint("x,y,z\n1,nan,3"), "t.csv: line 2, column Y: must be a number, is \"nan\"");
  EXPECT_EQ(complaint("id,x,y,z\n1.5,1,2,3"), "t.csv: line 2, column Index: must be a whole number, is \"1.5\"");
  EXPECT_EQ(complaint("id,x,y,z,parent\n1,1,2,3,4"), "t.csv: line 2, column Parent: no row before has the Index 4");
}

TEST(TaxelsCsv, NamesTheValueThatCannotBeWritten) {
  std::vector<Taxel> taxels = some();
  taxels[1].subtaxels[0].radius = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(test::complaint_of([&] { taxels_to_csv(taxels); }), "taxel 2: must be finite to be written");
}

}  // namespace
}  // namespace taxel
