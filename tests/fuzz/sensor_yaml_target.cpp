// Sensor descriptions of the predecessor's code, as YAML.
#include "core/layout/formats/sensor_yaml.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_or_refuse([&] { return parse_sensor_yaml(input, "input.yaml"); });
}

const Registered kTarget("sensor_yaml", run);

}  // namespace
}  // namespace taxel::fuzz
