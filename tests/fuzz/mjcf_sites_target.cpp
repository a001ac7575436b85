// Touch sites in MuJoCo scenes, written as sites again.
#include "fuzz/layout_reading.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_layouts_of_input("mjcf-sites", input);
}

const Registered kTarget("mjcf_sites", run);

}  // namespace
}  // namespace taxel::fuzz
