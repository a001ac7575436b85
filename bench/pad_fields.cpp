// Pads on the real meshes and on generated ones that are hard: time to build on one core, and what the field is worth.
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <ctime>
#include <filesystem>

#include "core/base/rng.h"
#include "core/hydro/pressure_field.h"
#include "core/mesh/closest_point.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/pad_meshes.h"

namespace {
using namespace taxel;

struct Row {
  const char* name;
  TriMesh mesh;
  double thickness;
};

/// How well the tets hold p = E min(depth, H)/H where the depth is below H: the part of that volume that they fill, and
/// the error of the pressure there, root mean square and largest, in parts of E. By points at random.
struct Fidelity {
  double filled = 0, rms = 0, worst = 0;
};

Fidelity fidelity(const PressureField& field, const MeshIndex& index, double modulus, double thickness) {
  const CounterRng rng(7);
  const Aabb& box = index.mesh().bounds();
  int inside = 0, found = 0;
  Fidelity result;
  const Bvh tree = tree_of_tets(field);
  for (std::uint64_t i = 0; inside < 40000; ++i) {
    const dvec3 x = box.lo + box.extent() * dvec3(rng.uniform(3 * i), rng.uniform(3 * i + 1), rng.uniform(3 * i + 2));
    const double depth = -index.signed_distance(x);
    if (!(depth > 0 && depth < thickness)) continue;
    ++inside;
    double pressure = -1;
    tree.visit(
        [&](const Aabb& node) {
          return node.overlaps({x, x});
        },
        [&](int t) {
          const Tet& tet = field.tets()[static_cast<std::size_t>(t)];
          bool in = true;
          for (std::size_t k = 0; k < 4; ++k) in = in && glm::dot(tet.normal[k], x) + tet.offset[k] >= 0;
          if (in) pressure = glm::dot(tet.gradient, x) + tet.constant;
        });
    if (pressure < 0) continue;
    ++found;
    const double error = std::abs(pressure / modulus - depth / thickness);
    result.rms += error * error;
    result.worst = std::max(result.worst, error);
  }
  result.filled = static_cast<double>(found) / inside;
  result.rms = std::sqrt(result.rms / std::max(1, found));
  return result;
}

std::string wanted;  // part of a name: measure only these

void measure(const Row& row) {
  if (std::string(row.name).find(wanted) == std::string::npos) return;
  constexpr int kRepeats = 15;
  const auto mesh = std::make_shared<const TriMesh>(row.mesh);
  std::vector<double> times;
  PressureFieldPtr field;
  for (int i = 0; i < kRepeats; ++i) {
    const std::clock_t start = std::clock();  // processor time: nothing else on the machine counts
    field = make_pad_field(mesh, 1e5, row.thickness);
    times.push_back(1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::sort(times.begin(), times.end());
  const FieldReport& report = field->report();
  const Fidelity good = fidelity(*field, MeshIndex(mesh), 1e5, row.thickness);
  fmt::print("{:<24}{:>7}{:>7.1f}{:>9.1f}{:>9.1f}{:>8}{:>9}{:>9}{:>9.2f}{:>9.1f}{:>9.1f}{:>9.2f}{:>9.1f}\n", row.name,
             mesh->face_count(), 1e3 * row.thickness, times.front(), times[kRepeats / 2], report.tets, report.inverted,
             report.zero_gradient, 100 * report.stiffness_cv, 100 * report.thickness_limited_fraction,
             100 * good.filled, 100 * good.rms, 100 * good.worst);
  for (const std::string& note : report.notes) fmt::print("    {}\n", note);
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
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  fmt::print("{:<24}{:>7}{:>7}{:>9}{:>9}{:>8}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n", "mesh", "faces", "H mm", "best ms",
             "median", "tets", "inverted", "zero", "CV %", "thin %", "filled %", "rms %", "worst %");
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
  measure({"notched cube", make_notched_cube(0.005, 8), 0.003});
  measure({"thimble, 2.5 mm wall", make_thimble(0.008, 0.015, 0.0025, 0.001), 0.002});
  measure({"thimble, 1 mm pad", make_thimble(0.008, 0.015, 0.0025, 0.001), 0.001});
  measure({"sharp plate", make_sharp_plate(0.03, 0.006, 0.002), 0.002});
  measure({"sharper plate", make_sharp_plate(0.03, 0.002, 0.002), 0.001});
}
