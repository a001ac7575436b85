#include "core/project/scenario.h"

#include <array>

namespace taxel {
namespace {

template <class... Kind>
constexpr unsigned kinds(Kind... kind) {
  return ((1U << static_cast<unsigned>(kind)) | ...);
}

using enum ScenarioKind;
constexpr unsigned kPressed = kinds(press, roll, twist, slide);  // led down to a depth, and up again
constexpr unsigned kTurned = kinds(roll, twist);
constexpr unsigned kPlaced = kPressed | kinds(drop);
constexpr unsigned kNoSweep = kPlaced | kinds(path, replay);
constexpr unsigned kAll = kNoSweep | kinds(sweep);
using enum ParameterRange;

// Those of the sweep first, as its files have them.
constexpr std::array<ScenarioParameter, 19> kParameters{
    {{"depth", &Scenario::depth, positive, kPressed | kinds(sweep)},
     {"speed", &Scenario::speed, positive, kPressed | kinds(sweep)},
     {"before", &Scenario::before, not_negative, kinds(sweep)},
     {"past", &Scenario::past, not_negative, kinds(sweep)},
     {"tilt_deg", &Scenario::tilt_deg, any, kPlaced | kinds(sweep)},
     {"record_every", &Scenario::record_every, positive, kinds(sweep)},
     {"timestep", &Scenario::timestep, positive, kAll & ~kinds(replay)},
     {"finger_mass", &Scenario::finger_mass, positive, kAll},
     {"box_size", &Scenario::box_size, positive, kAll},
     {"place", &Scenario::place, any, kPlaced},
     {"clearance", &Scenario::clearance, not_negative, kPressed},
     {"hold", &Scenario::hold, not_negative, kPressed},
     {"angle_deg", &Scenario::angle_deg, any, kTurned},
     {"rate_deg", &Scenario::rate_deg, positive, kTurned},
     {"distance", &Scenario::distance, positive, kinds(slide)},
     {"direction_deg", &Scenario::direction_deg, any, kinds(slide)},
     {"height", &Scenario::height, positive, kinds(drop)},
     {"duration", &Scenario::duration, positive, kinds(drop)},
     {"record_interval", &Scenario::record_interval, positive, kNoSweep}}};

}  // namespace

std::span<const ScenarioParameter> scenario_parameters() {
  return kParameters;
}

}  // namespace taxel
