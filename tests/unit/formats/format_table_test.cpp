// The table of formats: name and content select the format, each format reads its own files back, and values that a
// format cannot hold are reported.
#include "core/layout/formats/layout_format.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "core/base/files.h"
#include "core/layout/file/layout_json.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

Layout some_layout() {
  Layout layout;
  layout.name = "tip";
  layout.mesh.file = "m.obj";
  layout.taxels = {{7, "a", dvec3(1, 2, 3), dvec3(0, 1, 0), 0.006, {{dvec3(1, 2, 3), dvec3(0, 0, 1), 0.001}}}};
  return layout;
}

std::string word_of(const std::filesystem::path& path) {
  const LayoutFormat* format = layout_format_of(path);
  return format == nullptr ? "" : std::string(format->word);
}

TEST(FormatTable, ChoosesAFormatByTheFileName) {
  EXPECT_EQ(word_of("a/b.TAXELS.json"), "taxels");
  EXPECT_EQ(word_of("b.json"), "taxels");
  EXPECT_EQ(word_of("b.Csv"), "csv");
  EXPECT_EQ(word_of("b.probes.json"), "genesis");
  EXPECT_EQ(word_of("b.urdf"), "urdf");
  EXPECT_EQ(word_of("b.npz"), "npz");
  EXPECT_EQ(word_of("b.sites.xml"), "mjcf-sites");
  EXPECT_EQ(layout_format_of("csv"), nullptr);
  EXPECT_EQ(test::complaint_of([] { import_layout("b.obj"); }),
            "b.obj: is no layout by its name; known are .taxels.json, .json, .csv, .yaml, .yml, .txt, .probes.json, "
            ".npz, .xml, .mjcf, .sites.xml, .urdf, .xacro, .jsonl");
}

TEST(FormatTable, ChoosesAFormatByTheContentIfTheNameIsShared) {
  const test::TempFolder folder;
  EXPECT_EQ(word_of(folder.write("a.json", "\n [{\"link_name\": \"x\"}]")), "genesis");
  EXPECT_EQ(word_of(folder.write("b.json", "{\"format\": \"taxel-layout\"}")), "taxels");
  EXPECT_EQ(word_of(folder.write("a.xml", "<?xml version=\"1.0\"?>\n<!-- <mujoco> -->\n<robot name=\"r\">")), "urdf");
  EXPECT_EQ(word_of(folder.write("b.xml", "<mujoco/>")), "mjcf");
  EXPECT_FALSE(is_foreign_layout(folder / "b.xml")) << "a scene is opened as a scene";
  EXPECT_TRUE(is_foreign_layout(folder / "a.xml"));
  EXPECT_TRUE(is_foreign_layout(folder / "a.json"));
  EXPECT_FALSE(is_foreign_layout(folder / "b.json"));
  EXPECT_TRUE(looks_like_foreign_layout(folder.write("a.txt", "name a\n[calibration]\n")));
  EXPECT_FALSE(looks_like_foreign_layout(folder.write("b.txt", "notes of a meeting\n")));
  EXPECT_TRUE(is_foreign_layout(folder / "b.txt")) << "and the reader says that it is none";
}

/// Returns the formats that hold layouts.
std::vector<LayoutFormat> written_formats() {
  std::vector<LayoutFormat> formats = layout_formats();
  std::erase_if(formats, [](const LayoutFormat& format) { return format.write == nullptr; });
  return formats;
}

/// Returns the layout as a format returns it that holds only these values.
Layout held(Layout layout, const HeldValues& holds) {
  std::vector<Taxel>& taxels = layout.taxels;
  for (std::size_t i = 0; i < taxels.size(); ++i) {
    if (!holds.ids) taxels[i].id = static_cast<int>(i);
    if (!holds.names) taxels[i].name.clear();
    if (!holds.radii) taxels[i].radius = Taxel().radius;
    if (!holds.subtaxels) taxels[i].subtaxels.clear();
  }
  return layout;
}

TEST(FormatTable, HasFormatsThatKeepTheirValuesInARoundTrip) {
  const test::TempFolder folder;
  for (const LayoutFormat& format : written_formats()) {
    const auto path = folder / fmt::format("a{}", format.extensions[0]);
    const std::vector<std::string> lost = write_layout_as(format, path, some_layout());
    const ImportedLayout read = choose_sensor(read_layouts(format, path), "", path.string());
    EXPECT_EQ(read.layout.taxels, held(some_layout(), format.holds).taxels) << format.name;
    EXPECT_EQ(read.layout == some_layout(), format.holds.settings) << format.name;
    EXPECT_TRUE(format.holds.settings || !lost.empty()) << format.name << " says so where it cannot hold all";
    for (const bool HeldValues::*value :
         {&HeldValues::ids, &HeldValues::names, &HeldValues::radii, &HeldValues::subtaxels}) {
      const char* const word = value == &HeldValues::ids     ? "holds no ids"
                               : value == &HeldValues::names ? "holds no names"
                               : value == &HeldValues::radii ? "holds no radii"
                                                             : "holds no subtaxels";
      const bool is_noted = std::any_of(lost.begin(), lost.end(),
                                        [&](const std::string& note) { return note.find(word) != std::string::npos; });
      EXPECT_EQ(is_noted, !(format.holds.*value)) << format.name << ": " << word;
    }
  }
}

/// Returns a layout with random numbers of all magnitudes, ids with gaps, unit normals and one radius.
ImportedLayout random_layout(std::mt19937& random, bool has_names) {
  std::uniform_real_distribution<double> unit(-1, 1);
  ImportedLayout imported;
  Layout& layout = imported.layout;
  layout.name = "random";
  layout.mesh.file = "m.obj";
  imported.geom = "link";
  const int count = 1 + static_cast<int>(random() % 20);
  const double radius = std::exp(5 * unit(random) - 6);
  for (int i = 0, id = 0; i < count; ++i, id += 1 + static_cast<int>(random() % 3)) {
    Taxel taxel;
    taxel.id = id;
    taxel.center = std::exp(10 * unit(random)) * dvec3(unit(random), unit(random), unit(random));
    taxel.normal = glm::normalize(dvec3(unit(random), unit(random), unit(random)));
    taxel.radius = radius;
    if (has_names) taxel.name = fmt::format("t \"{}\", \xC3\xA9", random());
    layout.taxels.push_back(taxel);
  }
  return imported;
}

TEST(FormatTable, HasFormatsThatKeepRandomTaxelsExactly) {
  std::mt19937 random(7);
  for (int run = 0; run < 300; ++run) {
    const ImportedLayout one = random_layout(random, run % 2 == 0);
    for (const LayoutFormat& format : written_formats()) {
      SCOPED_TRACE(fmt::format("{} in run {}", format.word, run));
      const std::vector<ImportedLayout> read = format.parse(format.write({one}).bytes, "a");
      ASSERT_EQ(read.size(), 1U);
      std::vector<Taxel> taxels = read[0].layout.taxels;
      const std::vector<Taxel> wanted = held(one.layout, format.holds).taxels;
      ASSERT_EQ(taxels.size(), wanted.size());
      for (std::size_t i = 0; i < taxels.size() && format.word == "urdf"; ++i) {
        EXPECT_LT(glm::distance(taxels[i].normal, wanted[i].normal), 1e-15) << "angles";
        taxels[i].normal = wanted[i].normal;
      }
      ASSERT_EQ(taxels, wanted);
      const bool has_geom = format.holds.geom && format.word != "csv";  // a table holds USD prims
      EXPECT_EQ(read[0].geom, has_geom ? "link" : "");
    }
  }
}

TEST(FormatTable, HasFormatsThatKeepSeveralSensors) {
  std::mt19937 random(8);
  std::vector<ImportedLayout> several;
  for (int i = 0; i < 5; ++i) {
    several.push_back(random_layout(random, false));
    several.back().layout.name = several.back().geom = fmt::format("finger {}", i);
  }
  int formats = 0;
  for (const LayoutFormat& format : written_formats()) {
    if (!format.writes_several) continue;
    ++formats;
    const std::vector<ImportedLayout> read = format.parse(format.write(several).bytes, "a");
    ASSERT_EQ(read.size(), several.size()) << format.name;
    for (std::size_t i = 0; i < read.size(); ++i) {
      EXPECT_EQ(read[i].layout.name, several[i].layout.name) << format.name;
      EXPECT_EQ(read[i].geom, several[i].geom) << format.name;
      EXPECT_EQ(read[i].layout.taxels.size(), several[i].layout.taxels.size()) << format.name;
    }
    EXPECT_EQ(choose_sensor(read, "finger 3", "a").layout.taxels[0].center, several[3].layout.taxels[0].center);
    EXPECT_EQ(test::complaint_of([&] { choose_sensor(read, "thumb", "a"); }),
              "a: has no sensor \"thumb\", but \"finger 0\", \"finger 1\", \"finger 2\", \"finger 3\", \"finger 4\"");
  }
  EXPECT_EQ(formats, 5);
}

TEST(FormatTable, NamesTheLayoutsOfANoteThatIsNotOfAll) {
  std::vector<ImportedLayout> two(2);
  two[0].layout.name = "a";
  two[1].layout.name = "b";
  two[0].notes = {"both", "one"};
  two[1].notes = {"both"};
  EXPECT_EQ(notes_of(two), (std::vector<std::string>{"both", "a: one"}));
}

TEST(FormatTable, RefusesLayoutsThatAFormatCannotHold) {
  ImportedLayout none;
  none.layout.name = "x";
  ImportedLayout bare;
  bare.layout = some_layout();
  bare.has_normals = false;
  ImportedLayout infinite;
  infinite.layout = some_layout();
  infinite.layout.taxels[0].center.x = std::numeric_limits<double>::infinity();
  for (const LayoutFormat& format : written_formats()) {
    const std::string expected = format.word == "taxels" ? "accepted" : "x: has no taxels to write";
    EXPECT_EQ(test::complaint_of([&] { format.write({none}); }), expected) << format.name;
    if (format.word == "csv" || format.word == "yaml") {
      EXPECT_FALSE(format.parse(format.write({bare}).bytes, "a")[0].has_normals);
    } else {
      EXPECT_NE(test::complaint_of([&] { format.write({bare}); }).find("tip: has no normals, which a"),
                std::string::npos);
    }
    EXPECT_NE(test::complaint_of([&] { format.write({infinite}); }).find("must be finite to be written"),
              std::string::npos)
        << format.name;
  }
}

TEST(FormatTable, NamesTheValuesThatATableCannotHold) {
  const test::TempFolder folder;
  EXPECT_EQ(import_layout(folder.write("a.csv", "x,y,z\n1,2,3\n")).notes.size(), 3U);
  const auto bad = folder.write("b.csv", "x,y,z\n1,2,?\n");
  EXPECT_EQ(test::complaint_of([&] { import_layout(bad); }),
            bad.string() + ": line 2, column Z: must be a number, is \"?\"");
}

}  // namespace
}  // namespace taxel
