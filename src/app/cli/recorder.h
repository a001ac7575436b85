// Runs a simulator and records its rows, with a journal on disk, and reads a recorded run again with its scene.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/console.h"
#include "core/base/error.h"
#include "core/base/output.h"
#include "core/run/recording/recording.h"
#include "core/run/recording/run_recorder.h"
#include "core/sim/host/recording_journal.h"
#include "core/sim/simulator.h"

namespace taxel::cli {

/// Journal of a run on disk, so that a run that is killed, or whose files cannot be written, loses no complete row.
/// Writes the rows of a run with the output folder `out` to OUT/unfinished.rows and OUT/unfinished.npz while it runs.
/// Rows of an earlier run that has ended early are written next to OUT first, with a warning that names the folder.
class KeptRun {
 public:
  /// Writes nothing if `out` is empty. Warns if the rows of an earlier run cannot be read or written.
  KeptRun(const std::string& out, Console& console);
  /// Removes a journal without rows. One with rows stays unless commit() has removed it.
  ~KeptRun();
  KeptRun(const KeptRun&) = delete;
  KeptRun& operator=(const KeptRun&) = delete;

  /// Appends the new steps of `recording`. If that fails, warns once, and tries again at the next step.
  void follow(const Recording& recording);
  /// Calls put(), commits the folder and removes the journal. Returns the names of the files, none without a folder. If
  /// that fails, the collected files make room for the rows that are missing in the journal.
  std::vector<std::string> commit(std::optional<OutputFolder>& folder, const Recording& recording,
                                  const std::function<void(OutputFolder&)>& put);
  /// Returns work(). Adds to an Error where the rows are and how to get them.
  template <class Work>
  auto run(const Work& work) {
    try {
      return work();
    } catch (const Error& error) {
      throw explained(error);
    }
  }

 private:
  [[nodiscard]] Error explained(const Error& error) const;
  [[nodiscard]] std::string remedy() const;
  void remove_journal();

  std::string out_;
  Console& console_;
  std::unique_ptr<RecordingJournal> journal_;
  bool has_warned_ = false;
};

/// Number of steps, simulated time and computing time of a run.
struct RunCost {
  long steps = 0;
  double simulated = 0;  ///< simulated time [s]
  double wall = 0;       ///< wall time of all steps and rows [s]
  SensorTimes sensors;   ///< parts of `wall`; MuJoCo and the recording used the rest
  double cpu = 0;        ///< processor time of all steps and rows [s]
};

/// Follows the steps of a simulator. Throws Error if the recording is too large or contains a number that is not
/// finite.
class CheckedRecorder {
 public:
  /// Begins before the first step, or within it. `seconds` as in record(). Prints a note for a large recording.
  /// `errors`, which may be null, measures error bars.
  CheckedRecorder(const SimScene& scene, double seconds, Console& console,
                  std::shared_ptr<ErrorBarSource> errors = nullptr);
  void follow(const Simulator& simulator);
  [[nodiscard]] const Recording& recording() const { return recorder_.recording(); }
  [[nodiscard]] Recording take() { return recorder_.take(); }

 private:
  RunRecorder recorder_;
  StepView view_;
  long steps_ = 0;
};

/// Steps until the scenario or `seconds` of simulated time have ended, or a signal is received (signals.h), and records
/// all rows that are due. There is no limit if `seconds` is 0. `kept`, which may be null, writes the rows to disk
/// meanwhile. `errors`, which may be null, measures error bars. Throws the errors of CheckedRecorder.
Recording record(Simulator& simulator, double seconds, Console& console, RunCost& cost, KeptRun* kept = nullptr,
                 std::shared_ptr<ErrorBarSource> errors = nullptr);

/// Returns the error bars of a scene, and warns of each sensor with taxels that has none.
std::shared_ptr<ErrorBarSource> error_bars_of(const Simulator& simulator, Console& console);

/// A run that `taxel sweep` or `taxel run` recorded, with its scene, from which its contacts can be computed again.
struct RecordedRun {
  std::string file;  ///< path of readings.npz
  Recording recording;
  std::size_t sensor = 0;                ///< index of the requested sensor
  std::unique_ptr<Simulator> simulator;  ///< the scene, or null before load_scene()
};

/// Returns the index of the sensor on `geom`, or of the only sensor with taxels if `geom` is empty. Throws Error naming
/// `file` and its sensors, also for a soft geom without taxels.
std::size_t sensor_of(const Recording& recording, const std::string& geom, const std::string& file);

/// Reads a folder, or its readings.npz. `geom` as for sensor_of(). Throws Error.
RecordedRun read_run(const std::filesystem::path& path, const std::string& geom);

/// Loads scene.xml, which is in the folder of the recording. Throws Error if it is missing or is not the recorded
/// scene.
void load_scene(RecordedRun& run);

/// The arguments of Simulator::contact_at(): poses of all sensors and of all geoms.
struct RowPoses {
  std::vector<Pose> X_WM, X_WG;
};
/// Returns the poses of a row. Needs load_scene().
RowPoses poses_of(const RecordedRun& run, const RecordedRow& row);

}  // namespace taxel::cli
