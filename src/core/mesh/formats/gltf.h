// The parts of a glTF 2.0 file that make a mesh, as values, and their readers, for JSON, GLB and buffers.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Type of the components of an accessor, with the number of the specification (glTF 2.0, 5.1.3). INT and DOUBLE are
/// not in the specification, but in files of some exporters.
enum class GltfComponent { int8 = 5120, uint8, int16, uint16, int32, uint32, float32, float64 = 5130 };

/// Mode of a primitive that consists of triangles (glTF 2.0, 5.24.4). Lower numbers are points and lines.
enum GltfMode { kGltfTriangles = 4, kGltfStrip = 5, kGltfFan = 6 };

/// Part of a buffer. A stride of 0 means that the elements follow each other.
struct GltfView {
  int buffer = 0;
  std::uint64_t offset = 0, length = 0, stride = 0;  ///< [bytes]
};

/// Place of numbers in a buffer view.
struct GltfPlace {
  int view = -1;             ///< index in GltfModel::views, or -1 if the file names none
  std::uint64_t offset = 0;  ///< [bytes]
  GltfComponent component = GltfComponent::float32;
};

/// Elements that replace those of an accessor.
struct GltfSparse {
  std::uint64_t count = 0;
  GltfPlace indices, values;
};

struct GltfAccessor {
  GltfPlace place;
  std::uint64_t count = 0;
  int components = 1;  ///< number of components of an element
  bool normalized = false;
  std::optional<GltfSparse> sparse;
};

struct GltfPrimitive {
  int positions = -1, indices = -1;  ///< accessors, or -1 if there are none
  std::uint64_t mode = kGltfTriangles;
};

struct GltfNode {
  int mesh = -1;  ///< index in GltfModel::meshes, or -1 if the node has no mesh
  std::vector<int> children;
  glm::dmat4 transform = glm::dmat4(1.0);  ///< from the frame of the node to that of its parent
};

/// Indices of the file are 0 or more, but may be beyond the end of the lists.
struct GltfModel {
  std::vector<std::string> buffers;  ///< bytes
  std::vector<GltfView> views;
  std::vector<GltfAccessor> accessors;
  std::vector<std::vector<GltfPrimitive>> meshes;
  std::vector<GltfNode> nodes;
  std::vector<std::vector<int>> scenes;  ///< nodes of each scene
  int scene = 0;                         ///< index in `scenes` of the scene that is read
  std::vector<std::string> notes;        ///< changes of values that are slightly wrong
};

/// The parts of a file that is GLB, or a JSON text alone.
struct GltfChunks {
  std::string_view json;
  std::optional<std::string_view> binary;  ///< bytes of the buffer that has no uri
};

/// Finds the parts of a file. Throws Error if a GLB file is of another version or cut off.
GltfChunks find_gltf_chunks(std::string_view bytes, const std::string& file);

/// Returns the bytes of a buffer by its uri: Base64 in the uri itself, or a file in the folder of `file`. Only regular
/// files are opened. Throws Error that names `pointer`.
std::string read_gltf_uri(const std::string& uri, const std::string& file, const std::string& pointer);

/// Reads the model and the files of its buffers. Images, materials and animations are not looked at, and their files
/// are not opened. Throws Error with the JSON pointer of a value that is missing or not valid, of an extension that is
/// required and not read, or of a buffer that cannot be read.
GltfModel parse_gltf(std::string_view bytes, const std::string& file);

}  // namespace taxel
