// Presses the probe on a worker: the newest pose wins, so that the probe follows the pointer without delay.
#pragma once

#include <functional>
#include <optional>

#include "app/studio/jobs/newest_wins.h"
#include "ui/scene/pressed_probe.h"

namespace taxel::studio {

struct ProbeInput {
  SensorModelPtr model;
  Probe probe;
  bool operator==(const ProbeInput&) const = default;
};

class ProbeJob : public NewestWins<ProbeInput, ui::PressedProbe> {
 public:
  ProbeJob(JobExecutor& executor, std::function<void()> wake);

  /// Posts a press. Without a probe or a model, the reading is removed.
  void press(const SensorModelPtr& model, const std::optional<Probe>& probe);
  /// Presses the requested probe on a model that was just built, on the worker that built it, so that the model and its
  /// reading arrive together.
  void model_built(const SensorModelPtr& model);
};

}  // namespace taxel::studio
