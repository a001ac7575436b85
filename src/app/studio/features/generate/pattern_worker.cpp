#include "app/studio/features/generate/pattern_worker.h"

namespace taxel::studio {

namespace {

PatternAnswerPtr answer_to(const PatternRequest& request, Progress& progress) {
  auto answer = std::make_shared<PatternAnswer>();
  answer->number = request.number;
  try {
    answer->made = make_pattern(request.pattern, request.source, *request.skin, &progress);
  } catch (const std::exception& error) {
    answer->problem = error.what();
  }
  return answer;
}

}  // namespace

PatternWorker::PatternWorker(std::function<void()> wake) : worker_(answer_to, std::move(wake), Overtaken::cancel) {}

}  // namespace taxel::studio
