#include "core/document/scenario/scenario.h"

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
constexpr unsigned kChosen = kNoSweep | kinds(sweep);  // their object is chosen by the user
constexpr unsigned kAll = kChosen | kinds(paper);
using enum ParameterRange;

// Those of the sweep first, as its files have them.
constexpr std::array<ScenarioParameter, 20> kParameters{
    {{"depth", &Scenario::depth, positive, kPressed | kinds(sweep)},
     {"speed", &Scenario::speed, positive, kPressed | kinds(sweep)},
     {"before", &Scenario::before, not_negative, kinds(sweep)},
     {"past", &Scenario::past, not_negative, kinds(sweep)},
     {"tilt_deg", &Scenario::tilt_deg, any, kPlaced | kinds(sweep)},
     {"record_every", &Scenario::record_every, positive, kinds(sweep)},
     {"timestep", &Scenario::timestep, positive, kAll & ~kinds(replay)},
     {"finger_mass", &Scenario::finger_mass, positive, kAll},
     {"box_size", &Scenario::box_size, positive, kChosen},
     {"edge_radius", &Scenario::edge_radius, positive, kChosen, true},
     {"place", &Scenario::place, any, kPlaced},
     {"clearance", &Scenario::clearance, not_negative, kPressed},
     {"hold", &Scenario::hold, not_negative, kPressed},
     {"angle_deg", &Scenario::angle_deg, any, kTurned},
     {"rate_deg", &Scenario::rate_deg, positive, kTurned},
     {"distance", &Scenario::distance, positive, kinds(slide)},
     {"direction_deg", &Scenario::direction_deg, any, kinds(slide)},
     {"height", &Scenario::height, positive, kinds(drop)},
     {"duration", &Scenario::duration, positive, kinds(drop)},
     {"record_interval", &Scenario::record_interval, positive, kNoSweep | kinds(paper)}}};

double default_reach(ObjectShape shape) {
  return shape == ObjectShape::edge ? kEdgeReach : kBoxReach;
}

double default_interval(ScenarioKind kind) {
  return kind == paper ? kPaperInterval : kInterval;
}

}  // namespace

ObjectShape default_shape(ScenarioKind kind) {
  return kind == sweep ? ObjectShape::edge : ObjectShape::box;
}

Scenario default_scenario(ScenarioKind kind) {
  Scenario scenario = with_shape({}, default_shape(kind));
  scenario.record_interval = default_interval(kind);
  scenario.kind = kind;
  return scenario;
}

Scenario with_shape(Scenario scenario, ObjectShape shape) {
  for (double Scenario::*reach : {&Scenario::before, &Scenario::past})
    if (scenario.*reach == default_reach(scenario.shape)) scenario.*reach = default_reach(shape);
  scenario.shape = shape;
  scenario.object.clear();
  return scenario;
}

Scenario with_object(Scenario scenario, const std::string& file) {
  scenario = with_shape(std::move(scenario), ObjectShape::box);
  scenario.object = file;
  return scenario;
}

Scenario with_kind(Scenario scenario, ScenarioKind kind) {
  const bool has_default = scenario.object.empty() && scenario.shape == default_shape(scenario.kind);
  const bool has_poses = kind == path || kind == replay;
  if ((has_default && !has_poses) || kind == paper) scenario = with_shape(std::move(scenario), default_shape(kind));
  if (scenario.record_interval == default_interval(scenario.kind)) scenario.record_interval = default_interval(kind);
  scenario.kind = kind;
  return scenario;
}

std::span<const ScenarioParameter> scenario_parameters() {
  return kParameters;
}

}  // namespace taxel
