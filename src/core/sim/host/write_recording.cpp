#include "core/sim/host/write_recording.h"

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include "core/base/files.h"
#include "core/run/recording/recording_files.h"

namespace taxel {

namespace {

constexpr const char* kMcapFile = "readings.mcap";

RunNotes notes_of(const RunFile& run) {
  return {fmt::format("taxel {}, MuJoCo {}", TAXEL_VERSION, mj_versionString()), run.name, run.text};
}

}  // namespace

void put_recording(OutputFolder& folder, const Recording& recording, const Simulator* scene, const ExtraFiles& extra,
                   const RunFile& run) {
  if (scene != nullptr) folder.fill([&](const std::filesystem::path& into) { scene->export_scene(into); });
  const auto put = [&](const char* name, const std::string& text) {
    text.empty() ? folder.leave_out(name) : folder.write(name, text);
  };
  folder.write("readings.csv", recording_to_csv(recording));
  put("calibrated.csv", calibrated_to_csv(recording));
  put("shear.csv", shear_to_csv(recording));
  put("slip.csv", slip_to_csv(recording));
  put("tactile_state.jsonl", extra.tactile_state ? tactile_states(recording) : "");
  if (extra.mcap)
    folder.fill([&](const std::filesystem::path& into) { write_mcap(into / kMcapFile, recording, notes_of(run)); });
  else
    folder.leave_out(kMcapFile);
  folder.write("readings.npz", recording_to_npz(recording));
  if (!run.name.empty()) folder.write(run.name, run.text);
}

void write_recording(const std::filesystem::path& path, const Recording& recording, const Simulator* scene) {
  const std::filesystem::path extension = path.extension();
  if (extension == ".csv") return write_file_atomically(path, recording_to_csv(recording));
  if (extension == ".npz") return write_file_atomically(path, recording_to_npz(recording));
  if (extension == ".jsonl") return write_file_atomically(path, tactile_states(recording));
  if (extension == ".mcap") return write_mcap(path, recording, notes_of({}));
  OutputFolder folder(path);
  put_recording(folder, recording, scene, {}, {});
  folder.commit();
}

}  // namespace taxel
