// Unsaved edits after a kill, after a signal, and with an idle window.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <functional>
#include <sstream>
#include <thread>
#include <utility>

#include "script_lines.h"

namespace taxel::test {
namespace {

using Clock = std::chrono::steady_clock;

/// Opens the layout and sets the radius of taxel 3 to three millimetres.
const Lines kEdit{kLayoutMode,  kIdle, R"({"event": "click", "at": {"taxel": 3}})", kIdle, key("f"), type("3"), kIdle,
                  key("Enter"), kIdle};
/// Sets the radius of all taxels without the mouse, because in real time a click takes an unknown time.
const Lines kLiveEdit{kIdle, kLayoutMode, kIdle, key("a"),     kIdle, key("f"),
                      kIdle, type("3"),   kIdle, key("Enter"), kIdle};
const std::vector<std::string> kNextStart{"--empty", "--state-dir", "state"};

double radius_of_3(const Json& layout) {
  return taxel_of(layout, 3)["radius"];
}

/// The program with a script that never ends. A signal ends the program.
class EndlessRun {
 public:
  EndlessRun(const StudioProgram& studio, Lines lines, const std::string& autosave_every, bool live = false) {
    lines.push_back(R"({"frame": 100000000, "do": "quit"})");
    std::string script;
    for (const std::string& line : lines) script += line + "\n";
    write_text(studio.folder() / "endless.jsonl", script);
    std::vector<std::string> arguments{STUDIO_PROGRAM, "--script",         "endless.jsonl", "--state-dir",
                                       "state",        "--autosave-every", autosave_every,  kLayoutFile};
    if (live) arguments.emplace_back("--live");
    if (!in_a_window()) arguments.emplace_back("--headless");
    std::vector<char*> list;
    for (std::string& argument : arguments) list.push_back(argument.data());
    list.push_back(nullptr);
    child_ = ::fork();
    if (child_ != 0) return;
    if (::chdir(studio.folder().c_str()) != 0) ::_exit(125);
    ::execv(STUDIO_PROGRAM, list.data());
    ::_exit(126);
  }
  ~EndlessRun() {
    if (child_ > 0) end(SIGKILL);
  }
  EndlessRun(const EndlessRun&) = delete;
  EndlessRun& operator=(const EndlessRun&) = delete;

  /// Polls until `done` holds, for two minutes at most.
  static bool wait_for(const std::function<bool()>& done) {
    const auto deadline = Clock::now() + std::chrono::seconds(120);
    while (!done() && Clock::now() < deadline) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    return done();
  }
  /// Sends a signal and returns the status of the program as waitpid() reports it.
  int end(int signal) {
    ::kill(child_, signal);
    int status = 0;
    ::waitpid(std::exchange(child_, -1), &status, 0);
    return status;
  }

 private:
  pid_t child_ = -1;
};

bool is_kept(const StudioProgram& studio) {
  std::error_code ignored;
  for (const auto& entry : std::filesystem::directory_iterator(studio.folder() / "state/autosave", ignored))
    if (entry.path().extension() == ".taxelproj") return true;
  return false;
}

/// Kills the program as soon as its edit is on disk.
void edit_and_kill(const StudioProgram& studio) {
  EndlessRun run(studio, kEdit, "0.02");
  EXPECT_TRUE(EndlessRun::wait_for([&] { return is_kept(studio); }));
  EXPECT_TRUE(WIFSIGNALED(run.end(SIGKILL)));
}

/// Returns the radius of taxel 3 in the recovered document of the next start.
double recovered_radius(const StudioProgram& studio) {
  studio.play({kIdle, press("Recover"), kIdle, dump("recovered.json")}, kNextStart);
  return radius_of_3(studio.state("recovered.json")["document"]["layout"]);
}

TEST(Recovery, OffersTheEditsAfterAKill) {
  const StudioProgram studio;
  edit_and_kill(studio);
  studio.play({kIdle, dump("offered.json"), press("Recover"), kIdle, dump("recovered.json"),
               R"({"do": "screenshot", "file": "recovered.png"})"},
              kNextStart);
  EXPECT_FALSE(studio.state("offered.json")["recovery"].get<std::string>().empty());
  const Json recovered = studio.state("recovered.json");
  EXPECT_EQ(radius_of_3(recovered["document"]["layout"]), 0.003);
  EXPECT_TRUE(recovered["history"]["dirty"]);
  EXPECT_EQ(recovered["document"]["file"], kLayoutFile);
  EXPECT_TRUE(recovered["recovery"].get<std::string>().empty());
  studio.play({kIdle, dump("again.json")}, kNextStart);
  EXPECT_TRUE(studio.state("again.json")["recovery"].get<std::string>().empty()) << "the program ended in order";
}

/// Edits one after another, and a kill between them: only the edits of the last interval are lost.
TEST(Recovery, LosesAtMostOneIntervalByAKill) {
  const StudioProgram studio;
  constexpr int kFrom = 100, kEdits = 4000, kFramesPerEdit = 10, kKilledAfter = 60;
  constexpr double kEvery = 1, kWriting = 1;  // [s]; the second value is for the disk of a busy machine
  Lines lines = kEdit;
  for (int i = 1; i <= kEdits; ++i) {
    const int frame = kFrom + kFramesPerEdit * i;
    const auto at = [&](int shift, const std::string& line) {
      return R"({"frame": )" + std::to_string(frame + shift) + ", " + line.substr(1);
    };
    lines.push_back(at(0, key("f")));
    lines.push_back(at(1, type("1." + std::to_string(10000 + i).substr(1))));  // millimetres
    lines.push_back(at(3, key("Enter")));
    lines.push_back(at(6, dump("edit_" + std::to_string(i) + ".json")));
  }
  const auto dump_of = [&](int edit) { return studio.folder() / ("edit_" + std::to_string(edit) + ".json"); };
  int done = 0;  // number of edits
  {
    EndlessRun run(studio, lines, std::to_string(kEvery));
    const auto began = Clock::now();
    EXPECT_TRUE(EndlessRun::wait_for([&] {
      while (std::filesystem::exists(dump_of(done + 1))) ++done;
      return done >= kKilledAfter && Clock::now() - began > std::chrono::seconds(5);
    }));
    run.end(SIGKILL);
  }
  const auto killed_at = std::filesystem::file_time_type::clock::now();
  const int kept = static_cast<int>(std::lround(recovered_radius(studio) * 1e7 - 10000));
  ASSERT_GE(kept, 1);
  if (kept >= done) return;  // nothing is lost
  const auto lost_since = std::filesystem::last_write_time(dump_of(kept + 1));
  EXPECT_LE(std::chrono::duration<double>(killed_at - lost_since).count(), kEvery + kWriting)
      << "edit " << kept << " of " << done << " is kept";
}

// The interface's time does not advance while no frame is drawn, so the interval is measured in real time.
TEST(Recovery, KeepsTheEditsOfAnIdleWindow) {
  const StudioProgram studio;
  EndlessRun run(studio,
                 joined({kLiveEdit,
                         {R"({"do": "wait_for", "pointer": "/history/dirty", "equals": true})", dump("edited.json"),
                          R"({"do": "rest", "seconds": 600})"}}),
                 "3", true);
  ASSERT_TRUE(EndlessRun::wait_for([&] { return std::filesystem::exists(studio.folder() / "edited.json"); }));
  const auto edited_at = Clock::now();
  EXPECT_TRUE(
      EndlessRun::wait_for([&] { return is_kept(studio) || Clock::now() - edited_at > std::chrono::seconds(10); }));
  run.end(SIGKILL);
  ASSERT_TRUE(is_kept(studio)) << "10 s after the edit, at an interval of 3 s";
  EXPECT_EQ(recovered_radius(studio), 0.003);
}

class Signal : public testing::TestWithParam<int> {};

TEST_P(Signal, WritesTheEditsAndEndsTheProgram) {
  const StudioProgram studio;
  EndlessRun run(studio,
                 joined({kLiveEdit,
                         {key("w"), kIdle, R"({"do": "wait_for", "pointer": "/history/dirty", "equals": true})",
                          dump("edited.json"), R"({"do": "rest", "seconds": 600})"}}),
                 "30", true);
  ASSERT_TRUE(EndlessRun::wait_for([&] { return std::filesystem::exists(studio.folder() / "edited.json"); }));
  const auto asked_at = Clock::now();
  const int status = run.end(GetParam());
  EXPECT_LT(Clock::now() - asked_at, std::chrono::seconds(5));
  ASSERT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 128 + GetParam());
  EXPECT_EQ(recovered_radius(studio), 0.003);
  EXPECT_TRUE(studio.state("recovered.json")["overlays"]["wireframe"]) << "settings are written as well";
}

INSTANTIATE_TEST_SUITE_P(Ends, Signal, testing::Values(SIGTERM, SIGINT, SIGHUP));

TEST(Recovery, LeavesNothingIfASignalFollowsNoEdit) {
  const StudioProgram studio;
  EndlessRun run(studio, {kIdle, dump("idle.json")}, "30", true);
  ASSERT_TRUE(EndlessRun::wait_for([&] { return std::filesystem::exists(studio.folder() / "idle.json"); }));
  run.end(SIGTERM);
  EXPECT_TRUE(std::filesystem::is_empty(studio.folder() / "state/autosave"));
}

/// Returns the number of lines of a file. Expects each line to have as many commas as the first.
int complete_rows(const std::filesystem::path& file) {
  std::istringstream lines(file_text(file));
  std::string line;
  std::ptrdiff_t commas = -1;
  int rows = -1;
  for (; std::getline(lines, line); ++rows) {
    const std::ptrdiff_t here = std::count(line.begin(), line.end(), ',');
    EXPECT_EQ(std::exchange(commas, here), rows < 0 ? -1 : here) << "row " << rows;
  }
  return rows;
}

// Kills at many phases of a recording, also with an idle window: all steps that the window has counted are found.
TEST(Recovery, LosesNoRecordedStepByAKill) {
  for (const int phase : {1, 40, 400, 0}) {
    const StudioProgram studio;
    Lines lines{kIdle, R"({"do": "wait_for", "pointer": "/simulation/step", "least": 20})", key("r", kCtrl),
                R"({"do": "wait_for", "pointer": "/simulation/history/recording/steps", "least": )" +
                    std::to_string(std::max(phase, 60 * (phase == 0))) + "}"};
    if (phase == 0) lines = joined({lines, {key("Space"), kIdle, kIdle}});
    lines.push_back(dump("counted.json"));
    if (phase == 0) lines.push_back(R"({"do": "rest", "seconds": 600})");
    {
      EndlessRun run(studio, lines, "30", true);
      ASSERT_TRUE(EndlessRun::wait_for([&] { return std::filesystem::exists(studio.folder() / "counted.json"); }));
      EXPECT_TRUE(WIFSIGNALED(run.end(SIGKILL)));
    }
    EXPECT_FALSE(std::filesystem::exists(studio.folder() / "recording-1"));
    const Json counted = studio.state("counted.json")["simulation"]["history"]["recording"];
    studio.play({kIdle, dump("offered.json"), R"({"do": "screenshot", "file": "offered.png"})", press("Recover"), kIdle,
                 dump("written.json")},
                kNextStart);
    EXPECT_NE(studio.state("offered.json")["recovery"].get<std::string>().find("steps was not written"),
              std::string::npos);
    EXPECT_EQ(studio.state("written.json")["recovery"], "");
    const int rows = complete_rows(studio.folder() / "recording-1/readings.csv");
    EXPECT_GE(rows, counted["steps"].get<int>()) << "phase " << phase;
    EXPECT_TRUE(phase > 0 || rows == counted["steps"].get<int>()) << "at rest";
    EXPECT_TRUE(std::filesystem::exists(studio.folder() / "recording-1/readings.npz"));
    EXPECT_TRUE(std::filesystem::is_empty(studio.folder() / "state/recordings"));
  }
}

TEST(Recovery, DoesNotOfferAWrittenRecording) {
  const StudioProgram studio;
  const std::vector<std::string> live{"--live", "--state-dir", "state"};
  studio.play(
      {kIdle, key("r", kCtrl), R"({"do": "wait_for", "pointer": "/simulation/history/recording/steps", "least": 9})",
       key("r", kCtrl), R"({"do": "wait_for", "pointer": "/messages", "contains": "Recorded "})", kIdle},
      live);
  EXPECT_TRUE(std::filesystem::exists(studio.folder() / "recording-1/readings.npz"));
  EXPECT_TRUE(std::filesystem::is_empty(studio.folder() / "state/recordings"));
}

TEST(Recovery, CanBeDiscarded) {
  const StudioProgram studio;
  edit_and_kill(studio);
  studio.play({kIdle, press("Discard"), kIdle}, kNextStart);
  studio.play({kIdle, dump("again.json")}, kNextStart);
  EXPECT_TRUE(studio.state("again.json")["recovery"].get<std::string>().empty());
}

}  // namespace
}  // namespace taxel::test
