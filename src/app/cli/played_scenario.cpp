#include "app/cli/played_scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>

#include "app/cli/default_layout.h"
#include "app/cli/recording_report.h"
#include "app/cli/signals.h"
#include "core/base/output/output_folder.h"
#include "core/sim/host/write_recording.h"
#include "core/sim/scene/scenario_scene.h"

namespace taxel::cli {

bool warn_of_depth(const Scenario& scenario, const SensorModel& model, Console& console) {
  const double* depth = find_number(scenario, "depth");
  if (depth == nullptr) return false;
  const dvec3 size = model.mesh->bounds().extent();
  const double smallest = std::min({size.x, size.y, size.z});
  const Material& material = model.layout.material;
  // The default thickness of a pad is an eighth of the smallest extent (hydro_body.cpp).
  const double pad = material.thickness > 0 ? material.thickness : 0.125 * smallest;
  const bool is_pad = material.compliant() && material.field == FieldKind::pad;
  if (*depth > smallest)
    console.warn(fmt::format("/depth: {} m is deeper than the sensor is thick, {:.3g} m: the readings are not valid",
                             *depth, smallest));
  else if (is_pad && *depth > pad)
    console.warn(
        fmt::format("/depth: {} m is deeper than the pad is thick, {:.3g} m: beyond the pad the pressure goes "
                    "on with p = (E/H) x depth, which no material does",
                    *depth, pad));
  return *depth > smallest || (is_pad && *depth > pad);
}

int play(const PlayedScenario& played, Console& console) {
  std::optional<OutputFolder> folder;
  if (!played.out.empty()) folder.emplace(played.out);

  const auto start = std::chrono::steady_clock::now();
  const SensorModelPtr model = load_model(played.layout, played.over, console);
  check_has_taxels(*model, played.layout);
  warn_of_depth(played.scenario, *model, console);
  const std::unique_ptr<Simulator> simulator = Simulator::make_scenario(model, played.scenario);
  const double model_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const FinishOnSignal finish;
  KeptRun kept(played.out, console);
  return kept.run([&] {
    RunCost cost;
    const Recording recording =
        record(*simulator, 0, console, cost, &kept, played.error_bars ? error_bars_of(*simulator, console) : nullptr);
    RecordingReport report{played.command, played.scenario, "", 0,         {model}, recording,
                           cost,           model_seconds,   {}, played.out};
    report.files = kept.commit(folder, recording, [&](OutputFolder& into) {
      put_recording(into, recording, simulator.get(), played.extra, {played.file, sweep_file_json(report)});
    });
    print_report(console, report);
    return FinishOnSignal::exit_status(kDone);
  });
}

}  // namespace taxel::cli
