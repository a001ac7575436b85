// The worker thread that works out receptive fields for the 3-D view: the newest wish wins.
#pragma once

#include <functional>
#include <utility>

#include "app/studio/jobs/newest_wins.h"
#include "ui/scene/geometry/shown_fields.h"

namespace taxel::studio {

class FieldWorker {
 public:
  /// `wake` is called from the worker when there is something to show.
  explicit FieldWorker(std::function<void()> wake)
      : worker_([this](const ui::FieldsWish& wish, Progress&) { return maker_.make(wish); }, std::move(wake)) {}

  /// An empty wish: nothing any more.
  void ask(const ui::FieldsWish& wish) { worker_.ask(wish.empty() ? std::nullopt : std::optional(wish)); }
  /// The same of a model that was just built, in the thread that built it: model and fields are there together.
  void make_now(const SensorModelPtr& model) {
    std::optional<ui::FieldsWish> wish = worker_.asked();
    if (!wish || !model || wish->models.size() != 1) return;
    wish->models = {model};
    worker_.put(*wish, maker_.make(*wish));
  }
  /// What was made last, of this wish or of one before; null: nothing.
  [[nodiscard]] ui::ShownFieldsPtr newest() const { return worker_.newest(); }
  void wait() { worker_.wait(); }
  [[nodiscard]] bool busy() const { return worker_.busy(); }

 private:
  ui::FieldMaker maker_;
  NewestWins<ui::FieldsWish, ui::ShownFields> worker_;  // last: it ends first
};

}  // namespace taxel::studio
