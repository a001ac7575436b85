#include "app/cli/commands/run/run_lead.h"

namespace taxel::cli {

void add_lead(OptionList& list, LeadOptions& options) {
  list.add("--keyframe", &options.keyframe, "Start at this keyframe of the scene: its name, or its number from 0",
           {.unit = "NAME|NUMBER"});
  list.add("--ctrl", &options.files.controls,
           "Lead actuators by a table (CSV): a column `time` [s] from the start of the run, and a column for each led "
           "actuator by its name. Values between two rows are linear; the first and the last are held. Other actuators "
           "keep their control of the start",
           {.unit = "TABLE"});
  list.add("--mocap", &options.files.mocaps,
           "Lead mocap bodies by a table, as --ctrl: columns BODY_x, BODY_y, BODY_z [m] and, for the orientation, "
           "BODY_qw, BODY_qx, BODY_qy, BODY_qz; without BODY_ in a scene with one mocap body",
           {.unit = "TABLE"});
  list.add("--replay", &options.files.run,
           "Lead the first mocap body by the poses of a recorded run: a folder that `taxel sweep`, `play` or `run` "
           "wrote, or its readings.npz",
           {.unit = "RUN", .excludes = {"--mocap"}});
}

double lead_scene(Simulator& simulator, const LeadOptions& options, const std::string& scene, Console& console) {
  const SimScene& loaded = *simulator.scene();
  if (!options.keyframe.empty()) simulator.load_keyframe(keyframe_named(options.keyframe, loaded.controls, scene));
  if (options.files.is_empty()) return 0;
  const SceneLeadPtr lead = read_lead(options.files, loaded.controls);
  for (const std::string& note : lead->notes) console.warn(note);
  simulator.lead(lead);
  return static_cast<double>(steps_of(*lead, loaded.timestep)) * loaded.timestep;
}

}  // namespace taxel::cli
