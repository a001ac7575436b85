#include <nlohmann/json.hpp>

#include "app/cli/mesh_report.h"
#include "app/vector_json.h"
#include "core/mesh/mesh_check.h"

namespace taxel::cli {

std::string mesh_json(const LoadedMesh& loaded) {
  using Json = nlohmann::ordered_json;
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
  return text_of(json);
}

}  // namespace taxel::cli
