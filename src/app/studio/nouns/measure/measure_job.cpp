// Measures distances on the skin on a worker: on a large mesh a geodesic path takes longer than a frame.
#include <cmath>
#include <limits>
#include <memory>

#include "app/studio/frame/app.h"
#include "app/studio/frame/shown.h"
#include "app/studio/frame/viewer.h"
#include "app/studio/host/jobs/feature_job.h"
#include "app/studio/host/jobs/newest_wins.h"
#include "app/studio/nouns/measure/measure_state.h"
#include "core/mesh/geodesic.h"
#include "ui/scene/scene_input.h"

namespace taxel::studio {
namespace {

class MeasureJob : public NewestWins<ui::MeasureRequest, ui::Measured> {
 public:
  explicit MeasureJob(JobExecutor& executor);
};

constexpr double kFirstRadius = 1.2;  // first search radius, as a fraction of the straight distance
constexpr double kGrowth = 2.0;       // factor on the radius from one attempt to the next
constexpr double kLongest = 16;       // largest radius in diagonals of the mesh; the last attempt has no limit

/// The geodesic distances of the last skin.
class SkinMeasure {
 public:
  /// Propagates distances no farther than needed: starts at the straight distance and stops at the target.
  void operator()(const ui::MeasureRequest& request, ui::Measured& out) {
    use(request.skin);
    out.request = request;
    out.straight = glm::distance(request.a, request.b);
    const SurfacePoint a = skin_->closest_point(request.a), b = skin_->closest_point(request.b);
    const double longest = kLongest * skin_->mesh().bounds().diagonal();
    double radius = kFirstRadius * glm::distance(a.position, b.position);
    if (!(radius > 0)) {
      out.along = 0;
      return;
    }
    while (true) {
      distance_->propagate(a.face, a.position, radius);
      out.along = distance_->to(b.face, b.position);
      if (std::isfinite(out.along) || std::isinf(radius)) break;
      radius = radius < longest ? kGrowth * radius : std::numeric_limits<double>::infinity();
    }
    out.path = geodesic_path(*unfolded_, *distance_, a.position, b.face, b.position);
  }

 private:
  void use(const std::shared_ptr<const MeshIndex>& skin) {
    if (skin_ == skin) return;
    skin_ = skin;
    unfolded_ = std::make_shared<const UnfoldedMesh>(skin_->mesh_ptr());
    distance_ = std::make_unique<GeodesicDistance>(unfolded_);
  }

  std::shared_ptr<const MeshIndex> skin_;
  std::shared_ptr<const UnfoldedMesh> unfolded_;
  std::unique_ptr<GeodesicDistance> distance_;
};

}  // namespace

MeasureJob::MeasureJob(JobExecutor& executor)
    : NewestWins(executor, Priority::normal,
                 [measure = std::make_shared<SkinMeasure>()](const ui::MeasureRequest& request, ui::Measured& out,
                                                             Progress&) { (*measure)(request, out); }) {}

namespace {

class MeasureOfFeature final : public FeatureJob {
 public:
  explicit MeasureOfFeature(JobExecutor& executor) : measure_(executor) {}

  void request_about_layout(const ui::App& app, const SensorModelPtr& /*model*/) override {
    measure_.post(ui::measure_request(*app.viewer, app.shown->document, app.get<ui::MeasureState>()));
  }
  bool take_about_layout(const SensorModelPtr& /*model*/, bool /*is_compiled*/) override {
    return store(measured_, measure_.newest());
  }
  void fill(ui::App& app) const override { app.shown->document.measured = measured_; }
  [[nodiscard]] bool busy() const override { return measure_.busy(); }

 private:
  MeasureJob measure_;
  ui::MeasuredPtr measured_;
};

}  // namespace

std::unique_ptr<FeatureJob> make_measure_job(JobExecutor& executor) {
  return std::make_unique<MeasureOfFeature>(executor);
}

}  // namespace taxel::studio
