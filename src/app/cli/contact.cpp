// taxel contact: one contact between two shapes at given poses.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/contact_report.h"
#include "core/base/files.h"
#include "core/hydro/fields/vtk_tets.h"
#include "core/sensor/contact_case/contact_case.h"

namespace taxel::cli {
namespace {

struct Options {
  std::string file;
  std::string polygons;
  std::string tets;
  int repeat = 1;
};

/// Computes the contact `repeat` times; returns the median time in microseconds.
double timed_contact(const ContactCase& contact_case, const HydroBody& a, const HydroBody& b, int repeat,
                     ContactResult& result) {
  IntersectWorkspace workspace;
  std::vector<double> times;
  for (int i = 0; i < repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    evaluate_contact(contact_case, a, b, result, workspace);
    times.push_back(std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count());
  }
  const auto middle = times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2);
  std::nth_element(times.begin(), middle, times.end());
  return *middle;
}

std::string polygons_of(const std::string& file, const ContactReport& report) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == ".json") return polygons_json(report);
  if (extension == ".csv") return polygons_csv(report);
  throw Error(file, "polygons are written as .json or .csv");
}

/// The field of the soft body, of a where both are.
std::string tets_of(const MadeBody& a, const MadeBody& b, const std::string& file) {
  for (const MadeBody* made : {&a, &b}) {
    if (const auto* soft = std::get_if<SoftBody>(&made->body->geometry)) return vtk_text(*soft->field);
  }
  throw Error(file, "the soft body is a half-space: it has no tets");
}

int run(const Options& options, Console& console) {
  const ContactCase contact_case = read_contact_case(options.file);
  const MadeBody a = make_case_body(contact_case, contact_case.a, "a");
  const MadeBody b = make_case_body(contact_case, contact_case.b, "b");
  if (!a.body->soft() && !b.body->soft()) throw Error(options.file, "a and b are both rigid; one must have a modulus");
  if (a.body->half_space() && b.body->half_space())
    throw Error(options.file, "a and b are both planes: their contact has no end");
  ContactResult result;
  ContactReport report{result, contact_case.a.X_WB, a.warnings, {}, 0, options.repeat};
  report.warnings.insert(report.warnings.end(), b.warnings.begin(), b.warnings.end());
  report.microseconds = timed_contact(contact_case, *a.body, *b.body, options.repeat, result);
  for (const auto& [name, made] : {std::pair("a", &a), std::pair("b", &b)}) {
    if (const FieldReport* field = made->field_report()) report.fields.emplace_back(name, *field);
  }
  for (const std::string& warning : report.warnings) console.warn(options.file + ": " + warning);
  if (!options.polygons.empty()) write_file_atomically(options.polygons, polygons_of(options.polygons, report));
  if (!options.tets.empty()) write_file_atomically(options.tets, tets_of(a, b, options.tets));
  console.result(console.json() ? contact_json(report) : contact_text(report));
  return kDone;
}

}  // namespace

Command add_contact(CLI::App& parent, CommonOptions& common) {
  const auto options = std::make_shared<Options>();
  CLI::App* app = add_command(parent, common, "contact", "One contact between two shapes at given poses",
                              "taxel contact sphere_on_plane.json --polygons surface.csv --repeat 100");
  app->add_option("CASE", options->file, "Contact case: two shapes or layouts, materials, poses, velocities (JSON)")
      ->required()
      ->option_text("(required)");
  app->add_option("--polygons", options->polygons,
                  "Write the contact surface: one polygon each with vertices [m], pressures [Pa], normal, area [m^2], "
                  "tet (of a where both are soft), tet_b, face; .json or .csv")
      ->type_name("FILE");
  app->add_option(
         "--tets", options->tets,
         "Write the pressure field of the soft body: tets and pressures [Pa], its own frame, legacy VTK (.vtk)")
      ->type_name("FILE");
  app->add_option("--repeat", options->repeat, "Compute it this often; `microseconds` is the median")
      ->check(CLI::Range(1, 1000000))
      ->option_text("N=1");
  return {app, [options](Console& console) { return run(*options, console); }};
}

}  // namespace taxel::cli
