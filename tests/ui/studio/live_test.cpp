// Edits while the simulation runs in real time with all threads, mainly for the sanitizers. The variable
// TAXEL_LIVE_SECONDS sets the duration.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>

#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/host.h"
#include "app/studio/nouns/timeline/run_commands.h"
#include "app/studio/shell/timing.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

double seconds_wanted() {
  const char* text = std::getenv("TAXEL_LIVE_SECONDS");
  return text != nullptr ? std::atof(text) : 2.0;
}

/// Waits for `frames` frames.
struct Beat {
  int frame = 0;
  std::string operator()(int pictures) {
    frame += pictures;
    return R"({"frame": )" + std::to_string(frame) + R"(, "event": "mouse_move", "at": {"view": [0.529, 0.681]}})";
  }
};

/// One round: a taxel is moved, resized and undone; fields are computed; a probe is pressed; steps are scrubbed; the
/// run continues.
Lines round(int number, Beat& pause) {
  const std::string id = std::to_string(number % 12), radius = std::to_string(4 + number % 4);
  return joined(
      {{kLayoutMode, pause(3), key("A"), pause(2), key("F"), pause(1), type(radius), pause(1), key("Enter"), pause(2)},
       {key("x"), pause(1), pause(3), key("Escape"), pause(1), key("z", kCtrl), pause(2)},
       {key("2", kCtrl), pause(2), key("Space"), pause(4), key("Left"), pause(1), key("Left"), pause(1), key("End"),
        pause(1), key("Space"), pause(3)},
       {key("y", kCtrl), pause(2), key("z", kCtrl), pause(2), key("Backspace"), pause(2), key("Space"), pause(12),
        R"({"event": "mouse_down", "at": {"view": [0.529, 0.681]}})", pause(1),
        R"({"event": "mouse_move", "at": {"view": [0.616, 0.739]}})", pause(1), R"({"event": "mouse_up"})", pause(1)}});
}

// A request takes effect at once: a key that toggles may be pressed before the simulation has handled the previous one.
TEST(Live, PlaysAsRequestedLast) {
  studio::Options options;
  options.live = true;
  studio::Timing timing = studio::make_timing(options);
  SensorCache cache;
  ui::App app;
  studio::Host host(app, {.simulation = std::move(timing.simulation),
                          .executor = *timing.executor,
                          .cache = cache,
                          .is_real_time = timing.is_real_time});
  host.document.open(kLayoutFile, {});
  const auto run_until = [&](const auto& done) {
    const auto began = std::chrono::steady_clock::now();
    while (!done() && std::chrono::steady_clock::now() - began < std::chrono::seconds(60)) studio::update(host);
    return done();
  };
  ASSERT_TRUE(run_until([&] { return host.run.playback.plays && host.run.frame->step > 20; }));
  carry_out(ui::ResetSimulation{}, host);
  EXPECT_FALSE(host.run.moves());
  studio::set_playing(host, true);
  EXPECT_TRUE(host.run.moves());
  carry_out(ui::ScrubTo{0}, host);
  EXPECT_FALSE(host.run.moves());
  studio::set_playing(host, true);
  EXPECT_TRUE(host.run.moves());
  const CommandId asked = host.run.carried_out;
  ASSERT_TRUE(run_until([&] { return host.run.carried_out >= asked + 4; }));
  EXPECT_TRUE(host.run.moves());  // and the simulation moves
  ASSERT_TRUE(run_until([&] { return host.run.frame->step > 20; }));
  studio::set_playing(host, false);
  EXPECT_FALSE(host.run.moves());
}

TEST(Live, EditsWhileTheSimulationRuns) {
  const StudioProgram studio;
  const auto began = std::chrono::steady_clock::now();
  const auto seconds = [&] { return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(); };
  int rounds = 0;
  do {
    Lines script{kIdle};
    Beat pause;
    for (int i = 0; i < 4; ++i) {
      const Lines more = round(rounds++, pause);
      script.insert(script.end(), more.begin(), more.end());
    }
    script.insert(script.end(), {kLayoutMode, kIdle, dump("state.json")});
    studio.play(script, {"--live", kLayoutFile});
    const Json state = studio.state("state.json");
    EXPECT_EQ(state["document"]["layout"]["taxels"].size(), 12U);
    EXPECT_GT(state["simulation"]["step"], 0);
    for (const Json& message : state["messages"]) EXPECT_NE(message["severity"], "error") << message.dump();
  } while (seconds() < seconds_wanted());
  RecordProperty("rounds", rounds);
}

}  // namespace
}  // namespace taxel::test
