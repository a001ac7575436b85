#include "core/sim/study/side_by_side.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <vector>

#include "core/base/parallel.h"

namespace taxel {

void run_side_by_side(int count, const std::function<std::unique_ptr<Simulator>(int)>& make,
                      const std::function<void(int, Simulator&)>& run, Progress& progress) {
  const int together = std::max(1, tbb::this_task_arena::max_concurrency());
  for (int first = 0; first < count; first += together) {
    progress.check(static_cast<double>(first) / count);
    std::vector<std::unique_ptr<Simulator>> batch;
    for (int i = first; i < std::min(count, first + together); ++i) batch.push_back(make(i));
    parallel_chunks(static_cast<int>(batch.size()), 1, [&](int begin, int) {
      std::unique_ptr<Simulator>& simulator = batch[static_cast<std::size_t>(begin)];
      if (simulator) run(first + begin, *simulator);
      simulator.reset();
    });
  }
  progress.check(1);
}

}  // namespace taxel
