// Genesis' probes.
#include "fuzz/layout_reading.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_layouts_of_input("genesis", input);
}

const Registered kTarget("genesis", run);

}  // namespace
}  // namespace taxel::fuzz
