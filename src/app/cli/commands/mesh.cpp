// taxel mesh: describes a mesh and repairs, decimates or subdivides it.
#include <fmt/format.h>

#include <memory>

#include "app/cli/commands/mesh_repair.h"
#include "app/cli/commands/mesh_topology.h"
#include "app/cli/layout_options.h"
#include "app/cli/signals.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel::cli {
namespace {

struct MeshOptions {
  std::string file;
  std::string out;
  std::string scale = "1";
  TopologyOptions topology;
  RepairOptions repair;
};

struct MeshReport {
  LoadedMesh loaded;
  RepairedMeshPtr repaired;  ///< repaired mesh, or null without --repair

  /// Number of shells inside of another one.
  [[nodiscard]] int enclosed_shells() const {
    return loaded.mesh->shell_count() - static_cast<int>(outer_shells(*loaded.mesh).size());
  }
  void visit(ReportWriter& w) const {
    const TriMesh& mesh = *loaded.mesh;
    w("vertices", mesh.vertex_count());
    w("triangles", mesh.face_count());
    w("closed", mesh.closed());
    w("shells", mesh.shell_count());
    w("enclosed_shells", enclosed_shells());
    w("area", mesh.area());
    w("volume", mesh.volume());
    w("centroid", mesh.centroid());
    w.object("bounds", [&](ReportWriter& bounds) {
      bounds("lower", mesh.bounds().lo);
      bounds("upper", mesh.bounds().hi);
    });
    w("sha256", loaded.sha256);
    w("notes", loaded.notes);
    w.list("problems", check_mesh(mesh, ""), [](ReportWriter& problem, const Problem& p) {
      problem("severity", to_string(p.severity));
      problem("code", p.code);
      problem("message", p.message);
      problem("fix", p.fix);
    });
    if (repaired != nullptr) w.object("repair", [&](ReportWriter& repair) { visit_repair(repair, repaired->report); });
  }
  [[nodiscard]] std::string text() const {
    const TriMesh& mesh = *loaded.mesh;
    const dvec3 size = mesh.bounds().extent();
    std::string text = fmt::format("{} vertices, {} triangles, {}\n", mesh.vertex_count(), mesh.face_count(),
                                   mesh.closed() ? "closed" : "open");
    text += fmt::format("{} shell{}, {} inside another\n", mesh.shell_count(), mesh.shell_count() == 1 ? "" : "s",
                        enclosed_shells());
    text += fmt::format("size {} x {} x {} m, area {} m^2, volume {} m^3\n", size.x, size.y, size.z, mesh.area(),
                        mesh.volume());
    text += fmt::format("sha256 {}\n", loaded.sha256);
    for (const std::string& note : loaded.notes) text += fmt::format("repaired: {}\n", note);
    for (const Problem& p : check_mesh(mesh, "")) text += fmt::format("{}: {}\n", to_string(p.severity), p.message);
    return repaired ? text + repair_text(*repaired) : text;
  }
};

int run_mesh_command(const MeshOptions& options, Console& console) {
  const dvec3 scale = parse_scale("mesh", options.scale);
  const LoadedMesh loaded =
      with_progress(console, [&](Progress& progress) { return load_mesh(options.file, scale, &progress); });
  const RepairedMeshPtr repaired = repair_if_requested(loaded, options.repair, options.file);
  TriMeshPtr mesh = repaired ? repaired->mesh : loaded.mesh;
  std::optional<TopologyReport> change;
  if (options.topology.is_requested()) {
    change = change_topology(mesh, options.topology, options.file);
    mesh = change->after;
  }
  if (!options.out.empty()) save_mesh(options.out, *mesh);
  if (change)
    print_report(console, *change);  // the only report, also if the mesh was repaired before
  else
    print_report(console, MeshReport{loaded, repaired});
  return kDone;
}

}  // namespace

Run add_mesh(OptionList& list) {
  const auto options = std::make_shared<MeshOptions>();
  list.add("FILE", &options->file, "Mesh: " + extensions(can_read), required());
  list.add("--scale", &options->scale, "Multiply coordinates by one number, or by three: X,Y,Z (0.001 for mm)",
           {.text = "X=1"});
  add_repair_options(list, options->repair);
  add_topology_options(list, options->topology);
  list.add("--out", &options->out, "Write the mesh as repaired, decimated or subdivided: " + extensions(can_write),
           {.unit = "FILE"});
  return [options](Console& console) { return run_mesh_command(*options, console); };
}

}  // namespace taxel::cli
