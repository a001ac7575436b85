// Quantised positions of glTF files (KHR_mesh_quantization): all types, normalised or not, interleaved, moved by nodes.
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/base/math.h"
#include "core/mesh/mesh_io.h"
#include "fixtures/temp_folder.h"
#include "unit/mesh/random_mesh.h"

namespace taxel {
namespace {

using nlohmann::json;
using test::TempFolder;

/// A type of the components of positions.
struct Component {
  const char* name;
  int code;                ///< componentType of the file
  double lowest, highest;  ///< range of the stored whole numbers
  bool normalised = false;
  std::size_t bytes = 0;
};

template <class T>
Component component(const char* name, int code, bool normalised) {
  return {name,
          code,
          static_cast<double>(std::numeric_limits<T>::lowest()),
          static_cast<double>(std::numeric_limits<T>::max()),
          normalised,
          sizeof(T)};
}

std::vector<Component> components() {
  std::vector<Component> all;
  for (const bool normalised : {false, true}) {
    all.push_back(component<std::int8_t>("int8", 5120, normalised));
    all.push_back(component<std::uint8_t>("uint8", 5121, normalised));
    all.push_back(component<std::int16_t>("int16", 5122, normalised));
    all.push_back(component<std::uint16_t>("uint16", 5123, normalised));
  }
  return all;
}

/// Returns the number that a stored whole number represents, as the table of the specification has it
/// (glTF 2.0, 3.6.2.2: c / 127 and so on, at least -1 for signed types).
double represented(const Component& type, double stored) {
  if (!type.normalised) return stored;
  switch (type.code) {
    case 5120:
      return std::max(stored / 127.0, -1.0);
    case 5121:
      return stored / 255.0;
    case 5122:
      return std::max(stored / 32767.0, -1.0);
    default:
      return stored / 65535.0;
  }
}

/// A file of one mesh whose positions are stored as a type, each in `stride` bytes after four bytes that are no
/// position. The node's transform is `translation` and `scale`.
std::filesystem::path write_file(const TempFolder& folder, const std::vector<std::array<double, 3>>& stored,
                                 const std::vector<ivec3>& faces, const Component& type, std::size_t stride,
                                 const json& node) {
  std::string buffer;
  for (const std::array<double, 3>& point : stored) {
    std::string row(stride, '\x7b');
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto bits = static_cast<std::uint32_t>(static_cast<std::int32_t>(point[axis]));
      std::memcpy(row.data() + 4 + axis * type.bytes, &bits, type.bytes);  // little endian
    }
    buffer += row;
  }
  const std::size_t positions = buffer.size();
  for (const ivec3& face : faces)
    for (int c = 0; c < 3; ++c) buffer.append(reinterpret_cast<const char*>(&face[c]), 4);
  (void)folder.write("a.bin", buffer);
  json document = {{"asset", {{"version", "2.0"}}},
                   {"extensionsUsed", {"KHR_mesh_quantization"}},
                   {"extensionsRequired", {"KHR_mesh_quantization"}},
                   {"scene", 0},
                   {"scenes", {{{"nodes", {0}}}}},
                   {"nodes", {node}}};
  document["buffers"] = {{{"uri", "a.bin"}, {"byteLength", buffer.size()}}};
  document["bufferViews"] = {{{"buffer", 0}, {"byteLength", positions}, {"byteStride", stride}},
                             {{"buffer", 0}, {"byteOffset", positions}, {"byteLength", buffer.size() - positions}}};
  document["accessors"] = {
      {{"bufferView", 0},
       {"byteOffset", 4},
       {"componentType", type.code},
       {"type", "VEC3"},
       {"count", stored.size()},
       {"normalized", type.normalised}},
      {{"bufferView", 1}, {"componentType", 5125}, {"type", "SCALAR"}, {"count", 3 * faces.size()}}};
  document["meshes"] = {{{"primitives", {{{"attributes", {{"POSITION", 0}}}, {"indices", 1}}}}}};
  return folder.write("a.gltf", document.dump());
}

TEST(GltfQuantised, EqualsTheFloatMeshWithinHalfAStep) {
  const TempFolder folder;
  const TriMesh mesh = test::bumpy_sphere(2);
  const Aabb bounds = mesh.bounds();
  for (const Component& type : components()) {
    SCOPED_TRACE(testing::Message() << type.name << (type.normalised ? ", normalised" : ""));
    // Positions use the whole range of the type. -128 and -32768 are not used where they represent -1 as well.
    const double lowest = type.normalised && type.lowest < 0 ? -type.highest : type.lowest;
    const dvec3 step = (bounds.hi - bounds.lo) / (type.highest - lowest);
    std::vector<std::array<double, 3>> stored;
    for (const dvec3& v : mesh.vertices()) {
      const dvec3 q = glm::round((v - bounds.lo) / step) + lowest;
      stored.push_back({q.x, q.y, q.z});
    }
    const double unit = represented(type, 1);  // the size of one step of the stored numbers
    const dvec3 scale = step / unit, offset = bounds.lo - lowest * step;
    const json node = {
        {"mesh", 0}, {"scale", {scale.x, scale.y, scale.z}}, {"translation", {offset.x, offset.y, offset.z}}};
    for (const std::size_t stride : {std::size_t{4} + (3 * type.bytes + 3) / 4 * 4, std::size_t{28}}) {
      const TriMesh read = *load_mesh(write_file(folder, stored, mesh.faces(), type, stride, node)).mesh;
      // Faces of int8 may fall together, but no vertex is elsewhere.
      for (const dvec3& v : read.vertices()) {
        double nearest = 1e300;
        for (const dvec3& w : mesh.vertices()) {
          const dvec3 off = glm::abs(v - w) / step;
          nearest = std::min(nearest, std::max({off.x, off.y, off.z}));
        }
        EXPECT_LE(nearest, 0.5 + 1e-6);
      }
      EXPECT_NEAR(read.volume(), mesh.volume(), 3 * glm::length(step) * mesh.area());
      if (type.bytes == 2) {
        EXPECT_EQ(read.faces(), mesh.faces());
      }
    }
  }
}

TEST(GltfQuantised, RepresentsNumbersAsTheSpecificationDoes) {
  const TempFolder folder;
  for (const Component& type : components()) {
    SCOPED_TRACE(testing::Message() << type.name << (type.normalised ? ", normalised" : ""));
    const double low = type.lowest, high = type.highest;
    const std::vector<std::array<double, 3>> stored{{low, 0, 0}, {high, 1, low + 1}, {3, high, high - 1}};
    const json node = {{"mesh", 0}, {"matrix", {0, 2, 0, 0, 0, 0, 3, 0, -4, 0, 0, 0, 7, 8, 9, 1}}};
    const TriMesh read = *load_mesh(write_file(folder, stored, {{0, 1, 2}}, type, 12, node)).mesh;
    ASSERT_EQ(read.vertex_count(), 3);
    for (int v = 0; v < 3; ++v) {
      const auto& s = stored[at(v)];
      const double x = represented(type, s[0]), y = represented(type, s[1]), z = represented(type, s[2]);
      EXPECT_EQ(read.vertices()[at(v)], dvec3(7 - 4 * z, 8 + 2 * x, 9 + 3 * y)) << v;
    }
  }
}

}  // namespace
}  // namespace taxel
