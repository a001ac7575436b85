// The table of all commands: a new command is a file in commands/ and, here, its declaration and its row.
#include "app/cli/command_line.h"

namespace taxel::cli {

Run add_align(OptionList& list);
Run add_batch(OptionList& list);
Run add_check(OptionList& list);
Run add_contact(OptionList& list);
Run add_convert(OptionList& list);
Run add_explain(OptionList& list);
Run add_material(OptionList& list);
Run add_mesh(OptionList& list);
Run add_models(OptionList& list);
Run add_play(OptionList& list);
Run add_plot(OptionList& list);
Run add_presets(OptionList& list);
Run add_read(OptionList& list);
Run add_run(OptionList& list);
Run add_samples(OptionList& list);
Run add_study(OptionList& list);
Run add_sweep(OptionList& list);
Run add_validate(OptionList& list);

const std::vector<CommandSpec>& commands() {
  static const std::vector<CommandSpec> table{
      {"sweep", "The fingertip sweep of the paper: a finger slides over an edge that points up",
       "taxel sweep --layout finger.taxels.json --out result", add_sweep},
      {"play", "A scenario (sweep, press, roll, twist, slide, drop, path or replay) around a layout",
       "taxel play press.json --layout finger.taxels.json --out result", add_play},
      {"study", "A scenario with several values of one or two parameters, as many runs at a time as there are cores",
       "taxel study depths.json --layout finger.taxels.json --out result", add_study},
      {"batch", "A list of jobs (layout, scenario, changed parameters) on all cores, as a data set; resumes if killed",
       "taxel batch jobs.jsonl --out data", add_batch},
      {"run", "Any MuJoCo scene, with the sensors it declares or a layout attached to a geom",
       "taxel run scene.xml --layout finger.taxels.json --geom fingertip --seconds 2 --out result", add_run},
      {"contact", "One contact between two shapes at given poses",
       "taxel contact sphere_on_plane.json --polygons surface.csv --repeat 100", add_contact},
      {"read", "The readings of a layout in one contact, with every aggregate and its samples",
       "taxel read finger.taxels.json finger_on_box.json --json", add_read},
      {"explain",
       "Where a recorded reading comes from: its samples and polygons, the exact integral, the changes since the "
       "previous row, and whether the contact or the method caused them",
       "taxel explain result --taxel 3 --time 1.25", add_explain},
      {"align",
       "Aligns a recording of a real sensor with a run: finds the time shift, and gain and offset of each taxel by "
       "least squares",
       "taxel align result real.csv --map real.recmap.json --out aligned.csv", add_align},
      {"models",
       "The contacts of a recording as other models of a taxel read them: a star field, the weighted sum, the exact "
       "integral, MuJoCo's <tactile> depth, one MuJoCo touch site for each taxel",
       "taxel models result --every 4 --out models.csv", add_models},
      {"plot", "Plots of a recorded run or study as SVG or PDF: readings over travel or time, heat map, forces",
       "taxel plot result --normalised --out figure_4.pdf", add_plot},
      {"samples", "Samples and receptive fields of a layout",
       "taxel samples finger.taxels.json --out samples.csv --fields fields.csv", add_samples},
      {"mesh", "Size, shells and problems of a mesh, and the changes by its repair",
       "taxel mesh finger.stl --scale 0.001 --out finger.obj", add_mesh},
      {"material",
       "The modulus of a pad from Young's modulus, Poisson's ratio and thickness, or from a known elastomer",
       "taxel material --preset ecoflex-00-30 --thickness 0.002 --bonded --contact-radius 0.003", add_material},
      {"presets", "Layouts of known sensors, with the sources of their numbers",
       "taxel presets biotac --out biotac.taxels.json", add_presets},
      {"check", "Every problem of layouts, contact cases, sweeps, meshes and scenes, with its JSON pointer",
       "taxel check finger.taxels.json", add_check},
      {"convert",
       "A layout of any format in another format, with a note on each value that is lost or assumed; a recorded run as "
       "MCAP",
       "taxel convert probes.json finger.taxels.json --link finger --mesh finger.stl", add_convert},
      {"validate", "Contact and sensing against closed forms: computed, exact, error, bound",
       "taxel validate --markdown > docs/validation.md", add_validate}};
  return table;
}

}  // namespace taxel::cli
