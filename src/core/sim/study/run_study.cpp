#include "core/sim/study/run_study.h"

#include <tbb/task_arena.h>

#include <algorithm>

#include "core/base/parallel.h"

namespace taxel {

void run_study(const std::vector<StudyRun>& runs, const StudyModel& model, const StudyStep& on_step,
               const StudyEnd& on_end, Progress& progress) {
  const auto together = static_cast<std::size_t>(std::max(1, tbb::this_task_arena::max_concurrency()));
  for (std::size_t first = 0; first < runs.size(); first += together) {
    progress.check(static_cast<double>(first) / static_cast<double>(runs.size()));
    std::vector<std::unique_ptr<Simulator>> batch(std::min(together, runs.size() - first));
    for (std::size_t k = 0; k < batch.size(); ++k) {
      const SensorModelPtr sensor = model(first + k);
      try {
        if (sensor) batch[k] = Simulator::make_scenario(sensor, runs[first + k].scenario);
      } catch (const Error& e) {
        on_end(first + k, e.what());
      }
    }
    parallel_chunks(static_cast<int>(batch.size()), 1, [&](int begin, int) {
      const auto k = static_cast<std::size_t>(begin);
      if (!batch[k]) return;
      std::string error;
      try {
        bool is_running = true;
        while (is_running && !batch[k]->finished()) {
          progress.stop_if_cancelled();
          batch[k]->step();
          is_running = on_step(first + k, *batch[k]);
        }
      } catch (const Error& e) {
        error = e.what();
      }
      on_end(first + k, error);
      batch[k].reset();
    });
  }
  progress.check(1);
}

}  // namespace taxel
