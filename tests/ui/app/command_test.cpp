// Commands of any kind: who carries them out, and when two of them are equal.
#include "app/studio/frame/command.h"

#include <gtest/gtest.h>

#include "app/studio/frame/app.h"
#include "app/studio/frame/window_ui.h"
#include "app/studio/host/host.h"
#include "app/studio/host/jobs/job_executor.h"
#include "app/studio/nouns/files/document_commands.h"
#include "app/studio/nouns/menus/window_commands.h"
#include "app/studio/nouns/timeline/run_commands.h"

namespace taxel::ui {
namespace {

struct Count {
  int* count = nullptr;
};
void carry_out(const Count& command, App& /*app*/) {
  ++*command.count;
}

struct CountInHost {
  int* count = nullptr;
  int by = 1;
  bool operator==(const CountInHost&) const = default;
};
void carry_out(const CountInHost& command, studio::Host& /*host*/) {
  *command.count += command.by;
}

/// A simulation that only records its commands.
class Recorder final : public SimHost {
 public:
  explicit Recorder(std::vector<SimCommand>& commands) : commands_(commands) {}
  CommandId send(SimCommand command) override {
    commands_.push_back(std::move(command));
    return commands_.size();
  }
  void advance(double /*seconds*/) override {}
  SimReplies take() override { return {}; }
  void set_journal_folder(const std::string& /*folder*/) override {}

 private:
  std::vector<SimCommand>& commands_;
};

struct InHost {
  App app;
  studio::InlineExecutor executor;
  SensorCache cache;
  std::vector<SimCommand> sent;
  studio::Host host{app, {.simulation = std::make_unique<Recorder>(sent), .executor = executor, .cache = cache}};
};

TEST(Commands, AboutTheInterfaceTakeTheApp) {
  int count = 0;
  App app;
  const Command command = Count{&count};
  ASSERT_TRUE(command.is_about_interface());
  command.carry_out(app);
  EXPECT_EQ(count, 1);
}

TEST(Commands, AboutTheProgramTakeTheHost) {
  int count = 0;
  InHost in;
  const Command command = CountInHost{&count, 5};
  ASSERT_FALSE(command.is_about_interface());
  command.carry_out(in.host);
  EXPECT_EQ(count, 5);
}

TEST(Commands, AreEqualIfKindAndValuesAre) {
  int count = 0;
  const Command five = CountInHost{&count, 5};
  EXPECT_EQ(five, Command(CountInHost{&count, 5}));
  EXPECT_FALSE(five == Command(CountInHost{&count, 6}));
  EXPECT_FALSE(five == Command(Count{&count}));
  EXPECT_EQ(Command(StepOnce{}), Command(StepOnce{}));
  EXPECT_FALSE(Command(StepOnce{}) == Command(StepBack{}));
}

TEST(Commands, GiveTheirValueToTheirKindAlone) {
  const Command command = OpenFile{"hand.xml"};
  ASSERT_NE(command.get_if<OpenFile>(), nullptr);
  EXPECT_EQ(command.get_if<OpenFile>()->path, "hand.xml");
  EXPECT_EQ(command.get_if<Quit>(), nullptr);
}

TEST(Commands, AreSentAsTheyAreIfTheyAreOfTheSimulation) {
  InHost in;
  Breakpoints breakpoints;
  breakpoints.on_jump = true;
  Command(BreakpointsCommand{breakpoints}).carry_out(in.host);
  ASSERT_EQ(in.sent.size(), 1U);
  EXPECT_TRUE(std::get<BreakpointsCommand>(in.sent[0]).breakpoints.on_jump);
}

TEST(Commands, AboutASceneAreDroppedWithoutOne) {
  InHost in;
  Command(EditSceneCommand{}).carry_out(in.host);
  EXPECT_TRUE(in.sent.empty());
}

}  // namespace
}  // namespace taxel::ui
