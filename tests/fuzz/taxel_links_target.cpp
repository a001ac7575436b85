// URDF whose taxels are links.
#include "fuzz/layout_reading.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_layouts_of_input("urdf", input);
}

const Registered kTarget("taxel_links", run);

}  // namespace
}  // namespace taxel::fuzz
