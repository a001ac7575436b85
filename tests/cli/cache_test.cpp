// `taxel cache`: samples that one process keeps and the next one finds, and their removal.
#include "cli/taxel_program.h"
#include "fixtures/surroundings.h"

namespace taxel::test {
namespace {

namespace fs = std::filesystem;

/// Returns the variables by which programs keep samples below a folder.
Surroundings kept_in(const fs::path& folder, const std::string& megabytes = "") {
  return Surroundings({{"XDG_CACHE_HOME", folder.string()}, {"TAXEL_SAMPLE_CACHE", megabytes}});
}

TEST(CacheCommand, ListsAndRemovesWhatProgramsKeep) {
  const fs::path folder = test_folder(), layout = fingertip_layout();
  const Surroundings set = kept_in(folder);
  Json cache = taxel_json({"cache"});
  EXPECT_EQ(cache["skins"], 0);
  EXPECT_EQ(cache["max_bytes"], 1'000'000'000);
  const std::vector<std::string> samples{"samples", layout.string(), "--density", "1e6", "--out"};
  const auto written = [&](const std::string& name) {
    std::vector<std::string> arguments = samples;
    arguments.push_back((folder / name).string());
    taxel_json(arguments);
    return file_text(folder / name);
  };
  const std::string first = written("first.csv");
  cache = taxel_json({"cache"});
  EXPECT_EQ(cache["skins"], 1);
  EXPECT_EQ(cache["folder"], (folder / "taxelstudio" / "samples").string());
  EXPECT_EQ(written("second.csv"), first);
  EXPECT_EQ(taxel_json({"cache"})["skins"], 1);
  EXPECT_NE(taxel({"cache"}).out.find("samples of 1 skin, "), std::string::npos);
  const Json cleared = taxel_json({"cache", "--clear"});
  EXPECT_EQ(cleared["removed_skins"], 1);
  EXPECT_EQ(cleared["removed_bytes"], cache["bytes"]);
  EXPECT_EQ(taxel_json({"cache"})["bytes"], 0);
  EXPECT_EQ(written("third.csv"), first);
}

TEST(CacheCommand, KeepsNothingIfItIsOff) {
  const fs::path folder = test_folder();
  const Surroundings set = kept_in(folder, "off");
  taxel_json({"samples", fingertip_layout().string(), "--density", "1e6"});
  EXPECT_TRUE(fs::is_empty(folder));
  EXPECT_EQ(taxel_json({"cache"})["on"], false);
  EXPECT_NE(taxel({"cache", "--clear"}).out.find("TAXEL_SAMPLE_CACHE is \"off\""), std::string::npos);
}

TEST(CacheCommand, RefusesAWrongBound) {
  const fs::path folder = test_folder();
  const Surroundings set = kept_in(folder, "lots");
  expect_refusal(taxel({"cache"}),
                 "taxel: TAXEL_SAMPLE_CACHE: must be \"off\" or the most megabytes of samples to keep on disk, is "
                 "\"lots\"");
}

}  // namespace
}  // namespace taxel::test
