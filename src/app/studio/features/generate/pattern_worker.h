// The worker thread that makes the preview of a pattern of taxels: the newest request wins, those before are cancelled.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "app/studio/jobs/newest_wins.h"
#include "core/layout/generators/pattern.h"

namespace taxel::studio {

struct PatternRequest {
  std::uint64_t number = 0;  ///< tells it from all others
  Pattern pattern;
  PatternSource source;
  std::shared_ptr<const MeshIndex> skin;
  bool operator==(const PatternRequest& other) const { return number == other.number; }
};

struct PatternAnswer {
  std::uint64_t number = 0;  ///< of the request
  PatternTaxels made;
  std::string problem;  ///< why nothing was made; empty: it was
};
using PatternAnswerPtr = std::shared_ptr<const PatternAnswer>;

class PatternWorker {
 public:
  /// `wake` is called from the worker when there is another answer.
  explicit PatternWorker(std::function<void()> wake);

  void make(PatternRequest request) { worker_.ask(std::move(request)); }
  void drop() { worker_.ask(std::nullopt); }                                  ///< there is no answer any more
  [[nodiscard]] PatternAnswerPtr newest() const { return worker_.newest(); }  ///< null: there is none
  void wait() { worker_.wait(); }                                             ///< until nothing is to be done
  [[nodiscard]] bool busy() const { return worker_.busy(); }

 private:
  NewestWins<PatternRequest, PatternAnswer> worker_;
};

}  // namespace taxel::studio
