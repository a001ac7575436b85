#include "core/mesh/formats/vtk.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/mesh/formats/text_cursor.h"

namespace taxel {

namespace {

/// Types of numbers in VTK files. `bit` numbers can only be skipped.
enum class VtkNumber { bit, int8, uint8, int16, uint16, int32, uint32, int64, uint64, float32, float64 };

/// A position in a legacy VTK file. Messages name the line of a text, and the byte of a binary file. Every function
/// throws Error naming file and place if the file is damaged there.
class VtkSource {
 public:
  /// Reads the first three lines and the name of the data set. Throws Error if the file is no legacy VTK file or of a
  /// version after 5; an XML file is refused with the remedy.
  VtkSource(std::string_view bytes, const std::string& file);

  /// Returns the name of the data set, such as POLYDATA.
  [[nodiscard]] std::string_view data_set() const { return data_set_; }
  /// Returns the next word of this line or of a later one, or an empty word at the end of the file.
  std::string_view word_anywhere() { return cursor_.word_anywhere(); }
  /// Returns the next word of this line, or an empty word at its end.
  std::string_view word() { return cursor_.word(); }
  /// Passes over the lines up to an empty line, as a METADATA section ends.
  void skip_paragraph() { cursor_.skip_paragraph(); }
  /// Returns true if the next line begins with a word (in upper case).
  [[nodiscard]] bool next_line_begins_with(std::string_view upper) const;
  /// Reads a number of things from this line. `what` names them in messages.
  std::size_t count(const char* what);
  /// Reads the name of a type of number from this line.
  VtkNumber number_type();

  /// Begins a list of rows * columns numbers. Throws Error if the rest of the file is too short for them: memory for
  /// the numbers may be taken afterwards.
  void begin_numbers(std::size_t rows, std::size_t columns, VtkNumber type, const char* what);
  double finite_number();
  long long integer();
  /// Ends the list of numbers that was begun last.
  void end_numbers();
  /// Passes over rows * columns numbers.
  void skip_numbers(std::size_t rows, std::size_t columns, VtkNumber type, const char* what);

  [[nodiscard]] bool binary() const { return binary_; }
  [[noreturn]] void fail(const std::string& message) const;

 private:
  void read_head();
  std::string_view number_word();
  template <class T>
  T raw();

  std::string_view bytes_;
  std::string file_;
  TextCursor cursor_;
  std::string_view data_set_;
  bool binary_ = false;
  std::size_t at_ = 0;  ///< position in the numbers of a binary file
  VtkNumber type_ = VtkNumber::int32;
  const char* what_ = "";
};

constexpr double kNewestVersion = 5.1;

struct NumberName {
  std::string_view name;
  VtkNumber type;
};

/// `long` has eight bytes, as on the systems of today except Windows.
constexpr std::array<NumberName, 16> kNumberNames{{{"float", VtkNumber::float32},
                                                   {"double", VtkNumber::float64},
                                                   {"int", VtkNumber::int32},
                                                   {"vtkidtype", VtkNumber::int32},
                                                   {"vtktypeint64", VtkNumber::int64},
                                                   {"vtktypeint32", VtkNumber::int32},
                                                   {"long", VtkNumber::int64},
                                                   {"unsigned_int", VtkNumber::uint32},
                                                   {"unsigned_long", VtkNumber::uint64},
                                                   {"vtktypeuint64", VtkNumber::uint64},
                                                   {"short", VtkNumber::int16},
                                                   {"unsigned_short", VtkNumber::uint16},
                                                   {"char", VtkNumber::int8},
                                                   {"signed_char", VtkNumber::int8},
                                                   {"unsigned_char", VtkNumber::uint8},
                                                   {"bit", VtkNumber::bit}}};

std::size_t bits_of(VtkNumber type) {
  constexpr std::array<std::size_t, 11> kBits{1, 8, 8, 16, 16, 32, 32, 64, 64, 32, 64};
  return kBits[static_cast<std::size_t>(type)];
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r") == std::string_view::npos;
}

/// Returns true if a word equals a word in lower case, whatever its case is.
bool is_vtk_word(std::string_view word, std::string_view lower) {
  return std::equal(word.begin(), word.end(), lower.begin(), lower.end(),
                    [](char a, char b) { return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b; });
}

VtkSource::VtkSource(std::string_view bytes, const std::string& file)
    : bytes_(bytes), file_(file), cursor_(bytes, file, 0) {
  read_head();
}

void VtkSource::read_head() {
  const std::size_t begin = std::min(bytes_.find_first_not_of(" \t\r\n"), bytes_.size());
  if (bytes_.substr(begin).starts_with("<?xml") || bytes_.substr(begin).starts_with("<VTKFile"))
    throw Error(file_,
                "is a VTK XML file; only legacy VTK files are read: save it as legacy VTK (.vtk), with ParaView "
                "or PyVista");
  if (!cursor_.next_line() || cursor_.word() != "#" || !is_vtk_word(cursor_.word(), "vtk"))
    cursor_.fail("is not a legacy VTK file: it does not begin with '# vtk DataFile Version'");
  cursor_.word();  // DataFile
  cursor_.word();  // Version
  const std::string_view version = cursor_.word();
  if (const double number = cursor_.number(version); !(number >= 1 && number <= kNewestVersion))
    cursor_.fail(
        fmt::format("is of version {}; versions up to {} are read: save it in an older one", version, kNewestVersion));
  const std::size_t title = cursor_.offset();
  const std::size_t title_end = std::min(bytes_.find('\n', title), bytes_.size());
  // The cursor passes over empty lines, and so over an empty title.
  if (!is_blank(bytes_.substr(title, title_end - title))) cursor_.next_line();
  if (!cursor_.next_line()) cursor_.fail("is cut off before its third line, which must say ASCII or BINARY");
  const std::string_view form = cursor_.word();
  binary_ = is_vtk_word(form, "binary");
  if (!binary_ && !is_vtk_word(form, "ascii")) cursor_.fail("must say ASCII or BINARY in its third line");
  if (!is_vtk_word(cursor_.word_anywhere(), "dataset")) cursor_.fail("must say DATASET in its fourth line");
  data_set_ = cursor_.word();
}

bool VtkSource::next_line_begins_with(std::string_view upper) const {
  const std::size_t begin = bytes_.find_first_not_of(" \t\r\n", cursor_.offset());
  return begin != std::string_view::npos && bytes_.substr(begin).starts_with(upper);
}

std::size_t VtkSource::count(const char* what) {
  const long long n = cursor_.integer(cursor_.word());
  if (n < 0) fail(fmt::format("{} {} cannot be", n, what));
  return static_cast<std::size_t>(n);
}

VtkNumber VtkSource::number_type() {
  const std::string_view word = cursor_.word();
  for (const NumberName& row : kNumberNames) {
    if (is_vtk_word(word, row.name)) return row.type;
  }
  fail(fmt::format("unknown type of number '{}'", word.substr(0, 24)));
}

void VtkSource::begin_numbers(std::size_t rows, std::size_t columns, VtkNumber type, const char* what) {
  type_ = type;
  what_ = what;
  at_ = cursor_.offset();
  const double numbers = static_cast<double>(rows) * static_cast<double>(columns);
  // A number of a text has at least one digit, and a space before the next one.
  const double needed = binary_ ? std::ceil(numbers * static_cast<double>(bits_of(type)) / 8) : 2 * numbers - 1;
  // A text's numbers may begin in the line of their name, so the length of the whole file is the limit.
  const std::size_t left = binary_ ? bytes_.size() - at_ : bytes_.size();
  if (needed > static_cast<double>(left))
    fail(fmt::format("is cut off: {} {} need at least {:.0f} bytes, {} has {}", rows, what, needed,
                     binary_ ? "the rest of the file" : "the file", left));
}

std::string_view VtkSource::number_word() {
  const std::string_view word = cursor_.word_anywhere();
  if (word.empty()) fail(fmt::format("is cut off within its {}", what_));
  return word;
}

/// Returns the next number of a binary file. The file is as long as begin_numbers() has checked.
template <class T>
T VtkSource::raw() {
  std::array<char, sizeof(T)> raw;
  if (bytes_.size() - at_ < raw.size()) fail(fmt::format("is cut off within its {}", what_));
  std::memcpy(raw.data(), bytes_.data() + at_, raw.size());
  at_ += raw.size();
  if constexpr (std::endian::native == std::endian::little) std::reverse(raw.begin(), raw.end());
  return std::bit_cast<T>(raw);
}

double VtkSource::finite_number() {
  double x = 0;
  if (!binary_) {
    const std::string_view word = number_word();
    x = cursor_.number(word);
    if (!std::isfinite(x)) fail(fmt::format("{} is not finite", word.substr(0, 24)));
    return x;
  }
  if (type_ == VtkNumber::float32) {
    x = raw<float>();
  } else if (type_ == VtkNumber::float64) {
    x = raw<double>();
  } else {
    x = static_cast<double>(integer());
  }
  if (!std::isfinite(x)) fail(fmt::format("{} is not finite", x));
  return x;
}

long long VtkSource::integer() {
  if (!binary_) return cursor_.integer(number_word());
  switch (type_) {
    case VtkNumber::int8:
      return raw<std::int8_t>();
    case VtkNumber::uint8:
      return raw<std::uint8_t>();
    case VtkNumber::int16:
      return raw<std::int16_t>();
    case VtkNumber::uint16:
      return raw<std::uint16_t>();
    case VtkNumber::int32:
      return raw<std::int32_t>();
    case VtkNumber::uint32:
      return raw<std::uint32_t>();
    case VtkNumber::int64:
      return raw<std::int64_t>();
    case VtkNumber::uint64:
      return std::bit_cast<std::int64_t>(raw<std::uint64_t>());
    default:
      fail(fmt::format("has {} of a type that is not for whole numbers of a byte or more", what_));
  }
}

void VtkSource::end_numbers() {
  if (binary_) cursor_.continue_at(at_);
}

void VtkSource::skip_numbers(std::size_t rows, std::size_t columns, VtkNumber type, const char* what) {
  begin_numbers(rows, columns, type, what);
  if (binary_) {
    at_ += (rows * columns * bits_of(type) + 7) / 8;
  } else {
    for (std::size_t i = 0; i < rows * columns; ++i) number_word();
  }
  end_numbers();
}

void VtkSource::fail(const std::string& message) const {
  if (!binary_) cursor_.fail(message);
  throw Error(file_, fmt::format("byte {}", std::max(at_, cursor_.offset())), message);
}

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
