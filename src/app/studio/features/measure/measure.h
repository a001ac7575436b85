// Measures on the skin, in a worker: on a large mesh a geodesic takes longer than a picture may.
#pragma once

#include <memory>

#include "app/studio/jobs/newest_wins.h"
#include "core/mesh/geodesic/geodesic_distance.h"
#include "ui/scene/measured.h"

namespace taxel::studio {

class MeasureWorker {
 public:
  explicit MeasureWorker(std::function<void()> wake)
      : worker_([this](const ui::MeasureRequest& request, Progress&) { return measure(request); }, std::move(wake)) {}
  void ask(std::optional<ui::MeasureRequest> request) { worker_.ask(std::move(request)); }
  [[nodiscard]] ui::MeasuredPtr newest() const { return worker_.newest(); }
  void wait() { worker_.wait(); }
  [[nodiscard]] bool busy() const { return worker_.busy(); }

 private:
  ui::MeasuredPtr measure(const ui::MeasureRequest& request);

  std::shared_ptr<const MeshIndex> skin_;  // of what follows
  std::shared_ptr<const UnfoldedMesh> unfolded_;
  std::unique_ptr<GeodesicDistance> distance_;
  NewestWins<ui::MeasureRequest, ui::Measured> worker_;  // last: it ends first
};

}  // namespace taxel::studio
