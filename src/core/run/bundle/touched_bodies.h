// The bodies that sensors touch, as arrays of a saved step. core/sim/compare needs them to evaluate other models on it.
//
// Arrays: bodies (count); body<i>/name, kind ("rigid_half_space", "soft_half_space", "soft", "rigid_mesh"), field,
//   material (4: modulus, thickness, dissipation, friction)
//     soft half-space: half_space (2: stiffness, thickness)
//     rigid mesh: mesh (number of a mesh)
//     soft body: vertices (v, 3), tets (t, 4), pressure (v), core (1: has a rigid core)
//     soft body whose field continues beyond its tets: skin (number of a mesh), depth (2: thickness, E/H)
//   sensor<i>/body/... the arrays of a body, for a soft geom without taxels
//   sensor<i>/touched (t, 5: body or -1, geom, sensor, mirrored, is known), touched_names, touched_pos (t, 3),
//   touched_quat (t, 4), touched_shapes (t texts: "" for a sensor), touched_sizes (t, 3), touched_meshes (t)
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/mesh/tri_mesh.h"
#include "core/run/frame.h"
#include "core/run/recording/npz_arrays.h"

namespace taxel {

// Helper functions that write and read the arrays of a saved step.

inline void add_number(NpzWriter& out, const std::string& name, double value) {
  out.add(name, {}, std::span<const double>(&value, 1));
}
inline void add_number(NpzWriter& out, const std::string& name, std::int64_t value) {
  out.add(name, {}, std::span<const std::int64_t>(&value, 1));
}
template <class Vectors>
void add_vectors(NpzWriter& out, const std::string& name, const Vectors& vectors) {
  std::vector<double> flat;
  for (const dvec3& v : vectors) append(flat, v);
  out.add(name, {vectors.size(), 3}, std::span<const double>(flat));
}

inline std::vector<dvec3> vectors_of(const NpzReader& in, const std::string& name) {
  const std::vector<double> flat = finite_doubles(in, name, {NpzReader::kAny, 3});
  std::vector<dvec3> vectors;
  for (std::size_t i = 0; i < flat.size(); i += 3) vectors.push_back(vector_at(flat, i));
  return vectors;
}
inline double number_of(const NpzReader& in, const std::string& name) {
  return finite_doubles(in, name, {})[0];
}
/// Returns `value` as an int. Throws Error naming file and array unless it is within [least, end).
inline int index_of(const NpzReader& in, const std::string& name, std::int64_t value, std::int64_t least,
                    std::size_t end) {
  if (value < least || value >= static_cast<std::int64_t>(end))
    throw Error(in.file(), name,
                fmt::format("{} is not among {} to {}", value, least, static_cast<std::int64_t>(end) - 1));
  return static_cast<int>(value);
}
inline std::size_t count_of(const NpzReader& in, const std::string& name) {
  constexpr std::size_t kMost = 1'000'000;
  return static_cast<std::size_t>(index_of(in, name, in.integers(name, {})[0], 0, kMost));
}

/// Meshes of a saved step. A mesh that several parts use is written once.
class BundledMeshes {
 public:
  std::int64_t number(const TriMeshPtr& mesh) {
    const auto found = std::find(meshes_.begin(), meshes_.end(), mesh);
    const auto at = found - meshes_.begin();
    if (found == meshes_.end()) meshes_.push_back(mesh);
    return at;
  }
  void write(NpzWriter& out) const {
    add_number(out, "meshes", static_cast<std::int64_t>(meshes_.size()));
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
      const std::string prefix = fmt::format("mesh{}/", i);
      add_vectors(out, prefix + "vertices", meshes_[i]->vertices());
      std::vector<std::int64_t> faces;
      for (const ivec3& face : meshes_[i]->faces()) faces.insert(faces.end(), {face.x, face.y, face.z});
      out.add(prefix + "faces", {meshes_[i]->faces().size(), 3}, std::span<const std::int64_t>(faces));
    }
  }

 private:
  std::vector<TriMeshPtr> meshes_;
};

/// Writes one body as arrays whose names begin with `prefix`.
void write_body(const HydroBody& body, const std::string& prefix, BundledMeshes& meshes, NpzWriter& out);
/// Reads the body that write_body() wrote. Throws Error naming file and array if its kind or field is unknown or an
/// array is not valid.
HydroBodyPtr read_body(const NpzReader& in, const std::string& prefix, const std::vector<TriMeshPtr>& meshes);

/// Writes the bodies that the sensors of a scene touch.
void write_touched(const SimScene& scene, BundledMeshes& meshes, NpzWriter& out);
/// Reads scene.touched, which remains empty if the file is of a version without these arrays. `scene` must have its
/// geoms and sensors.
void read_touched(const NpzReader& in, const std::vector<TriMeshPtr>& meshes, SimScene& scene);

}  // namespace taxel
