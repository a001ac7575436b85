// Writes GLB: one mesh with positions, vertex normals and indices.
#include <tiny_gltf.h>

#include <cstring>
#include <sstream>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/mesh/formats/mesh_format.h"

namespace taxel {
namespace {

/// Appends `bytes` to the buffer and a view of these bytes to the model. Returns the view's index.
int add_view(tinygltf::Model& model, const void* bytes, std::size_t size, int target) {
  std::vector<unsigned char>& data = model.buffers[0].data;
  tinygltf::BufferView view;
  view.buffer = 0;
  view.byteOffset = data.size();
  view.byteLength = size;
  view.target = target;
  data.resize(data.size() + size);
  std::memcpy(data.data() + view.byteOffset, bytes, size);
  model.bufferViews.push_back(view);
  return static_cast<int>(model.bufferViews.size()) - 1;
}

/// Returns the index of a new accessor of `view`.
int add_accessor(tinygltf::Model& model, int view, int component_type, int type, std::size_t count) {
  tinygltf::Accessor accessor;
  accessor.bufferView = view;
  accessor.componentType = component_type;
  accessor.type = type;
  accessor.count = count;
  model.accessors.push_back(accessor);
  return static_cast<int>(model.accessors.size()) - 1;
}

/// Appends vectors as numbers of type float. Returns the index of their accessor.
int add_vectors(tinygltf::Model& model, const std::vector<dvec3>& vectors) {
  const std::vector<glm::vec3> rounded(vectors.begin(), vectors.end());
  const int view = add_view(model, rounded.data(), rounded.size() * sizeof(glm::vec3), TINYGLTF_TARGET_ARRAY_BUFFER);
  return add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_FLOAT, TINYGLTF_TYPE_VEC3, rounded.size());
}

}  // namespace

std::string write_glb(const TriMesh& mesh) {
  tinygltf::Model model;
  model.asset.version = "2.0";
  model.asset.generator = "Taxel Studio";
  model.buffers.emplace_back();
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  const int positions = add_vectors(model, mesh.vertices());
  const glm::vec3 lo(mesh.bounds().lo), hi(mesh.bounds().hi);
  model.accessors[at(positions)].minValues = {lo.x, lo.y, lo.z};
  model.accessors[at(positions)].maxValues = {hi.x, hi.y, hi.z};
  primitive.attributes["POSITION"] = positions;
  primitive.attributes["NORMAL"] = add_vectors(model, mesh.vertex_normals());
  const auto& faces = mesh.faces();
  const int view = add_view(model, faces.data(), faces.size() * sizeof(ivec3), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
  primitive.indices =
      add_accessor(model, view, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, 3 * faces.size());
  model.meshes.emplace_back();
  model.meshes[0].primitives.push_back(primitive);
  model.nodes.emplace_back();
  model.nodes[0].mesh = 0;
  model.scenes.emplace_back();
  model.scenes[0].nodes.push_back(0);
  model.defaultScene = 0;
  std::ostringstream out;
  tinygltf::TinyGLTF writer;
  if (!writer.WriteGltfSceneToStream(&model, out, false, true)) throw Error("the mesh cannot be written as GLB");
  return out.str();
}

}  // namespace taxel
