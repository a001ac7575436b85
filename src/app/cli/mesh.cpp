// taxel mesh: what a mesh is and what was repaired.
#include <fmt/format.h>

#include <memory>

#include "app/cli/command.h"
#include "app/cli/mesh_repair.h"
#include "app/cli/mesh_report.h"
#include "app/cli/mesh_topology.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel::cli {

std::string mesh_text(const LoadedMesh& loaded) {
  const TriMesh& mesh = *loaded.mesh;
  const dvec3 size = mesh.bounds().extent();
  const int enclosed = mesh.shell_count() - static_cast<int>(outer_shells(mesh).size());
  std::string text = fmt::format("{} vertices, {} triangles, {}\n", mesh.vertex_count(), mesh.face_count(),
                                 mesh.closed() ? "closed" : "open");
  text +=
      fmt::format("{} shell{}, {} inside another\n", mesh.shell_count(), mesh.shell_count() == 1 ? "" : "s", enclosed);
  text += fmt::format("size {} x {} x {} m, area {} m^2, volume {} m^3\n", size.x, size.y, size.z, mesh.area(),
                      mesh.volume());
  text += fmt::format("sha256 {}\n", loaded.sha256);
  for (const std::string& note : loaded.notes) text += fmt::format("repaired: {}\n", note);
  for (const Problem& p : check_mesh(mesh, "")) text += fmt::format("{}: {}\n", to_string(p.severity), p.message);
  return text;
}

namespace {

struct Options {
  std::string file;
  std::string out;
  std::string scale = "1";
  TopologyOptions topology;
  RepairOptions repair;
};

/// Decimates or subdivides, and reports that alone.
int run_topology(const TriMeshPtr& mesh, const Options& options, Console& console) {
  const ChangedMesh changed = change_topology(mesh, options.topology, options.file);
  if (!options.out.empty()) save_mesh(options.out, *changed.after);
  console.result(console.json() ? topology_json(changed, options.topology) : topology_text(changed, options.topology));
  return kDone;
}

int run(const Options& options, Console& console) {
  const LoadedMesh loaded = load_mesh(options.file, parse_scale("mesh", options.scale));
  const RepairedMeshPtr repaired = repair_as_asked(loaded, options.repair, options.file);
  const TriMeshPtr mesh = repaired ? repaired->mesh : loaded.mesh;
  if (options.topology.is_asked()) return run_topology(mesh, options, console);
  if (!options.out.empty()) save_mesh(options.out, *mesh);
  if (console.json())
    console.result(mesh_json(loaded, repaired.get()));
  else
    console.result(mesh_text(loaded) + (repaired ? repair_text(*repaired) : ""));
  return kDone;
}

}  // namespace

Command add_mesh(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(parent, common, "mesh", "What a mesh is and what was repaired",
                              "taxel mesh finger.stl --scale 0.001 --out finger.obj");
  app->add_option("FILE", options->file, "Mesh: .obj .stl .ply .off .gltf .glb")->required()->option_text("(required)");
  app->add_option("--scale", options->scale, "Multiply coordinates by one number, or by three: X,Y,Z (0.001 for mm)")
      ->option_text("X=1");
  add_repair_options(*app, options->repair);
  add_topology_options(*app, options->topology);
  app->add_option("--out", options->out, "Write the mesh as repaired, decimated or subdivided: .obj .stl .off .glb")
      ->type_name("FILE");
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
