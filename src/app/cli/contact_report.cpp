#include "app/cli/contact_report.h"

#include <fmt/format.h>

#include <iterator>

#include "core/hydro/fields/field_report.h"

namespace taxel::cli {

std::string contact_text(const ContactReport& report) {
  const ContactSurface& surface = report.result.surface;
  const auto vector = [](const dvec3& v) { return fmt::format("{} {} {}", v.x, v.y, v.z); };
  std::string text;
  const auto line = [&](const char* key, const std::string& value) { text += fmt::format("{:<14}{}\n", key, value); };
  line("polygons", fmt::format("{}", surface.polygons.size()));
  line("triangles", fmt::format("{}", surface.triangle_count()));
  line("area", fmt::format("{} m^2", surface.area()));
  line("force", vector(report.result.wrench_W.force) + " N, on a, world frame");
  line("torque", vector(report.result.wrench_W.torque) + " N m, about the origin of a");
  line("centroid", vector(report.result.centroid_W) + " m, of the pressure");
  line("max_pressure", fmt::format("{} Pa", surface.max_pressure()));
  for (std::size_t i = 0; i < kRejections; ++i) {
    const RejectedPolygons& rejected = surface.rejected[i];
    if (rejected.count == 0) continue;
    line("rejected", fmt::format("{}: {} polygons, {} m^2, {} N", to_string(static_cast<Rejection>(i)), rejected.count,
                                 rejected.area, rejected.force));
  }
  for (const auto& [body, field] : report.fields) {
    for (const Problem& p : field_problems(field, "", "")) line(("field " + body).c_str(), p.message);
  }
  line("microseconds", fmt::format("{:.1f}, median of {}", report.microseconds, report.repeats));
  return text;
}

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

}  // namespace taxel::cli
