// Meshes of glTF 2.0 and GLB. Read are all triangles (lists, strips and fans) of all meshes of the file's
// scene, each moved by its node's transform. Accessors may be quantised (KHR_mesh_quantization), interleaved or sparse.
// Images, points and lines are skipped. Refused are accessors out of range and compressed meshes.

#include "core/mesh/formats/gltf.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <limits>
#include <optional>
#include <unordered_map>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/math.h"
#include "core/base/text/base64.h"
#include "core/base/text/json.h"
#include "core/mesh/formats/mesh_format.h"

namespace taxel {

// Bytes of glTF files: the chunks of GLB (glTF 2.0, 4.4), and the buffers that a uri names (3.6.1).

namespace {

constexpr std::size_t kGlbHeader = 12, kChunkGlbHeader = 8;  // lengths [bytes]
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t glb_number_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// Returns the content of the chunk of a type at `offset`, or nothing if it is not there or cut off.
std::optional<std::string_view> chunk_at(std::string_view bytes, std::size_t offset, std::uint32_t type) {
  if (offset > bytes.size() || bytes.size() - offset < kChunkGlbHeader) return std::nullopt;
  const std::size_t length = glb_number_at(bytes, offset), begin = offset + kChunkGlbHeader;
  if (glb_number_at(bytes, offset + 4) != type || length > bytes.size() - begin) return std::nullopt;
  return bytes.substr(begin, length);
}

/// Returns a uri with each %XX replaced by its byte (RFC 3986, 2.1).
std::string without_escapes(const std::string& uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      out += static_cast<char>(byte);
      i += 2;
    } else {
      out += uri[i];
    }
  }
  return out;
}

}  // namespace

GltfChunks find_gltf_chunks(std::string_view bytes, const std::string& file) {
  if (!bytes.starts_with("glTF")) return {bytes, std::nullopt};
  const auto refuse = [&](const std::string& why) { throw Error(file, "is not valid glTF: " + why); };
  if (bytes.size() < kGlbHeader + kChunkGlbHeader)
    refuse(fmt::format("its header must have {} bytes, there are {}", kGlbHeader + kChunkGlbHeader, bytes.size()));
  if (const std::uint32_t version = glb_number_at(bytes, 4); version != 2)
    refuse(fmt::format("version of GLB must be 2, is {}", version));
  if (const std::uint32_t length = glb_number_at(bytes, 8); length > bytes.size())
    refuse(fmt::format("is cut off: the header announces {} bytes, there are {}", length, bytes.size()));
  const std::optional<std::string_view> json = chunk_at(bytes, kGlbHeader, kJsonChunk);
  if (!json) refuse("its first chunk must be JSON and end within the file");
  return {*json, chunk_at(bytes, kGlbHeader + kChunkGlbHeader + json->size(), kBinaryChunk)};
}

std::string read_gltf_uri(const std::string& uri, const std::string& file, const std::string& pointer) {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    const std::string_view head = std::string_view(uri).substr(0, comma);
    if (comma == std::string::npos || !head.ends_with(";base64"))
      throw Error(file, pointer,
                  fmt::format("must begin with \"data:TYPE;base64,\", begins with \"{}\"", uri.substr(0, 40)));
    std::optional<std::string> decoded = from_base64(std::string_view(uri).substr(comma + 1));
    if (!decoded) throw Error(file, pointer, "is not Base64");
    return *std::move(decoded);
  }
  const std::string name = without_escapes(uri);
  if (name.find('\0') != std::string::npos) throw Error(file, pointer, "must be the name of a file, has a zero byte");
  try {
    return read_file(std::filesystem::path(file).parent_path() / name);
  } catch (const Error& error) {
    throw Error(file, pointer, short_quote(name) + ": " + error.message());
  }
}

namespace {

/// Largest depth of a node. Each level of the recursion takes a part of the stack.
constexpr int kMaxNodeDepth = 256;
/// Largest numbers of vertices and triangles of a scene. A mesh that many nodes refer to is counted once per node.
constexpr std::size_t kMaxVertices = 10'000'000, kMaxTriangles = 20'000'000;

/// Returns the length of a component [bytes].
std::size_t component_bytes(GltfComponent component) {
  switch (component) {
    case GltfComponent::int8:
    case GltfComponent::uint8:
      return 1;
    case GltfComponent::int16:
    case GltfComponent::uint16:
      return 2;
    case GltfComponent::float64:
      return 8;
    default:
      return 4;
  }
}

/// Numbers of one type in a part of a buffer, checked against the buffer's size.
class NumberView {
 public:
  /// Throws Error naming `where`.
  NumberView(const GltfModel& model, const GltfPlace& place, std::size_t count, int components, const std::string& file,
             const std::string& where)
      : component_size_(component_bytes(place.component)), component_(place.component) {
    const auto fail = [&](const std::string& why) { throw Error(file, where, why); };
    if (place.view < 0 || at(place.view) >= model.views.size())
      fail("has no buffer view (compressed meshes are not read)");
    const GltfView& view = model.views[at(place.view)];
    if (at(view.buffer) >= model.buffers.size()) fail("its buffer does not exist");
    const std::string& data = model.buffers[at(view.buffer)];
    const std::size_t element = component_size_ * at(components);
    stride_ = view.stride == 0 ? element : view.stride;
    if (stride_ < element || stride_ % component_size_ != 0)
      fail(fmt::format("its elements have {} bytes, which byteStride {} does not fit", element, stride_));
    if (view.offset > data.size() || view.length > data.size() - view.offset)
      fail("its buffer view reaches beyond its buffer");
    if (place.offset > view.length) fail("reaches beyond its buffer view");
    const std::size_t room = view.length - place.offset;  // no sum of offsets: it could wrap
    if (count > 0 && (room < element || (count - 1) > (room - element) / stride_))
      fail(fmt::format("reaches beyond its buffer view: {} elements of {} bytes, there are {} bytes", count, element,
                       room));
    data_ = data.data() + view.offset + place.offset;
  }

  [[nodiscard]] double number(std::size_t element, int component, bool normalized) const {
    const char* p = data_ + stride_ * element + component_size_ * at(component);
    switch (component_) {
      case GltfComponent::int8:
        return read<std::int8_t>(p, normalized);
      case GltfComponent::uint8:
        return read<std::uint8_t>(p, normalized);
      case GltfComponent::int16:
        return read<std::int16_t>(p, normalized);
      case GltfComponent::uint16:
        return read<std::uint16_t>(p, normalized);
      case GltfComponent::int32:
        return read<std::int32_t>(p, normalized);
      case GltfComponent::uint32:
        return read<std::uint32_t>(p, normalized);
      case GltfComponent::float64:
        return read<double>(p, normalized);
      default:
        return read<float>(p, normalized);
    }
  }

 private:
  /// Normalised integers represent [0, 1] or [-1, 1] (glTF 2.0, 3.6.2.2).
  template <class T>
  static double read(const char* p, bool normalized) {
    T value;
    std::memcpy(&value, p, sizeof value);
    if constexpr (std::is_integral_v<T>) {
      if (normalized) return std::max(static_cast<double>(value) / std::numeric_limits<T>::max(), -1.0);
    }
    return static_cast<double>(value);
  }

  const char* data_ = nullptr;
  std::size_t component_size_ = 0, stride_ = 0;
  GltfComponent component_;
};

/// One accessor's numbers. Those of a sparse accessor are the numbers of its buffer view, or zeros, in which single
/// elements are replaced (glTF 2.0, 3.6.2.3).
class AccessorReader {
 public:
  AccessorReader(const GltfModel& model, int index, const std::string& file) {
    const std::string where = fmt::format("accessor {}", index);
    if (at(index) >= model.accessors.size()) throw Error(file, where, "does not exist");
    const GltfAccessor& accessor = model.accessors[at(index)];
    count_ = accessor.count;
    components_ = accessor.components;
    component_ = accessor.place.component;
    normalized_ = accessor.normalized;
    const bool has_view = accessor.place.view >= 0 && at(accessor.place.view) < model.views.size();
    if (has_view || !accessor.sparse) dense_.emplace(model, accessor.place, count_, components_, file, where);
    if (count_ > kMaxVertices * 6)  // zeros take no bytes in the file, so their number is not bounded by its size
      throw Error(file, where, fmt::format("has {} elements, at most {} are read", count_, kMaxVertices * 6));
    if (accessor.sparse) replace_elements(model, *accessor.sparse, file, where);
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] int components() const { return components_; }
  [[nodiscard]] bool whole_numbers() const {
    return component_ != GltfComponent::float32 && component_ != GltfComponent::float64;
  }
  [[nodiscard]] double number(std::size_t element, int component) const {
    if (const auto found = replaced_.find(element); found != replaced_.end())
      return values_->number(found->second, component, normalized_);
    return dense_ ? dense_->number(element, component, normalized_) : 0.0;
  }

 private:
  void replace_elements(const GltfModel& model, const GltfSparse& sparse, const std::string& file,
                        const std::string& where) {
    if (sparse.count > count_)
      throw Error(file, where, fmt::format("replaces {} of its {} elements", sparse.count, count_));
    const std::size_t count = sparse.count;
    const NumberView indices(model, sparse.indices, count, 1, file, where + " sparse indices");
    values_.emplace(model, sparse.values, count, components_, file, where + " sparse values");
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
  int components_ = 0;
  GltfComponent component_ = GltfComponent::float32;
  bool normalized_ = false;
};

/// Collects the triangles of a scene.
class SceneReader {
 public:
  SceneReader(const GltfModel& model, std::string file)
      : model_(model), file_(std::move(file)), added_(model.nodes.size(), 0) {}

  void add_node(int index, const glm::dmat4& parent, int depth) {
    if (at(index) >= model_.nodes.size()) throw Error(file_, fmt::format("node {} does not exist", index));
    if (depth > kMaxNodeDepth)
      throw Error(file_, fmt::format("node {} is nested deeper than {} nodes", index, kMaxNodeDepth));
    // Nodes form trees (glTF 2.0, 3.5.3): 31 nodes that share children would otherwise be 2^30 copies of a mesh.
    if (added_[at(index)] != 0)
      throw Error(file_, fmt::format("node {} has several parents or is its own descendant", index));
    added_[at(index)] = 1;
    const GltfNode& node = model_.nodes[at(index)];
    const glm::dmat4 transform = parent * node.transform;
    if (node.mesh >= 0) {
      if (at(node.mesh) >= model_.meshes.size()) throw Error(file_, fmt::format("mesh {} does not exist", node.mesh));
      for (const GltfPrimitive& p : model_.meshes[at(node.mesh)]) add_primitive(p, transform);
    }
    for (const int child : node.children) add_node(child, transform, depth + 1);
  }

  void add_notes(const std::vector<std::string>& notes) {
    soup_.notes.insert(soup_.notes.end(), notes.begin(), notes.end());
  }
  [[nodiscard]] PolygonSoup take() { return std::move(soup_); }

 private:
  void add_primitive(const GltfPrimitive& primitive, const glm::dmat4& transform) {
    if (primitive.mode < kGltfTriangles || primitive.mode > kGltfFan || primitive.positions < 0) return;
    const AccessorReader points(model_, primitive.positions, file_);
    if (points.components() != 3)
      throw Error(file_, fmt::format("accessor {}", primitive.positions), "is no list of points");
    if (points.count() > kMaxVertices - soup_.vertices.size())
      throw Error(file_, fmt::format("the scene has more than {} vertices, the most that are read", kMaxVertices));
    const int first = static_cast<int>(soup_.vertices.size());
    for (std::size_t i = 0; i < points.count(); ++i) {
      const dvec3 p(transform * glm::dvec4(points.number(i, 0), points.number(i, 1), points.number(i, 2), 1.0));
      if (!is_finite(p)) throw Error(file_, fmt::format("vertex {}", i), "coordinate is not finite");
      soup_.vertices.push_back(p);
    }
    const bool mirrored = glm::determinant(dmat3(transform)) < 0;
    add_triangles(corners_of(primitive, points.count()), first, primitive.mode, mirrored);
  }

  std::vector<int> corners_of(const GltfPrimitive& primitive, std::size_t point_count) const {
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

  void add_triangles(const std::vector<int>& corners, int first, std::uint64_t mode, bool mirrored) {
    const std::size_t step = mode == kGltfTriangles ? 3 : 1;
    for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
      const bool odd = mode == kGltfStrip && i % 2 == 1;
      ivec3 t(corners[mode == kGltfFan ? 0 : i], corners[i + 1], corners[i + 2]);
      if (odd != mirrored) std::swap(t.y, t.z);
      soup_.triangles.push_back(t + first);
    }
    if (soup_.triangles.size() > kMaxTriangles)
      throw Error(file_, fmt::format("the scene has more than {} triangles, the most that are read", kMaxTriangles));
  }

  const GltfModel& model_;
  std::string file_;
  std::vector<char> added_;  ///< 1 for each of the model's nodes that is already in the scene
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup read_gltf(std::string_view bytes, const std::string& file) {
  const GltfModel model = parse_gltf(bytes, file);
  SceneReader reader(model, file);
  reader.add_notes(model.notes);
  if (model.scenes.empty()) {
    // Without a scene, every node without a parent is added.
    std::vector<char> child(model.nodes.size(), 0);
    for (const GltfNode& node : model.nodes) {
      for (const int c : node.children) {
        if (at(c) < child.size()) child[at(c)] = 1;
      }
    }
    for (std::size_t i = 0; i < child.size(); ++i) {
      if (child[i] == 0) reader.add_node(static_cast<int>(i), glm::dmat4(1.0), 0);
    }
    return reader.take();
  }
  if (at(model.scene) >= model.scenes.size()) throw Error(file, fmt::format("scene {} does not exist", model.scene));
  for (const int node : model.scenes[at(model.scene)]) reader.add_node(node, glm::dmat4(1.0), 0);
  return reader.take();
}

}  // namespace taxel
