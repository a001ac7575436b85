// The disk around the output: existing files stay, nobody else's files are touched, and computed rows are not lost.
#include <fmt/format.h>
#include <sys/stat.h>

#include <csignal>
#include <set>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

constexpr const char* kPressScenario =
    R"({"kind": "press", "hold": 0, "clearance": 0.0002, "tilt_deg": 20, "shape": "plate"})";

void pause(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

/// Returns the names of all files and folders below a folder, without the streams of Running.
std::set<std::string> names_below(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder))
    names.insert(entry.path().lexically_relative(folder).string());
  names.erase("stdout.txt"), names.erase("stderr.txt");
  return names;
}

unsigned mode_of(const fs::path& path) {
  struct stat status {};
  EXPECT_EQ(::lstat(path.c_str(), &status), 0) << path;
  return status.st_mode & 07777U;
}

Outcome in_shell(const std::string& setup, const std::string& arguments, const fs::path& folder) {
  return run_program("/bin/sh", {"-c", setup + " exec " TAXEL_PROGRAM " " + arguments}, folder);
}

/// Writes the files of a slow command of each kind, and returns its arguments before --out.
std::vector<std::string> slow_command(const std::string& kind, const fs::path& folder) {
  const std::string dense = "4e8";  // compiles for seconds
  write_text(folder / "press.json", kPressScenario);
  if (kind == "sweep") return {"sweep", "--density", dense};
  if (kind == "play") return {"play", "press.json", "--density", dense};
  if (kind == "study") {
    write_text(folder / "study.json", fmt::format(R"({{"format": "taxel-study", "version": 1, "scenario": {},
        "parameters": [{{"parameter": "depth", "values": [0.0005, 0.0006]}}]}})",
                                                  kPressScenario));
    return {"study", "study.json", "--density", dense};
  }
  if (kind == "batch") {
    write_text(
        folder / "jobs.jsonl",
        fmt::format("{{\"scenario\": {}, \"set\": {{\"/layout/sampling/density\": {}}}}}\n", kPressScenario, dense));
    return {"batch", "jobs.jsonl"};
  }
  const std::string patch = fmt::format(R"([{{"op": "replace", "path": "/sampling/density", "value": {}}}])", dense);
  const std::string layout = changed_layout(folder, Json::parse(patch)).string();
  write_text(folder / "ball.xml", R"(<mujoco><worldbody><geom name="ball" size="0.02"/></worldbody></mujoco>)");
  return {"run", "ball.xml", "--layout", layout, "--geom", "ball"};
}

class EachCommand : public testing::TestWithParam<const char*> {};

TEST_P(EachCommand, RemovesNothingOfAnotherRunNextToIt) {
  const fs::path folder = test_folder();
  std::vector<std::string> arguments = slow_command(GetParam(), folder);
  arguments.insert(arguments.end(), {"--out", "results/1"});
  const Running run(arguments, folder);
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder / "results/1") || run.has_ended(); }));
  fs::create_directories(folder / "results/2");  // as another run does
  write_text(folder / "results/2/readings.csv", "rows");
  write_text(folder / "results/1/notes.txt", "mine");
  run.send(SIGINT);
  pause(40);
  run.send(SIGINT);
  const Outcome outcome = run.wait();
  EXPECT_EQ(outcome.status, 128 + SIGINT) << outcome.err;
  EXPECT_EQ(file_text(folder / "results/2/readings.csv"), "rows");
  EXPECT_EQ(file_text(folder / "results/1/notes.txt"), "mine");
  std::set<std::string> left = names_below(folder / "results/1");
  std::erase_if(left, [](const std::string& name) { return name.starts_with(".batch"); });  // to be continued
  EXPECT_EQ(left, std::set<std::string>{"notes.txt"});
}

INSTANTIATE_TEST_SUITE_P(Of, EachCommand, testing::Values("sweep", "play", "run", "study", "batch"));

TEST(SecondSignal, EndsABatchAtOnce) {
  const fs::path folder = test_folder();
  std::vector<std::string> arguments = slow_command("batch", folder);
  arguments.insert(arguments.end(), {"--out", "out"});
  const Running run(arguments, folder);
  ASSERT_TRUE(wait_until([&] { return fs::exists(folder / "out/.batch/journal"); }));
  pause(300);
  run.send(SIGINT);
  pause(300);
  EXPECT_FALSE(run.has_ended()) << "the layout is compiled to its end";
  const auto start = std::chrono::steady_clock::now();
  run.send(SIGINT);
  EXPECT_EQ(run.wait().status, 128 + SIGINT);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

/// Waits until a run has rows on the disk.
void wait_for_rows(const Running& run, const fs::path& out, std::uintmax_t bytes) {
  std::error_code ec;
  ASSERT_TRUE(wait_until([&] {
    return run.has_ended() ||
           (fs::exists(out / "unfinished.rows", ec) && fs::file_size(out / "unfinished.rows", ec) > bytes);
  }));
}

/// Expects the first rows of a run, at least `least` of them.
void expect_first_rows(const fs::path& part, const fs::path& whole, std::size_t least) {
  const std::string rows = file_text(part), all = file_text(whole);
  EXPECT_GT(static_cast<std::size_t>(std::count(rows.begin(), rows.end(), '\n')), least);
  EXPECT_EQ(rows, all.substr(0, rows.size()));
  EXPECT_EQ(rows.back(), '\n');
}

/// A run of 3000 rows, which takes a second or more.
const std::vector<std::string> kLongRun{"run", TAXEL_SOURCE_DIR "/assets/scenes/press.xml", "--seconds", "1.5",
                                        "--out"};

std::vector<std::string> long_run(const std::string& out) {
  std::vector<std::string> arguments = kLongRun;
  arguments.push_back(out);
  return arguments;
}

TEST(SecondSignal, LeavesTheRowsAndSaysHowToGetThem) {
  const fs::path folder = test_folder();
  ASSERT_EQ(taxel(long_run("whole"), folder).status, 0);
  const Running run(long_run("out"), folder);
  wait_for_rows(run, folder / "out", 20000);
  run.send(SIGINT);
  run.send(SIGTERM);  // at once, before the first is noticed
  const Outcome outcome = run.wait();
  EXPECT_TRUE(outcome.status == 128 + SIGINT || outcome.status == 128 + SIGTERM) << outcome.status << outcome.err;
  ASSERT_TRUE(fs::exists(folder / "out"));
  if (!fs::exists(folder / "out/readings.csv")) {
    EXPECT_NE(outcome.err.find("`taxel convert out/unfinished.rows FOLDER`"), std::string::npos) << outcome.err;
    ASSERT_EQ(taxel({"convert", "out/unfinished.rows", "out"}, folder).status, 0);
  }
  expect_first_rows(folder / "out/readings.csv", folder / "whole/readings.csv", 10);
  for (const std::string& name : names_below(folder)) EXPECT_EQ(name.find(".part"), std::string::npos) << name;
}

TEST(FullDiskOfARun, LeavesTheRowsAndSaysHowToGetThem) {
  const fs::path folder = test_folder();
  ASSERT_EQ(taxel(long_run("whole"), folder).status, 0);
  const auto csv = fs::file_size(folder / "whole/readings.csv");
  // A limit of the size of each file replaces a full disk. Half of the rows fit.
  const std::string limit = fmt::format("trap '' XFSZ; ulimit -f {};", csv / 512 / 2);
  const Outcome full = in_shell(limit, fmt::format("{}", fmt::join(long_run("out"), " ")), folder);
  EXPECT_EQ(full.status, 2) << full.err;
  EXPECT_NE(full.err.find("writing failed: File too large; the "), std::string::npos) << full.err;
  EXPECT_NE(full.err.find(" rows so far are in out/unfinished.rows: `taxel convert out/unfinished.rows FOLDER`"),
            std::string::npos)
      << full.err;
  EXPECT_EQ(names_below(folder / "out"), (std::set<std::string>{"unfinished.npz", "unfinished.rows"}));
  ASSERT_EQ(taxel({"convert", "out/unfinished.rows", "rows"}, folder).status, 0);
  expect_first_rows(folder / "rows/readings.csv", folder / "whole/readings.csv", 200);
  const Outcome next = taxel(long_run("out"), folder);
  EXPECT_EQ(next.status, 0) << next.err;
  EXPECT_EQ(file_text(folder / "out-recovered/readings.csv"), file_text(folder / "rows/readings.csv"));
  EXPECT_EQ(file_text(folder / "out/readings.csv"), file_text(folder / "whole/readings.csv"));
}

TEST(FileSizeLimit, IsAnErrorThatLeavesNoPart) {
  const fs::path folder = test_folder();
  const std::string layout = fingertip_layout().string();
  const Outcome outcome = in_shell("ulimit -f 8;", "samples " + layout + " --density 1e6 --out s.csv --quiet", folder);
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "taxel: s.csv: writing failed: File too large\n");
  EXPECT_TRUE(names_below(folder).empty());
}

TEST(ClosedStreams, DoNotEndTheHandlerOfASignal) {
  const fs::path folder = test_folder();
  const Outcome outcome = run_program(
      "/bin/sh",
      {"-c", TAXEL_PROGRAM " sweep --density 4e8 --out out >&- 2>&- & pid=$!; while [ ! -e out ]; do sleep 0.05; done; "
                           "kill -TERM $pid; wait $pid"},
      folder);
  EXPECT_EQ(outcome.status, 128 + SIGTERM);
  EXPECT_FALSE(fs::exists(folder / "out"));
}

TEST(ClosedStreams, AreNoFilesOfTheRun) {
  const fs::path folder = test_folder();
  write_text(folder / "press.json", kPressScenario);
  const std::string play = "play press.json --density 1e5 --depth 0.02 --out ";
  const std::vector<std::string> files{"readings.csv", "readings.npz", "scene.xml", "scenario.json"};
  ASSERT_EQ(in_shell("", "play press.json --density 1e5 --out whole", folder).status, 0);
  const Outcome closed = in_shell("", "play press.json --density 1e5 --out out 0<&- 1>&- 2>&-", folder);
  EXPECT_EQ(closed.status, 2) << "the report cannot be printed";
  for (const std::string& file : files)
    EXPECT_EQ(file_text(folder / "out" / file), file_text(folder / "whole" / file)) << file;
}

/// A command that writes a file, with the file as its last argument.
struct Writer {
  const char* name;
  std::vector<std::string> arguments;
};

std::vector<Writer> writers(const fs::path& folder) {
  const std::string layout = fingertip_layout().string();
  const std::string mesh = TAXEL_SOURCE_DIR "/assets/meshes/fingertip.obj";
  write_text(folder / "a.csv", "id,x,y,z,nx,ny,nz,radius\n0,0,0,0.01,0,0,1,0.004\n");
  return {{"samples", {"samples", layout, "--density", "1e4", "--out"}},
          {"fields", {"samples", layout, "--density", "1e4", "--fields"}},
          {"mesh", {"mesh", mesh, "--out"}},
          {"convert", {"convert", layout, "--to", "csv"}},
          {"plot", {"plot", shared_box_sweep().string(), "--out"}},
          {"messages", {"convert", shared_box_sweep().string()}}};
}

std::string extension_of(const std::string& writer) {
  return writer == "mesh" ? ".stl" : writer == "plot" ? ".svg" : writer == "messages" ? ".jsonl" : ".csv";
}

TEST(EachWriter, KeepsRightsAndLinks) {
  const fs::path folder = test_folder();
  for (const Writer& writer : writers(folder)) {
    const std::string extension = extension_of(writer.name);
    const fs::path file = folder / ("real" + extension), link = folder / ("link" + extension),
                   twin = folder / ("twin" + extension);
    const auto write = [&](const fs::path& target) {
      std::vector<std::string> arguments = writer.arguments;
      arguments.push_back(target.string());
      const Outcome outcome = taxel(arguments, folder);
      EXPECT_EQ(outcome.status, 0) << writer.name << ": " << outcome.err;
    };
    for (const fs::path& old : {file, link, twin}) fs::remove(old);
    write_text(file, "old");
    ASSERT_EQ(::chmod(file.c_str(), 0600), 0);
    fs::create_symlink(file.filename(), link);
    write(link);
    EXPECT_TRUE(fs::is_symlink(link)) << writer.name;
    EXPECT_EQ(mode_of(file), 0600U) << writer.name;
    const std::string bytes = file_text(file);
    EXPECT_NE(bytes, "old") << writer.name;
    fs::create_hard_link(file, twin);
    write_text(file, "old");
    write(file);
    EXPECT_EQ(file_text(twin), bytes) << writer.name;
    EXPECT_EQ(mode_of(twin), 0600U) << writer.name;
  }
}

TEST(EachWriter, WritesIntoPipesAndDevices) {
  const fs::path folder = test_folder();
  for (const Writer& writer : writers(folder)) {
    const std::string extension = extension_of(writer.name);
    const fs::path file = folder / ("file" + extension), pipe = folder / ("pipe" + extension),
                   null = folder / ("null" + extension), full = folder / ("full" + extension);
    for (const fs::path& old : {file, pipe, null, full}) fs::remove(old);
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    fs::create_symlink("/dev/null", null);
    fs::create_symlink("/dev/full", full);
    const auto write = [&](const fs::path& target, const std::string& setup) {
      return in_shell(setup, fmt::format("{} {} > /dev/null", fmt::join(writer.arguments, " "), target.string()),
                      folder);
    };
    ASSERT_EQ(write(file, "").status, 0) << writer.name;
    const Outcome read = write(pipe, "timeout 60 cat " + pipe.string() + " > copy & sleep 0.1;");
    EXPECT_EQ(read.status, 0) << writer.name << read.err;
    EXPECT_TRUE(wait_until([&] { return file_text(folder / "copy") == file_text(file); })) << writer.name;
    EXPECT_EQ(write(null, "").status, 0) << writer.name;
    const Outcome no_room = write(full, "");
    EXPECT_EQ(no_room.status, 2) << writer.name;
    EXPECT_NE(no_room.err.find(": writing failed: No space left on device"), std::string::npos) << no_room.err;
    EXPECT_TRUE(fs::is_fifo(pipe)) << writer.name;
    EXPECT_TRUE(fs::is_symlink(null) && fs::is_symlink(full)) << writer.name;
    EXPECT_TRUE(fs::is_character_file("/dev/null") && fs::is_character_file("/dev/full")) << writer.name;
  }
}

TEST(EachWriter, RefusesAPipeThatNobodyReads) {
  const fs::path folder = test_folder();
  ASSERT_EQ(::mkfifo((folder / "s.csv").c_str(), 0600), 0);
  expect_refusal(
      taxel({"samples", fingertip_layout().string(), "--density", "1e4", "--out", "s.csv", "--quiet"}, folder),
      "taxel: s.csv: cannot be written: no program reads it");
  EXPECT_TRUE(fs::is_fifo(folder / "s.csv"));
}

TEST(EachWriter, GoesOnInTheFileOfStdout) {
  const fs::path folder = test_folder();
  fs::create_symlink("/proc/self/fd/1", folder / "stdout.csv");  // as /dev/stdout is
  const std::string layout = fingertip_layout().string();
  const Outcome plain = taxel({"samples", layout, "--density", "1e4", "--out", "s.csv"}, folder);
  ASSERT_EQ(plain.status, 0);
  const Outcome both = in_shell("", "samples " + layout + " --density 1e4 --out stdout.csv > both", folder);
  EXPECT_EQ(both.status, 0) << both.err;
  const std::string text = file_text(folder / "both"), csv = file_text(folder / "s.csv");
  EXPECT_EQ(text.substr(0, csv.size()), csv);
  EXPECT_GT(text.size(), csv.size()) << "the report follows";
  EXPECT_TRUE(fs::is_symlink(folder / "stdout.csv"));
}

TEST(RunFolder, KeepsRightsAndLinksOfItsFiles) {
  const fs::path folder = test_folder();
  write_text(folder / "press.json", kPressScenario);
  fs::create_directories(folder / "out");
  write_text(folder / "elsewhere.csv", "old");
  fs::create_symlink("../elsewhere.csv", folder / "out/readings.csv");
  write_text(folder / "out/readings.npz", "old");
  ASSERT_EQ(::chmod((folder / "out/readings.npz").c_str(), 0600), 0);
  ASSERT_EQ(taxel({"play", "press.json", "--density", "1e5", "--out", "out", "--quiet"}, folder).status, 0);
  EXPECT_TRUE(fs::is_symlink(folder / "out/readings.csv"));
  EXPECT_EQ(file_text(folder / "elsewhere.csv").substr(0, 5), "time,");
  EXPECT_EQ(mode_of(folder / "out/readings.npz"), 0600U);
}

TEST(UnfinishedRows, AreRecoveredIntoTheirOwnFolderOnly) {
  const fs::path folder = test_folder();
  const Running run(long_run("out"), folder);
  wait_for_rows(run, folder / "out", 20000);
  run.send(SIGKILL);
  run.wait();
  std::string rows = file_text(folder / "out/unfinished.rows");
  const std::size_t begin = rows.find('\n') + 1, end = rows.find('\n', begin);
  rows.replace(begin, end - begin, (folder / "elsewhere/deep").string());
  fs::create_directories(folder / "moved");
  write_text(folder / "moved/unfinished.rows", rows);
  fs::rename(folder / "out/unfinished.npz", folder / "moved/unfinished.npz");
  const Outcome next = taxel({"sweep", "--object", "box", "--density", "1e5", "--out", "moved"}, folder);
  EXPECT_EQ(next.status, 0) << next.err;
  EXPECT_FALSE(fs::exists(folder / "elsewhere"));
  EXPECT_TRUE(fs::exists(folder / "moved-recovered/readings.csv"));
}

TEST(BatchFolder, IsLookedAtBeforeItIsCalledComplete) {
  const fs::path folder = test_folder();
  write_text(folder / "jobs.jsonl", fmt::format(R"({{"scenario": {}, "set": {{"/layout/sampling/density": 1e4}}}})"
                                                "\n",
                                                kPressScenario));
  const auto batch = [&](const std::vector<std::string>& options = {}) {
    std::vector<std::string> words{"batch", "jobs.jsonl", "--out", "done", "--json"};
    words.insert(words.end(), options.begin(), options.end());
    return taxel(words, folder);
  };
  ASSERT_EQ(batch().status, 0);
  EXPECT_EQ(Json::parse(batch().out)["was_complete"], true);

  EXPECT_EQ(batch({"--npz"}).err, "taxel: warning: done/runs/ID.npz: is missing, and is made again\n");
  EXPECT_EQ(Json::parse(batch({"--npz"}).out)["was_complete"], true);
  const fs::path run = fs::directory_iterator(folder / "done/runs")->path();
  fs::remove(run);
  EXPECT_EQ(batch({"--npz"}).err,
            "taxel: warning: done/runs/" + run.filename().string() + ": is missing, and is made again\n");
  EXPECT_TRUE(fs::exists(run));

  const std::string shard = "done/shards/" + fs::directory_iterator(folder / "done/shards")->path().filename().string();
  write_text(folder / "done/notes.txt", "mine");
  for (const std::string& name : {shard, std::string("done/episodes.jsonl")}) {
    const std::string bytes = file_text(folder / name);
    fs::remove(folder / name);
    const Outcome again = batch();
    EXPECT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(again.err, "taxel: warning: " + name + ": is missing, and is made again\n");
    EXPECT_EQ(file_text(folder / name), bytes);
    EXPECT_EQ(file_text(folder / "done/notes.txt"), "mine");
    write_text(folder / name, bytes.substr(1) + "x");  // of the same size
    expect_refusal(batch(),
                   "taxel: " + name +
                       ": is not as the batch has written it: remove it to have it written again, or give another "
                       "folder");
    write_text(folder / name, bytes);
  }
}

}  // namespace
}  // namespace taxel::test
