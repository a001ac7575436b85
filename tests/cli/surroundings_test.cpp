// Unusual machines: full disks, folders that cannot be written, no home, a locale with decimal commas.
#include <unistd.h>

#include <algorithm>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Runs taxel in a shell after `setup`.
Outcome taxel_after(const std::string& setup, const std::string& arguments, const fs::path& folder) {
  return run_program("/bin/sh", {"-c", setup + "; exec " TAXEL_PROGRAM " " + arguments}, folder);
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    names.push_back(entry.path().filename().string());
  return names;
}

TEST(Surroundings, LeaveNothingOfAFileThatDoesNotFit) {
  const fs::path folder = test_folder();
  // A limit of 4 kB for each file replaces a full disk: writing fails in the same place.
  const std::string full = "trap '' XFSZ; ulimit -f 8";
  const Outcome sweep = taxel_after(full, "sweep --object box --density 1e5 --out out --quiet", folder);
  EXPECT_EQ(sweep.status, 2);
  EXPECT_EQ(sweep.err.find(".part"), std::string::npos) << sweep.err;
  EXPECT_NE(sweep.err.find("/out/"), std::string::npos) << sweep.err;
  EXPECT_NE(sweep.err.find("writing failed: File too large"), std::string::npos) << sweep.err;
  const Outcome samples =
      taxel_after(full, "samples " + fingertip_layout().string() + " --density 1e6 --out s.csv --quiet", folder);
  EXPECT_EQ(samples.err, "taxel: s.csv: writing failed: File too large\n");
  EXPECT_TRUE(names_in(folder).empty()) << names_in(folder).front();
}

TEST(Surroundings, KeepTheOldFilesIfAFolderIsInTheWay) {
  const fs::path folder = test_folder();
  fs::create_directories(folder / "out/scene.xml");
  write_text(folder / "out/readings.csv", "old");
  const Outcome sweep = taxel({"sweep", "--object", "box", "--density", "1e5", "--out", "out", "--quiet"}, folder);
  EXPECT_EQ(sweep.status, 2);
  EXPECT_NE(sweep.err.find("out/scene.xml: is a folder, a file is needed; no file was written"), std::string::npos)
      << sweep.err;
  EXPECT_EQ(file_text(folder / "out/readings.csv"), "old");
  std::vector<std::string> names = names_in(folder / "out");
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"readings.csv", "scene.xml", "unfinished.npz", "unfinished.rows"}));
}

TEST(Surroundings, AreRefusedBeforeTheRunIfReadOnly) {
  const fs::path folder = test_folder();
  fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
  // Root can write everywhere, but not without this capability.
  std::vector<std::string> words{TAXEL_PROGRAM, "sweep", "--out", "out"};
  if (::geteuid() == 0) words.insert(words.begin(), {"setpriv", "--bounding-set", "-dac_override"});
  const Outcome sweep = run_program("/usr/bin/env", words, folder);
  fs::permissions(folder, fs::perms::owner_all);
  expect_refusal(sweep, "taxel: out: folder cannot be made: Permission denied");
}

TEST(Surroundings, MayLackAHomeAndAnEnvironment) {
  const fs::path folder = test_folder();
  const Outcome bare = run_program("/usr/bin/env", {"-i", TAXEL_PROGRAM, "check", fingertip_layout().string()}, folder);
  EXPECT_EQ(bare.status, 0) << bare.err;
  EXPECT_EQ(bare.out, taxel({"check", fingertip_layout().string()}, folder).out);
}

TEST(Surroundings, GiveTheSameNumbersWithDecimalCommas) {
  const fs::path folder = test_folder();
  // A locale for this test only, compiled from the definitions of the package "locales".
  ASSERT_EQ(run_program("/usr/bin/localedef", {"-i", "de_DE", "-f", "UTF-8", "./de_DE.UTF-8"}, folder).status, 0);
  const std::string german = "export LOCPATH=" + folder.string() + " LC_ALL=de_DE.UTF-8";
  const Outcome comma = run_program("/bin/sh", {"-c", german + "; locale decimal_point"}, folder);
  ASSERT_EQ(comma.out, ",\n") << comma.err;
  const std::string arguments = "sweep --object box --depth 0.0012 --density 1e5 --quiet --out ";
  ASSERT_EQ(taxel_after(german, arguments + "comma", folder).status, 0);
  ASSERT_EQ(taxel_after("export LC_ALL=C", arguments + "point", folder).status, 0);
  for (const char* file : {"readings.csv", "scene.xml"})
    EXPECT_EQ(file_text(folder / "comma" / file), file_text(folder / "point" / file)) << file;
}

TEST(ManySamples, GiveAWarningBeforeTheyAreMade) {
  const fs::path folder = test_folder();
  const auto samples = [&](const std::string& density) {
    return run_program(
        "/usr/bin/timeout",
        {"1", TAXEL_PROGRAM, "samples", fingertip_layout().string(), "--density", density, "--out", "s.csv"}, folder);
  };
  const Outcome many = samples("5e9");
  EXPECT_EQ(many.status, 124) << "it is ended while they are made";
  EXPECT_NE(
      many.err.find("/sampling/density: 5000000000 per square metre gives up to 8.52e+06 samples, which need about "
                    "12.7 GiB of memory"),
      std::string::npos)
      << many.err;
  EXPECT_TRUE(names_in(folder).empty()) << names_in(folder).front();
  EXPECT_EQ(samples("1e5").err.find("GiB"), std::string::npos);
}

}  // namespace
}  // namespace taxel::test
