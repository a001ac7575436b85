// PLY (Stanford polygon format): ASCII, binary little endian and binary big endian; elements and properties may come in
// any order. Triangles are in the element `face` as polygons, or in `tristrips` as strips.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>

#include "core/base/error.h"
#include "core/mesh/formats/mesh_format.h"
#include "core/mesh/formats/text_cursor.h"

namespace taxel {
namespace {

enum class Number { none, int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
  std::string name;
  Number value = Number::none;
  Number count = Number::none;  ///< type of a list's length; none for a single number
};

struct Element {
  std::string name;
  long long count = 0;
  std::vector<Property> properties;
};

enum class Encoding { ascii, little, big };

struct Header {
  Encoding encoding = Encoding::ascii;
  std::vector<Element> elements;
  std::size_t size = 0;  ///< number of bytes
};

Number number_type(const TextCursor& cursor, std::string_view word) {
  constexpr std::array<std::pair<std::string_view, Number>, 16> kNames{{{"char", Number::int8},
                                                                        {"int8", Number::int8},
                                                                        {"uchar", Number::uint8},
                                                                        {"uint8", Number::uint8},
                                                                        {"short", Number::int16},
                                                                        {"int16", Number::int16},
                                                                        {"ushort", Number::uint16},
                                                                        {"uint16", Number::uint16},
                                                                        {"int", Number::int32},
                                                                        {"int32", Number::int32},
                                                                        {"uint", Number::uint32},
                                                                        {"uint32", Number::uint32},
                                                                        {"float", Number::float32},
                                                                        {"float32", Number::float32},
                                                                        {"double", Number::float64},
                                                                        {"float64", Number::float64}}};
  for (const auto& [name, type] : kNames) {
    if (name == word) return type;
  }
  cursor.fail(fmt::format("unknown number type '{}'", word));
}

Encoding encoding_of(const TextCursor& cursor, std::string_view word) {
  if (word == "ascii") return Encoding::ascii;
  if (word == "binary_little_endian") return Encoding::little;
  if (word == "binary_big_endian") return Encoding::big;
  cursor.fail(fmt::format("unknown format '{}'", word));
}

Property read_property(TextCursor& cursor) {
  Property property;
  std::string_view word = cursor.word();
  if (word == "list") {
    property.count = number_type(cursor, cursor.word());
    word = cursor.word();
  }
  property.value = number_type(cursor, word);
  property.name = cursor.word();
  return property;
}

Header read_header(TextCursor& cursor) {
  Header header;
  if (!cursor.next_line() || cursor.word() != "ply") cursor.fail("is not a PLY file: it does not begin with 'ply'");
  while (cursor.next_line()) {
    const std::string_view key = cursor.word();
    if (key == "format") {
      header.encoding = encoding_of(cursor, cursor.word());
    } else if (key == "element") {
      Element element;
      element.name = cursor.word();
      element.count = cursor.integer(cursor.word());
      if (element.count < 0) cursor.fail(fmt::format("{} elements '{}' cannot be", element.count, element.name));
      header.elements.push_back(std::move(element));
    } else if (key == "property") {
      if (header.elements.empty()) cursor.fail("a property before the first element");
      header.elements.back().properties.push_back(read_property(cursor));
    } else if (key == "end_header") {
      header.size = cursor.offset();
      return header;
    }
  }
  cursor.fail("is cut off: no 'end_header'");
}

/// Throws Error if there are several elements 'vertex', or if the rows of the only one lack x, y or z.
void check_vertex_element(const Header& header, const std::string& file) {
  const auto is_vertex = [](const Element& element) { return element.name == "vertex"; };
  const auto count = std::count_if(header.elements.begin(), header.elements.end(), is_vertex);
  if (count > 1) throw Error(file, "header", fmt::format("must have one element 'vertex', has {}", count));
  if (count == 0) return;
  const Element& vertex = *std::find_if(header.elements.begin(), header.elements.end(), is_vertex);
  for (const std::string_view name : {"x", "y", "z"}) {
    const auto is_coordinate = [&](const Property& p) { return p.name == name && p.count == Number::none; };
    if (std::none_of(vertex.properties.begin(), vertex.properties.end(), is_coordinate))
      throw Error(file, "header", fmt::format("element 'vertex' has no property '{}'", name));
  }
}

std::size_t bytes_of(Number type) {
  constexpr std::array<std::size_t, 9> kBytes{0, 1, 1, 2, 2, 4, 4, 4, 8};
  return kBytes[static_cast<std::size_t>(type)];
}

/// Throws Error if the bytes after the header are too few for the rows that the header announces. A list may be empty,
/// and a number of a text has at least one digit and a space before the next one.
void check_announced_rows(const Header& header, std::size_t file_bytes, const std::string& file) {
  const bool text = header.encoding == Encoding::ascii;
  const double left = static_cast<double>(file_bytes - header.size);
  double needed = text ? -1 : 0;  // the last number of a text needs no space
  for (const Element& element : header.elements) {
    double row = 0;
    for (const Property& p : element.properties)
      row += text ? 2 : static_cast<double>(bytes_of(p.count == Number::none ? p.value : p.count));
    needed += row * static_cast<double>(element.count);
    if (element.count > 0 && needed > left)
      throw Error(
          file, "header",
          fmt::format("is cut off: {} elements '{}' need at least {:.0f} bytes, the rest of the file has {:.0f}",
                      element.count, element.name, row * static_cast<double>(element.count) - (text ? 1 : 0), left));
  }
}

/// The numbers after the header, read in order, in any of the three encodings.
class Body {
 public:
  Body(std::string_view bytes, std::string file, const Header& header, TextCursor& text)
      : bytes_(bytes), file_(std::move(file)), at_(header.size), encoding_(header.encoding), text_(text) {}

  double next(Number type) {
    switch (type) {
      case Number::int8:
        return read<std::int8_t>();
      case Number::uint8:
        return read<std::uint8_t>();
      case Number::int16:
        return read<std::int16_t>();
      case Number::uint16:
        return read<std::uint16_t>();
      case Number::int32:
        return read<std::int32_t>();
      case Number::uint32:
        return read<std::uint32_t>();
      case Number::float32:
        return read<float>();
      case Number::float64:
        return read<double>();
      case Number::none:
        break;
    }
    return 0;
  }

  [[noreturn]] void fail(const std::string& message) const {
    if (encoding_ == Encoding::ascii) text_.fail(message);
    throw Error(file_, fmt::format("byte {}", at_), message);
  }

 private:
  template <class T>
  double read() {
    if (encoding_ == Encoding::ascii) {
      const std::string_view word = text_.word_anywhere();
      if (word.empty()) fail("is cut off");
      return text_.number(word);
    }
    std::array<char, sizeof(T)> raw;
    if (bytes_.size() - at_ < raw.size()) fail("is cut off");
    std::memcpy(raw.data(), bytes_.data() + at_, raw.size());
    at_ += raw.size();
    if (encoding_ == Encoding::big) std::reverse(raw.begin(), raw.end());
    T value;
    std::memcpy(&value, raw.data(), raw.size());
    return static_cast<double>(value);
  }

  std::string_view bytes_;
  std::string file_;
  std::size_t at_;
  Encoding encoding_;
  TextCursor& text_;
};

/// Returns `value` as an index below `end`. Throws Error naming the value if it is not a whole number in that range.
int index_from(const Body& body, double value, double end, const char* what) {
  if (!(value >= 0 && value < end) || value != std::floor(value))
    body.fail(fmt::format("{} {} cannot be", what, value));
  return static_cast<int>(value);
}

/// Reads one row of an element and calls `scalar(name, value)` for its numbers and `list(name, values)` for its lists.
template <class Scalar, class List>
void read_row(Body& body, const Element& element, std::vector<double>& values, const Scalar& scalar, const List& list) {
  for (const Property& property : element.properties) {
    if (property.count == Number::none) {
      scalar(property.name, body.next(property.value));
      continue;
    }
    const int count = index_from(body, body.next(property.count), std::numeric_limits<int>::max(), "list length");
    values.clear();
    for (int i = 0; i < count; ++i) values.push_back(body.next(property.value));
    list(property.name, values);
  }
}

void read_vertex(Body& body, const Element& element, std::vector<double>& values, PolygonSoup& soup) {
  dvec3 p(std::numeric_limits<double>::quiet_NaN());
  const auto scalar = [&](const std::string& name, double value) {
    if (name == "x") p.x = value;
    if (name == "y") p.y = value;
    if (name == "z") p.z = value;
  };
  read_row(body, element, values, scalar, [](const std::string&, const std::vector<double>&) {});
  if (!is_finite(p)) body.fail(fmt::format("vertex {}: coordinate is not finite or missing", soup.vertices.size()));
  soup.vertices.push_back(p);
}

void read_face(Body& body, const Element& element, double vertex_count, std::vector<double>& values,
               PolygonSoup& soup) {
  std::vector<int> corners;
  const auto list = [&](const std::string& name, const std::vector<double>& numbers) {
    if (name != "vertex_indices" && name != "vertex_index") return;
    for (const double value : numbers) corners.push_back(index_from(body, value, vertex_count, "vertex number"));
  };
  read_row(
      body, element, values, [](const std::string&, double) {}, list);
  soup.add_polygon(corners);
}

/// Adds the triangles of strips: each vertex makes a triangle with the two before it, every second one turned over. The
/// vertex number -1 begins a new strip.
void read_strips(Body& body, const Element& element, double vertex_count, std::vector<double>& values,
                 PolygonSoup& soup) {
  std::vector<int> strip;
  const auto list = [&](const std::string& name, const std::vector<double>& numbers) {
    if (name != "vertex_indices" && name != "vertex_index") return;
    for (const double value : numbers) {
      if (value == -1) {
        strip.clear();
        continue;
      }
      strip.push_back(index_from(body, value, vertex_count, "vertex number"));
      const std::size_t n = strip.size();
      if (n < 3) continue;
      const bool odd = n % 2 == 0;
      const int a = strip[n - 3], b = strip[n - 2], c = strip[n - 1];
      if (a != b && b != c && a != c) soup.triangles.emplace_back(odd ? b : a, odd ? a : b, c);
    }
  };
  read_row(
      body, element, values, [](const std::string&, double) {}, list);
}

}  // namespace

PolygonSoup read_ply(std::string_view bytes, const std::string& file) {
  TextCursor text(bytes, file, '\0');
  const Header header = read_header(text);
  check_vertex_element(header, file);
  check_announced_rows(header, bytes.size(), file);
  Body body(bytes, file, header, text);
  double vertex_count = 0;
  for (const Element& element : header.elements) {
    if (element.name == "vertex") vertex_count = static_cast<double>(element.count);
  }
  PolygonSoup soup;
  std::vector<double> values;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    for (long long i = 0; i < element.count; ++i) {
      if (element.name == "vertex") {
        read_vertex(body, element, values, soup);
      } else if (element.name == "face") {
        read_face(body, element, vertex_count, values, soup);
      } else if (element.name == "tristrips") {
        read_strips(body, element, vertex_count, values, soup);
      } else {
        const auto ignore = [](const std::string&, const auto&) {};
        read_row(body, element, values, ignore, ignore);
      }
    }
  }
  return soup;
}

}  // namespace taxel
