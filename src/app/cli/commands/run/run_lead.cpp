#include "app/cli/commands/run/run_lead.h"

#include "core/sim/host/lead_simulator.h"

namespace taxel::cli {

void add_lead(OptionList& list, LeadRequest& request) {
  list.add("--keyframe", &request.keyframe, "Start at this keyframe of the scene: its name, or its number from 0",
           {.unit = "NAME|NUMBER"});
  list.add("--ctrl", &request.files.controls,
           "Lead actuators by a table (CSV): a column `time` [s] from the start of the run, and a column for each led "
           "actuator by its name. Values between two rows are linear; the first and the last are held. Other actuators "
           "keep their control of the start",
           {.unit = "TABLE"});
  list.add("--mocap", &request.files.mocaps,
           "Lead mocap bodies by a table, as --ctrl: columns BODY_x, BODY_y, BODY_z [m] and, for the orientation, "
           "BODY_qw, BODY_qx, BODY_qy, BODY_qz; without BODY_ in a scene with one mocap body",
           {.unit = "TABLE"});
  list.add("--replay", &request.files.run,
           "Lead the first mocap body by the poses of a recorded run: a folder that `taxel sweep`, `play` or `run` "
           "wrote, or its readings.npz",
           {.unit = "RUN", .excludes = {"--mocap"}});
}

double lead_scene(Simulator& simulator, const LeadRequest& request, const std::string& scene, Console& console) {
  const SceneLeadPtr lead = lead_simulator(simulator, request, scene);
  if (lead == nullptr) return 0;
  for (const std::string& note : lead->notes) console.warn(note);
  const double timestep = simulator.scene()->timestep;
  return static_cast<double>(steps_of(*lead, timestep)) * timestep;
}

}  // namespace taxel::cli
