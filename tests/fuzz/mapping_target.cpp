// Mappings of the columns of a real recording.
#include "core/run/real/column_mapping.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_and_write_again(
      input, [](const std::string& text) { return mapping_from_json(text, "input.recmap.json"); },
      [](const auto& value) { return mapping_to_json(value); });
}

const Registered kTarget("mapping", run);

}  // namespace
}  // namespace taxel::fuzz
