// Opening displays a preview of the samples first. Polished samples replace it while the program stays usable.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "script_lines.h"

namespace taxel::test {
namespace {

std::string at_frame(int frame, const std::string& rest) {
  return R"({"frame": )" + std::to_string(frame) + ", " + rest + "}";
}

/// Writes a fingertip with `density` samples per square metre into the test's folder.
std::string write_layout(const StudioProgram& studio, double density) {
  const std::string assets = TAXEL_SOURCE_DIR "/assets";
  Json layout = Json::parse(file_text(assets + "/layouts/fingertip.taxels.json"));
  layout["mesh"]["file"] = assets + "/meshes/fingertip.obj";
  layout["sampling"]["density"] = density;
  write_text(studio.folder() / "finger.taxels.json", layout.dump());
  return "finger.taxels.json";
}

bool says(const Json& state, const std::string& what) {
  return state["messages"].dump().find(what) != std::string::npos;
}
bool shows(const Json& state, const std::string& widget) {
  return state["widgets"].dump().find(widget) != std::string::npos;
}

TEST(Polish, ShowsThePreviewFirstAndStartsTheSweepPolished) {
  const StudioProgram studio(DrawnFrames::saved, CompiledParts::own);
  const std::string file = write_layout(studio, 2e6);
  studio.play({at_frame(2, R"("event": "drop", "files": [")" + file + R"("])"),
               at_frame(3, R"("do": "dump_state", "file": "first.json")"),
               at_frame(4, R"("event": "click", "at": {"taxel": 9})"),
               at_frame(5, R"("do": "dump_state", "file": "chosen.json")"), R"({"do": "wait_idle"})", dump("idle.json"),
               R"({"do": "wait_time", "time": 1.5})", dump("later.json")});
  const Json first = studio.state("first.json"), chosen = studio.state("chosen.json"), idle = studio.state("idle.json");
  EXPECT_EQ(first["model"], Json({{"quality", "preview"}, {"polishing", true}}));
  EXPECT_EQ(first["simulation"]["sensors"][0]["quality"], "preview");
  EXPECT_TRUE(shows(first, "Polishing samples"));
  EXPECT_EQ(first["document"]["layout"]["taxels"].size(), 12U);
  EXPECT_EQ(first["simulation"]["readings"].size(), 12U);
  EXPECT_EQ(idle["model"], Json({{"quality", "polished"}, {"polishing", false}}));
  EXPECT_EQ(idle["simulation"]["sensors"][0]["quality"], "polished");
  EXPECT_FALSE(shows(idle, "Polishing samples"));

  // The program stays usable.
  EXPECT_EQ(chosen["model"]["quality"], "preview");
  EXPECT_FALSE(chosen["selection"]["taxel"].is_null());
  EXPECT_EQ(idle["selection"], chosen["selection"]);
  EXPECT_EQ(idle["camera"], chosen["camera"]);
  EXPECT_EQ(idle["document"], chosen["document"]);
  EXPECT_EQ(idle["mode"], chosen["mode"]);
  EXPECT_GT(idle["simulation"]["step"], chosen["simulation"]["step"]);
  EXPECT_TRUE(idle["simulation"]["playing"]);
  EXPECT_EQ(idle["messages"], first["messages"]) << "nothing to say";
  const Json later = studio.state("later.json");
  EXPECT_EQ(later["simulation"]["preview_rows"], idle["simulation"]["preview_rows"]);
  EXPECT_EQ(later["simulation"]["preview_rows"], 0);
  EXPECT_EQ(chosen["simulation"]["step"], 0);
}

TEST(Polish, GivesReadingsOfPolishedSamplesAlone) {
  const StudioProgram studio(DrawnFrames::saved, CompiledParts::own);
  const std::string file = write_layout(studio, 1e6);
  // Once through the preview, and once loaded again, when the polished samples are cached and no preview is made.
  studio.play({at_frame(2, R"("event": "drop", "files": [")" + file + R"("])"),
               at_frame(3, R"("do": "wait_time", "time": 1.5)"), dump("dropped.json"),
               at_frame(4, R"("event": "drop", "files": [")" + file + R"("])"),
               at_frame(5, R"("do": "dump_state", "file": "reloaded.json")"), R"({"do": "wait_time", "time": 1.5})",
               dump("again.json")});
  EXPECT_EQ(studio.state("reloaded.json")["model"]["quality"], "polished") << "at once: the samples are known";
  EXPECT_EQ(studio.state("reloaded.json")["simulation"]["preview_rows"], 0);
  const Json dropped = studio.state("dropped.json")["simulation"], again = studio.state("again.json")["simulation"];
  ASSERT_EQ(dropped["step"], again["step"]);
  EXPECT_EQ(dropped["sensors"], again["sensors"]);
  EXPECT_GT(dropped["sensors"][0]["polygons"], 0);
}

TEST(Polish, KeepsThePreviewAfterCancelUntilRequestedAgain) {
  const StudioProgram studio(DrawnFrames::saved, CompiledParts::own);
  const std::string file = write_layout(studio, 1e6);
  studio.play({at_frame(2, R"("event": "drop", "files": [")" + file + R"("])"),
               at_frame(4, R"("event": "click", "at": {"widget": "Cancel polishing"})"),
               at_frame(5, R"("do": "wait_idle")"), dump("cancelled.json"),
               at_frame(6, R"("event": "click", "at": {"widget": "Polish"})"), R"({"do": "wait_idle"})",
               dump("asked.json")});
  const Json cancelled = studio.state("cancelled.json"), asked = studio.state("asked.json");
  EXPECT_EQ(cancelled["model"], Json({{"quality", "preview"}, {"polishing", false}}));
  EXPECT_TRUE(says(cancelled, "Polishing was cancelled"));
  EXPECT_TRUE(shows(cancelled, "Preview samples"));
  EXPECT_TRUE(cancelled["simulation"]["playing"]);
  EXPECT_EQ(asked["model"], Json({{"quality", "polished"}, {"polishing", false}}));
  EXPECT_EQ(asked["simulation"]["sensors"][0]["quality"], "polished");
}

/// Threads that keep every core busy, as other programs do.
class BusyMachine {
 public:
  explicit BusyMachine(unsigned threads) {
    for (unsigned i = 0; i < threads; ++i)
      threads_.emplace_back([this] {
        while (!ends_.load(std::memory_order_relaxed)) {
        }
      });
  }
  ~BusyMachine() {
    ends_ = true;
    for (std::thread& thread : threads_) thread.join();
  }
  BusyMachine(const BusyMachine&) = delete;
  BusyMachine& operator=(const BusyMachine&) = delete;

 private:
  std::atomic<bool> ends_ = false;
  std::vector<std::thread> threads_;
};

const std::string kEnded = R"({"do": "wait_for", "pointer": "/simulation/finished", "equals": true})";

/// Starts the program in real time, lets it run to the end of a sweep that is in contact from the first steps on, and
/// writes the recorded steps and the state as NAME.csv and NAME.json.
void record_live(const StudioProgram& studio, const std::string& name, const Lines& first, const std::string& file) {
  write_text(studio.folder() / "touching.json",
             R"({"format": "taxel-scenario", "version": 1, "scenario":
                 {"kind": "sweep", "shape": "box", "before": 0.002, "speed": 0.02}})");
  studio.play(joined({first,
                      {kEnded, dump(name + ".json"), key("e", kCtrlShift), kIdle, key("a", kCtrl),
                       type((studio.folder() / (name + ".csv")).string()), kIdle, key("Enter"), kIdle,
                       R"({"do": "wait_for", "pointer": "/messages", "contains": "Recorded "})"}}),
              {"--live", "--scenario", "touching.json", file});
}

// The load determines when the samples are polished, so the run waits for them.
TEST(Polish, RecordsTheSameCurveInTwoLiveStartsAtAnyLoad) {
  const StudioProgram studio(DrawnFrames::saved, CompiledParts::own);
  const std::string file = write_layout(studio, 2e6);
  record_live(studio, "alone", {}, file);
  {
    const BusyMachine busy(2 * std::max(1U, std::thread::hardware_concurrency()));
    record_live(studio, "busy", {}, file);
  }
  const std::string alone = file_text(studio.folder() / "alone.csv");
  EXPECT_GT(std::count(alone.begin(), alone.end(), '\n'), 500);
  EXPECT_TRUE(alone == file_text(studio.folder() / "busy.csv"));
  for (const char* name : {"alone.json", "busy.json"}) {
    const Json run = studio.state(name)["simulation"];
    EXPECT_EQ(run["preview_rows"], 0) << name;
    EXPECT_EQ(run["history"]["events"].dump().find("other_layout"), std::string::npos) << run["history"]["events"];
  }
}

// A run that is restarted, paused, or advanced step by step while the samples are polished. Polishing this many samples
// takes seconds, so the script observes it even on a loaded machine.
TEST(Polish, RecordsTheSameCurveInLiveRunsByKeys) {
  const StudioProgram studio(DrawnFrames::saved, CompiledParts::own);
  const std::string file = write_layout(studio, 8e6);
  const std::string polishing = R"({"do": "wait_for", "pointer": "/model/polishing", "equals": true})";
  record_live(studio, "alone", {}, file);
  record_live(studio, "restarted", {polishing, key("Enter", kCtrl)}, file);
  record_live(studio, "paused", {polishing, key("Space"), kIdle, key("Space")}, file);
  record_live(studio, "stepped", {polishing, key("Right"), key("Right"), kIdle, key("Space")}, file);
  for (const char* name : {"restarted.csv", "paused.csv", "stepped.csv"})
    EXPECT_TRUE(file_text(studio.folder() / name) == file_text(studio.folder() / "alone.csv")) << name;
}

TEST(Polish, DelaysRunsAndStepsByKeys) {
  const StudioProgram studio(DrawnFrames::saved, CompiledParts::own);
  const std::string file = write_layout(studio, 2e6);
  const std::string open = at_frame(2, R"("event": "drop", "files": [")" + file + R"("])");
  const std::string space = R"("event": "key", "key": "Space")", right = R"("event": "key", "key": "Right")";
  studio.play({open, at_frame(3, R"("do": "dump_state", "file": "held.json")"), at_frame(4, space), kIdle,
               dump("paused.json"), key("Space"), R"({"do": "wait_time", "time": 0.1})", dump("runs.json")});
  const Json held = studio.state("held.json"), paused = studio.state("paused.json")["simulation"];
  EXPECT_TRUE(held["simulation"]["playing"]);
  EXPECT_TRUE(shows(held, "starts when polished"));
  EXPECT_EQ(paused["step"], 0);
  EXPECT_FALSE(paused["playing"]);
  EXPECT_GE(studio.state("runs.json")["simulation"]["time"].get<double>(), 0.1);

  studio.play({open, at_frame(3, right), at_frame(4, right), at_frame(4, R"("do": "dump_state", "file": "waits.json")"),
               kIdle, dump("stepped.json")});
  EXPECT_EQ(studio.state("waits.json")["model"]["quality"], "preview");
  EXPECT_EQ(studio.state("waits.json")["simulation"]["step"], 0);
  const Json stepped = studio.state("stepped.json")["simulation"];
  EXPECT_EQ(stepped["step"], 2);
  EXPECT_FALSE(stepped["playing"]);
  EXPECT_EQ(stepped["history"]["events"].size(), 0U);
}

// The edit ends the polishing of the opened layout, and the run reads with the edited layout's polished samples.
TEST(Polish, UsesAnEditDuringItFromTheFirstStep) {
  const StudioProgram studio(DrawnFrames::saved, CompiledParts::own);
  const std::string file = write_layout(studio, 1e6);
  const Lines edit{key("1", kCtrl), key("a"), kIdle, key("f"), type("3"), key("Enter"), kIdle, key("2", kCtrl)};
  record_live(studio, "edited", edit, file);
  const Json run = studio.state("edited.json")["simulation"];
  EXPECT_EQ(run["preview_rows"], 0);
  EXPECT_EQ(run["sensors"][0]["quality"], "polished");
}

TEST(Polish, ContinuesIfAnotherFileIsRefused) {
  const StudioProgram studio(DrawnFrames::saved, CompiledParts::own);
  const std::string file = write_layout(studio, 1e6);
  studio.play({at_frame(2, R"("event": "drop", "files": [")" + file + R"("])"),
               at_frame(3, R"("event": "drop", "files": ["nothing.obj"])"),
               at_frame(4, R"("do": "dump_state", "file": "refused.json")"), R"({"do": "wait_idle"})",
               dump("idle.json")});
  const Json refused = studio.state("refused.json"), idle = studio.state("idle.json");
  EXPECT_TRUE(says(refused, "nothing.obj: no such file"));
  EXPECT_EQ(refused["model"], Json({{"quality", "preview"}, {"polishing", true}}));
  EXPECT_EQ(idle["model"]["quality"], "polished");
  EXPECT_EQ(idle["messages"].size(), 1U) << "said once: " << idle["messages"].dump();
}

TEST(Polish, EndsIfAnotherFileOpens) {
  const StudioProgram studio(DrawnFrames::saved, CompiledParts::own);
  const std::string file = write_layout(studio, 1e6), mesh = TAXEL_SOURCE_DIR "/assets/meshes/fingertip.glb";
  studio.play({at_frame(2, R"("event": "drop", "files": [")" + file + R"("])"),
               at_frame(3, R"("event": "drop", "files": [")" + mesh + R"("])"),
               at_frame(4, R"("do": "dump_state", "file": "mesh.json")"), R"({"do": "wait_idle"})",
               R"({"do": "screenshot", "file": "mesh.png"})", dump("idle.json")});
  EXPECT_EQ(studio.state("mesh.json")["document"]["file"], mesh);
  EXPECT_EQ(studio.state("mesh.json")["model"]["quality"], "preview");
  const Json idle = studio.state("idle.json");
  EXPECT_EQ(idle["document"]["file"], mesh);
  EXPECT_EQ(idle["mode"], "layout");
  EXPECT_EQ(idle["model"]["quality"], "polished");
}

TEST(Polish, ReportsAnEmptyFieldOfThePolishedSamples) {
  const StudioProgram studio(DrawnFrames::saved, CompiledParts::own);
  write_layout(studio, 1e6);
  Json layout = Json::parse(file_text(studio.folder() / "finger.taxels.json"));
  layout["taxels"][5]["radius"] = 2e-5;  // less than the distance of samples
  write_text(studio.folder() / "finger.taxels.json", layout.dump());
  studio.play({at_frame(2, R"("event": "drop", "files": ["finger.taxels.json"])"),
               at_frame(3, R"("do": "dump_state", "file": "first.json")"), R"({"do": "wait_idle"})",
               dump("idle.json")});
  EXPECT_FALSE(says(studio.state("first.json"), "no sample lies in the receptive field"));
  const Json messages = studio.state("idle.json")["messages"];
  const std::string text = messages.dump();
  const std::size_t told = text.find("/taxels/5: no sample lies in the receptive field");
  ASSERT_NE(told, std::string::npos) << text;
  EXPECT_EQ(text.find("no sample lies", told + 20), std::string::npos) << "once";
}

}  // namespace
}  // namespace taxel::test
