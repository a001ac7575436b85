// Every file of tests/fixtures/broken through `taxel check` and the command that would use it: each gives the
// expected error or warning within 5 s and 1 GB. Files that cannot be in the repository are made here.
#include <sys/stat.h>

#include <algorithm>
#include <sstream>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

const fs::path kBroken = fs::path(TAXEL_SOURCE_DIR) / "tests" / "fixtures" / "broken";

/// A line of expected.tsv.
struct BrokenFile {
  std::string name;     ///< name of the file
  std::string command;  ///< command that uses the file
  std::string message;  ///< part of the message of `taxel check`
};

std::vector<BrokenFile> broken_files() {
  std::vector<BrokenFile> files;
  std::istringstream lines(file_text(kBroken / "expected.tsv"));
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with('#')) continue;
    const std::size_t first = line.find('\t'), second = line.find('\t', first + 1);
    files.push_back({line.substr(0, first), line.substr(first + 1, second - first - 1), line.substr(second + 1)});
  }
  return files;
}

/// Runs taxel with at most 5 s and about 1 GB of address space, which includes libraries and threads. The sanitizers
/// reserve much more address space and take much longer.
Outcome bounded_taxel(const std::vector<std::string>& arguments, const fs::path& folder) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  std::vector<std::string> words{"60", TAXEL_PROGRAM};
#else
  std::vector<std::string> words{"5", "/bin/sh", "-c", "ulimit -v 1500000; exec \"$0\" \"$@\"", TAXEL_PROGRAM};
#endif
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program("/usr/bin/timeout", words, folder);
}

/// Expects that a file is refused, or used with a warning.
void expect_not_silent(const Outcome& outcome) {
  const bool warned = outcome.status == 0 && outcome.err.find("warning: ") != std::string::npos;
  EXPECT_TRUE(outcome.status == 1 || outcome.status == 2 || warned) << "exit status " << outcome.status;
  EXPECT_EQ(outcome.err.find("taxel: unexpected"), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.err.find("out of memory"), std::string::npos) << outcome.err;
}

TEST(BrokenFiles, AreRefusedWithTheirMessage) {
  const std::vector<BrokenFile> files = broken_files();
  EXPECT_GE(files.size(), 150U);
  for (const BrokenFile& file : files) {
    SCOPED_TRACE(file.name);
    ASSERT_TRUE(fs::exists(kBroken / file.name));
    const Outcome check = bounded_taxel({"check", file.name}, kBroken);
    expect_not_silent(check);
    EXPECT_NE((check.out + check.err).find(file.message), std::string::npos) << check.out << check.err;
    if (file.command != "check") expect_not_silent(bounded_taxel({file.command, file.name}, kBroken));
  }
}

TEST(BrokenFiles, AreAllListed) {
  std::vector<std::string> listed{"expected.tsv", "ball.off"}, present;
  for (const BrokenFile& file : broken_files()) listed.push_back(file.name);
  for (const fs::directory_entry& entry : fs::directory_iterator(kBroken))
    present.push_back(entry.path().filename().string());
  std::sort(listed.begin(), listed.end());
  std::sort(present.begin(), present.end());
  EXPECT_EQ(listed, present);
}

/// Pipes, devices and folders with the names of files are refused without waiting.
TEST(BrokenFiles, AreRefusedIfTheyAreNotRegularFiles) {
  const fs::path folder = test_folder();
  for (const std::string name :
       {"f.obj", "f.ply", "f.gltf", "f.taxels.json", "f.taxelproj", "f.csv", "f.yaml", "f.xml", "f.json"}) {
    SCOPED_TRACE(name);
    const std::string command = name == "f.xml" ? "run" : name == "f.json" ? "play" : "check";
    ASSERT_EQ(::mkfifo((folder / name).c_str(), 0600), 0);
    for (const std::string& word : {std::string("check"), command}) {
      const Outcome pipe = bounded_taxel({word, name}, folder);
      EXPECT_EQ(pipe.status, 2);
      EXPECT_NE(pipe.err.find(name + ": is not a regular file"), std::string::npos) << pipe.err;
    }
    fs::remove(folder / name);
    fs::create_symlink("/dev/zero", folder / name);
    EXPECT_NE(bounded_taxel({"check", name}, folder).err.find("is not a regular file"), std::string::npos);
    fs::remove(folder / name);
    fs::create_directory(folder / name);
    EXPECT_EQ(bounded_taxel({"check", name}, folder).status, 2);
  }
}

TEST(BrokenFiles, AreRefusedIfTheMeshOfALayoutIsNotRegular) {
  const fs::path folder = test_folder();
  ASSERT_EQ(::mkfifo((folder / "m.obj").c_str(), 0600), 0);
  const fs::path layout =
      changed_layout(folder, Json::parse(R"([{"op": "replace", "path": "/mesh/file", "value": "m.obj"}])"));
  for (const char* command : {"check", "samples"}) {
    const Outcome outcome = bounded_taxel({command, layout.string()}, folder);
    EXPECT_NE(outcome.status, 0);
    EXPECT_NE((outcome.out + outcome.err).find("m.obj: is not a regular file"), std::string::npos) << outcome.err;
  }
}

TEST(BrokenFiles, AreRefusedIfASceneNamesAnIrregularFile) {
  const fs::path folder = test_folder();
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  const std::string box = "<worldbody><geom type=\"box\" size=\"1 1 1\"/></worldbody></mujoco>";
  for (const char* part :
       {"<asset><mesh name=\"m\" file=\"pipe\" content_type=\"model/obj\"/></asset>",
        "<asset><hfield name=\"h\" file=\"pipe\" size=\"1 1 1 1\"/></asset>",
        "<asset><skin name=\"s\" file=\"pipe\"/></asset>",
        "<asset><texture name=\"t\" type=\"2d\" file=\"pipe\"/></asset>",
        "<asset><texture name=\"t\" type=\"cube\" fileup=\"pipe\"/></asset>", "<include file=\"pipe\"/>"}) {
    SCOPED_TRACE(part);
    write_text(folder / "scene.xml", "<mujoco>" + (part + box));
    for (const char* command : {"run", "check"}) {
      const Outcome outcome = bounded_taxel({command, "scene.xml"}, folder);
      EXPECT_NE(outcome.status, 0);
      EXPECT_NE(outcome.err.find("scene.xml: pipe: is not a regular file"), std::string::npos) << outcome.err;
    }
  }
}

/// A recording with one flipped bit is refused by all commands that read recordings.
TEST(BrokenFiles, AreRefusedIfARecordingMissesItsChecksum) {
  const fs::path folder = test_folder(), run = shared_box_sweep({"--density", "1e6"});
  for (const fs::directory_entry& entry : fs::directory_iterator(run)) fs::copy(entry, folder);
  std::string bytes = file_text(folder / "readings.npz");
  bytes[bytes.find("readings.npy") + 12 + 128 + 4] ^= 1;  // after its name and NPY's header of 128 bytes
  write_text(folder / "readings.npz", bytes);
  write_text(folder / "replay.json", R"({"kind": "replay", "source": "."})");
  using Arguments = std::vector<std::string>;
  for (const Arguments& arguments : {Arguments{"explain", ".", "--taxel", "4", "--time", "1"},
                                     Arguments{"align", ".", "readings.csv"}, Arguments{"play", "replay.json"}}) {
    const Outcome outcome = bounded_taxel(arguments, folder);
    EXPECT_EQ(outcome.status, 2) << arguments[0];
    EXPECT_NE(outcome.err.find("readings: is broken off or damaged"), std::string::npos) << outcome.err;
  }
}

TEST(BrokenFiles, AreNotWrittenByRunsWithoutSteps) {
  const fs::path folder = test_folder();
  write_text(folder / "scene.xml",
             "<mujoco><worldbody><body><freejoint/><geom name=\"finger\" type=\"mesh\" mesh=\"m\"/>"
             "</body></worldbody><asset><mesh name=\"m\" file=\"" +
                 (fs::path(TAXEL_SOURCE_DIR) / "assets/meshes/fingertip.obj").string() + "\"/></asset></mujoco>");
  expect_refusal(taxel({"run", "scene.xml", "--layout", fingertip_layout().string(), "--geom", "finger", "--seconds",
                        "1e-6", "--out", "out"},
                       folder),
                 "taxel: run: --seconds: must be at least half of the time step, 0.002 s, is 1e-06 s: no row would be "
                 "recorded");
  EXPECT_FALSE(fs::exists(folder / "out"));
}

}  // namespace
}  // namespace taxel::test
