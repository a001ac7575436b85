// taxel check: lists every problem of the given files.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "app/cli/command_layout.h"
#include "app/cli/report_writer.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/message.h"
#include "core/document/project.h"
#include "core/document/scenario/scenario.h"
#include "core/document/scenario/study.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/user_choices.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/mesh_check.h"
#include "core/sensor/contact_case/contact_case.h"
#include "core/sensor/layout_source.h"
#include "core/sensor/sensor_model.h"
#include "core/sim/simulator.h"

namespace taxel::cli {

namespace {

/// Checks the values of a layout that are known without a mesh: ids, normals and radii.
Problems check_bare_layout(ImportedLayout imported, const std::string& file) {
  imported.layout.mesh.file = "unknown";  // the missing mesh is reported as a note
  return check_layout_values(imported.layout, file);
}

/// Checks a layout on the mesh that its file names.
void check_on_own_mesh(const ImportedLayout& imported, const std::string& file, Problems& problems) {
  const std::size_t earlier_notes = imported.notes.size();
  const MeshRef mesh = imported.layout.mesh;
  const ImportedSource read = put_on_mesh_file(imported, mesh.file, mesh.scale, file);
  for (std::size_t i = earlier_notes; i < read.notes.size(); ++i)
    problems.push_back({file, "", Severity::note, "import", read.notes[i], ""});
  const Problems found = check_layout_on_loaded_mesh(read.source.layout, read.source.mesh, file);
  problems.insert(problems.end(), found.begin(), found.end());
}

/// Lists the losses in the import of another program's layout, then checks it like any other layout if its mesh is
/// known. Without a mesh all sensors of the file are read.
Problems check_foreign_layout(const std::string& file, const SkinChoice& skin) {
  Problems problems;
  const auto add_notes = [&](const std::vector<std::string>& notes) {
    for (const std::string& text : notes) problems.push_back({file, "", Severity::note, "import", text, ""});
  };
  if (skin.mesh.empty()) {
    std::vector<ImportedLayout> layouts = read_layouts(*layout_format_of(file), file);
    if (!skin.sensor.empty()) layouts = {choose_sensor(std::move(layouts), skin.sensor, file)};
    add_notes(notes_of(layouts));
    bool has_mesh = true;
    for (const ImportedLayout& imported : layouts) {
      has_mesh = has_mesh && !imported.layout.mesh.file.empty();
      if (!imported.layout.mesh.file.empty()) {
        check_on_own_mesh(imported, file, problems);
        continue;
      }
      if (imported.cell > 0) continue;  // the mesh gives its taxels
      const Problems found = check_bare_layout(imported, file);
      problems.insert(problems.end(), found.begin(), found.end());
    }
    if (!has_mesh)
      problems.push_back({file, "", Severity::note, "import", "has no mesh: only its values are checked",
                          "name the mesh with --mesh FILE"});
    return problems;
  }
  const ImportedSource read = read_any_source(file, skin);
  add_notes(read.notes);
  const Problems found = check_layout_on_loaded_mesh(read.source.layout, read.source.mesh, file);
  problems.insert(problems.end(), found.begin(), found.end());
  return problems;
}

Problems check_mesh_file(const std::string& file) {
  const LoadedMesh loaded = load_mesh(file);
  Problems problems = check_mesh(*loaded.mesh, file);
  for (const std::string& note : loaded.notes)
    problems.push_back({file, "", Severity::note, "mesh_repaired", note, ""});
  return problems;
}

/// Checks that both bodies of a case can be made, that one of them is soft, and that one of them is not a plane.
Problems check_case(const ContactCase& contact_case) {
  Problems problems;
  const std::string& file = contact_case.file;
  const auto make = [&](const CaseBody& body, const std::string& name) -> HydroBodyPtr {
    try {
      const MadeBody made = make_case_body(contact_case, body, name);
      for (const std::string& warning : made.warnings) {
        problems.push_back({file, "/" + name, Severity::warning, "body_warning", warning, ""});
      }
      if (const FieldReport* report = made.model ? nullptr : made.field_report()) {
        for (Problem& p : field_problems(*report, file, "/" + name)) {
          if (p.severity == Severity::note) problems.push_back(std::move(p));  // the others are among the warnings
        }
      }
      return made.body;
    } catch (const Error& e) {
      const bool own = e.file() == file;
      problems.push_back(
          {file, own ? e.where() : "/" + name, Severity::error, "body_not_made", own ? e.message() : e.what(), ""});
      return nullptr;
    }
  };
  const HydroBodyPtr a = make(contact_case.a, "a");
  const HydroBodyPtr b = make(contact_case.b, "b");
  if (a && b && !a->soft() && !b->soft())
    problems.push_back(
        {file, "", Severity::error, "both_rigid", "a and b are both rigid", "give a modulus to one of them"});
  if (a && b && a->half_space() && b->half_space()) {
    problems.push_back({file, "", Severity::error, "both_planes", "a and b are both planes: their contact is unbounded",
                        "give one of them another shape"});
  }
  return problems;
}

/// Lists the sensors of a scene with their layouts and the geoms that they touch, then the repairs of these geoms'
/// meshes, and the warnings of the sensors.
Problems check_scene(const std::filesystem::path& path) {
  const std::string file = path.string();
  const std::unique_ptr<Simulator> simulator = Simulator::load(path);
  const SimScene& scene = *simulator->scene();
  Problems problems;
  for (std::size_t i = 0; i < scene.sensors.size(); ++i) {
    if (scene.sensors[i] == nullptr) continue;
    const Layout& layout = scene.sensors[i]->layout;
    std::string names;
    const std::size_t count = i < scene.touched.size() ? scene.touched[i].size() : 0;
    for (std::size_t k = 0; k < count; ++k)
      names += fmt::format("{}\"{}\"", names.empty() ? "" : ", ", scene.touched[i][k].name);
    problems.push_back({file, "", Severity::note, "sensor",
                        fmt::format("geom \"{}\": layout \"{}\" of {} taxel{}, {}", scene.sensor_geoms[i], layout.name,
                                    layout.taxels.size(), layout.taxels.size() == 1 ? "" : "s",
                                    count > 0 ? "touches " + names : "can touch nothing"),
                        ""});
  }
  for (const std::string& text : simulator->repairs())
    problems.push_back({file, "", Severity::note, "mesh_repaired", text, ""});
  for (const std::string& text : simulator->warnings())
    problems.push_back({file, "", Severity::warning, "scene_warning", text, ""});
  return problems;
}

/// Returns a sensor for trial scenarios: the built-in fingertip, which `taxel play` uses without --layout.
SensorModelPtr trial_sensor() {
  Console silent(CommonOptions{.quiet = true});
  LayoutOptions quick;
  quick.preview = true;
  return load_model("", quick, silent);
}

/// Throws Error if the scenario cannot be made because a file that it names is missing or it takes too many steps.
void expect_playable(const SensorModelPtr& sensor, const Scenario& scenario, const std::string& file) {
  try {
    (void)Simulator::make_scenario(sensor, scenario);
  } catch (const Error& e) {
    if (!e.file().empty()) throw;
    throw Error(file, e.where(), e.message());
  }
}

/// Tries some of the runs. Throws Error if none of them can be made, as `taxel study` does; otherwise lists the runs
/// that cannot be made.
Problems check_runs(const Study& study, const std::string& file) {
  constexpr std::size_t kMaxTried = 16;  // spread over all runs, including the first and the last
  const std::vector<StudyRun> runs = runs_of(study);
  const std::size_t tried = std::min(runs.size(), kMaxTried);
  const SensorModelPtr sensor = trial_sensor();
  Problems problems;
  for (std::size_t i = 0; i < tried; ++i) {
    const std::size_t run = tried > 1 ? i * (runs.size() - 1) / (tried - 1) : 0;
    try {
      expect_playable(sensor, runs[run].scenario, file);
    } catch (const Error& e) {
      if (problems.size() + 1 == tried) throw;
      problems.push_back({file, "", Severity::warning, "run_not_made",
                          fmt::format("run {} of {} cannot be made: {}", run + 1, runs.size(), e.what()), ""});
    }
  }
  return problems;
}

/// Checks the layout, with pointers from the project's root, then the files that its scenario names.
Problems check_project_file(const std::string& text, const std::string& file) {
  const Project project = parse_project(text, file);
  Problems problems = check_layout_file(project.layout, file);
  for (Problem& p : problems) p.pointer = "/layout" + p.pointer;
  Scenario scenario = with_absolute_files(project.scenario, file);
  const auto files = files_of(scenario);
  if (std::all_of(files.begin(), files.end(), [](const auto& named) { return named.second->empty(); })) return problems;
  try {
    expect_playable(trial_sensor(), scenario, file);
  } catch (const Error& e) {
    problems.push_back({file, "/scenario", Severity::error, "scenario_not_made", e.what(), ""});
  }
  return problems;
}

/// Returns the value of the top-level key "format" without parsing the whole text, or empty if there is none.
std::string format_of(const std::string& text) {
  const std::size_t key = text.find("\"format\"");
  const std::size_t open = key == std::string::npos ? key : text.find('"', key + 8);
  const std::size_t close = open == std::string::npos ? open : text.find('"', open + 1);
  return close == std::string::npos ? "" : text.substr(open + 1, close - open - 1);
}

/// Returns all problems of a file that can be read. Throws Error for a file that cannot be read: missing, not JSON, a
/// value of the wrong type, an unknown version or kind, a scene that does not compile. `skin` names the mesh of layouts
/// of other programs; without a mesh only their values are checked.
Problems check_file(const std::string& file, const SkinChoice& skin) {
  const std::filesystem::path path(file);
  if (is_mesh_file(path)) return check_mesh_file(file);
  if (is_foreign_layout(path)) return check_foreign_layout(file, skin);
  const std::string text = read_file(path);
  const std::string extension = path.extension().string();
  if (extension == ".xml" || extension == ".mjcf") {
    return check_scene(path);
  }
  const std::string format = format_of(text);
  if (format == "contact-case") return check_case(parse_contact_case(text, file));
  if (format == "taxel-sweep" || format == "taxel-play" || format == "taxel-scenario") {
    expect_playable(trial_sensor(), with_absolute_files(parse_scenario(text, file), path), file);
    return {};
  }
  if (format == "taxel-study") {
    Study study = parse_study(text, file);
    study.scenario = with_absolute_files(study.scenario, path);
    return check_runs(study, file);
  }
  if (format == "taxel-project") return check_project_file(text, file);
  if (!format.empty() && format != "taxel-layout") {
    throw Error(
        file, "/format",
        "is \"" + format +
            "\"; must be taxel-layout, taxel-project, taxel-scenario, taxel-study, contact-case, taxel-sweep or "
            "taxel-play");
  }
  const LayoutOfFile layout = parse_layout_of_file(text, file);
  Problems problems;
  for (const std::string& note : layout.notes) problems.push_back({file, "", Severity::note, "migrated", note, ""});
  if (!problems.empty()) problems.front().fix = "taxel convert writes it in this version now";
  Problems found = check_layout_file(layout.layout, file);
  problems.insert(problems.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
  return problems;
}

struct CheckOptions {
  std::vector<std::string> files;
  SkinChoice skin;
};

struct CheckReport {
  Problems problems;
  std::size_t files = 0;  ///< number of files

  void visit(ReportWriter& w) const {
    w.list("problems", problems, [](ReportWriter& problem, const Problem& p) {
      problem("file", p.file);
      problem("pointer", p.pointer);
      problem("severity", to_string(p.severity));
      problem("code", p.code);
      problem("message", shown_part(p.message));
      problem("fix", shown_part(p.fix));
    });
  }
  /// "FILE: POINTER: severity: message; fix" for each problem, and a line with their numbers.
  [[nodiscard]] std::string text() const {
    std::string text;
    for (const Problem& p : problems) {
      const std::string place = p.pointer.empty() ? "" : shown_part(p.pointer) + ": ";
      const std::string fix = p.fix.empty() ? "" : "; " + shown_part(p.fix);
      text += fmt::format("{}: {}{}: {}{}\n", p.file, place, to_string(p.severity), shown_part(p.message), fix);
    }
    const auto count = [&](Severity severity) {
      return std::count_if(problems.begin(), problems.end(), [&](const Problem& p) { return p.severity == severity; });
    };
    return text + fmt::format("{} file{}: {} errors, {} warnings, {} notes\n", files, files == 1 ? "" : "s",
                              count(Severity::error), count(Severity::warning), count(Severity::note));
  }
};

/// Checks all files, also after one that cannot be read.
int run_check_command(const CheckOptions& options, Console& console) {
  CheckReport report{{}, options.files.size()};
  Problems& problems = report.problems;
  bool is_unreadable = false;
  for (const std::string& file : options.files) {
    try {
      const Problems found = check_file(file, options.skin);
      problems.insert(problems.end(), found.begin(), found.end());
    } catch (const Error& e) {
      print_failure(e);
      problems.push_back(
          {e.file().empty() ? file : e.file(), e.where(), Severity::error, "unreadable", e.message(), ""});
      is_unreadable = true;
    }
  }
  print_report(console, report);
  const bool is_clean =
      std::all_of(problems.begin(), problems.end(), [](const Problem& p) { return p.severity == Severity::note; });
  return is_unreadable ? kBadInput : is_clean ? kDone : kProblemsFound;
}

}  // namespace

Run add_check(OptionList& list) {
  const auto options = std::make_shared<CheckOptions>();
  list.add("FILE", &options->files,
           "Files to check; exit status 1 if one has an error or a warning, 2 if one cannot be read", required());
  add_skin(list, options->skin);
  return [options](Console& console) { return run_check_command(*options, console); };
}

}  // namespace taxel::cli
