#include "app/cli/played_scenario.h"

#include <chrono>
#include <memory>
#include <optional>

#include "app/cli/default_layout.h"
#include "app/cli/recording_report.h"
#include "app/cli/signals.h"
#include "core/base/output_folder.h"
#include "core/sim/recording/write_recording.h"
#include "core/sim/scene/scenario_scene.h"

namespace taxel::cli {

int play(const PlayedScenario& played, Console& console) {
  std::optional<OutputFolder> folder;
  if (!played.out.empty()) folder.emplace(played.out);

  const auto start = std::chrono::steady_clock::now();
  const SensorModelPtr model = load_model(played.layout, played.over, console);
  check_has_taxels(*model, played.layout);
  const std::unique_ptr<Simulator> simulator = Simulator::make_scenario(model, played.scenario);
  const double model_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const FinishOnSignal finish;
  RunCost cost;
  const Recording recording = record(*simulator, 0, console, cost);
  RecordingReport report{played.command, played.scenario, "", 0,         {model}, recording,
                         cost,           model_seconds,   {}, played.out};
  if (folder) {
    put_recording(*folder, recording, simulator.get(), played.tactile_state);
    folder->write(played.file, sweep_file_json(report));
    report.files = folder->commit();
  }
  console.result(console.json() ? recording_json(report) : recording_text(report));
  return FinishOnSignal::exit_status(kDone);
}

}  // namespace taxel::cli
