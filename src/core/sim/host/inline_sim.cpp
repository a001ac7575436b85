#include "core/sim/host/inline_sim.h"

#include <cmath>
#include <variant>

namespace taxel {
namespace {

/// A number of steps that is less than a whole one by this fraction is whole: 20 ms are twenty steps of 1 ms.
constexpr double kRounding = 1e-12;

bool sets_pace(const SimCommand& command) {
  return std::holds_alternative<PlayCommand>(command) || std::holds_alternative<PauseCommand>(command) ||
         std::holds_alternative<SpeedCommand>(command);
}

}  // namespace

CommandId InlineSim::send(SimCommand command) {
  loop_.execute(++sent_, command);
  const SimReport& newest = loop_.events().back().what;
  if (std::holds_alternative<RunStarted>(newest) || std::holds_alternative<SceneLoaded>(newest) ||
      std::holds_alternative<ScrubCommand>(command))
    unspent_ = 0;
  is_held_ = is_held_ || !sets_pace(command) || !std::holds_alternative<Done>(newest);
  is_frame_due_ = true;
  return sent_;
}

void InlineSim::advance(double seconds) {
  if (is_held_ || !loop_.playing()) return;
  unspent_ += seconds * loop_.speed();
  const auto steps = static_cast<int>(std::floor(unspent_ / loop_.timestep() * (1 + kRounding)));
  if (steps < 1) return;
  unspent_ -= steps * loop_.timestep();
  for (int i = 0; i < steps && loop_.step(); ++i) {
  }
  is_held_ = is_frame_due_ = true;
}

SimReplies InlineSim::take() {
  SimReplies replies;
  if (is_frame_due_) replies.frame = loop_.make_frame(0, true, true);
  replies.events = loop_.take_events();
  is_held_ = is_frame_due_ = false;
  return replies;
}

}  // namespace taxel
