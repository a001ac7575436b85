// Reads the JSON of glTF 2.0. No library for glTF is used: they open the files that a document names, pipes and images
// included, and word their messages differently in each version.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/error.h"
#include "core/base/text/json.h"
#include "core/mesh/formats/gltf.h"

namespace taxel {
namespace {

using GltfJson = nlohmann::ordered_json;
using GltfValue = JsonNode<GltfJson>;

int read_index(const GltfValue& value) {
  const std::uint64_t index = value.natural();
  if (index > static_cast<std::uint64_t>(std::numeric_limits<int>::max())) value.wrong("an index of at most 31 bits");
  return static_cast<int>(index);
}

void read_index(const GltfValue& object, const char* key, int& out) {
  if (const auto value = object.find(key)) out = read_index(*value);
}

void read_natural(const GltfValue& object, const char* key, std::uint64_t& out) {
  if (const auto value = object.find(key)) out = value->natural();
}

/// Calls read(item) for each item of an array that may be missing, and returns the results.
template <class Read>
auto read_list(const GltfValue& object, const char* key, const Read& read) {
  std::vector<decltype(read(object))> list;
  const auto array = object.find(key);
  const std::size_t count = array ? array->length() : 0;
  list.reserve(count);
  for (std::size_t i = 0; i < count; ++i) list.push_back(read(array->item(i)));
  return list;
}

std::vector<int> read_indices(const GltfValue& object, const char* key) {
  return read_list(object, key, [](const GltfValue& item) { return read_index(item); });
}

/// Throws Error unless the file is of version 2.
void check_version(const GltfValue& root) {
  const GltfValue asset = root.at("asset");
  asset.must_be_object();
  const GltfValue version = asset.at("version");
  if (!version.text().starts_with("2.")) version.wrong("2.0, the version that is read");
}

/// Throws Error naming the first extension that the file requires and that is not read, with the remedy.
void check_extensions(const GltfValue& root, const std::string& file) {
  constexpr std::array<std::string_view, 7> kRead{"KHR_mesh_quantization", "KHR_texture_transform",
                                                  "KHR_materials_unlit",   "KHR_texture_basisu",
                                                  "EXT_texture_webp",      "KHR_materials_pbrSpecularGlossiness",
                                                  "KHR_lights_punctual"};
  for (const std::string& name :
       read_list(root, "extensionsRequired", [](const GltfValue& item) { return item.text(); })) {
    if (std::find(kRead.begin(), kRead.end(), name) != kRead.end()) continue;
    const bool compressed = name == "KHR_draco_mesh_compression" || name.ends_with("_meshopt_compression");
    throw Error(file, "extensionsRequired",
                fmt::format("needs the extension {}, which is not read: export the mesh without {}", name.substr(0, 60),
                            compressed ? "compression" : "it"));
  }
}

/// Returns the bytes of a buffer. `binary` is the chunk of GLB; only the first buffer may be there.
std::string read_buffer(const GltfValue& buffer, const std::optional<std::string_view>& binary,
                        const std::string& file) {
  buffer.must_be_object();
  const GltfValue length_value = buffer.at("byteLength");
  const std::uint64_t length = length_value.natural();
  std::string bytes;
  if (const auto uri = buffer.find("uri")) {
    bytes = read_gltf_uri(uri->text(), file, uri->pointer());
  } else {
    if (!binary || buffer.pointer() != "/buffers/0")
      buffer.fail_at("uri", "is missing, and the file has no bytes for the buffer");
    bytes = *binary;
  }
  if (bytes.size() < length)
    length_value.fail(
        fmt::format("must be at most {}, the number of bytes of the buffer, is {}", bytes.size(), length));
  bytes.resize(length);
  return bytes;
}

GltfView read_view(const GltfValue& object) {
  object.must_be_object();
  GltfView view;
  view.buffer = read_index(object.at("buffer"));
  view.length = object.at("byteLength").natural();
  read_natural(object, "byteOffset", view.offset);
  if (const auto stride = object.find("byteStride")) {
    view.stride = stride->natural();
    if (view.stride < 4 || view.stride > 252 || view.stride % 4 != 0) stride->wrong("a multiple of 4 from 4 to 252");
  }
  return view;
}

GltfComponent read_component(const GltfValue& value) {
  const std::uint64_t number = value.natural();
  if (!(number >= 5120 && number <= 5126) && number != 5130) value.wrong("5120, 5121, 5122, 5123, 5125 or 5126");
  return static_cast<GltfComponent>(number);
}

int read_component_count(const GltfValue& value) {
  using Type = std::pair<std::string_view, int>;
  constexpr std::array kTypes{Type{"SCALAR", 1}, Type{"VEC2", 2}, Type{"VEC3", 3}, Type{"VEC4", 4},
                              Type{"MAT2", 4},   Type{"MAT3", 9}, Type{"MAT4", 16}};
  const std::string word = value.text();
  for (const auto& [name, count] : kTypes)
    if (name == word) return count;
  value.wrong("SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
}

GltfPlace read_place(const GltfValue& object, GltfComponent component) {
  object.must_be_object();
  GltfPlace place{-1, 0, component};
  read_index(object, "bufferView", place.view);
  read_natural(object, "byteOffset", place.offset);
  return place;
}

GltfAccessor read_accessor(const GltfValue& object) {
  object.must_be_object();
  const GltfComponent component = read_component(object.at("componentType"));
  GltfAccessor accessor;
  accessor.place = read_place(object, component);
  accessor.count = object.at("count").natural();
  accessor.components = read_component_count(object.at("type"));
  if (const auto normalized = object.find("normalized")) accessor.normalized = normalized->flag();
  if (const auto sparse = object.find("sparse")) {
    sparse->must_be_object();
    const GltfValue indices = sparse->at("indices");
    indices.must_be_object();
    accessor.sparse =
        GltfSparse{sparse->at("count").natural(), read_place(indices, read_component(indices.at("componentType"))),
                   read_place(sparse->at("values"), component)};
  }
  return accessor;
}

GltfPrimitive read_primitive(const GltfValue& object) {
  object.must_be_object();
  GltfPrimitive primitive;
  const GltfValue attributes = object.at("attributes");
  attributes.must_be_object();
  read_index(attributes, "POSITION", primitive.positions);
  read_index(object, "indices", primitive.indices);
  read_natural(object, "mode", primitive.mode);
  return primitive;
}

std::vector<GltfPrimitive> read_primitives(const GltfValue& mesh) {
  mesh.must_be_object();
  (void)mesh.at("primitives");  // must exist
  return read_list(mesh, "primitives", read_primitive);
}

/// Returns the rotation of a node (glTF 2.0, 3.5.3: a unit quaternion x y z w). A length that is off by less than 1 %
/// is that of rounded numbers and is corrected. Throws Error for other lengths: they would scale the mesh.
dquat read_rotation(const GltfValue& value, std::vector<std::string>& notes) {
  constexpr double kRounding = 1e-5;  // of numbers of 32 bits
  constexpr double kMaxError = 0.01;
  const std::vector<double> q = value.numbers(4);
  const dquat rotation(q[3], q[0], q[1], q[2]);
  const double length = glm::length(rotation);
  if (!(std::abs(length - 1) <= kMaxError))
    value.fail(fmt::format("must be a quaternion of length 1, has length {:.6g}", length));
  if (std::abs(length - 1) > kRounding)
    notes.push_back(fmt::format("normalised {}: its length is {:.6g}", value.pointer(), length));
  return glm::normalize(rotation);
}

/// Returns the transform of a node (glTF 2.0, 3.5.2).
glm::dmat4 read_transform(const GltfValue& node, std::vector<std::string>& notes) {
  glm::dmat4 matrix(1.0);
  if (const auto value = node.find("matrix")) {
    const std::vector<double> columns = value->numbers(16);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = columns[static_cast<std::size_t>(i)];
    return matrix;
  }
  if (const auto value = node.find("translation")) matrix = glm::translate(matrix, value->vector3());
  if (const auto value = node.find("rotation")) matrix *= glm::mat4_cast(read_rotation(*value, notes));
  if (const auto value = node.find("scale")) matrix = glm::scale(matrix, value->vector3());
  return matrix;
}

GltfNode read_node(const GltfValue& object, std::vector<std::string>& notes) {
  object.must_be_object();
  GltfNode node;
  read_index(object, "mesh", node.mesh);
  node.children = read_indices(object, "children");
  node.transform = read_transform(object, notes);
  return node;
}

GltfJson parse_text(std::string_view text, const std::string& file) {
  try {
    return parse_json<GltfJson>(std::string(text), file);
  } catch (const Error& error) {
    throw Error(file, error.where(), "is not valid glTF: " + error.message());
  }
}

}  // namespace

GltfModel parse_gltf(std::string_view bytes, const std::string& file) {
  const GltfChunks chunks = find_gltf_chunks(bytes, file);
  const GltfJson json = parse_text(chunks.json, file);
  if (!json.is_object()) throw Error(file, "is not valid glTF: must be a JSON object");
  const GltfValue root(json, file);
  check_version(root);
  check_extensions(root, file);
  GltfModel model;
  model.buffers =
      read_list(root, "buffers", [&](const GltfValue& buffer) { return read_buffer(buffer, chunks.binary, file); });
  model.views = read_list(root, "bufferViews", read_view);
  model.accessors = read_list(root, "accessors", read_accessor);
  model.meshes = read_list(root, "meshes", read_primitives);
  model.nodes = read_list(root, "nodes", [&](const GltfValue& node) { return read_node(node, model.notes); });
  model.scenes = read_list(root, "scenes", [](const GltfValue& scene) { return read_indices(scene, "nodes"); });
  read_index(root, "scene", model.scene);
  return model;
}

}  // namespace taxel
