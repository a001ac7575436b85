#include "core/sim/plugin/shared/geom_content.h"

#include <vector>

#include "core/sim/plugin/shared/shared_parts.h"

namespace taxel {
namespace {

template <class Number>
std::string hash_of_part(const Number* all, int first, int count) {
  return hash_of_numbers(std::span<const Number>(all + first, static_cast<std::size_t>(count)));
}

std::string mesh_content(const mjModel& m, int mesh) {
  return hash_of_part(m.mesh_vert, 3 * m.mesh_vertadr[mesh], 3 * m.mesh_vertnum[mesh]) +
         hash_of_part(m.mesh_face, 3 * m.mesh_faceadr[mesh], 3 * m.mesh_facenum[mesh]) +
         hash_of_part(m.mesh_pos, 3 * mesh, 3) + hash_of_part(m.mesh_quat, 4 * mesh, 4);
}

std::string height_field_content(const mjModel& m, int id) {
  const int size[] = {m.hfield_nrow[id], m.hfield_ncol[id]};
  return hash_of_part(size, 0, 2) + hash_of_part(m.hfield_size, 4 * id, 4) +
         hash_of_part(m.hfield_data, static_cast<int>(m.hfield_adr[id]), size[0] * size[1]);
}

}  // namespace

std::optional<std::string> geom_content(const mjModel& m, int geom) {
  const int type = m.geom_type[geom], asset = m.geom_dataid[geom];
  if (type == mjGEOM_SDF && m.geom_plugin[geom] >= 0) return std::nullopt;
  const std::vector<mjtNum> numbers = {static_cast<mjtNum>(type), m.geom_size[3 * geom], m.geom_size[3 * geom + 1],
                                       m.geom_size[3 * geom + 2], m.stat.extent};  // of it an infinite plane is drawn
  std::string content = hash_of_numbers(std::span(numbers));
  if (asset >= 0 && (type == mjGEOM_MESH || type == mjGEOM_SDF)) content += mesh_content(m, asset);
  if (asset >= 0 && type == mjGEOM_HFIELD) content += height_field_content(m, asset);
  return content;
}

}  // namespace taxel
