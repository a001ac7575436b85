// The worker thread that works out receptive fields for the 3-D view: the newest request wins.
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
      : worker_([this](const ui::FieldsRequest& request, Progress&) { return maker_.make(request); }, std::move(wake)) {
  }

  /// An empty request: nothing any more.
  void ask(const ui::FieldsRequest& request) { worker_.ask(request.empty() ? std::nullopt : std::optional(request)); }
  /// The same of a model that was just built, in the thread that built it: model and fields are there together.
  void make_now(const SensorModelPtr& model) {
    std::optional<ui::FieldsRequest> request = worker_.asked();
    if (!request || !model || request->models.size() != 1) return;
    request->models = {model};
    worker_.put(*request, maker_.make(*request));
  }
  /// What was made last, of this request or of one before; null: nothing.
  [[nodiscard]] ui::ShownFieldsPtr newest() const { return worker_.newest(); }
  void wait() { worker_.wait(); }
  [[nodiscard]] bool busy() const { return worker_.busy(); }

 private:
  ui::FieldMaker maker_;
  NewestWins<ui::FieldsRequest, ui::ShownFields> worker_;  // last: it ends first
};

}  // namespace taxel::studio
