// Layouts as JSON, and the rules for their values.
#include "core/layout/check/layout_check.h"
#include "core/layout/file/layout_json.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_and_write_again(
      input, [](const std::string& text) { return parse_layout(text, "input.taxels.json"); },
      [](const auto& value) { return layout_to_json(value); });
  if (const auto layout = read_or_refuse([&] { return parse_layout(input, "input.taxels.json"); }))
    check_layout_values(*layout, "input.taxels.json");
}

const Registered kTarget("layout", run);

}  // namespace
}  // namespace taxel::fuzz
