// glTF 2.0 and GLB, parsed by tinygltf. Read are all triangles (lists, strips and fans) of all meshes of the file's
// scene, each moved by its node's transform. Accessors may be quantised (KHR_mesh_quantization), interleaved or sparse.
// Images, points and lines are skipped. Refused are accessors out of range and compressed meshes.

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <array>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <sstream>
#include <unordered_map>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/index.h"
#include "core/mesh/formats/mesh_format.h"

namespace taxel {
namespace {

/// Largest depth of a node. Each level of the recursion takes a part of the stack.
constexpr int kMaxNodeDepth = 256;
/// Largest numbers of vertices and triangles of a scene. A mesh that many nodes refer to is counted once per node.
constexpr std::size_t kMaxVertices = 10'000'000, kMaxTriangles = 20'000'000;

bool skip_image(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
  return true;
}

/// Reads a buffer that has its own file by read_file(), which accepts regular files up to a limit of size.
// The library calls these two functions and ends the program if they throw.

bool read_buffer_file(std::vector<unsigned char>* out, std::string* error, const std::string& path, void*) {
  try {
    const std::string bytes = read_file(path);
    out->assign(bytes.begin(), bytes.end());
  } catch (const std::exception& e) {
    *error += e.what();
    return false;
  }
  return true;
}

/// A name that no file system accepts names no file.
bool is_buffer_file(const std::string& path, void*) {
  std::error_code unknown;
  return std::filesystem::exists(path, unknown);
}

tinygltf::Model parse_gltf(std::string_view bytes, const std::string& file) {
  tinygltf::TinyGLTF loader;
  loader.SetImageLoader(skip_image, nullptr);
  tinygltf::FsCallbacks files{};
  files.FileExists = is_buffer_file;
  files.ExpandFilePath = [](const std::string& name, void*) { return name; };
  files.ReadWholeFile = read_buffer_file;
  loader.SetFsCallbacks(files);
  tinygltf::Model model;
  std::string error, warning;
  const std::filesystem::path parent = std::filesystem::path(file).parent_path();
  const std::string folder = parent.empty() ? "." : parent.string();
  const auto size = static_cast<unsigned int>(bytes.size());
  if (bytes.size() > std::numeric_limits<unsigned int>::max()) throw Error(file, "is larger than 4 GiB");
  const bool binary = bytes.starts_with("glTF");
  const bool read =
      binary ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                           reinterpret_cast<const unsigned char*>(bytes.data()), size, folder)
             : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, folder);
  if (!read) {
    while (!error.empty() && error.back() == '\n') error.pop_back();
    std::replace(error.begin(), error.end(), '\n', ' ');
    throw Error(file, "is not valid glTF: " + (error.empty() ? std::string("cannot be parsed") : error));
  }
  return model;
}

/// Throws Error naming the first extension that the file requires and that is not read, with the remedy.
void check_extensions(const tinygltf::Model& model, const std::string& file) {
  constexpr std::array<std::string_view, 7> kRead{"KHR_mesh_quantization", "KHR_texture_transform",
                                                  "KHR_materials_unlit",   "KHR_texture_basisu",
                                                  "EXT_texture_webp",      "KHR_materials_pbrSpecularGlossiness",
                                                  "KHR_lights_punctual"};
  for (const std::string& name : model.extensionsRequired) {
    if (std::find(kRead.begin(), kRead.end(), name) != kRead.end()) continue;
    const bool compressed = name == "KHR_draco_mesh_compression" || name.ends_with("_meshopt_compression");
    throw Error(file, "extensionsRequired",
                fmt::format("needs the extension {}, which is not read: export the mesh without {}", name.substr(0, 60),
                            compressed ? "compression" : "it"));
  }
}

/// Numbers of one type in a part of a buffer, checked against the buffer's size.
class NumberView {
 public:
  /// `stride` 0 means that the elements follow each other. Throws Error naming `where`.
  NumberView(const tinygltf::Model& model, int view_index, std::size_t offset, std::size_t count, int component_type,
             int components, std::size_t stride, const std::string& file, const std::string& where)
      : component_type_(component_type) {
    const auto fail = [&](const std::string& why) { throw Error(file, where, why); };
    if (view_index < 0 || at(view_index) >= model.bufferViews.size())
      fail("has no buffer view (compressed meshes are not read)");
    const tinygltf::BufferView& view = model.bufferViews[at(view_index)];
    if (view.buffer < 0 || at(view.buffer) >= model.buffers.size()) fail("its buffer does not exist");
    const std::vector<unsigned char>& data = model.buffers[at(view.buffer)].data;
    const int size = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type));
    if (size <= 0 || components <= 0) fail("has an unknown type or stride");
    component_size_ = at(size);
    const std::size_t element = component_size_ * at(components);
    stride_ = stride == 0 ? element : stride;
    if (stride_ < element) fail("has an unknown type or stride");
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset)
      fail("its buffer view reaches beyond its buffer");
    if (offset > view.byteLength) fail("reaches beyond its buffer view");
    const std::size_t room = view.byteLength - offset;  // no sum of offsets: it could wrap
    if (count > 0 && (room < element || (count - 1) > (room - element) / stride_))
      fail(fmt::format("reaches beyond its buffer view: {} elements of {} bytes, there are {} bytes", count, element,
                       room));
    data_ = data.data() + view.byteOffset + offset;
  }

  [[nodiscard]] double number(std::size_t element, int component, bool normalized) const {
    const unsigned char* p = data_ + stride_ * element + component_size_ * at(component);
    switch (component_type_) {
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return read<std::int8_t>(p, normalized);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return read<std::uint8_t>(p, normalized);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return read<std::int16_t>(p, normalized);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return read<std::uint16_t>(p, normalized);
      case TINYGLTF_COMPONENT_TYPE_INT:
        return read<std::int32_t>(p, normalized);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return read<std::uint32_t>(p, normalized);
      case TINYGLTF_COMPONENT_TYPE_DOUBLE:
        return read<double>(p, normalized);
      default:
        return read<float>(p, normalized);
    }
  }

 private:
  /// Normalised integers represent [0, 1] or [-1, 1] (glTF 2.0, 3.6.2.2).
  template <class T>
  static double read(const unsigned char* p, bool normalized) {
    T value;
    std::memcpy(&value, p, sizeof value);
    if constexpr (std::is_integral_v<T>) {
      if (normalized) return std::max(static_cast<double>(value) / std::numeric_limits<T>::max(), -1.0);
    }
    return static_cast<double>(value);
  }

  const unsigned char* data_ = nullptr;
  std::size_t component_size_ = 0, stride_ = 0;
  int component_type_ = 0;
};

/// One accessor's numbers. Those of a sparse accessor are the numbers of its buffer view, or zeros, in which single
/// elements are replaced (glTF 2.0, 3.6.2.3).
class AccessorReader {
 public:
  AccessorReader(const tinygltf::Model& model, int index, const std::string& file) {
    const std::string where = fmt::format("accessor {}", index);
    if (index < 0 || at(index) >= model.accessors.size()) throw Error(file, where, "does not exist");
    const tinygltf::Accessor& accessor = model.accessors[at(index)];
    count_ = accessor.count;
    components_ = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    component_type_ = accessor.componentType;
    normalized_ = accessor.normalized;
    const bool has_view = accessor.bufferView >= 0 && at(accessor.bufferView) < model.bufferViews.size();
    if (has_view || !accessor.sparse.isSparse) {
      std::size_t stride = 0;
      if (has_view) {
        const int bytes = accessor.ByteStride(model.bufferViews[at(accessor.bufferView)]);
        if (bytes <= 0) throw Error(file, where, "has an unknown type or stride");
        stride = at(bytes);
      }
      dense_.emplace(model, accessor.bufferView, accessor.byteOffset, count_, component_type_, components_, stride,
                     file, where);
    }
    if (count_ > kMaxVertices * 6)  // zeros take no bytes in the file, so their number is not bounded by its size
      throw Error(file, where, fmt::format("has {} elements, at most {} are read", count_, kMaxVertices * 6));
    if (accessor.sparse.isSparse) replace_elements(model, accessor, file, where);
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] int components() const { return components_; }
  [[nodiscard]] bool whole_numbers() const {
    return component_type_ != TINYGLTF_COMPONENT_TYPE_FLOAT && component_type_ != TINYGLTF_COMPONENT_TYPE_DOUBLE;
  }
  [[nodiscard]] double number(std::size_t element, int component) const {
    if (const auto found = replaced_.find(element); found != replaced_.end())
      return values_->number(found->second, component, normalized_);
    return dense_ ? dense_->number(element, component, normalized_) : 0.0;
  }

 private:
  void replace_elements(const tinygltf::Model& model, const tinygltf::Accessor& accessor, const std::string& file,
                        const std::string& where) {
    const auto& sparse = accessor.sparse;
    if (sparse.count < 0 || at(sparse.count) > count_)
      throw Error(file, where, fmt::format("replaces {} of its {} elements", sparse.count, count_));
    const std::size_t count = at(sparse.count);
    const NumberView indices(model, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
                             count, sparse.indices.componentType, 1, 0, file, where + " sparse indices");
    values_.emplace(model, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset), count,
                    component_type_, components_, 0, file, where + " sparse values");
    for (std::size_t i = 0; i < count; ++i) {
      const double element = indices.number(i, 0, false);
      if (!(element >= 0 && element < static_cast<double>(count_)))
        throw Error(file, where + " sparse indices", fmt::format("no element {} (there are {})", element, count_));
      replaced_[static_cast<std::size_t>(element)] = i;
    }
  }

  std::optional<NumberView> dense_, values_;
  std::unordered_map<std::size_t, std::size_t> replaced_;  ///< row of values_ for each replaced element
  std::size_t count_ = 0;
  int components_ = 0, component_type_ = 0;
  bool normalized_ = false;
};

glm::dmat4 local_transform(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) {
    glm::dmat4 matrix(1.0);
    for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[at(i)];
    return matrix;
  }
  glm::dmat4 matrix(1.0);
  if (node.translation.size() == 3)
    matrix = glm::translate(matrix, dvec3(node.translation[0], node.translation[1], node.translation[2]));
  if (node.rotation.size() == 4)  // x y z w
    matrix *= glm::mat4_cast(dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
  if (node.scale.size() == 3) matrix = glm::scale(matrix, dvec3(node.scale[0], node.scale[1], node.scale[2]));
  return matrix;
}

/// Collects the triangles of a scene.
class SceneReader {
 public:
  SceneReader(const tinygltf::Model& model, std::string file)
      : model_(model), file_(std::move(file)), added_(model.nodes.size(), 0) {}

  void add_node(int index, const glm::dmat4& parent, int depth) {
    if (index < 0 || at(index) >= model_.nodes.size()) throw Error(file_, fmt::format("node {} does not exist", index));
    if (depth > kMaxNodeDepth)
      throw Error(file_, fmt::format("node {} is nested deeper than {} nodes", index, kMaxNodeDepth));
    // Nodes form trees (glTF 2.0, 3.5.3): 31 nodes that share children would otherwise be 2^30 copies of a mesh.
    if (added_[at(index)] != 0)
      throw Error(file_, fmt::format("node {} has several parents or is its own descendant", index));
    added_[at(index)] = 1;
    const tinygltf::Node& node = model_.nodes[at(index)];
    const glm::dmat4 transform = parent * local_transform(node);
    if (node.mesh >= 0) {
      if (at(node.mesh) >= model_.meshes.size()) throw Error(file_, fmt::format("mesh {} does not exist", node.mesh));
      for (const tinygltf::Primitive& p : model_.meshes[at(node.mesh)].primitives) add_primitive(p, transform);
    }
    for (const int child : node.children) add_node(child, transform, depth + 1);
  }

  [[nodiscard]] PolygonSoup take() { return std::move(soup_); }

 private:
  void add_primitive(const tinygltf::Primitive& primitive, const glm::dmat4& transform) {
    // Without a mode in the file, tinygltf gives -1. The default are triangles (glTF 2.0, 5.24).
    const int mode = primitive.mode < 0 ? TINYGLTF_MODE_TRIANGLES : primitive.mode;
    if (mode < TINYGLTF_MODE_TRIANGLES) return;
    const auto position = primitive.attributes.find("POSITION");
    if (position == primitive.attributes.end()) return;
    const AccessorReader points(model_, position->second, file_);
    if (points.components() != 3)
      throw Error(file_, fmt::format("accessor {}", position->second), "is no list of points");
    if (points.count() > kMaxVertices - soup_.vertices.size())
      throw Error(file_, fmt::format("the scene has more than {} vertices, the most that are read", kMaxVertices));
    const int first = static_cast<int>(soup_.vertices.size());
    for (std::size_t i = 0; i < points.count(); ++i) {
      const dvec3 p(transform * glm::dvec4(points.number(i, 0), points.number(i, 1), points.number(i, 2), 1.0));
      if (!is_finite(p)) throw Error(file_, fmt::format("vertex {}", i), "coordinate is not finite");
      soup_.vertices.push_back(p);
    }
    const bool mirrored = glm::determinant(dmat3(transform)) < 0;
    add_triangles(corners_of(primitive, points.count()), first, mode, mirrored);
  }

  std::vector<int> corners_of(const tinygltf::Primitive& primitive, std::size_t point_count) const {
    std::vector<int> corners;
    if (primitive.indices < 0) {
      for (std::size_t i = 0; i < point_count; ++i) corners.push_back(static_cast<int>(i));
      return corners;
    }
    const AccessorReader indices(model_, primitive.indices, file_);
    if (indices.components() != 1 || !indices.whole_numbers())
      throw Error(file_, fmt::format("accessor {}", primitive.indices), "is no list of vertex numbers");
    for (std::size_t i = 0; i < indices.count(); ++i) {
      const double index = indices.number(i, 0);
      if (!(index >= 0 && index < static_cast<double>(point_count)))
        throw Error(file_, fmt::format("accessor {}", primitive.indices), fmt::format("no vertex {}", index));
      corners.push_back(static_cast<int>(index));
    }
    return corners;
  }

  void add_triangles(const std::vector<int>& corners, int first, int mode, bool mirrored) {
    const std::size_t step = mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      const bool odd = mode == TINYGLTF_MODE_TRIANGLE_STRIP && i % 2 == 1;
      ivec3 t(corners[mode == TINYGLTF_MODE_TRIANGLE_FAN ? 0 : i], corners[i + 1], corners[i + 2]);
      if (odd != mirrored) std::swap(t.y, t.z);
      soup_.triangles.push_back(t + first);
    }
    if (soup_.triangles.size() > kMaxTriangles)
      throw Error(file_, fmt::format("the scene has more than {} triangles, the most that are read", kMaxTriangles));
  }

  const tinygltf::Model& model_;
  std::string file_;
  std::vector<char> added_;  ///< 1 for each of the model's nodes that is already in the scene
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup read_gltf(std::string_view bytes, const std::string& file) {
  const tinygltf::Model model = parse_gltf(bytes, file);
  check_extensions(model, file);
  SceneReader reader(model, file);
  if (model.scenes.empty()) {
    // Without a scene, every node without a parent is added.
    std::vector<char> child(model.nodes.size(), 0);
    for (const tinygltf::Node& node : model.nodes) {
      for (const int c : node.children) {
        if (c >= 0 && at(c) < child.size()) child[at(c)] = 1;
      }
    }
    for (std::size_t i = 0; i < child.size(); ++i) {
      if (child[i] == 0) reader.add_node(static_cast<int>(i), glm::dmat4(1.0), 0);
    }
    return reader.take();
  }
  const int chosen = model.defaultScene >= 0 ? model.defaultScene : 0;
  if (at(chosen) >= model.scenes.size()) throw Error(file, fmt::format("scene {} does not exist", chosen));
  for (const int node : model.scenes[at(chosen)].nodes) reader.add_node(node, glm::dmat4(1.0), 0);
  return reader.take();
}

}  // namespace taxel
