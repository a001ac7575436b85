// taxel mesh: describes a mesh and repairs, decimates or subdivides it.
#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>

#include "app/cli/command_layout.h"
#include "app/cli/command_line.h"
#include "app/cli/report_writer.h"
#include "app/cli/signals.h"
#include "core/base/error.h"
#include "core/layout/words.h"
#include "core/mesh/compare.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"
#include "core/mesh/topology/mesh_check.h"
#include "core/mesh/topology/remesh.h"
#include "core/mesh/tri_mesh.h"

namespace taxel::cli {

namespace {

struct TopologyOptions {
  std::optional<int> decimate;   ///< requested number of faces
  std::optional<int> subdivide;  ///< requested number of subdivisions
  std::string scheme = "midpoint";
  [[nodiscard]] bool is_requested() const { return decimate || subdivide; }
};

/// A mesh before and after a change of its topology, and the distance between both surfaces.
struct TopologyReport {
  TopologyOptions options;
  TriMeshPtr before, after;
  SurfaceDistance distance;

  void visit(ReportWriter& w) const;
  [[nodiscard]] std::string text() const;
};

void visit_mesh(ReportWriter& w, const TriMesh& mesh) {
  w("vertices", mesh.vertex_count());
  w("triangles", mesh.face_count());
  w("closed", mesh.closed());
  w("area", mesh.area());
  w("volume", mesh.volume());
}

/// Adds --decimate, --subdivide and --scheme. `options` must outlive the parsing.
void add_topology_options(OptionList& list, TopologyOptions& options) {
  list.add("--decimate", &options.decimate,
           "Collapse edges until N triangles are left, beginning with the edges that move the surface least",
           {.unit = "N"});
  list.add("--subdivide", &options.subdivide, "Split every triangle into four, N times",
           {.unit = "N", .excludes = {"--decimate"}});
  list.add(
      "--scheme", &options.scheme,
      "Scheme of --subdivide: midpoint does not move the surface, loop smooths and shrinks it (Loop 1987)",
      {.unit = "WORD", .check = one_of({"midpoint", "loop"}), .default_text = "midpoint", .needs = {"--subdivide"}});
}

/// Decimates or subdivides a mesh. Throws Error naming `file`.
TopologyReport change_topology(const TriMeshPtr& mesh, const TopologyOptions& options, const std::string& file) {
  TopologyReport report{options, mesh, nullptr, {}};
  try {
    const SubdivisionScheme scheme = options.scheme == "loop" ? SubdivisionScheme::loop : SubdivisionScheme::midpoint;
    report.after = std::make_shared<const TriMesh>(options.decimate ? decimate(*mesh, *options.decimate)
                                                                    : subdivide(*mesh, *options.subdivide, scheme));
  } catch (const Error& e) {
    throw Error(file, e.where(), e.message());
  }
  report.distance = measure_surface_distance(report.before, report.after);
  return report;
}

void TopologyReport::visit(ReportWriter& w) const {
  w("change", options.decimate ? "decimate" : "subdivide");
  w("asked", options.decimate ? *options.decimate : *options.subdivide);
  if (options.subdivide) w("scheme", options.scheme);
  w.object("before", [&](ReportWriter& mesh) { visit_mesh(mesh, *before); });
  w.object("after", [&](ReportWriter& mesh) { visit_mesh(mesh, *after); });
  w("distance_max", distance.largest);
  w("distance_rms", distance.rms);
}

std::string TopologyReport::text() const {
  std::string text = options.decimate
                         ? fmt::format("decimated from {} to {} triangles\n", before->face_count(), after->face_count())
                         : fmt::format("subdivided from {} to {} triangles by {}\n", before->face_count(),
                                       after->face_count(), options.scheme);
  if (options.decimate && after->face_count() > *options.decimate)
    text += fmt::format("{} were requested: removing another edge would fold the mesh or change its topology\n",
                        *options.decimate);
  text +=
      fmt::format("{} before, {} after\n", before->closed() ? "closed" : "open", after->closed() ? "closed" : "open");
  text += fmt::format("largest distance of the surfaces {:.4g} m, rms {:.4g} m\n", distance.largest, distance.rms);
  text += fmt::format("area {:.6g} m^2 before, {:.6g} m^2 after; volume {:.6g} m^3 before, {:.6g} m^3 after\n",
                      before->area(), after->area(), before->volume(), after->volume());
  return text;
}

struct RepairOptions {
  std::string level;  ///< word of a RepairLevel, or empty if no repair is requested
  RepairRecipe recipe;
};

/// Adds --repair, --edge, --tolerance, --join and --fill. `options` must outlive the parsing.
void add_repair_options(OptionList& list, RepairOptions& options) {
  std::vector<std::string> names;
  for (const Word<RepairLevel>& word : words_of(RepairLevel{})) names.emplace_back(word.text);
  list.add("--repair", &options.level,
           "Repair the mesh into a solid: auto, exact (never wraps), wrap (always), keep (only check)",
           {.unit = "LEVEL", .check = one_of(names)});
  const auto add_length = [&](const char* name, std::optional<double>& value, const char* help, const char* text) {
    list.add(name, &value, help, {.text = text, .needs = {"--repair"}});
  };
  add_length("--edge", options.recipe.edge, "Edge length of a wrap in metres", "M=diagonal/128");
  add_length("--tolerance", options.recipe.tolerance, "Largest simplification error of a wrap in metres", "M=edge/6");
  add_length("--join", options.recipe.join, "Largest distance over which rims are joined in metres", "M=3e-4 diagonal");
  add_length("--fill", options.recipe.fill, "Widest hole that is filled without a warning in metres", "M=0.1 diagonal");
}

/// Returns the repaired mesh, or null if the options request no repair. Throws Error naming `file`.
RepairedMeshPtr repair_if_requested(const LoadedMesh& loaded, const RepairOptions& options, const std::string& file,
                                    Console& console) {
  if (options.level.empty()) return nullptr;
  RepairRecipe recipe = options.recipe;
  recipe.level = from_word<RepairLevel>(options.level).value_or(recipe.level);
  try {
    return with_progress(console, [&](Progress& progress) { return repair_mesh(loaded.mesh, recipe, 0.0, &progress); });
  } catch (const Error& error) {
    throw Error(file, error.where(), error.message());
  }
}

/// Writes all changes of a repair. Lengths in metres, areas in square metres.
void visit_repair(ReportWriter& w, const RepairReport& report) {
  w("level", to_word(report.level));
  w("closed", report.closed);
  w("faces_before", report.faces_before);
  w("faces_after", report.faces_after);
  w("shells_before", report.shells_before);
  w("shells_after", report.shells_after);
  w("vertices_moved", report.vertices_moved);
  w("largest_move", report.largest_move);
  w("distance_max", report.distance_max);
  w("distance_rms", report.distance_rms);
  w("area_added", report.area_added);
  w("area_removed", report.area_removed);
  w("seconds", report.seconds);
  w.list("steps", report.steps, [](ReportWriter& step, const RepairStep& s) {
    step("code", s.code);
    step("count", s.count);
    step("faces", s.faces);
    step("area", s.area);
    step("length", s.length);
    step("place", s.place);
  });
}

/// Returns the changes as lines of text.
std::string repair_text(const RepairedMesh& repaired) {
  const RepairReport& report = repaired.report;
  if (report.steps.empty()) return "repair: nothing to do\n";
  std::string text = repair_summary(report) + "\n";
  for (const RepairStep& step : report.steps)
    text += fmt::format("  {}: {}: {}\n", to_string(step.severity), step.code, step.message);
  const TriMesh& mesh = *repaired.mesh;
  text += fmt::format("repaired mesh: {} vertices, {} triangles, {}, {} shell{}, volume {} m^3\n", mesh.vertex_count(),
                      mesh.face_count(), mesh.closed() ? "closed" : "open", mesh.shell_count(),
                      mesh.shell_count() == 1 ? "" : "s", mesh.volume());
  return text;
}

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
  const RepairedMeshPtr repaired = repair_if_requested(loaded, options.repair, options.file, console);
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
