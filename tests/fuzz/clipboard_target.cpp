// Taxels on the clipboard.
#include "core/layout/file/layout_json.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_and_write_again(
      input, [](const std::string& text) { return parse_taxels(text); },
      [](const auto& value) { return taxels_to_json(value); });
}

const Registered kTarget("clipboard", run);

}  // namespace
}  // namespace taxel::fuzz
