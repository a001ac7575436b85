// Sensor descriptions of the predecessor's code, as YAML.
#include "fuzz/layout_reading.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_layouts_of_input("yaml", input);
}

const Registered kTarget("sensor_yaml", run);

}  // namespace
}  // namespace taxel::fuzz
