// Contact cases.
#include "core/sensor/contact_case/contact_case.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_or_refuse([&] { return parse_contact_case(input, "input.json"); });
}

const Registered kTarget("contact_case", run);

}  // namespace
}  // namespace taxel::fuzz
