// What a viewer may ask of the simulation; executed between two steps, in order.
#pragma once

#include <string>
#include <variant>

#include "core/project/scenario.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

struct PlayCommand {};
struct PauseCommand {};
struct StepCommand {
  int steps = 1;
};
struct ResetCommand {};
struct SpeedCommand {
  double factor = 1.0;
};  ///< multiples of real time
struct LoadSweepCommand {
  SensorModelPtr model;
  SweepScenario scenario;
};
/// The sensors that read by `replaced` read by `model` from now on: the state stays as it is, and its readings are made
/// anew. Nothing happens where no sensor does.
struct ReplaceModelCommand {
  SensorModelPtr replaced, model;
};
struct LoadSceneCommand {
  std::string file;
};  ///< MJCF with its own sensors
struct QuitCommand {};

using SimCommand = std::variant<PlayCommand, PauseCommand, StepCommand, ResetCommand, SpeedCommand, LoadSweepCommand,
                                ReplaceModelCommand, LoadSceneCommand, QuitCommand>;

}  // namespace taxel
