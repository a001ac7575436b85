// STL, binary and ASCII. Normals and attributes are skipped when reading: the order of the corners gives the outside.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/text_cursor.h"

namespace taxel {
namespace {

constexpr std::size_t kHeader = 84;    // 80 bytes of comment and the number of triangles
constexpr std::size_t kTriangle = 50;  // normal, three corners (12 floats), two bytes of attributes

/// Returns true if the word equals the keyword, which is in lower case. Some programs write keywords in capitals.
bool is_keyword(std::string_view word, std::string_view keyword) {
  return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(),
                    [](char c, char lower) { return (c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) == lower; });
}

/// Returns whether the file is in ASCII. Many binary files begin with "solid" too, but a text has no zero bytes, and a
/// binary number of triangles below 2^24 has one.
bool is_ascii(std::string_view bytes) {
  constexpr std::string_view kSolid = "solid";
  const std::size_t mark = bytes.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n", mark);
  return begin != std::string_view::npos && is_keyword(bytes.substr(begin, kSolid.size()), kSolid) &&
         bytes.substr(0, kHeader).find('\0') == std::string_view::npos;
}

PolygonSoup read_binary(std::string_view bytes, const std::string& file) {
  if (bytes.size() < kHeader)
    throw Error(file, fmt::format("is not an STL file: {} bytes, the header alone has {}", bytes.size(), kHeader));
  std::uint32_t stored = 0;
  std::memcpy(&stored, bytes.data() + kHeader - sizeof stored, sizeof stored);
  const std::size_t count = stored;
  if (bytes.size() < kHeader + kTriangle * count) {
    throw Error(file, fmt::format("is cut off or not an STL file: {} triangles need {} bytes, there are {}", count,
                                  kHeader + kTriangle * count, bytes.size()));
  }
  PolygonSoup soup;
  soup.vertices.reserve(3 * count);
  soup.triangles.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    float numbers[12];
    std::memcpy(numbers, bytes.data() + kHeader + kTriangle * i, sizeof numbers);
    const int first = static_cast<int>(soup.vertices.size());
    for (int c = 1; c <= 3; ++c) {
      const dvec3 p(numbers[3 * c], numbers[3 * c + 1], numbers[3 * c + 2]);
      if (!is_finite(p)) throw Error(file, fmt::format("triangle {}", i), "coordinate is not finite");
      soup.vertices.push_back(p);
    }
    soup.triangles.emplace_back(first, first + 1, first + 2);
  }
  return soup;
}

PolygonSoup read_ascii(std::string_view bytes, const std::string& file) {
  PolygonSoup soup;
  std::vector<int> corners;
  bool ended = false;
  for (TextCursor cursor(bytes, file, '\0'); cursor.next_line();) {
    const std::string_view key = cursor.word();
    if (is_keyword(key, "vertex")) {
      corners.push_back(static_cast<int>(soup.vertices.size()));
      soup.vertices.push_back(cursor.finite_point());
    } else if (is_keyword(key, "endloop")) {
      if (corners.size() < 3) cursor.fail(fmt::format("a facet of {} corners", corners.size()));
      soup.add_polygon(corners);
      corners.clear();
    }
    ended = is_keyword(key, "endsolid");
  }
  if (!ended) throw Error(file, "is cut off: it does not end with 'endsolid'");
  return soup;
}

}  // namespace

PolygonSoup read_stl(std::string_view bytes, const std::string& file) {
  return is_ascii(bytes) ? read_ascii(bytes, file) : read_binary(bytes, file);
}

std::string write_stl(const TriMesh& mesh) {
  std::string bytes(kHeader, '\0');
  const std::string comment = "binary STL by Taxel Studio";
  std::copy(comment.begin(), comment.end(), bytes.begin());
  const auto count = static_cast<std::uint32_t>(mesh.face_count());
  std::memcpy(bytes.data() + kHeader - sizeof count, &count, sizeof count);
  for (int f = 0; f < mesh.face_count(); ++f) {
    const std::array<glm::vec3, 4> numbers{glm::vec3(mesh.face_normals()[at(f)]), glm::vec3(mesh.vertex(f, 0)),
                                           glm::vec3(mesh.vertex(f, 1)), glm::vec3(mesh.vertex(f, 2))};
    bytes.append(reinterpret_cast<const char*>(numbers.data()), sizeof numbers);
    bytes.append(2, '\0');  // the attributes
  }
  return bytes;
}

}  // namespace taxel
