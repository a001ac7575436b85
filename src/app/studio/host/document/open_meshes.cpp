#include "app/studio/host/document/open_meshes.h"

#include <algorithm>

namespace taxel::studio {

OpenMeshPtr read_open_mesh(const MeshRef& mesh, Progress* progress) {
  LoadedMesh loaded = load_mesh(mesh.file, mesh.scale, progress);
  MeshFindings findings = mesh_report(*loaded.mesh, loaded.notes);
  if (progress != nullptr) progress->stop_if_cancelled();
  return std::make_shared<const OpenMesh>(OpenMesh{std::move(loaded), std::move(findings)});
}

void OpenMeshes::clear() {
  const std::lock_guard lock(mutex_);
  meshes_.clear();
}

void OpenMeshes::add(const MeshRef& ref, OpenMeshPtr mesh) {
  const std::lock_guard lock(mutex_);
  std::erase_if(meshes_, [&](const auto& entry) { return same_file(entry.first, ref); });
  if (meshes_.size() >= kMost) meshes_.erase(meshes_.begin());
  meshes_.emplace_back(ref, std::move(mesh));
}

OpenMeshPtr OpenMeshes::known(const MeshRef& ref) const {
  const std::lock_guard lock(mutex_);
  const auto found =
      std::find_if(meshes_.begin(), meshes_.end(), [&](const auto& entry) { return same_file(entry.first, ref); });
  return found == meshes_.end() ? nullptr : found->second;
}

OpenMeshPtr OpenMeshes::get(const MeshRef& ref) {
  if (OpenMeshPtr mesh = known(ref)) return mesh;
  OpenMeshPtr mesh = read_open_mesh(ref);
  add(ref, mesh);
  return mesh;
}

}  // namespace taxel::studio
