#include "core/sensor/contact_case/pose_readings.h"

#include <fmt/format.h>

#include <atomic>
#include <thread>

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/sensor/contact_case/contact_case.h"
#include "core/sensor/readout/reading.h"

namespace taxel {
namespace {

constexpr std::size_t kPosesPerPiece = 16;  // a light press takes 30 us, and a piece half a millisecond

[[noreturn]] void refuse_pose(std::size_t row, const std::string& why) {
  throw Error("", fmt::format("/poses/{}", row), why);
}

/// Checks one pose. Throws Error naming the row.
void check_row(std::size_t row, const dvec3& p, const dquat& q) {
  if (!is_finite(p) || !is_finite(dvec3(q.x, q.y, q.z)) || !std::isfinite(q.w)) refuse_pose(row, "must be finite");
  const double length = glm::length(q);
  if (!(std::abs(length - 1) <= kPoseUnit))
    refuse_pose(row, fmt::format("the quaternion w x y z must have length 1, has {:.6g}", length));
}

/// One worker's memory, which it uses again from pose to pose.
class PoseReader {
 public:
  PoseReader(const SensorModel& model, const HydroBody& object)
      : model_(model), object_(object), motions_{{combine(model.body->material, object.material), {}}} {}

  void read(std::size_t row, const Pose& X_MO, PoseReadings& out) {
    case_.b.X_WB = X_MO;
    evaluate_contact(case_, *model_.body, object_, result_, workspace_);
    const ContactSurface* const surfaces[] = {&result_.surface};
    read_sensor(model_, surfaces, reading_, RayPath::fastest, motions_);
    const std::size_t taxels = at(out.taxels);
    std::copy(reading_.values.begin(), reading_.values.end(), out.readings.begin() + std::ptrdiff_t(row * taxels));
    const Wrench& wrench = result_.wrench_W;
    const double six[] = {wrench.force.x,  wrench.force.y,  wrench.force.z,
                          wrench.torque.x, wrench.torque.y, wrench.torque.z};
    std::copy(std::begin(six), std::end(six), out.wrenches.begin() + std::ptrdiff_t(6 * row));
    out.areas[row] = result_.surface.area();
  }

 private:
  const SensorModel& model_;
  const HydroBody& object_;
  ContactCase case_;  // the layout is at the origin
  ContactResult result_;
  IntersectWorkspace workspace_;
  SensorReading reading_;
  std::array<SurfaceMotion, 1> motions_;
};

}  // namespace

PoseReadings read_poses(const SensorModel& model, const HydroBody& object, std::span<const Pose> poses,
                        const PoseReadingOptions& options) {
  if (!model.body->soft() && !object.soft())
    throw Error("", "/material/modulus", "must be greater than 0: the layout and the object are both rigid");
  for (std::size_t i = 0; i < poses.size(); ++i) check_row(i, poses[i].p, poses[i].q);
  PoseReadings out;
  out.taxels = model.taxel_count();
  out.readings.resize(poses.size() * at(out.taxels));
  out.wrenches.resize(6 * poses.size());
  out.areas.resize(poses.size());

  const std::size_t pieces = (poses.size() + kPosesPerPiece - 1) / kPosesPerPiece;
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t workers = std::min(options.threads > 0 ? at(options.threads) : cores, pieces);
  std::atomic<std::size_t> next = 0, finished = 0;
  // Which worker reads a pose depends on the threads. Its row does not: no memory of a worker outlasts a pose.
  parallel_chunks(static_cast<int>(workers), 1, [&](int, int) {
    PoseReader reader(model, object);
    for (std::size_t piece = next++; piece < pieces; piece = next++) {
      if (options.progress != nullptr) options.progress->stop_if_cancelled();
      const std::size_t end = std::min(poses.size(), (piece + 1) * kPosesPerPiece);
      for (std::size_t i = piece * kPosesPerPiece; i < end; ++i) reader.read(i, poses[i], out);
      const auto done = static_cast<double>(++finished);
      if (options.progress != nullptr) options.progress->set(done / static_cast<double>(pieces));
    }
  });
  return out;
}

std::vector<Pose> poses_from_rows(std::span<const double> numbers) {
  std::vector<Pose> poses(numbers.size() / 7);
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::span<const double> n = numbers.subspan(7 * i, 7);
    const dvec3 p(n[0], n[1], n[2]);
    check_row(i, p, {n[3], n[4], n[5], n[6]});
    poses[i] = {unit_quaternion(n[3], n[4], n[5], n[6]), p};
  }
  return poses;
}

}  // namespace taxel
