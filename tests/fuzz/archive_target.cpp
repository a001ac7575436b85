// Zip archives in their form on disk, and the text of every member.
#include "core/run/recording/recording_files.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const auto archive = read_or_refuse([&] { return ZipArchive("input.npz", input); });
  if (!archive) return;
  for (const char* name : {"time", "text"}) {
    read_or_refuse([&] { return archive->read(std::string(name) + ".npy"); });
    const NpzReader arrays(*archive);
    read_or_refuse([&] { return arrays.doubles(name, {NpzReader::kAny}); });
    read_or_refuse([&] { return arrays.texts(name); });
  }
}

const Registered kTarget("archive", run);

}  // namespace
}  // namespace taxel::fuzz
