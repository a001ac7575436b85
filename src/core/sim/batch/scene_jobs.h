// Jobs that run a user's scene: the checks of a list, and the runs. A run depends on its job alone.
#pragma once

#include <functional>
#include <list>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/document/batch/job.h"
#include "core/run/batch/episode.h"
#include "core/run/batch/scene_episode.h"
#include "core/run/lead.h"
#include "core/run/recording/recording.h"
#include "core/sim/simulator.h"

namespace taxel {

/// Returns the controls of all actuators for the step of a row, whose values are in the only row of `observation`.
using JobPolicy =
    std::function<std::vector<double>(const Job& job, const EpisodeScene& scene, const Episode& observation)>;

/// Checks the scenes of a list. Each combination of a file, its attachments and the kinds of changes is loaded once.
class SceneChecker {
 public:
  /// Throws Error as SceneReader says: a name that the scene does not have, no sensor, a table that does not fit, or a
  /// row that is not due at a whole number of time steps.
  SceneFacts check(const SceneJob& scene);

 private:
  std::map<std::string, std::shared_ptr<const SimScene>> scenes_;
  std::map<std::string, SceneLeadPtr> leads_;
  std::unique_ptr<Simulator> latest_;  // keeps the compiled sensors of its layouts for the runs
};

/// The results of a run.
struct SceneResult {
  Recording recording;
  Episode episode;
  EpisodeScene scene;
};

/// Runs jobs. Safe to use from several threads. Scenes that are not in use are kept for later jobs.
class SceneRunner {
 public:
  /// `compiler` is held while MuJoCo compiles, which must not happen twice at the same time.
  explicit SceneRunner(std::mutex& compiler) : compiler_(compiler) {}

  /// Runs a job, which has a scene, to its end. Asks is_stopped(), which may be empty, before each step. Throws Error
  /// if the scene cannot be loaded or becomes unstable, or the policy gives other numbers than controls; BatchStopped;
  /// and the errors of the policy.
  SceneResult run(const Job& job, bool has_poses, const std::function<bool()>& is_stopped, const JobPolicy& policy);

 private:
  std::unique_ptr<Simulator> take(const Job& job);
  void keep(const std::string& key, std::unique_ptr<Simulator> simulator);

  static constexpr std::size_t kKept = 32;

  std::mutex& compiler_;
  std::mutex mutex_;
  std::list<std::pair<std::string, std::unique_ptr<Simulator>>> idle_;  // by Job::layout_key, the latest first
};

}  // namespace taxel
