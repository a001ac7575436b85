// The largest number of taxels that each format reads: the last one is read, one more is refused with its place. And
// writers that lose a taxel.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "core/base/archive/npz.h"
#include "core/layout/formats/layout_format.h"
#include "fixtures/complaint.h"
#include "fixtures/temp_folder.h"

namespace taxel {
namespace {

constexpr int kMost = 100'000;

/// Returns "accepted", or the message of the reader of a format.
std::string reading(const char* word, const std::string& bytes) {
  return test::complaint_of([&] { find_layout_format(word)->parse(bytes, "f"); });
}

std::string repeated(const std::string& text, int count) {
  std::string all;
  for (int i = 0; i < count; ++i) all += text;
  return all;
}

TEST(FormatLimits, IcubTextHasAHundredThousandRows) {
  const std::string head = "[calibration]\n0 0 0 0 0 1\n", zeros = repeated("0 0 0 0 0 0\n", kMost - 1);
  EXPECT_EQ(reading("icub", head + zeros), "accepted");
  EXPECT_EQ(reading("icub", head + zeros + "0 0 0 0 0 1\n"),
            "f: line 100002 (row 100000): is beyond the 100000 rows that are read");
  ImportedLayout one;
  one.layout.taxels = {{kMost - 1, "", dvec3(1), dvec3(0, 0, 1), 1, {}}};
  const LayoutFormat& icub = *find_layout_format("icub");
  EXPECT_EQ(icub.parse(icub.write({one}).bytes, "f")[0].layout.taxels.at(0).id, kMost - 1);
  one.layout.taxels[0].id = kMost;
  EXPECT_EQ(test::complaint_of([&] { icub.write({one}); }),
            "taxel 100000: has an id that is no row number from 0 to 99999");
  one.layout.taxels[0].id = -1;
  EXPECT_EQ(test::complaint_of([&] { icub.write({one}); }),
            "taxel -1: has an id that is no row number from 0 to 99999");
}

TEST(FormatLimits, PosesAreAHundredThousand) {
  for (const int count : {kMost, kMost + 1}) {
    std::vector<double> poses;
    for (int i = 0; i < count; ++i) poses.insert(poses.end(), {1, 0, 0, 7, 0, 1, 0, 8, 0, 0, 1, 9});
    NpzWriter npz;
    npz.add("poses", {static_cast<std::size_t>(count), 3, 4}, poses);
    EXPECT_EQ(reading("npz", npz.bytes()),
              count == kMost ? "accepted" : "f: poses: has 100001 poses, at most 100000 are read");
  }
}

TEST(FormatLimits, ProbesAreAHundredThousandInAllLinks) {
  const std::string probe = R"({"pos":[0,0,1],"normal":[0,0,1],"radius":1})";
  const std::string first = R"([{"link_name":"a","probes":[)" + repeated(probe + ",", kMost - 2) + probe + "]}";
  const auto with_link = [&](const std::string& probes) {
    return first + R"(,{"link_name":"b","probes":[)" + probes + "]}]";
  };
  EXPECT_EQ(reading("genesis", with_link(probe + "," + probe)),
            "f: /1/probes/1: is beyond the 100000 probes that are read");
}

TEST(FormatLimits, TaxelsOfUrdfAreAHundredThousandInAllSensors) {
  const auto sensor = [](const std::string& tactile) {
    return "<sensor name=\"s\"><parent link=\"l\"/><tactile>" + tactile + "</tactile></sensor>";
  };
  const auto urdf = [&](const std::string& tactile) { return "<robot name=\"r\">" + sensor(tactile) + "</robot>"; };
  EXPECT_EQ(reading("urdf", urdf("<array rows=\"400\" cols=\"250\" size=\"1 1\"/>")), "accepted");
  EXPECT_EQ(reading("urdf", urdf("<array rows=\"400\" cols=\"251\" size=\"1 1\"/>")),
            "f: line 1, <array>: has 400 x 251 taxels, at most 100000 are read");
  EXPECT_EQ(reading("urdf", urdf(repeated("<taxel idx=\"0\"/>", kMost))), "accepted");
  EXPECT_EQ(reading("urdf", urdf(repeated("<taxel idx=\"0\"/>", kMost + 1))),
            "f: line 1, <tactile>: has 100001 taxels, at most 100000 are read");
  const std::string half = sensor("<array rows=\"400\" cols=\"125\" size=\"1 1\"/>");
  EXPECT_EQ(reading("urdf", "<robot>" + half + half + "</robot>"), "accepted");
  EXPECT_EQ(reading("urdf", "<robot>" + half + half + sensor("<taxel idx=\"0\"/>") + "</robot>"),
            "f: line 1, <sensor>: is beyond the 100000 taxels that are read");
}

using Writer = WrittenLayouts (*)(const std::vector<ImportedLayout>&);

/// Writes tables or probes after a change of the taxels.
template <class Change>
WrittenLayouts write_changed(const char* word, std::vector<ImportedLayout> layouts, const Change& change) {
  change(layouts);
  return find_layout_format(word)->write(layouts);
}

// Each of these writers has one fault. A writer that only changes the order of the taxels loses nothing.
TEST(CheckedLayouts, RefuseAWriterThatLosesOrMovesATaxel) {
  ImportedLayout one;
  one.layout.name = "tip";
  for (int i = 0; i < 3; ++i) one.layout.taxels.push_back({i, "", dvec3(i, 1, 2), dvec3(0, 0, 1), 0.006, {}});
  LayoutFormat csv = *find_layout_format("csv");
  const std::string refusal = "a.csv: is not written: Table of taxels would not hold all taxels with their ids";
  const auto written = [&](const LayoutFormat& format, const std::vector<ImportedLayout>& layouts) {
    return test::complaint_of([&] { checked_layouts(format, layouts, "a.csv"); });
  };
  EXPECT_EQ(written(csv, {one}), "accepted");
  using Layouts = std::vector<ImportedLayout>;
  const Writer faulty[] = {
      [](const Layouts& l) { return write_changed("csv", l, [](Layouts& c) { c[0].layout.taxels.pop_back(); }); },
      [](const Layouts& l) { return write_changed("csv", l, [](Layouts& c) { c[0].layout.taxels[2].id = 9; }); },
      [](const Layouts& l) {
        return write_changed("csv", l, [](Layouts& c) { c[0].layout.taxels[2].center.z += 1e-15; });
      },
      [](const Layouts& l) {
        return write_changed("csv", l,
                             [](Layouts& c) { std::swap(c[0].layout.taxels[0].id, c[0].layout.taxels[1].id); });
      },
      [](const Layouts& l) {
        return write_changed("csv", l, [](Layouts& c) { c[0].layout.taxels.push_back(c[0].layout.taxels[0]); });
      }};
  const test::TempFolder folder;
  for (const Writer writer : faulty) {
    csv.write = writer;
    EXPECT_EQ(written(csv, {one}), refusal) << &writer - faulty;
    const std::filesystem::path file = folder / "a.csv";
    EXPECT_EQ(test::complaint_of([&] { write_layout_as(csv, file, one.layout); }).substr(file.string().size()),
              refusal.substr(5));
    EXPECT_FALSE(std::filesystem::exists(file));
  }
  csv.write = [](const Layouts& l) {
    return write_changed("csv", l, [](Layouts& c) { std::swap(c[0].layout.taxels[0], c[0].layout.taxels[2]); });
  };
  EXPECT_EQ(written(csv, {one}), "accepted") << "another order";
  LayoutFormat genesis = *find_layout_format("genesis");
  genesis.write = [](const Layouts& l) { return write_changed("genesis", l, [](Layouts& c) { c.pop_back(); }); };
  ImportedLayout other = one;
  other.layout.name = "thumb";
  EXPECT_EQ(written(genesis, {one, other}).substr(0, 23), "a.csv: is not written: ") << "a layout is lost";
}

}  // namespace
}  // namespace taxel
