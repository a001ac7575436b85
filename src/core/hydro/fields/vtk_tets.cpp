#include "core/hydro/fields/vtk_tets.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/mesh/formats/text_cursor.h"

namespace taxel {
namespace {

constexpr long long kMax = 1LL << 28, kTet = 10;

bool is_word(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; });
}

class VtkReader {
 public:
  VtkReader(std::string_view text, const std::string& file, const dvec3& scale)
      : cursor_(text, file, 0), scale_(scale) {}

  TetMesh read() {
    read_head();
    for (std::string_view word = cursor_.word_anywhere(); !word.empty(); word = cursor_.word_anywhere()) {
      if (is_word(word, "points")) {
        read_points();
      } else if (is_word(word, "cells")) {
        read_cells();
      } else if (is_word(word, "cell_types")) {
        read_types();
      } else if (is_word(word, "point_data")) {
        read_point_data();
        break;  // nothing that follows is of use
      } else if (is_word(word, "cell_data")) {
        break;
      } else if (!is_word(word, "metadata") && !is_word(word, "information")) {
        cursor_.fail(fmt::format("'{}' is not expected here", word.substr(0, 24)));
      }
    }
    if (mesh_.vertices.empty()) cursor_.fail("has no POINTS");
    if (mesh_.tets.empty()) cursor_.fail("has no CELLS");
    if (!typed_) cursor_.fail("has no CELL_TYPES");
    return std::move(mesh_);
  }

 private:
  void read_head() {
    if (!cursor_.next_line() || !is_word(cursor_.word(), "#") || !is_word(cursor_.word(), "vtk"))
      cursor_.fail("is not a legacy VTK file: it does not begin with '# vtk DataFile Version'");
    if (!cursor_.next_line()) cursor_.fail("is cut off after its first line");
    std::string_view form = cursor_.word();  // the title, where it is not empty: the cursor passes over empty lines
    if (!is_word(form, "ascii") && !is_word(form, "binary")) {
      if (!cursor_.next_line()) cursor_.fail("is cut off after its title");
      form = cursor_.word();
    }
    if (is_word(form, "binary")) cursor_.fail("is binary; only ASCII is read");
    if (!is_word(form, "ascii")) cursor_.fail("must say ASCII in its third line");
    if (!is_word(cursor_.word_anywhere(), "dataset")) cursor_.fail("must say DATASET UNSTRUCTURED_GRID");
    const std::string_view set = cursor_.word();
    if (!is_word(set, "unstructured_grid"))
      cursor_.fail(fmt::format("is a data set '{}', not an UNSTRUCTURED_GRID", set.substr(0, 24)));
  }

  int count(const char* what) {
    const long long n = cursor_.integer(cursor_.word());
    if (n < 0 || n > kMax) cursor_.fail(fmt::format("{} {} cannot be", n, what));
    return static_cast<int>(n);
  }

  std::string_view word_of(const char* what, std::size_t found, std::size_t wanted) {
    const std::string_view word = cursor_.word_anywhere();
    if (word.empty()) cursor_.fail(fmt::format("is cut off: {} of {} {}", found, wanted, what));
    return word;
  }

  double finite_number(std::string_view word) {
    const double x = cursor_.number(word);
    if (!std::isfinite(x)) cursor_.fail(fmt::format("{} is not finite", word.substr(0, 24)));
    return x;
  }

  void read_points() {
    const auto n = static_cast<std::size_t>(count("points"));
    cursor_.word();  // the type of number
    for (std::size_t v = 0; v < n; ++v) {
      dvec3 x{0};
      for (int a = 0; a < 3; ++a) x[a] = finite_number(word_of("points", v, n)) * scale_[a];
      mesh_.vertices.push_back(x);
    }
  }

  /// Reads the cells. Files of VTK up to version 4 write the number of corners before the corners; later versions list
  /// offsets and corners separately.
  void read_cells() {
    const auto n = static_cast<std::size_t>(count("cells"));
    count("numbers of cells");
    for (std::size_t t = 0; t < n; ++t) {
      const std::string_view word = word_of("cells", t, n);
      if (is_word(word, "offsets")) cursor_.fail("lists OFFSETS, as VTK 5 does; write it as version 4.2 or older");
      if (const long long corners = cursor_.integer(word); corners != 4)
        cursor_.fail(fmt::format("cell {} has {} corners, a tet has 4", t, corners));
      ivec4 tet(0);
      for (int i = 0; i < 4; ++i) {
        const long long v = cursor_.integer(word_of("cells", t, n));
        if (v < 0 || v >= static_cast<long long>(mesh_.vertices.size()))
          cursor_.fail(fmt::format("cell {}: no point {} (there are {})", t, v, mesh_.vertices.size()));
        tet[i] = static_cast<int>(v);
      }
      mesh_.tets.push_back(tet);
    }
  }

  void read_types() {
    const auto n = static_cast<std::size_t>(count("cell types"));
    if (n != mesh_.tets.size()) cursor_.fail(fmt::format("{} cell types for {} cells", n, mesh_.tets.size()));
    for (std::size_t t = 0; t < n; ++t) {
      const long long type = cursor_.integer(word_of("cell types", t, n));
      if (type != kTet) cursor_.fail(fmt::format("cell {} is of type {}, a tet is of type {}", t, type, kTet));
    }
    typed_ = true;
  }

  /// Looks for "SCALARS pressure TYPE [1]", passing over everything else.
  void read_point_data() {
    const auto n = static_cast<std::size_t>(count("points with data"));
    if (n != mesh_.vertices.size())
      cursor_.fail(fmt::format("data of {} points, but there are {}", n, mesh_.vertices.size()));
    while (cursor_.next_line()) {
      const std::string_view key = cursor_.word();
      if (is_word(key, "cell_data")) return;
      if (!is_word(key, "scalars") || !is_word(cursor_.word(), "pressure")) continue;
      cursor_.word();  // the type of number
      const std::string_view components = cursor_.word();
      if (!components.empty() && components != "1") continue;
      if (!is_word(cursor_.word_anywhere(), "lookup_table")) cursor_.fail("LOOKUP_TABLE is missing");
      cursor_.word();
      for (std::size_t v = 0; v < n; ++v) mesh_.pressure.push_back(finite_number(word_of("pressures", v, n)));
      return;
    }
  }

  TextCursor cursor_;
  dvec3 scale_;
  TetMesh mesh_;
  bool typed_ = false;
};

}  // namespace

TetMesh read_vtk_tets(std::string_view text, const std::string& file, const dvec3& scale) {
  return VtkReader(text, file, scale).read();
}

TetMesh load_vtk_tets(const std::filesystem::path& path, const dvec3& scale) {
  return read_vtk_tets(read_file(path), path.string(), scale);
}

std::string vtk_text(const PressureField& field) {
  std::string text = "# vtk DataFile Version 3.0\nTaxel Studio pressure field\nASCII\nDATASET UNSTRUCTURED_GRID\n";
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "POINTS {} double\n", field.vertices().size());
  for (const dvec3& v : field.vertices()) fmt::format_to(out, "{} {} {}\n", v.x, v.y, v.z);
  fmt::format_to(out, "CELLS {} {}\n", field.tets().size(), 5 * field.tets().size());
  for (const Tet& tet : field.tets()) {
    const ivec4& v = tet.vertices;
    fmt::format_to(out, "4 {} {} {} {}\n", v[0], v[1], v[2], v[3]);
  }
  fmt::format_to(out, "CELL_TYPES {}\n", field.tets().size());
  for (std::size_t t = 0; t < field.tets().size(); ++t) text += "10\n";
  fmt::format_to(out, "POINT_DATA {}\nSCALARS pressure double 1\nLOOKUP_TABLE default\n", field.vertices().size());
  for (const double p : field.vertex_pressure()) fmt::format_to(out, "{}\n", p);
  return text;
}

}  // namespace taxel
