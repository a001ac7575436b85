// Pads on real meshes and on difficult generated meshes: time to build, and quality of the field.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>

#include "core/hydro/fields/pressure_field.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/repair/repair.h"
#include "fixtures/pad_checks.h"
#include "fixtures/pad_meshes.h"
#include "fixtures/rough_meshes.h"

namespace {
using namespace taxel;

struct Row {
  const char* name;
  TriMesh mesh;
  double thickness;
};

std::string wanted;  // measures only meshes whose name contains this text

struct Times {
  double best, median;  ///< [ms]
};

/// Measures the times of repeated calls of `work`. `clock` returns milliseconds from any start.
template <class Work, class Clock>
Times repeat(const Work& work, const Clock& clock) {
  constexpr int kRepeats = 15;
  std::vector<double> times;
  for (int i = 0; i < kRepeats; ++i) {
    const double start = clock();
    work();
    times.push_back(clock() - start);
  }
  std::sort(times.begin(), times.end());
  return {times.front(), times[kRepeats / 2]};
}

void measure(const Row& row, const char* layers, PadLayering layering) {
  const auto mesh = std::make_shared<const TriMesh>(row.mesh);
  PressureFieldPtr field;
  // Other layerings are only for comparison and use the same skin.
  const double refine = layering == PadLayering::automatic ? kDefaultRefine : 0.0;
  const auto make = [&] { field = make_pad_field(mesh, 1e5, row.thickness, {}, layering, refine); };
  const Times waiting = repeat(make, [] {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
  });
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  // Processor time, which other programs on the machine do not change.
  const Times times = repeat(make, [] { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; });
  const FieldReport& report = field->report();
  const Fidelity good = fidelity(*field, MeshIndex(mesh), 1e5, row.thickness);
  fmt::print(
      "{:<24}{:>7}{:>7.1f}{:>8}{:>8}{:>9.1f}{:>9.1f}{:>9.1f}{:>8}{:>7}{:>7}{:>7}{:>7}{:>9.2f}{:>7.3f}{:>7.1f}{:>8.3f}"
      "{:>6.1f}{:>7.1f}{:>7.1f}{:>9.1f}{:>7.2f}{:>8.1f}\n",
      row.name, mesh->face_count(), 1e3 * row.thickness, layers, report.two_layer_faces, times.best, times.median,
      waiting.median, report.tets, report.refined_faces, report.caps, report.inverted, report.zero_gradient,
      100 * report.stiffness_cv, 100 * report.bare.area / report.skin_area, 100 * report.thickness_limited_fraction,
      report.press_errors[0].mean, 100 * report.press_errors[0].deviation, 100 * report.press_errors[0].without_tets,
      100 * report.press_errors[1].without_tets, 100 * good.filled, 100 * good.rms, 100 * good.worst);
  for (const std::string& note : report.notes) fmt::print("    {}\n", note);
}

void measure(const Row& row) {
  if (std::string(row.name).find(wanted) == std::string::npos) return;
  measure(row, "auto", PadLayering::automatic);
  measure(row, "one", PadLayering::one);
  measure(row, "two", PadLayering::two);
}

void measure_file(const char* name, const char* file, double scale, double thickness) {
  const std::filesystem::path path = std::filesystem::path(TAXEL_REAL_DATA) / file;
  if (!std::filesystem::exists(path)) {
    fmt::print("{:<24}skipped: no {}\n", name, path.string());
    return;
  }
  const TriMeshPtr mesh = repair_mesh(load_mesh(path, dvec3(scale)).mesh, {}, thickness)->mesh;
  if (!mesh->closed()) {
    fmt::print("{:<24}skipped: not closed\n", name);
    return;
  }
  measure({name, extract_shells(*mesh, outer_shells(*mesh)), thickness});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) wanted = argv[1];
  fmt::print(
      "{:<24}{:>7}{:>7}{:>8}{:>8}{:>9}{:>9}{:>9}{:>8}{:>7}{:>7}{:>7}{:>7}{:>9}{:>7}{:>7}{:>8}{:>6}{:>7}{:>7}{:>9}{:>7}"
      "{:>8}\n",
      "mesh", "faces", "H mm", "layers", "double", "best ms", "median", "cores ms", "tets", "added", "tents", "invert",
      "zero", "CV %", "bare %", "thin %", "0.1 H", "+- %", "none %", "1/4 H", "filled %", "rms %", "worst %");
  measure_file("Shadow fingertip", "meshes/shadow_f_distal_pst.stl", 0.001, 0.002);
  measure_file("BioTac fingertip", "meshes/shadow_f_distal_bt_sp.stl", 0.001, 0.002);
  measure_file("plate", "meshes/plate_8in_col.stl", 1, 0.002);
  measure_file("Spot", "meshes/spot/spot_triangulated.obj", 0.1, 0.005);
  measure_file("paper's fingertip", "paper/ubi_tip_collision.stl", 0.001, 0.002);
  measure_file("Ability thumb", "skins/ability_thumb.glb", 1, 0.002);
  measure_file("Inspire thumb", "skins/inspire_thumb.obj", 1, 0.002);
  measure_file("Allegro tip", "skins/allegro_tip.stl", 1, 0.002);
  measure_file("D'Claw tip", "skins/dclaw_tip.obj", 1, 0.002);
  measure_file("DIGIT holder", "skins/digit_holder.stl", 0.001, 0.002);
  measure_file("gripper flange", "skins/gripper_flange.stl", 0.001, 0.002);
  measure_file("LEAP link", "skins/leap_pip.stl", 1, 0.002);
  measure({"own fingertip", make_fingertip(), 0.002});
  measure({"wedge of 12 faces", make_wedge(), 0.002});
  measure({"rough ball", make_rough_ball(2, 0.6, 2), 0.002});
  measure({"sphere", make_icosphere(0.02, 4), 0.004});
  measure({"torus", make_torus(0.02, 0.006, 80, 32), 0.002});
  measure({"torus, deep", make_torus(0.02, 0.006, 80, 32), 0.006});
  measure({"L-block", make_l_block(0.005, 8), 0.003});
  measure({"L-block, coarse", make_l_block(0.02, 2), 0.005});
  measure({"L-block, short edges", make_l_block(0.001, 10), 0.0025});
  measure({"L-block, shorter edges", make_l_block(0.0005, 20), 0.0025});
  measure({"notched cube", make_notched_cube(0.005, 8), 0.003});
  measure({"thimble, 2.5 mm wall", make_thimble(0.008, 0.015, 0.0025, 0.001), 0.002});
  measure({"thimble, 1 mm pad", make_thimble(0.008, 0.015, 0.0025, 0.001), 0.001});
  measure({"sharp plate", make_sharp_plate(0.03, 0.006, 0.002), 0.002});
  measure({"sharper plate", make_sharp_plate(0.03, 0.002, 0.002), 0.001});
}
