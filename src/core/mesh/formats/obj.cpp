// Wavefront OBJ: v and f lines. Texture coordinates, normals, groups and materials are skipped.
#include <fmt/format.h>

#include <span>

#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/text_cursor.h"

namespace taxel {
namespace {

/// Returns the vertex of a corner: "7", "7/1", "7//3" or "7/1/3"; a negative number counts back from the last vertex.
/// `vertex_count` is the number of vertices read so far, `total` the number of vertices of the file.
int corner_of(const TextCursor& cursor, std::string_view word, int vertex_count, int total) {
  const long long index = cursor.integer(word.substr(0, word.find('/')));
  if (index > 0 && index <= total) return static_cast<int>(index - 1);
  if (index < 0 && index >= -vertex_count) return static_cast<int>(vertex_count + index);
  cursor.fail(fmt::format("no vertex {} (there are {})", index, total));
}

int count_vertices(std::string_view bytes, const std::string& file) {
  int count = 0;
  for (TextCursor cursor(bytes, file, '#'); cursor.next_line();) count += cursor.word() == "v" ? 1 : 0;
  return count;
}

}  // namespace

PolygonSoup read_obj(std::string_view bytes, const std::string& file) {
  const int total = count_vertices(bytes, file);
  PolygonSoup soup;
  std::vector<int> corners;       // of all polygons
  std::vector<std::size_t> ends;  // of each polygon in `corners`: polygons may precede their vertices
  for (TextCursor cursor(bytes, file, '#'); cursor.next_line();) {
    const std::string_view key = cursor.word();
    if (key == "v") {
      soup.vertices.push_back(cursor.finite_point());
    } else if (key == "f") {
      for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word())
        corners.push_back(corner_of(cursor, word, static_cast<int>(soup.vertices.size()), total));
      ends.push_back(corners.size());
    }
  }
  std::size_t first = 0;
  for (const std::size_t end : ends) {
    soup.add_polygon(std::span(corners).subspan(first, end - first));
    first = end;
  }
  return soup;
}

std::string write_obj(const TriMesh& mesh) {
  std::string text;
  for (const dvec3& v : mesh.vertices()) text += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
  for (const ivec3& f : mesh.faces()) text += fmt::format("f {} {} {}\n", f.x + 1, f.y + 1, f.z + 1);
  return text;
}

}  // namespace taxel
