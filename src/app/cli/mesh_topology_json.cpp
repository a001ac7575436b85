#include <nlohmann/json.hpp>

#include "app/cli/mesh_topology.h"
#include "app/vector_json.h"

namespace taxel::cli {
namespace {

using Json = nlohmann::ordered_json;

Json numbers_of(const TriMesh& mesh) {
  return {{"vertices", mesh.vertex_count()},
          {"triangles", mesh.face_count()},
          {"closed", mesh.closed()},
          {"area", mesh.area()},
          {"volume", mesh.volume()}};
}

}  // namespace

std::string topology_json(const ChangedMesh& changed, const TopologyOptions& options) {
  Json json;
  json["change"] = options.decimate ? "decimate" : "subdivide";
  json["asked"] = options.decimate ? *options.decimate : *options.subdivide;
  if (options.subdivide) json["scheme"] = options.scheme;
  json["before"] = numbers_of(*changed.before);
  json["after"] = numbers_of(*changed.after);
  json["distance_max"] = changed.distance.largest;
  json["distance_rms"] = changed.distance.rms;
  return text_of(json);
}

}  // namespace taxel::cli
