// `taxel presets`: the list, and a written layout that runs.
#include "cli/taxel_program.h"

namespace taxel::test {
namespace {

namespace fs = std::filesystem;

TEST(PresetsCommand, ListsAllAndWritesLayoutsWithoutProblems) {
  const fs::path folder = test_folder();
  const Json presets = taxel_json({"presets"})["presets"];
  ASSERT_EQ(presets.size(), 9U);
  for (const Json& preset : presets) {
    const std::string name = preset["name"], file = name + ".taxels.json";
    EXPECT_FALSE(preset["source"].get<std::string>().empty()) << name;
    const Json one = taxel_json({"presets", name, "--out", file}, folder)["presets"];
    ASSERT_EQ(one.size(), 1U);
    EXPECT_EQ(one[0], preset);
    const Json layout = Json::parse(file_text(folder / file));
    EXPECT_EQ(layout["taxels"].size(), preset["taxels"].get<std::size_t>()) << name;
    EXPECT_EQ(layout["mesh"]["file"], name + ".obj");
    const Outcome check = taxel({"check", file}, folder);
    EXPECT_EQ(check.status, 0) << name << ": " << check.out << check.err;
  }
  const Json samples = taxel_json({"samples", "myrmex.taxels.json", "--quiet", "--preview"}, folder);
  EXPECT_EQ(samples["taxels"].size(), 256U);
}

TEST(PresetsCommand, RefusesUnknownNamesAndWrongOptions) {
  const fs::path folder = test_folder();
  expect_refusal(taxel({"presets", "biotack"}, folder),
                 "taxel: presets: NAME: biotack is unknown, there are fingertip, icub, biotac, xela-4x4, xela-4x6, "
                 "xela-curved, myrmex, barometers, dense");
  expect_refusal(taxel({"presets", "--out", "f.taxels.json"}, folder),
                 "taxel: presets: --out: needs the NAME of a preset");
  expect_refusal(taxel({"presets", "dense", "--out", "dense.obj"}, folder),
                 "taxel: presets: --out: dense.obj is the name of the mesh: end it with .taxels.json");
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace taxel::test
