// The key `materials` of the MuJoCo plugins.
#include "core/sim/plugin/plugin_config.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_or_refuse([&] { return parse_materials(input, "input.xml"); });
}

const Registered kTarget("materials", run);

}  // namespace
}  // namespace taxel::fuzz
