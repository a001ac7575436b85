#include "core/sim/host/write_recording.h"

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/run/recording/recording_files.h"

namespace taxel {

void put_recording(OutputFolder& folder, const Recording& recording, const Simulator* scene, const ExtraFiles& extra,
                   const RunFile& run) {
  if (scene != nullptr) folder.fill([&](const std::filesystem::path& into) { export_scene(*scene, into); });
  const auto put = [&](const char* name, const std::string& text) {
    text.empty() ? folder.leave_out(name) : folder.write(name, text);
  };
  folder.write("readings.csv", recording_to_csv(recording));
  put("calibrated.csv", calibrated_to_csv(recording));
  put("shear.csv", shear_to_csv(recording));
  put("slip.csv", slip_to_csv(recording));
  put("tactile_state.jsonl", extra.tactile_state ? tactile_states(recording) : "");
  folder.leave_out("readings.mcap");  // Python has written it for an older run
  folder.write("readings.npz", recording_to_npz(recording));
  if (!run.name.empty()) folder.write(run.name, run.text);
}

void write_recording(const std::filesystem::path& path, const Recording& recording, const Simulator* scene) {
  const std::filesystem::path extension = path.extension();
  if (extension == ".csv") return write_file_atomically(path, recording_to_csv(recording));
  if (extension == ".npz") return write_file_atomically(path, recording_to_npz(recording));
  if (extension == ".jsonl") return write_file_atomically(path, tactile_states(recording));
  if (extension == ".mcap")
    throw Error(path.string(), "is written by Python: write a folder, then python -m taxel.mcap FOLDER FILE.mcap");
  OutputFolder folder(path);
  put_recording(folder, recording, scene, {}, {});
  folder.commit();
}

}  // namespace taxel
