#include "app/studio/features/generate/pattern_job.h"

#include <utility>

namespace taxel::studio {

PatternJob::PatternJob(JobPool& pool, std::function<void()> wake)
    : NewestWins(
          pool, Priority::normal,
          [](const PatternRequest& request, PatternResult& out, Progress& progress) {
            out.number = request.number;
            out.made = make_pattern(request.pattern, request.source, *request.skin, &progress);
          },
          std::move(wake)) {}

}  // namespace taxel::studio
