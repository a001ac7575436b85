#include <nlohmann/json.hpp>
#include "app/cli/contact_report.h"

#include "app/vector_json.h"

namespace taxel::cli {
namespace {
using Json = nlohmann::ordered_json;

Json part_json(const SkinPart& part) {
  Json json{{"faces", part.faces}, {"area", part.area}};
  if (part.faces == 0) return json;
  json["bounds"] = {numbers<Json>(part.bounds.lo), numbers<Json>(part.bounds.hi)};
  json["worst_face"] = part.worst_face;
  json["worst_place"] = numbers<Json>(part.worst_place);
  return json;
}

Json field_json(const std::string& body, const FieldReport& report) {
  Json json{{"body", body},
            {"tets", report.tets},
            {"inverted", report.inverted},
            {"zero_gradient", report.zero_gradient},
            {"stiffness",
             {{"mean", report.stiffness_mean},
              {"min", report.stiffness_min},
              {"max", report.stiffness_max},
              {"cv", report.stiffness_cv}}},
            {"skin_area", report.skin_area}};
  if (report.core) {  // a pad
    json["thickness"] = report.thickness;
    json["limited"] = part_json(report.limited);
    json["limited"]["least_part"] = report.least_part;
    json["bare"] = part_json(report.bare);
    json["two_layer_faces"] = report.two_layer_faces;
    json["depth_error"] = {{"mean", report.depth_error_mean}, {"rms", report.depth_error_rms}};
  }
  json["notes"] = report.notes;
  return json;
}

}  // namespace

std::string contact_json(const ContactReport& report) {
  const ContactSurface& surface = report.result.surface;
  Json json;
  json["polygons"] = surface.polygons.size();
  json["triangles"] = surface.triangle_count();
  json["area"] = surface.area();
  json["force"] = numbers<Json>(report.result.wrench_W.force);
  json["torque"] = numbers<Json>(report.result.wrench_W.torque);
  json["centroid"] = numbers<Json>(report.result.centroid_W);
  json["max_pressure"] = surface.max_pressure();
  json["rejected"] = Json::array();
  for (std::size_t i = 0; i < kRejections; ++i) {
    const RejectedPolygons& rejected = surface.rejected[i];
    if (rejected.count == 0) continue;
    json["rejected"].push_back({{"reason", to_string(static_cast<Rejection>(i))},
                                {"count", rejected.count},
                                {"area", rejected.area},
                                {"force", rejected.force}});
  }
  json["warnings"] = report.warnings;
  json["fields"] = Json::array();
  for (const auto& [body, field] : report.fields) json["fields"].push_back(field_json(body, field));
  json["microseconds"] = report.microseconds;
  return text_of(json);
}

std::string polygons_json(const ContactReport& report) {
  const ContactSurface& surface = report.result.surface;
  const RigidTransform X_WA(report.X_WA);
  Json json;
  json["format"] = "contact-polygons";
  json["version"] = 1;
  json["polygons"] = Json::array();
  for (const ContactPolygon& polygon : surface.polygons) {
    Json one;
    one["vertices"] = Json::array();
    one["pressures"] = Json::array();
    for (int i = polygon.first; i < polygon.first + polygon.count; ++i) {
      one["vertices"].push_back(numbers<Json>(X_WA(surface.vertices[static_cast<std::size_t>(i)])));
      one["pressures"].push_back(surface.pressure[static_cast<std::size_t>(i)]);
    }
    one["normal"] = numbers<Json>(X_WA.R * polygon.normal);
    one["area"] = polygon.area;
    one["tet"] = polygon.tet;
    one["tet_b"] = polygon.tet_b;
    one["face"] = polygon.face;
    json["polygons"].push_back(std::move(one));
  }
  return text_of(json);
}

}  // namespace taxel::cli
