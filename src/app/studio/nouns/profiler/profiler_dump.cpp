// The costs of steps and pictures in the state of the window.
#include <nlohmann/json.hpp>
#include <vector>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/nouns/profiler/profiler_state.h"

namespace taxel::ui {

namespace {

using Json = nlohmann::ordered_json;

}  // namespace

void dump_profile(const App& app, nlohmann::ordered_json& state) {
  const std::vector<StepCost> steps = app.shown->run.frame ? app.shown->run.frame->costs : std::vector<StepCost>{};
  const auto mean = [](const auto& costs, auto member) {
    double sum = 0;
    for (const auto& cost : costs) sum += static_cast<double>(cost.*member);
    return costs.empty() ? 0.0 : sum / static_cast<double>(costs.size());
  };
  const auto& pictures = app.get<ProfileState>().pictures;
  state["profile"] = {{"steps", steps.size()},
                      {"mujoco", mean(steps, &StepCost::mujoco)},
                      {"surfaces", mean(steps, &StepCost::surfaces)},
                      {"forces", mean(steps, &StepCost::forces)},
                      {"readings", mean(steps, &StepCost::readings)},
                      {"history", mean(steps, &StepCost::history)},
                      {"pictures", pictures.size()},
                      {"panels", mean(pictures, &PictureCost::panels)},
                      {"scene", mean(pictures, &PictureCost::scene)},
                      {"window", mean(pictures, &PictureCost::window)}};
}

}  // namespace taxel::ui
