// taxel mesh: what a mesh is and what was repaired.
#include <fmt/format.h>

#include <memory>

#include "app/cli/command.h"
#include "app/cli/mesh_report.h"

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
  return text;
}

namespace {

struct Options {
  std::string file;
  std::string out;
  std::vector<double> scale{1.0};
};

int run(const Options& options, Console& console) {
  if (options.scale.size() == 2) throw Error("mesh", "--scale takes one number or three");
  const dvec3 scale =
      options.scale.size() == 3 ? dvec3(options.scale[0], options.scale[1], options.scale[2]) : dvec3(options.scale[0]);
  if (scale.x * scale.y * scale.z == 0) throw Error("mesh", "--scale must not be 0");
  const LoadedMesh loaded = load_mesh(options.file, scale);
  if (!options.out.empty()) save_mesh(options.out, *loaded.mesh);
  console.result(console.json() ? mesh_json(loaded) : mesh_text(loaded));
  return kDone;
}

}  // namespace

Command add_mesh(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(parent, common, "mesh", "What a mesh is and what was repaired",
                              "taxel mesh finger.stl --scale 0.001 --out finger.obj");
  app->add_option("FILE", options->file, "Mesh: .obj .stl .ply .off .gltf .glb")->required()->type_name("FILE");
  app->add_option("--scale", options->scale, "Multiply coordinates by one number, or by three for x y z")
      ->expected(1, 3)
      ->check(finite())
      ->type_name("X");
  app->add_option("--out", options->out, "Write the repaired mesh: .obj .stl .off .glb")->type_name("FILE");
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
