#include "core/mesh/formats/vtk_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "core/base/error.h"

namespace taxel {
namespace {

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

}  // namespace

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

}  // namespace taxel
