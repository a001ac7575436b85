// Tables of taxels.
#include "fuzz/layout_reading.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_layouts_of_input("csv", input);
}

const Registered kTarget("taxels_csv", run);

}  // namespace
}  // namespace taxel::fuzz
