// taxel generate: makes layouts by patterns of taxels, on a mesh or on the meshes of a scene's bodies.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include "app/cli/command_layout.h"
#include "app/cli/report_writer.h"
#include "app/cli/signals.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/expression.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/generators/generated_layout.h"
#include "core/layout/generators/pattern_text.h"
#include "core/mesh/mesh_io.h"
#include "core/sim/scene/scene_layouts.h"

namespace taxel::cli {
namespace {

namespace fs = std::filesystem;

struct GenerateOptions {
  std::string file;  ///< mesh or scene
  std::string out;
  std::vector<std::string> bodies;
  GenerateRequest request;
};

/// A written layout.
struct GeneratedFile {
  std::string file, mesh;
  std::size_t taxels = 0;
  int left_out = 0;
  std::vector<std::string> bodies;  ///< empty if a mesh was given
};

struct GenerateReport {
  std::vector<GeneratedFile> layouts;

  void visit(ReportWriter& w) const {
    w.list("layouts", layouts, [](ReportWriter& one, const GeneratedFile& layout) {
      one("file", layout.file);
      one("mesh", layout.mesh);
      one("taxels", layout.taxels);
      one("left_out", layout.left_out);
      one("bodies", layout.bodies);
    });
  }
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const GeneratedFile& layout : layouts)
      text += fmt::format("{}: {} taxels{}{}\n", layout.file, layout.taxels,
                          layout.left_out > 0 ? fmt::format(", {} points are not over the skin", layout.left_out) : "",
                          layout.bodies.empty() ? "" : fmt::format(", for {}", fmt::join(layout.bodies, ", ")));
    return text;
  }
};

/// Returns the name of the option for a field: "max_slope_deg" is --max-slope.
std::string generate_option(const std::string& key) {
  std::string name = key.ends_with("_deg") ? key.substr(0, key.size() - 4) : key;
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

/// Returns a vector of "X,Y,Z", each a number with arithmetic in `unit`. Throws Error naming the option.
dvec3 parse_vector(const std::string& option, const std::string& text, const std::string& unit) {
  std::vector<double> numbers;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    try {
      numbers.push_back(evaluate(text.substr(begin, end - begin), unit));
    } catch (const Error& error) {
      throw Error("generate", option, fmt::format("\"{}\": {}", text, error.message()));
    }
    begin = end + 1;
  }
  if (numbers.size() != 3) throw Error("generate", option, fmt::format("must be three numbers X,Y,Z, is \"{}\"", text));
  return {numbers[0], numbers[1], numbers[2]};
}

/// Makes one layout. Errors about a field name its option.
GeneratedLayout generate_on(const fs::path& mesh, const GenerateRequest& request, Console& console) {
  try {
    return with_progress(console, [&](Progress& progress) { return generate_layout(mesh, request, &progress); });
  } catch (const Error& error) {
    const std::vector<PatternFieldHelp> fields = pattern_fields();
    const std::array<std::string_view, 5> others{"pattern", "region", "pad", "distal", "at"};
    const bool is_option =
        std::any_of(fields.begin(), fields.end(), [&](const auto& f) { return f.key == error.where(); }) ||
        std::find(others.begin(), others.end(), error.where()) != others.end();
    if (!is_option) throw;
    throw Error(error.file().empty() ? "generate" : error.file(), generate_option(error.where()), error.message());
  }
}

/// Writes the layout with the path of its mesh from the layout's folder.
GeneratedFile write_generated(GeneratedLayout made, const fs::path& out, Console& console) {
  for (const std::string& note : made.notes) console.note(fmt::format("{}: {}", made.layout.mesh.file, note));
  const fs::path mesh = fs::absolute(made.layout.mesh.file).lexically_normal();
  const fs::path relative = mesh.lexically_relative(fs::absolute(out).lexically_normal().parent_path());
  if (!relative.empty()) made.layout.mesh.file = relative.generic_string();
  write_layout(out, made.layout);
  return {out.string(), mesh.string(), made.layout.taxels.size(), made.left_out, {}};
}

bool is_scene_file(const fs::path& file) {
  const std::string extension = file.extension().string();
  return extension == ".xml" || extension == ".mjcf" || extension == ".urdf";
}

/// Writes a layout for each mesh of the scene's bodies into the folder `out`.
GenerateReport generate_on_scene(const GenerateOptions& options, Console& console) {
  const BodyMeshes found = read_body_meshes(options.file, options.bodies);
  for (const std::string& note : found.notes) console.note(fmt::format("{}: left out: {}", options.file, note));
  std::vector<std::pair<fs::path, GeneratedLayout>> made;
  for (const BodyMesh& mesh : found.meshes) {
    const fs::path out = fs::path(options.out) / (mesh.name + ".taxels.json");
    const bool is_taken = std::any_of(made.begin(), made.end(), [&](const auto& one) { return one.first == out; });
    if (is_taken) throw Error(options.file, fmt::format("two meshes have the name \"{}\"", mesh.name));
    GenerateRequest request = options.request;
    request.scale = mesh.scale;
    made.emplace_back(out, generate_on(mesh.file, request, console));
  }
  make_folder(options.out);
  GenerateReport report;
  for (std::size_t i = 0; i < made.size(); ++i) {
    report.layouts.push_back(write_generated(std::move(made[i].second), made[i].first, console));
    report.layouts.back().bodies = found.meshes[i].bodies;
  }
  return report;
}

int run_generate_command(const GenerateOptions& options, Console& console) {
  GenerateReport report;
  if (is_scene_file(options.file)) {
    if (options.request.scale)
      throw Error("generate", "--scale", "is for a mesh: a scene gives the scale of its meshes");
    report = generate_on_scene(options, console);
  } else {
    if (!options.bodies.empty())
      throw Error("generate", "--body", fmt::format("needs a scene (.xml, .mjcf, .urdf), {} is a mesh", options.file));
    if (!options.out.ends_with(".taxels.json"))
      throw Error("generate", "--out", fmt::format("must end with .taxels.json, is {}", options.out));
    report.layouts.push_back(
        write_generated(generate_on(options.file, options.request, console), options.out, console));
  }
  console.note(
      "the material is that of the built-in fingertip, a pad of 2 mm with 50 kPa: taxel material sets another");
  print_report(console, report);
  return kDone;
}

/// Returns a help text of the window without the unit in brackets: options take any unit.
std::string without_unit(const std::string& help) {
  const std::size_t first = help.find(" [mm]");
  return first == std::string::npos ? help : help.substr(0, first) + help.substr(first + 5);
}

/// Adds an option for each field of the patterns. A field of several kinds is one option.
void add_fields(OptionList& list, GenerateRequest& request) {
  for (const PatternFieldHelp& field : pattern_fields()) {
    const auto read = [&request, key = field.key](const std::string& text) { request.values.emplace_back(key, text); };
    list.add(generate_option(field.key), read,
             fmt::format("{} ({})", without_unit(field.help), fmt::join(field.kinds, ", ")),
             {.unit = field.unit.empty()  ? "VALUE"
                      : field.unit == "m" ? "LENGTH"
                                          : "ANGLE",
              .default_text = field.default_text});
  }
}

}  // namespace

Run add_generate(OptionList& list) {
  const auto options = std::make_shared<GenerateOptions>();
  GenerateRequest& request = options->request;
  list.add("FILE", &options->file, "Mesh, or scene (.xml, .mjcf, .urdf) with the meshes of its bodies", required());
  list.add("--pattern", &request.kind, "Kind of pattern",
           {.unit = "WORD", .check = one_of(pattern_words()), .default_text = "hexagonal"});
  list.add("--out", &options->out, "Layout file to write; for a scene a folder, with a file for each mesh",
           {.unit = "PATH", .is_required = true});
  list.add("--body", &options->bodies,
           "Body of the scene, once for each (default: all bodies with a mesh file). Bodies with the same mesh share a "
           "layout",
           {.unit = "NAME"});
  list.add("--region", &request.region,
           "Only faces that satisfy conditions on their middle (x, y, z) and normal (nx, ny, nz) in the mesh's frame, "
           "such as \"z > 5 mm, ny < -0.3\"; they become the sensing region",
           {.unit = "TEXT"});
  const auto add_vector = [&](const char* name, std::optional<dvec3>& value, const char* unit, const char* help) {
    const auto read = [&value, name, unit](const std::string& text) { value = parse_vector(name, text, unit); };
    list.add(name, read, help, {.unit = "X,Y,Z"});
  };
  add_vector("--pad", request.pad, "", "Direction of the touching side in the mesh's frame (default: from the shape)");
  add_vector("--distal", request.distal, "", "Direction in which the sensor points (default: from the shape)");
  add_vector("--at", request.at, "m",
             "Middle of the pattern, moved to the skin (default: middle of the touching side)");
  const auto add_path = [&](const char* name, fs::path& path, const char* help) {
    list.add(name, [&path](const std::string& text) { path = text; }, help, {.unit = "FILE"});
  };
  add_path("--table", request.table, "CSV file of the pattern table, with columns x, y, z");
  add_path("--image", request.image, "PNG or JPEG picture of the pattern image");
  const auto read_scale = [&request](const std::string& text) { request.scale = parse_scale("generate", text); };
  list.add("--scale", read_scale,
           "Multiply the mesh's coordinates by one number or X,Y,Z (default: m or mm by its size)", {.unit = "X"});
  add_fields(list, request);
  return [options](Console& console) { return run_generate_command(*options, console); };
}

}  // namespace taxel::cli
