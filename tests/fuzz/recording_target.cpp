// Recordings (readings.npz): the input is a list of members (members.h), so that checksums never stop a fuzzer.
#include "core/run/recording/recording_files.h"
#include "fuzz/members.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const auto recording = read_or_refuse([&] { return read_recording(NpzReader(archive_of(input))); });
  if (!recording) return;
  recording_to_csv(*recording);
  const std::string written = recording_to_npz(*recording);
  const Recording again = read_recording(NpzReader(ZipArchive("again.npz", written)));
  require(recording_to_npz(again) == written, "a recording that is read can be written and read again");
}

const Registered kTarget("recording", run);

}  // namespace
}  // namespace taxel::fuzz
