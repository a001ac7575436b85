// The worker thread that presses the probe: the newest pose wins, so that the probe follows the hand as fast as it can
// be pressed, and nobody waits for the poses in between.
#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>

#include "app/studio/jobs/newest_wins.h"
#include "core/base/memo.h"
#include "ui/scene/pressed_probe.h"

namespace taxel::studio {

class ProbeWorker {
 public:
  /// `wake` is called from the worker when there is another reading.
  explicit ProbeWorker(std::function<void()> wake);

  /// To be pressed as soon as what is pressed now is done. Without a request or a model: nothing any more.
  void press(const SensorModelPtr& model, const std::optional<ui::ProbeRequest>& request);
  /// The same request on a model that was just built, in the thread that built it: model and reading are there
  /// together.
  void press_now(const SensorModelPtr& model);
  /// The last reading; null: there is none.
  [[nodiscard]] ui::PressedProbePtr newest() const { return worker_.newest(); }
  void wait() { worker_.wait(); }                             ///< until newest() is what was asked for
  [[nodiscard]] bool busy() const { return worker_.busy(); }  ///< it is not yet

 private:
  struct Job {
    SensorModelPtr model;
    ui::ProbeRequest request;
    bool operator==(const Job&) const = default;
  };
  ui::PressedProbePtr attempt(const Job& job);
  ui::ProbeRequest with_mesh(const ui::ProbeRequest& request);

  std::mutex pressing_;  // guards what follows: one press at a time
  ProbePress press_;
  Memo<std::string, TriMeshPtr> meshes_{4};   ///< by file
  NewestWins<Job, ui::PressedProbe> worker_;  // last: it ends first
};

}  // namespace taxel::studio
