// The way of a layout through two formats keeps the values that both hold; real files go through all of them.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>

#include "core/layout/file/imported_layout.h"
#include "core/layout/formats/layout_format.h"
#include "core/mesh/make/primitives.h"
#include "fixtures/complaint.h"

namespace taxel {
namespace {

/// The layout as it returns from a format that holds only these values.
std::vector<Taxel> kept_taxels(std::vector<Taxel> taxels, const LayoutFormat& format) {
  const HeldValues& holds = format.holds;
  if (format.word == "icub")  // rows are in the order of ids
    std::stable_sort(taxels.begin(), taxels.end(), [](const Taxel& a, const Taxel& b) { return a.id < b.id; });
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    if (!holds.ids) taxels[i].id = static_cast<int>(i);
    const bool is_grid = format.word == "genesis" && taxels[0].name == "row 0 column 0";  // the name is its place there
    const bool is_repeated = format.word == "mjcf-sites" &&
                             std::any_of(taxels.begin(), taxels.begin() + static_cast<std::ptrdiff_t>(i),
                                         [&](const Taxel& earlier) { return earlier.name == taxels[i].name; });
    if (is_repeated || (!holds.names && !is_grid)) taxels[i].name.clear();
    if (!holds.radii) taxels[i].radius = Taxel().radius;
    if (!holds.subtaxels) taxels[i].subtaxels.clear();
  }
  return taxels;
}

/// Expects the same taxels, normals up to the rounding of angles.
void expect_same_taxels(std::vector<Taxel> is, const std::vector<Taxel>& wanted) {
  ASSERT_EQ(is.size(), wanted.size());
  for (std::size_t i = 0; i < is.size(); ++i) {
    const bool has_normal = wanted[i].normal != dvec3(0);
    EXPECT_EQ(is[i].normal != dvec3(0), has_normal);
    if (has_normal) {
      EXPECT_LT(glm::distance(glm::normalize(is[i].normal), glm::normalize(wanted[i].normal)), 3e-15);
    }
    is[i].normal = wanted[i].normal;
    ASSERT_EQ(is[i], wanted[i]) << "taxel " << i;
  }
}

std::vector<ImportedLayout> through(const LayoutFormat& format, const std::vector<ImportedLayout>& layouts) {
  return format.parse(format.write(layouts).bytes, "a");
}

ImportedLayout layout_of_random_taxels(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  ImportedLayout one;
  one.layout.name = "sensor";
  one.geom = "link";
  const double radius = std::exp(3 * unit(random) - 6);
  int id = 0;
  for (int i = 0; i < 12; ++i, id += 1 + static_cast<int>(random() % 3)) {
    Taxel taxel;
    taxel.id = id;
    if (random() % 2 == 0) taxel.name = fmt::format("t {} <\"&'>", i);
    taxel.center = std::exp(5 * unit(random)) * dvec3(unit(random), unit(random), unit(random));
    taxel.normal = glm::normalize(dvec3(unit(random), unit(random), unit(random)));
    taxel.radius = radius;
    if (random() % 4 == 0) taxel.subtaxels = {{taxel.center, taxel.normal, 0.5 * radius}};
    one.layout.taxels.push_back(taxel);
  }
  return one;
}

TEST(FormatPairs, KeepTheValuesThatBothFormatsHold) {
  std::mt19937 random(11);
  int pairs = 0;
  for (int run = 0; run < 5; ++run) {
    ImportedLayout one = layout_of_random_taxels(random);
    one.layout.mesh.file = "m.obj";  // scenes need one
    for (const LayoutFormat& a : layout_formats()) {
      for (const LayoutFormat& b : layout_formats()) {
        if (a.write == nullptr || b.write == nullptr) continue;
        SCOPED_TRACE(fmt::format("{} then {}", a.word, b.word));
        ImportedLayout middle = through(a, {one})[0];
        middle.layout.mesh.file = "m.obj";
        const ImportedLayout end = through(b, {middle})[0];
        expect_same_taxels(end.layout.taxels, kept_taxels(kept_taxels(one.layout.taxels, a), b));
        const auto holds_link = [](const LayoutFormat& format) { return format.holds.geom && format.word != "csv"; };
        EXPECT_EQ(end.geom == "link", holds_link(a) && holds_link(b));
        ++pairs;
      }
    }
  }
  EXPECT_EQ(pairs, 5 * 9 * 9);
}

class RealLayouts : public testing::TestWithParam<std::pair<const char*, std::vector<std::size_t>>> {
 protected:
  const std::filesystem::path real{TAXEL_REAL_DATA};
};

TEST_P(RealLayouts, ComeBackEqualThroughEachFormatThatHoldsThem) {
  const auto& [name, counts] = GetParam();
  const std::filesystem::path file = real / name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is absent";
  const std::vector<ImportedLayout> layouts = read_layouts(*layout_format_of(file), file);
  ASSERT_EQ(layouts.size(), counts.size());
  int formats = 0;
  for (const LayoutFormat& format : layout_formats()) {
    if (format.write == nullptr) continue;
    SCOPED_TRACE(format.word);
    for (std::size_t i = 0; i < layouts.size(); ++i) {
      ImportedLayout one = layouts[i];
      EXPECT_EQ(one.layout.taxels.size(), counts[i]);
      one.layout.mesh.file = "m.obj";
      if (!one.has_normals && format.word != "csv" && format.word != "yaml") {
        EXPECT_NE(test::complaint_of([&] { format.write({one}); }).find("has no normals"), std::string::npos);
        continue;
      }
      const ImportedLayout back = through(format, {one})[0];
      expect_same_taxels(back.layout.taxels, kept_taxels(one.layout.taxels, format));
      EXPECT_EQ(back.has_normals, one.has_normals);
      ++formats;
    }
  }
  EXPECT_EQ(formats, layouts.front().has_normals ? 9 * static_cast<int>(layouts.size()) : 2);
}

INSTANTIATE_TEST_SUITE_P(RealFormats, RealLayouts,
                         testing::Values(std::pair{"formats/genesis_probes_98_sharpa.json",
                                                   std::vector<std::size_t>{9, 9, 9, 9, 4, 4, 4, 4, 4, 4, 4, 4, 4, 9, 4,
                                                                            9, 4}},
                                         std::pair{"formats/ubi_tactile.urdf", std::vector<std::size_t>{256, 2}},
                                         std::pair{"formats/gentact_header.csv", std::vector<std::size_t>{2}},
                                         std::pair{"paper/curved_fingertip.yaml", std::vector<std::size_t>{12}},
                                         std::pair{"flat_taxel_sensor.yaml", std::vector<std::size_t>{256}},
                                         std::pair{"shadow_fingertip.taxels.json", std::vector<std::size_t>{12}}));

TEST(RealFormats, GiveTheirCountsOnTheFoamOfTheirScenes) {
  const std::filesystem::path real(TAXEL_REAL_DATA);
  if (!std::filesystem::exists(real / "myrmex_sensor.yaml")) GTEST_SKIP() << real << " is absent";
  const auto foam = std::make_shared<const TriMesh>(make_box(dvec3(0.2, 0.2, 0.02)));
  for (const char* name : {"myrmex_sensor.yaml", "flat_taxel_sensor.yaml"}) {
    ImportedLayout imported = import_layout(real / name);
    EXPECT_FALSE(imported.has_normals && imported.cell == 0) << "the skin gives the normals";
    put_on_skin(imported, foam, name);
    ASSERT_EQ(imported.layout.taxels.size(), 256U) << name;
    for (const Taxel& taxel : imported.layout.taxels) EXPECT_EQ(taxel.normal, dvec3(0, 0, 1)) << name;
  }
}

TEST(RealFormats, RefuseFilesThatHoldNoLayout) {
  const std::filesystem::path real(TAXEL_REAL_DATA);
  if (!std::filesystem::exists(real / "formats")) GTEST_SKIP() << real << " has no folder formats";
  const auto complaint = [&](const char* name) {
    return test::complaint_of([&] { read_layouts(*layout_format_of(real / name), real / name); });
  };
  EXPECT_NE(complaint("formats/genesis_canvas_xhand1.json").find("is the canvas of a hand"), std::string::npos);
  EXPECT_NE(complaint("paper/fingertip_mocap.xml").find("holds no layout"), std::string::npos);
  EXPECT_NE(complaint("myrmex_box_world.xml").find("holds no layout"), std::string::npos);
}

}  // namespace
}  // namespace taxel
