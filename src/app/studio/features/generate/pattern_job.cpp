#include "app/studio/features/generate/pattern_job.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace taxel::studio {

std::string displayed_problem(const PatternFieldError& error) {
  if (!error.value) return fmt::format("{}: {}", error.field.label, error.rule);
  const DisplayUnit unit = display_unit(error.field.quantity);
  if (error.field.quantity == FieldQuantity::number)
    return fmt::format("{}: {}, is {}", error.field.label, error.rule, *error.value);
  return fmt::format("{}: {}, is {:g} {}", error.field.label, error.rule, *error.value / std::pow(10.0, unit.decimal),
                     unit.typed);
}

PatternJob::PatternJob(JobExecutor& executor)
    : NewestWins(executor, Priority::normal, [](const PatternRequest& request, PatternResult& out, Progress& progress) {
        out.number = request.number;
        try {
          out.made = make_pattern(request.pattern, request.source, *request.skin, &progress);
        } catch (const PatternFieldError& error) {
          out.problem = displayed_problem(error);
        }
      }) {}

}  // namespace taxel::studio
