// Tables of poses.
#include "core/sensor/contact_case/pose_readings.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_or_refuse([&] { return parse_poses_csv(input, "input.csv"); });
}

const Registered kTarget("poses_csv", run);

}  // namespace
}  // namespace taxel::fuzz
