// URDF with tactile sensors.
#include "fuzz/layout_reading.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_layouts_of_input("urdf", input);
}

const Registered kTarget("urdf", run);

}  // namespace
}  // namespace taxel::fuzz
