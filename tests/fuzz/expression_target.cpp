// Arithmetic with units, as in number fields. The first line of the input is the unit.
#include <cmath>

#include "core/base/text/expression.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const std::size_t end = std::min(input.find('\n'), input.size());
  const std::string unit = input.substr(0, end), text = end < input.size() ? input.substr(end + 1) : "";
  const auto value = read_or_refuse([&] { return evaluate(text, unit); });
  if (value) require(std::isfinite(*value), "a value is finite");
}

const Registered kTarget("expression", run);

}  // namespace
}  // namespace taxel::fuzz
