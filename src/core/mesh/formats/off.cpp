// Object File Format in its text form: OFF, COFF, NOFF, STOFF and their mixtures. A vertex's line begins with its three
// coordinates in each of them.
#include <fmt/format.h>

#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/text_cursor.h"

namespace taxel {
namespace {

long long count_from(const TextCursor& cursor, std::string_view word, const char* what) {
  const long long count = cursor.integer(word);
  if (count < 0) cursor.fail(fmt::format("{} {} cannot be", count, what));
  return count;
}

/// Returns a count as an int. Throws Error if the file is too short for things of at least `least` bytes, where the
/// last one may lack its newline.
int fitting(const TextCursor& cursor, long long count, const char* what, int least, std::string_view bytes) {
  const double needed = static_cast<double>(count) * least - 1;
  if (needed > static_cast<double>(bytes.size()))
    cursor.fail(fmt::format("is cut off: {} {} need at least {:.0f} bytes, the file has {}", count, what, needed,
                            bytes.size()));
  return static_cast<int>(count);
}

}  // namespace

PolygonSoup read_off(std::string_view bytes, const std::string& file) {
  TextCursor cursor(bytes, file, '#');
  std::string_view word = cursor.word_anywhere();
  if (word.ends_with("OFF")) {
    if (word.find('4') != std::string_view::npos || word.find('n') != std::string_view::npos)
      cursor.fail("only meshes in three dimensions are read");
    word = cursor.word_anywhere();
    if (word == "BINARY") cursor.fail("binary OFF is not read");
  } else {
    cursor.fail("is not an OFF file: it does not begin with 'OFF'");
  }
  const long long announced_vertices = count_from(cursor, word, "vertices");
  const long long announced_faces = count_from(cursor, cursor.word_anywhere(), "faces");
  const int vertex_count = fitting(cursor, announced_vertices, "vertices", 6, bytes);
  const int face_count = fitting(cursor, announced_faces, "faces", 2, bytes);
  PolygonSoup soup;
  for (int v = 0; v < vertex_count; ++v) {
    if (!cursor.next_line()) cursor.fail(fmt::format("is cut off: {} of {} vertices", v, vertex_count));
    soup.vertices.push_back(cursor.finite_point());
  }
  std::vector<int> corners;
  for (int f = 0; f < face_count; ++f) {
    if (!cursor.next_line()) cursor.fail(fmt::format("is cut off: {} of {} faces", f, face_count));
    const long long announced_corners = count_from(cursor, cursor.word(), "corners");
    const int corner_count = fitting(cursor, announced_corners, "corners", 2, bytes);
    corners.clear();
    for (int c = 0; c < corner_count; ++c) {
      const long long index = cursor.integer(cursor.word());
      if (index < 0 || index >= vertex_count)
        cursor.fail(fmt::format("no vertex {} (there are {}, counted from 0)", index, vertex_count));
      corners.push_back(static_cast<int>(index));
    }
    soup.add_polygon(corners);
  }
  return soup;
}

std::string write_off(const TriMesh& mesh) {
  std::string text = fmt::format("OFF\n{} {} 0\n", mesh.vertex_count(), mesh.face_count());
  for (const dvec3& v : mesh.vertices()) text += fmt::format("{} {} {}\n", v.x, v.y, v.z);
  for (const ivec3& f : mesh.faces()) text += fmt::format("3 {} {} {}\n", f.x, f.y, f.z);
  return text;
}

}  // namespace taxel
