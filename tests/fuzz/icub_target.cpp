// iCub's positions of taxels.
#include "fuzz/layout_reading.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_layouts_of_input("icub", input);
}

const Registered kTarget("icub", run);

}  // namespace
}  // namespace taxel::fuzz
