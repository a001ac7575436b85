// Recordings of a real sensor as tables, read with the mapping that is guessed for them.
#include <cmath>

#include "core/run/real/real_recording.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const ColumnMapping mapping = guess_mapping(input, {1, 2, 3});
  read_or_refuse([&] { return look_at_table(input, mapping, "input.csv", 5); });
  const auto recording = read_or_refuse([&] { return parse_real_recording(input, mapping, "input.csv"); });
  if (!recording) return;
  for (const double time : recording->series.time) require(std::isfinite(time), "times are finite");
}

const Registered kTarget("table", run);

}  // namespace
}  // namespace taxel::fuzz
