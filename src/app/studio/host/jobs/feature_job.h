// The work of a feature in workers: requested while the interface is drawn, and displayed when it is done.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/studio/host/jobs/job_executor.h"
#include "app/studio/host/run/host_event.h"
#include "core/run/command.h"
#include "core/run/event.h"

namespace taxel::ui {
struct App;
}

namespace taxel::studio {

using SendToSimulation = std::function<void(SimCommand)>;

/// The part of a run that jobs depend on.
struct FollowedRun {
  SimFramePtr frame;               ///< displayed frame, or null
  bool runs = false;               ///< whether the displayed step changes by itself
  bool keeps_explanation = false;  ///< whether the last explanation stays until the run pauses
};

/// The job of one feature. An earlier result stays until there is one for the displayed model. All functions but
/// model_built() are called on the window's thread.
class FeatureJob {
 public:
  FeatureJob() = default;
  virtual ~FeatureJob() = default;
  FeatureJob(const FeatureJob&) = delete;
  FeatureJob& operator=(const FeatureJob&) = delete;

  /// Posts the questions of the feature about the edited layout, of which `model` was compiled. Called as soon as the
  /// interface is laid out.
  virtual void request_about_layout(const ui::App& /*app*/, const SensorModelPtr& /*model*/) {}
  /// Posts the questions of the feature about the run. Called when the frame is drawn.
  virtual void request_about_run(const ui::App& /*app*/, const SensorModelPtr& /*model*/,
                                 const SendToSimulation& /*send*/) {}
  /// Takes the newest result about the layout. Returns whether it is new. `is_compiled`: the model includes all edits.
  virtual bool take_about_layout(const SensorModelPtr& /*model*/, bool /*is_compiled*/) { return false; }
  /// Takes the newest result about the run. Returns whether it is new.
  virtual bool take_about_run(const SensorModelPtr& /*model*/, const FollowedRun& /*run*/,
                              const SendToSimulation& /*send*/) {
    return false;
  }
  /// Reports results that the user, or the program, has to know of.
  virtual void report(HostEvents& /*events*/) {}
  /// Sets the results in the state of the feature.
  virtual void fill(ui::App& app) const = 0;
  /// Whether a result is under way.
  [[nodiscard]] virtual bool busy() const = 0;

  /// An edited model was built. Called on the worker that built it, so that what depends on it arrives together with
  /// it.
  virtual void model_built(const SensorModelPtr& /*model*/) {}
  virtual void note_edit() {}   ///< the layout was edited
  virtual void drop_scene() {}  ///< no scene is displayed any more
  /// Accepts the reply to a RecallCommand. RecallCommand::asker is the number of the job that asked.
  virtual void accept(const StepsRecalled& /*recalled*/) {}

 protected:
  /// Stores a result. Returns whether it differs from the previous one.
  template <class Ptr>
  static bool store(Ptr& stored, Ptr newest) {
    if (newest == stored) return false;
    stored = std::move(newest);
    return true;
  }
};

/// A job about the run that recalls recorded steps. `Job` has newest(), busy() and accept().
template <class Job, class ResultPtr>
class RecallingJob : public FeatureJob {
 public:
  /// `asker` is RecallCommand::asker of the job.
  RecallingJob(JobExecutor& executor, int asker) : executor_(executor), asker_(asker), job_(executor) {}

  bool take_about_run(const SensorModelPtr& /*model*/, const FollowedRun& run, const SendToSimulation& send) final {
    if (const std::optional<RecallCommand> recall = follow(job_, run)) send(*recall);
    executor_.run_posted();
    return store(result_, ResultPtr(job_.newest()));
  }
  [[nodiscard]] bool busy() const final { return job_.busy(); }
  void accept(const StepsRecalled& recalled) final {
    if (recalled.asker == asker_) job_.accept(recalled);
  }

 protected:
  /// Follows the displayed step. Returns the command that recalls the steps to look at next.
  virtual std::optional<RecallCommand> follow(Job& job, const FollowedRun& run) = 0;
  [[nodiscard]] Job& job() { return job_; }
  [[nodiscard]] const Job& job() const { return job_; }
  [[nodiscard]] const ResultPtr& result() const { return result_; }

 private:
  JobExecutor& executor_;
  int asker_;
  Job job_;
  ResultPtr result_;
};

/// Passes each call to the jobs of all features, in the order of their rows.
class FeatureJobs {
 public:
  explicit FeatureJobs(JobExecutor& executor);

  void request_about_layout(const ui::App& app, const SensorModelPtr& model);
  void request_about_run(const ui::App& app, const SensorModelPtr& model, const SendToSimulation& send);
  /// Takes the newest results. Returns whether one of them is new.
  bool take_about_layout(const SensorModelPtr& model, bool is_compiled);
  bool take_about_run(const SensorModelPtr& model, const FollowedRun& run, const SendToSimulation& send);
  void report(HostEvents& events);
  void fill(ui::App& app) const;
  [[nodiscard]] bool busy() const;
  void model_built(const SensorModelPtr& model);  ///< on any thread
  void note_edit();
  void drop_scene();
  void accept(const StepsRecalled& recalled);

 private:
  std::vector<std::unique_ptr<FeatureJob>> jobs_;
};

}  // namespace taxel::studio
