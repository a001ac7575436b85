#include "app/studio/features/scenario/scenario_fields.h"

#include <array>

namespace taxel::ui {

namespace {

constexpr FieldUnit kMillimetresPerSecond{"mm/s", -3, -1}, kMilliseconds{"ms", -3, -1}, kDegrees{"deg", 0, -1},
    kGrams{"g", -3, -1}, kPlain{"", 0, -1};

constexpr std::array<ScenarioField, 20> kFields{
    {{&Scenario::depth, "Depth (mm)", kExactMillimetres, "How far below first touch on the object's top it is led"},
     {&Scenario::speed, "Path speed (mm/s)", kMillimetresPerSecond, "Along straight ways"},
     {&Scenario::before, "Before the edge (mm)", kExactMillimetres,
      "Where the lowest point of the finger starts; farther away if it would touch an upright edge there"},
     {&Scenario::past, "Past the edge (mm)", kExactMillimetres,
      "Where the lowest point of the finger ends; farther away if it would touch an upright edge there"},
     {&Scenario::tilt_deg, "Tilt (\u00b0)", kDegrees, "Of the finger's distal axis below the horizontal"},
     {&Scenario::place, "Place (mm)", kExactMillimetres,
      "Lowest point of the finger, from the object's middle along x"},
     {&Scenario::clearance, "Clearance (mm)", kExactMillimetres, "Gap between finger and object at the start"},
     {&Scenario::angle_deg, "Angle (\u00b0)", kDegrees, "Through which it turns, and back; it rolls towards +x"},
     {&Scenario::rate_deg, "Rate (\u00b0/s)", kDegrees, "At which it turns"},
     {&Scenario::distance, "Slide distance (mm)", kExactMillimetres, "There, and the same way back"},
     {&Scenario::direction_deg, "Direction (\u00b0)", kDegrees, "Of the slide, from +x towards +y"},
     {&Scenario::hold, "Hold (s)", kPlain, "Rest at the depth, or at the end of the way there"},
     {&Scenario::height, "Height (mm)", kExactMillimetres, "From which it drops: the gap to the object"},
     {&Scenario::duration, "Drop lasts (s)", kPlain, "Until the scenario is over"},
     {&Scenario::box_size, "Object size (mm)", kExactMillimetres,
      "Edges of a box, sides of a plate (a tenth as thick), diameter of a sphere"},
     {&Scenario::edge_radius, "Edge radius (mm)", kExactMillimetres, "Of the round on the edge that points up"},
     {&Scenario::finger_mass, "Finger mass (g)", kGrams, "Of the whole finger"},
     {&Scenario::record_every, "Row every (mm)", kExactMillimetres, "Of travel, in plots and recordings"},
     {&Scenario::record_interval, "Row every (ms)", kMilliseconds, "In plots and recordings"},
     {&Scenario::timestep, "Time step (ms)", kMilliseconds, "Of the simulation"}}};

}  // namespace

std::span<const ScenarioField> scenario_fields() {
  return kFields;
}

}  // namespace taxel::ui
