#include "app/cli/recorded_run.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/run/recording/npz.h"

namespace taxel::cli {

std::size_t sensor_of(const Recording& recording, const std::string& geom, const std::string& file) {
  const std::vector<RecordedSensor>& sensors = recording.sensors;
  if (sensors.empty()) throw Error(file, "sensor_geoms", "names no sensor");
  std::vector<std::size_t> with_taxels;
  std::string names;
  for (std::size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i].taxel_ids.empty()) {
      if (sensors[i].geom == geom) throw Error(file, fmt::format("geom \"{}\" is soft, but has no taxels", geom));
      continue;
    }
    if (sensors[i].geom == geom) return i;
    names += (with_taxels.empty() ? "" : ", ") + sensors[i].geom;
    with_taxels.push_back(i);
  }
  if (with_taxels.empty()) throw Error(file, "has only soft geoms without taxels");
  if (geom.empty() && with_taxels.size() == 1) return with_taxels.front();
  throw Error(file, geom.empty() ? "has several sensors: name one by --sensor: " + names
                                 : fmt::format("has no sensor \"{}\", but {}", geom, names));
}

RecordedRun read_run(const std::filesystem::path& path, const std::string& geom) {
  RecordedRun run;
  run.file = recording_file(path).string();
  run.recording = read_recording(path);
  run.sensor = sensor_of(run.recording, geom, run.file);
  return run;
}

void load_scene(RecordedRun& run) {
  const std::filesystem::path scene = std::filesystem::path(run.file).parent_path() / "scene.xml";
  std::error_code unknown;
  if (!std::filesystem::exists(scene, unknown))
    throw Error(scene.string(), "is missing: the contact is computed again from the scene next to the recording");
  run.simulator = Simulator::load(scene);
  const SimScene& made = *run.simulator->scene();
  const auto differs = [&](const std::string& what) {
    throw Error(scene.string(), "is not the recorded scene: " + what);
  };
  if (made.sensors.size() != run.recording.sensors.size())
    differs(fmt::format("it has {} sensors, the recording {}", made.sensors.size(), run.recording.sensors.size()));
  for (std::size_t i = 0; i < made.sensors.size(); ++i) {
    const RecordedSensor& recorded = run.recording.sensors[i];
    if (made.sensor_geoms[i] != recorded.geom)
      differs(
          fmt::format("sensor {} is on \"{}\", in the recording on \"{}\"", i, made.sensor_geoms[i], recorded.geom));
    std::vector<int> ids;
    for (const Taxel& taxel : made.sensors[i]->layout.taxels) ids.push_back(taxel.id);
    if (ids != recorded.taxel_ids) differs(fmt::format("the taxels of \"{}\" differ", recorded.geom));
  }
  std::vector<std::string> objects;
  for (const SceneGeom& geom : made.geoms)
    if (geom.sensor < 0) objects.push_back(geom.name);
  if (objects != run.recording.objects) differs("its geoms differ");
}

RowPoses poses_of(const RecordedRun& run, const RecordedRow& row) {
  RowPoses poses;
  for (const SensorRecord& record : row.sensors) poses.X_WM.push_back(record.X_WM);
  std::size_t object = 0;
  for (const SceneGeom& geom : run.simulator->scene()->geoms)
    poses.X_WG.push_back(geom.sensor < 0 ? row.objects[object++] : Pose{});
  return poses;
}

}  // namespace taxel::cli
