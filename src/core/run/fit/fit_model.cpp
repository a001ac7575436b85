#include "core/run/fit/fit_model.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"

namespace taxel {
namespace {

constexpr std::size_t kMostParts = 64;  // a derivative by one parameter needs two, and a step one

double* size_of_shape(ContactCase& contact_case) {
  return contact_case.b.shape ? &contact_case.b.shape->size.x : nullptr;
}

}  // namespace

FitModel::FitModel(const FitSubject& subject, int threads, Progress* progress)
    : source_(subject.sensor), case_(subject.contact_case), threads_(threads), progress_(progress) {
  const Layout& layout = source_.layout;
  if (layout.taxels.empty()) throw Error(source_.file, "/taxels", "must have at least one taxel");
  given_[0] = layout.taxels.front().radius;
  if (const double* size = size_of_shape(case_)) given_[1] = *size;
  given_[2] = layout.material.thickness;
  if (layout.material.law.kind == LawKind::stiffening) given_[3] = layout.material.law.k;
  const Pose& X_WM = case_.a.X_WB;
  for (const Taxel& taxel : layout.taxels) centers_W_.push_back(X_WM * taxel.center);
}

std::size_t FitModel::place_of(int taxel, const std::string& file) const {
  const std::vector<Taxel>& taxels = source_.layout.taxels;
  const auto found = std::find_if(taxels.begin(), taxels.end(), [&](const Taxel& t) { return t.id == taxel; });
  if (found == taxels.end()) throw Error(file, fmt::format("{} has no taxel {}", source_.file, taxel));
  return static_cast<std::size_t>(found - taxels.begin());
}

dvec3 FitModel::center_of(std::size_t taxel) const {
  return centers_W_[taxel];
}

const FitModel::Parts& FitModel::parts_of(const FitGeometry& geometry) {
  if (const auto found = parts_.find(geometry); found != parts_.end()) return found->second;
  if (parts_.size() >= kMostParts) parts_.clear();
  Layout layout = source_.layout;
  if (geometry[0] != given_[0])
    for (Taxel& taxel : layout.taxels) taxel.radius = geometry[0];
  if (geometry[2] != given_[2]) layout.material.thickness = geometry[2];
  if (geometry[3] != given_[3]) layout.material.law = PressureLaw{LawKind::stiffening, geometry[3], {}};
  SensorBuild how;
  how.cache = &cache_;
  Parts parts;
  parts.model = build_sensor_model(layout, source_.mesh.mesh, source_.mesh.sha256, source_.file, how);
  ContactCase changed = case_;
  if (double* size = size_of_shape(changed); size != nullptr && geometry[1] != given_[1]) {
    changed.b.shape->resolution *= geometry[1] / *size;  // as many faces as before, so that readings vary smoothly
    *size = geometry[1];
  }
  parts.object = make_case_body(changed, changed.b, "b").body;
  return parts_.emplace(geometry, std::move(parts)).first->second;
}

PoseReadings FitModel::read(const FitGeometry& geometry, std::span<const dvec3> displacements) {
  if (progress_ != nullptr) progress_->stop_if_cancelled();
  const Parts& parts = parts_of(geometry);
  const Pose X_MW = case_.a.X_WB.inverse();
  std::vector<Pose> poses;
  poses.reserve(displacements.size());
  for (const dvec3& displacement : displacements) {
    Pose X_WO = case_.b.X_WB;
    X_WO.p += displacement;
    poses.push_back(X_MW * X_WO);
  }
  PoseReadingOptions options;
  options.threads = threads_;
  return read_poses(*parts.model, *parts.object, poses, options);
}

}  // namespace taxel
