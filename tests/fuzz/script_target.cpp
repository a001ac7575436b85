// Scripts of the window.
#include "app/studio/shell/script/script.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_or_refuse([&] { return studio::parse_script(input, "/scripts/input.jsonl"); });
}

const Registered kTarget("script", run);

}  // namespace
}  // namespace taxel::fuzz
