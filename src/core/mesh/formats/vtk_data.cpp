#include "core/mesh/formats/vtk_data.h"

#include <fmt/format.h>

#include <array>

#include "core/mesh/formats/vtk_source.h"

namespace taxel {
namespace {

constexpr std::uint8_t kVertices = 2, kLines = 4, kStrip = 6, kPolygon = 7;

/// A section that lists cells. Those of POLYDATA are all of one type.
struct CellSection {
  std::string_view word;
  const char* cells;
  const char* cell;
  std::uint8_t type;  ///< 0: the types are in a section of their own
};
constexpr std::array<CellSection, 5> kCellSections{{{"cells", "cells", "cell", 0},
                                                    {"polygons", "polygons", "polygon", kPolygon},
                                                    {"triangle_strips", "strips", "strip", kStrip},
                                                    {"lines", "lines", "line", kLines},
                                                    {"vertices", "vertices", "vertex cell", kVertices}}};

/// An attribute that has a name, a type of number, and a fixed number of numbers for each point or cell.
struct PlainAttribute {
  std::string_view word;
  std::size_t numbers;
};
constexpr std::array<PlainAttribute, 7> kPlainAttributes{{{"vectors", 3},
                                                          {"normals", 3},
                                                          {"tensors", 9},
                                                          {"tensors6", 6},
                                                          {"global_ids", 1},
                                                          {"pedigree_ids", 1},
                                                          {"edge_flags", 1}}};

class VtkDataReader {
 public:
  VtkDataReader(std::string_view bytes, const std::string& file, VtkAttributes attributes)
      : source_(bytes, file), attributes_(attributes) {}

  VtkData read() {
    check_data_set();
    for (std::string_view word = source_.word_anywhere(); !word.empty(); word = source_.word_anywhere()) {
      const bool attributes = is_vtk_word(word, "point_data") || is_vtk_word(word, "cell_data");
      if (attributes && attributes_ == VtkAttributes::skip) break;
      if (!read_geometry(word) && !read_attribute(word))
        source_.fail(fmt::format("'{}' is not expected here", word.substr(0, 24)));
      if (!data_.pressure.empty()) break;  // nothing that follows is of use
    }
    if (data_.points.empty()) source_.fail("has no POINTS");
    if (data_.ends.empty()) source_.fail(data_.poly_data ? "has no POLYGONS" : "has no CELLS");
    if (data_.types.size() != data_.ends.size()) source_.fail("has no CELL_TYPES");
    return std::move(data_);
  }

 private:
  void check_data_set() {
    const std::string_view set = source_.data_set();
    data_.poly_data = is_vtk_word(set, "polydata");
    if (data_.poly_data || is_vtk_word(set, "unstructured_grid")) return;
    source_.fail(fmt::format(
        "is a data set '{}'; only POLYDATA and UNSTRUCTURED_GRID are read: save its surface as POLYDATA (Extract "
        "Surface in ParaView)",
        set.substr(0, 24)));
  }

  bool read_geometry(std::string_view word) {
    for (const CellSection& section : kCellSections) {
      if ((section.type == 0) == data_.poly_data || !is_vtk_word(word, section.word)) continue;
      read_cells(section);
      return true;
    }
    if (is_vtk_word(word, "points")) {
      read_points();
    } else if (is_vtk_word(word, "cell_types") && !data_.poly_data) {
      read_types();
    } else {
      return false;
    }
    return true;
  }

  void read_points() {
    if (!data_.points.empty()) source_.fail("has POINTS twice");
    const std::size_t n = source_.count("points");
    source_.begin_numbers(n, 3, source_.number_type(), "points");
    data_.points.resize(n);
    for (dvec3& point : data_.points) {
      for (int axis = 0; axis < 3; ++axis) point[axis] = source_.finite_number();
    }
    source_.end_numbers();
  }

  /// Reads a section of cells. Files up to version 4 have the number of corners before the corners; later versions have
  /// offsets and corners separately.
  void read_cells(const CellSection& section) {
    if (section.type == 0 && !data_.ends.empty()) source_.fail("has CELLS twice");
    const std::size_t first = source_.count(section.cells);
    const std::size_t second = source_.count("numbers of cells");
    if (source_.next_line_begins_with("OFFSETS")) {
      read_offsets(section, first, second);
    } else {
      read_counted_cells(section, first, second);
    }
    if (section.type != 0) data_.types.resize(data_.ends.size(), section.type);
  }

  void read_counted_cells(const CellSection& section, std::size_t cells, std::size_t numbers) {
    if (cells > numbers) source_.fail(fmt::format("{} {} cannot be in {} numbers", cells, section.cells, numbers));
    source_.begin_numbers(numbers, 1, VtkNumber::int32, "numbers of cells");
    std::size_t left = numbers;
    for (std::size_t c = 0; c < cells; ++c) {
      const long long corners = source_.integer();
      --left;
      if (corners < 0 || static_cast<std::size_t>(corners) > left - (cells - 1 - c))
        source_.fail(fmt::format("{} {} has {} corners, but {} {} are announced to be {} numbers", section.cell, c,
                                 corners, cells, section.cells, numbers));
      left -= static_cast<std::size_t>(corners);
      for (long long i = 0; i < corners; ++i) add_corner(section, c, source_.integer());
      end_cell();
    }
    if (left != 0)
      source_.fail(fmt::format("{} {} are announced to be {} numbers, but are {}", cells, section.cells, numbers,
                               numbers - left));
    source_.end_numbers();
  }

  void read_offsets(const CellSection& section, std::size_t offsets, std::size_t corners) {
    source_.word_anywhere();  // OFFSETS
    source_.begin_numbers(offsets, 1, source_.number_type(), "offsets");
    std::vector<std::size_t> begins(offsets);
    for (std::size_t i = 0; i < offsets; ++i) {
      const long long begin = source_.integer();
      const std::size_t least = i == 0 ? 0 : begins[i - 1];
      const std::size_t most = i == 0 ? 0 : corners;
      if (begin < 0 || static_cast<std::size_t>(begin) < least || static_cast<std::size_t>(begin) > most)
        source_.fail(fmt::format("offset {} is {}, must be {} to {}", i, begin, least, most));
      begins[i] = static_cast<std::size_t>(begin);
    }
    source_.end_numbers();
    if (!begins.empty() && begins.back() != corners)
      source_.fail(fmt::format("the last offset is {}, must be {}", begins.back(), corners));
    if (!is_vtk_word(source_.word_anywhere(), "connectivity")) source_.fail("CONNECTIVITY must follow OFFSETS");
    source_.begin_numbers(corners, 1, source_.number_type(), "corners");
    for (std::size_t c = 0; c + 1 < offsets; ++c) {
      for (std::size_t i = begins[c]; i < begins[c + 1]; ++i) add_corner(section, c, source_.integer());
      end_cell();
    }
    source_.end_numbers();
  }

  void add_corner(const CellSection& section, std::size_t cell, long long corner) {
    if (corner < 0 || corner >= static_cast<long long>(data_.points.size()))
      source_.fail(fmt::format("{} {}: no point {} (there are {})", section.cell, cell, corner, data_.points.size()));
    data_.corners.push_back(static_cast<int>(corner));
  }

  void end_cell() { data_.ends.push_back(static_cast<int>(data_.corners.size())); }

  void read_types() {
    const std::size_t n = source_.count("cell types");
    if (n != data_.ends.size()) source_.fail(fmt::format("{} cell types for {} cells", n, data_.ends.size()));
    if (!data_.types.empty()) source_.fail("has CELL_TYPES twice");
    source_.begin_numbers(n, 1, VtkNumber::int32, "cell types");
    for (std::size_t i = 0; i < n; ++i) {
      const long long type = source_.integer();
      if (type < 0 || type > 255) source_.fail(fmt::format("cell {} is of type {}, which is not known", i, type));
      data_.types.push_back(static_cast<std::uint8_t>(type));
    }
    source_.end_numbers();
  }

  bool read_attribute(std::string_view word) {
    for (const PlainAttribute& attribute : kPlainAttributes) {
      if (!is_vtk_word(word, attribute.word)) continue;
      source_.word();  // the name
      source_.skip_numbers(rows_, attribute.numbers, source_.number_type(), "attributes");
      return true;
    }
    if (is_vtk_word(word, "metadata")) {
      source_.skip_paragraph();
    } else if (is_vtk_word(word, "point_data") || is_vtk_word(word, "cell_data")) {
      begin_attributes(is_vtk_word(word, "point_data"));
    } else if (is_vtk_word(word, "scalars")) {
      read_scalars();
    } else if (is_vtk_word(word, "field")) {
      read_field();
    } else if (is_vtk_word(word, "texture_coordinates")) {
      source_.word();
      const std::size_t dimension = source_.count("texture coordinates");
      source_.skip_numbers(rows_, dimension, source_.number_type(), "attributes");
    } else if (is_vtk_word(word, "color_scalars") || is_vtk_word(word, "lookup_table")) {
      source_.word();
      const std::size_t n = source_.count("colours");
      const bool table = is_vtk_word(word, "lookup_table");
      source_.skip_numbers(table ? n : rows_, table ? 4 : n, VtkNumber::uint8, "colours");
    } else {
      return false;
    }
    return true;
  }

  void begin_attributes(bool of_points) {
    of_points_ = of_points;
    rows_ = source_.count(of_points ? "points with data" : "cells with data");
    if (of_points && rows_ != data_.points.size())
      source_.fail(fmt::format("data of {} points, but there are {}", rows_, data_.points.size()));
  }

  void read_scalars() {
    const std::string_view name = source_.word();
    const VtkNumber type = source_.number_type();
    const std::string_view components = source_.word();
    std::size_t columns = 1;
    for (std::size_t n : {2U, 3U, 4U}) columns = components == fmt::format("{}", n) ? n : columns;
    if (!is_vtk_word(source_.word_anywhere(), "lookup_table")) source_.fail("LOOKUP_TABLE is missing");
    source_.word();
    read_numbers(rows_, columns, type, of_points_ && is_vtk_word(name, "pressure"));
  }

  void read_field() {
    source_.word();  // the name of the field
    const std::size_t arrays = source_.count("arrays");
    for (std::size_t i = 0; i < arrays; ++i) {
      std::string_view name = source_.word_anywhere();
      while (is_vtk_word(name, "metadata")) {
        source_.skip_paragraph();
        name = source_.word_anywhere();
      }
      if (name.empty()) source_.fail(fmt::format("is cut off: {} of {} arrays", i, arrays));
      const std::size_t columns = source_.count("components"), rows = source_.count("rows");
      read_numbers(rows, columns, source_.number_type(),
                   of_points_ && rows == data_.points.size() && is_vtk_word(name, "pressure"));
    }
  }

  void read_numbers(std::size_t rows, std::size_t columns, VtkNumber type, bool pressure) {
    if (!pressure || columns != 1) return source_.skip_numbers(rows, columns, type, "attributes");
    source_.begin_numbers(rows, 1, type, "pressures");
    data_.pressure.clear();
    for (std::size_t i = 0; i < rows; ++i) data_.pressure.push_back(source_.finite_number());
    source_.end_numbers();
  }

  VtkSource source_;
  VtkAttributes attributes_;
  VtkData data_;
  bool of_points_ = false;
  std::size_t rows_ = 0;  ///< number of points or cells that the attributes belong to
};

}  // namespace

VtkData read_vtk_data(std::string_view bytes, const std::string& file, VtkAttributes attributes) {
  return VtkDataReader(bytes, file, attributes).read();
}

}  // namespace taxel
