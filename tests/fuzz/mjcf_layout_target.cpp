// Layouts in MuJoCo scenes: of the plugin, and touch sites.
#include "fuzz/layout_reading.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_layouts_of_input("mjcf", input);
}

const Registered kTarget("mjcf_layout", run);

}  // namespace
}  // namespace taxel::fuzz
