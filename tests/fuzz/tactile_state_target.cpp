// Messages TactileState, which are refused with a sentence.
#include "core/layout/formats/layout_format.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const LayoutFormat& format = *find_layout_format("tactile_state");
  require(!read_or_refuse([&] { return format.parse(input, "input"); }), "a message holds no layout");
  format.is_start(input);
}

const Registered kTarget("tactile_state", run);

}  // namespace
}  // namespace taxel::fuzz
