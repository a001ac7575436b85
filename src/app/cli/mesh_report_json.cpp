#include <nlohmann/json.hpp>

#include "app/cli/mesh_report.h"
#include "app/vector_json.h"
#include "core/layout/words.h"
#include "core/mesh/topology/mesh_check.h"

namespace taxel::cli {

namespace {

using Json = nlohmann::ordered_json;

/// Lengths in metres, areas in square metres.
Json repair_json(const RepairReport& report) {
  Json json;
  json["level"] = to_word(report.level);
  json["closed"] = report.closed;
  json["faces_before"] = report.faces_before;
  json["faces_after"] = report.faces_after;
  json["shells_before"] = report.shells_before;
  json["shells_after"] = report.shells_after;
  json["vertices_moved"] = report.vertices_moved;
  json["largest_move"] = report.largest_move;
  json["distance_max"] = report.distance_max;
  json["distance_rms"] = report.distance_rms;
  json["area_added"] = report.area_added;
  json["area_removed"] = report.area_removed;
  json["seconds"] = report.seconds;
  json["steps"] = Json::array();
  for (const RepairStep& step : report.steps) {
    json["steps"].push_back({{"code", step.code},
                             {"count", step.count},
                             {"faces", step.faces},
                             {"area", step.area},
                             {"length", step.length},
                             {"place", numbers<Json>(step.place)}});
  }
  return json;
}

}  // namespace

std::string mesh_json(const LoadedMesh& loaded, const RepairedMesh* repaired) {
  const TriMesh& mesh = *loaded.mesh;
  Json json;
  json["vertices"] = mesh.vertex_count();
  json["triangles"] = mesh.face_count();
  json["closed"] = mesh.closed();
  json["shells"] = mesh.shell_count();
  json["enclosed_shells"] = mesh.shell_count() - static_cast<int>(outer_shells(mesh).size());
  json["area"] = mesh.area();
  json["volume"] = mesh.volume();
  json["centroid"] = numbers<Json>(mesh.centroid());
  json["bounds"] = {{"lower", numbers<Json>(mesh.bounds().lo)}, {"upper", numbers<Json>(mesh.bounds().hi)}};
  json["sha256"] = loaded.sha256;
  json["notes"] = loaded.notes;
  json["problems"] = Json::array();
  for (const Problem& p : check_mesh(mesh, "")) {
    json["problems"].push_back(
        {{"severity", to_string(p.severity)}, {"code", p.code}, {"message", p.message}, {"fix", p.fix}});
  }
  if (repaired != nullptr) json["repair"] = repair_json(repaired->report);
  return text_of(json);
}

}  // namespace taxel::cli
