// Pads on the real meshes and on generated ones that are hard: time to build, and what the field is worth.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>

#include "core/hydro/pressure_field.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/pad_checks.h"
#include "fixtures/pad_meshes.h"

namespace {
using namespace taxel;

struct Row {
  const char* name;
  TriMesh mesh;
  double thickness;
};

std::string wanted;  // part of a name: measure only these

struct Times {
  double best, median;  ///< [ms]
};

/// `clock`: milliseconds from any start.
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
  const auto make = [&] { field = make_pad_field(mesh, 1e5, row.thickness, {}, layering); };
  const Times waiting = repeat(make, [] {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
  });
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  // Processor time: nothing else on the machine counts.
  const Times times = repeat(make, [] { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; });
  const FieldReport& report = field->report();
  const Fidelity good = fidelity(*field, MeshIndex(mesh), 1e5, row.thickness);
  fmt::print(
      "{:<24}{:>7}{:>7.1f}{:>8}{:>8}{:>9.1f}{:>9.1f}{:>9.1f}{:>8}{:>9}{:>9}{:>9.2f}{:>9.1f}{:>9.1f}{:>9.2f}{:>9.1f}\n",
      row.name, mesh->face_count(), 1e3 * row.thickness, layers, report.two_layer_faces, times.best, times.median,
      waiting.median, report.tets, report.inverted, report.zero_gradient, 100 * report.stiffness_cv,
      100 * report.thickness_limited_fraction, 100 * good.filled, 100 * good.rms, 100 * good.worst);
  for (const std::string& note : report.notes) fmt::print("    {}\n", note);
}

void measure(const Row& row) {
  if (std::string(row.name).find(wanted) == std::string::npos) return;
  measure(row, "auto", PadLayering::automatic);
  measure(row, "one", PadLayering::one);
  measure(row, "two", PadLayering::two);
}

void measure_file(const char* name, const char* file, double scale, double thickness) {
  const std::filesystem::path path = std::filesystem::path(TAXEL_REAL_DATA) / "meshes" / file;
  if (!std::filesystem::exists(path)) {
    fmt::print("{:<24}skipped: no {}\n", name, path.string());
    return;
  }
  const LoadedMesh loaded = load_mesh(path, dvec3(scale));
  measure({name, extract_shells(*loaded.mesh, outer_shells(*loaded.mesh)), thickness});
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1) wanted = argv[1];
  fmt::print("{:<24}{:>7}{:>7}{:>8}{:>8}{:>9}{:>9}{:>9}{:>8}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n", "mesh", "faces",
             "H mm", "layers", "double", "best ms", "median", "cores ms", "tets", "inverted", "zero", "CV %", "thin %",
             "filled %", "rms %", "worst %");
  measure_file("Shadow fingertip", "shadow_f_distal_pst.stl", 0.001, 0.002);
  measure_file("BioTac fingertip", "shadow_f_distal_bt_sp.stl", 0.001, 0.002);
  measure_file("plate", "plate_8in_col.stl", 1, 0.002);
  measure_file("Spot", "spot/spot_triangulated.obj", 0.1, 0.005);
  measure({"own fingertip", make_fingertip(), 0.002});
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
