// taxel contact: computes one contact between two shapes at given poses.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iterator>
#include <memory>
#include <utility>

#include "app/cli/command_line.h"
#include "app/cli/report_writer.h"
#include "core/base/files.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/hydro/fields/tet_mesh.h"
#include "core/hydro/intersect.h"
#include "core/sensor/contact_case/contact_case.h"

namespace taxel::cli {
namespace {

struct ContactOptions {
  std::string file;
  std::string polygons;
  std::string tets;
  int repeat = 1;
};

void visit_skin_part(ReportWriter& w, const SkinPart& part) {
  w("faces", part.faces);
  w("area", part.area);
  if (part.faces == 0) return;
  w("bounds", std::array{part.bounds.lo, part.bounds.hi});
  w("worst_face", part.worst_face);
  w("worst_place", part.worst_place);
}

/// Writes the quality of the pressure field of body "a" or "b".
void visit_field(ReportWriter& w, const std::pair<std::string, FieldReport>& field) {
  const FieldReport& report = field.second;
  w("body", field.first);
  w("tets", report.tets);
  w("inverted", report.inverted);
  w("zero_gradient", report.zero_gradient);
  w.object("stiffness", [&report](ReportWriter& stiffness) {
    stiffness("mean", report.stiffness_mean);
    stiffness("min", report.stiffness_min);
    stiffness("max", report.stiffness_max);
    stiffness("cv", report.stiffness_cv);
  });
  w("skin_area", report.skin_area);
  if (report.core) {  // the field is a pad
    w("thickness", report.thickness);
    w.object("limited", [&report](ReportWriter& limited) {
      visit_skin_part(limited, report.limited);
      limited("least_part", report.least_part);
    });
    w.object("bare", [&report](ReportWriter& bare) { visit_skin_part(bare, report.bare); });
    w("two_layer_faces", report.two_layer_faces);
    w.object("depth_error", [&report](ReportWriter& error) {
      error("mean", report.depth_error_mean);
      error("rms", report.depth_error_rms);
    });
  }
  w("notes", report.notes);
}

struct ContactReport {
  ContactResult result;
  Pose X_WA;  ///< pose of body a
  std::vector<std::string> warnings;
  std::vector<std::pair<std::string, FieldReport>> fields;  ///< name ("a", "b") and field of each body with tets
  double microseconds = 0;                                  ///< median time of one surface and its wrench
  int repeats = 1;

  /// Numbers of polygons that were left out, by reason; reasons without polygons are not listed.
  [[nodiscard]] std::vector<std::pair<const char*, RejectedPolygons>> rejected() const {
    std::vector<std::pair<const char*, RejectedPolygons>> listed;
    for (std::size_t i = 0; i < kRejections; ++i)
      if (const RejectedPolygons& r = result.surface.rejected[i]; r.count != 0)
        listed.emplace_back(to_string(static_cast<Rejection>(i)), r);
    return listed;
  }
  void visit(ReportWriter& w) const {
    w("polygons", result.surface.polygons.size());
    w("triangles", result.surface.triangle_count());
    w("area", result.surface.area());
    w("force", result.wrench_W.force);
    w("torque", result.wrench_W.torque);
    w("centroid", result.centroid_W);
    w("max_pressure", result.surface.max_pressure());
    w.list("rejected", rejected(), [](ReportWriter& one, const auto& polygons) {
      one("reason", polygons.first);
      one("count", polygons.second.count);
      one("area", polygons.second.area);
      one("force", polygons.second.force);
    });
    w("warnings", warnings);
    w.list("fields", fields, visit_field);
    w("microseconds", microseconds);
  }
  [[nodiscard]] std::string text() const;
};

std::string ContactReport::text() const {
  const ContactSurface& surface = result.surface;
  const auto vector = [](const dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
  std::string text;
  const auto line = [&](const std::string& key, const std::string& value) {
    text += fmt::format("{:<14}{}\n", key, value);
  };
  line("polygons", fmt::format("{}", surface.polygons.size()));
  line("triangles", fmt::format("{}", surface.triangle_count()));
  line("area", fmt::format("{} m^2", surface.area()));
  line("force", vector(result.wrench_W.force) + " N, on a, world frame");
  line("torque", vector(result.wrench_W.torque) + " N m, about the origin of a");
  line("centroid", vector(result.centroid_W) + " m, of the pressure");
  line("max_pressure", fmt::format("{} Pa", surface.max_pressure()));
  for (const auto& [reason, polygons] : rejected())
    line("rejected",
         fmt::format("{}: {} polygons, {} m^2, {} N", reason, polygons.count, polygons.area, polygons.force));
  for (const auto& [body, field] : fields)
    for (const Problem& p : field_problems(field, "", "")) line("field " + body, p.message);
  line("microseconds", fmt::format("{:.1f}, median of {}", microseconds, repeats));
  return text;
}

/// Returns all polygons in the world frame as JSON: vertices, pressures, normal, area, tets, face.
std::string polygons_json(const ContactReport& report) {
  const ContactSurface& surface = report.result.surface;
  const RigidTransform X_WA(report.X_WA);
  ReportWriter writer;
  writer("format", "contact-polygons");
  writer("version", 1);
  writer.list("polygons", surface.polygons, [&](ReportWriter& w, const ContactPolygon& polygon) {
    std::vector<dvec3> vertices_W;
    std::vector<double> pressures;
    for (int i = polygon.first; i < polygon.first + polygon.count; ++i) {
      vertices_W.push_back(X_WA(surface.vertices[static_cast<std::size_t>(i)]));
      pressures.push_back(surface.pressure[static_cast<std::size_t>(i)]);
    }
    w("vertices", vertices_W);
    w("pressures", pressures);
    w("normal", X_WA.R * polygon.normal);
    w("area", polygon.area);
    w("tet", polygon.tet);
    w("tet_b", polygon.tet_b);
    w("face", polygon.face);
  });
  return writer.text();
}

/// Returns the same values as polygons_json() with one line for each corner of a polygon.
std::string polygons_csv(const ContactReport& report) {
  const ContactSurface& surface = report.result.surface;
  const RigidTransform X_WA(report.X_WA);
  std::string text = "polygon,x,y,z,pressure,nx,ny,nz,area,tet,tet_b,face\n";
  int number = 0;
  for (const ContactPolygon& polygon : surface.polygons) {
    const dvec3 n = X_WA.R * polygon.normal;
    for (int i = polygon.first; i < polygon.first + polygon.count; ++i) {
      const dvec3 v = X_WA(surface.vertices[static_cast<std::size_t>(i)]);
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{},{},{},{},{},{}\n", number, v.x, v.y, v.z,
                     surface.pressure[static_cast<std::size_t>(i)], n.x, n.y, n.z, polygon.area, polygon.tet,
                     polygon.tet_b, polygon.face);
    }
    ++number;
  }
  return text;
}

/// Computes the contact `repeat` times. Returns the median time in microseconds.
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

/// Returns the polygons in the format of the file's extension. Throws Error for any other extension.
std::string polygons_of(const std::string& file, const ContactReport& report) {
  const std::string extension = std::filesystem::path(file).extension().string();
  if (extension == ".json") return polygons_json(report);
  if (extension == ".csv") return polygons_csv(report);
  throw Error(file, "polygons are written as .json or .csv");
}

/// Returns the field of the soft body, or that of a if both are soft, as VTK text. Throws Error naming `file`.
std::string tets_of(const MadeBody& a, const MadeBody& b, const std::string& file) {
  for (const MadeBody* made : {&a, &b}) {
    if (const auto* soft = std::get_if<SoftBody>(&made->body->geometry)) return vtk_text(*soft->field);
  }
  throw Error(file, "the soft body is a half-space: it has no tets");
}

int run_contact_command(const ContactOptions& options, Console& console) {
  const ContactCase contact_case = read_contact_case(options.file);
  const MadeBody a = make_case_body(contact_case, contact_case.a, "a");
  const MadeBody b = make_case_body(contact_case, contact_case.b, "b");
  if (!a.body->soft() && !b.body->soft()) throw Error(options.file, "a and b are both rigid; one must have a modulus");
  if (a.body->half_space() && b.body->half_space())
    throw Error(options.file, "a and b are both planes: their contact is unbounded");
  ContactReport report{{}, contact_case.a.X_WB, a.warnings, {}, 0, options.repeat};
  report.warnings.insert(report.warnings.end(), b.warnings.begin(), b.warnings.end());
  report.microseconds = timed_contact(contact_case, *a.body, *b.body, options.repeat, report.result);
  for (const auto& [name, made] : {std::pair("a", &a), std::pair("b", &b)}) {
    if (const FieldReport* field = made->field_report()) report.fields.emplace_back(name, *field);
  }
  for (const std::string& warning : report.warnings) console.warn(options.file + ": " + warning);
  if (!options.polygons.empty()) write_file_atomically(options.polygons, polygons_of(options.polygons, report));
  if (!options.tets.empty()) write_file_atomically(options.tets, tets_of(a, b, options.tets));
  print_report(console, report);
  return kDone;
}

}  // namespace

Run add_contact(OptionList& list) {
  const auto options = std::make_shared<ContactOptions>();
  list.add("CASE", &options->file, "Contact case: two shapes or layouts, materials, poses, velocities (JSON)",
           required());
  list.add("--polygons", &options->polygons,
           "Write the contact surface: one polygon each with vertices [m], pressures [Pa], normal, area [m^2], "
           "tet (of a if both are soft), tet_b, face; .json or .csv",
           {.unit = "FILE"});
  list.add("--tets", &options->tets,
           "Write the pressure field of the soft body: tets and pressures [Pa], its own frame, legacy VTK (.vtk)",
           {.unit = "FILE"});
  list.add("--repeat", &options->repeat, "Compute the contact this many times; `microseconds` is the median",
           {.text = "N=1", .check = in_range(1, 1000000)});
  return [options](Console& console) { return run_contact_command(*options, console); };
}

}  // namespace taxel::cli
