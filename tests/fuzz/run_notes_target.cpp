// Files about runs (sweep.json, scenario.json), which become notes of an MCAP file.
#include "core/run/mcap/recording_mcap.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const auto notes = read_or_refuse([&] { return parse_run_notes(input, "sweep.json", "sweep.json"); });
  if (!notes) return;
  require(notes->file_text == input, "the file is attached without changes");
  require(!recording_to_mcap({}, *notes).empty(), "the notes can be written");
}

const Registered kTarget("run_notes", run);

}  // namespace
}  // namespace taxel::fuzz
