#include <fmt/format.h>
#include <fmt/ranges.h>

#include <bit>
#include <charconv>
#include <cstring>

#include "core/base/archive/npz.h"
#include "core/base/error.h"

namespace taxel {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are read as they lie in memory");

/// Returns the text after `key` in the dictionary of an NPY header; empty if the header has no such key.
std::string_view after(std::string_view dictionary, std::string_view key) {
  const std::size_t at = dictionary.find(key);
  return at == std::string_view::npos ? std::string_view() : dictionary.substr(at + key.size());
}

void append_utf8(std::string& text, char32_t c) {
  const auto put = [&](char32_t byte) { text += static_cast<char>(byte); };
  if (c < 0x80) {
    put(c);
  } else if (c < 0x800) {
    put(0xc0 | (c >> 6)), put(0x80 | (c & 0x3f));
  } else if (c < 0x10000) {
    put(0xe0 | (c >> 12)), put(0x80 | ((c >> 6) & 0x3f)), put(0x80 | (c & 0x3f));
  } else {
    put(0xf0 | (c >> 18)), put(0x80 | ((c >> 12) & 0x3f)), put(0x80 | ((c >> 6) & 0x3f)), put(0x80 | (c & 0x3f));
  }
}

/// Reads numbers separated by commas, up to the closing bracket.
bool parse_shape(std::string_view text, NpzReader::Shape& shape) {
  while (!text.empty() && text.front() != ')') {
    std::size_t n = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), n);
    if (code != std::errc()) return false;
    shape.push_back(n);
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    while (!text.empty() && (text.front() == ',' || text.front() == ' ')) text.remove_prefix(1);
  }
  return !text.empty();
}

/// Returns the number of bytes of one element; 0 for types that are not supported.
std::size_t element_size(const std::string& type) {
  if (type == "<f8" || type == "<i8") return 8;
  if (type == "<f4") return 4;
  std::size_t length = 0;
  if (type.starts_with("<U") &&
      std::from_chars(type.data() + 2, type.data() + type.size(), length).ptr == type.data() + type.size())
    return 4 * length;
  return 0;
}

}  // namespace

std::string read_archive_member(const std::filesystem::path& path, const std::string& name) {
  const ZipArchive archive(path);
  return archive.has(name) ? archive.read(name) : "";
}

/// Reads an array in the format NPY 1.0 (NumPy enhancement proposal 1).
NpzReader::Array NpzReader::at(const std::string& name) const {
  const std::string& file = this->file();
  if (!has(name)) throw Error(file, name, "is missing");
  std::string bytes;
  try {
    bytes = archive_.read(name + ".npy");
  } catch (const Error& e) {
    throw Error(file, name, e.message());
  }
  constexpr std::size_t kPrefix = 10;
  if (bytes.size() < kPrefix || bytes.compare(0, 8, std::string("\x93NUMPY\x01\x00", 8)) != 0)
    throw Error(file, name, "is no array in NPY 1.0");
  const std::size_t header = static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
  if (bytes.size() < kPrefix + header) throw Error(file, name, "is broken off");
  const std::string_view dictionary(bytes.data() + kPrefix, header);
  Array array;
  const std::string_view type = after(dictionary, "'descr': '");
  array.type = type.substr(0, type.find('\''));
  if (element_size(array.type) == 0)
    throw Error(file, name, fmt::format("has elements of type \"{}\", which are not read", array.type));
  if (!after(dictionary, "'fortran_order': ").starts_with("False"))
    throw Error(file, name, "lies in memory column by column, which is not read");
  if (!parse_shape(after(dictionary, "'shape': ("), array.shape)) throw Error(file, name, "has no shape");
  bytes.erase(0, kPrefix + header);
  array.data = std::move(bytes);
  std::size_t left = array.data.size() / element_size(array.type);  // division cannot overflow, unlike a product
  for (const std::size_t n : array.shape) array.count = n == 0 || array.count <= left / n ? array.count * n : left + 1;
  if (array.count * element_size(array.type) != array.data.size())
    throw Error(file, name, "does not hold as many values as its shape says");
  return array;
}

template <class T>
std::vector<T> NpzReader::numbers(const std::string& name, const std::string& type, const Shape& shape) const {
  const Array array = at(name);
  if (array.type != type) throw Error(file(), name, fmt::format("is of type {}, not {}", array.type, type));
  bool fits = array.shape.size() == shape.size();
  for (std::size_t i = 0; fits && i < shape.size(); ++i) fits = shape[i] == kAny || shape[i] == array.shape[i];
  if (!fits) {
    std::vector<std::string> wanted;
    for (const std::size_t n : shape) wanted.push_back(n == kAny ? "any" : fmt::format("{}", n));
    throw Error(file(), name,
                fmt::format("is of shape ({}), must be ({})", fmt::join(array.shape, ", "), fmt::join(wanted, ", ")));
  }
  std::vector<T> values(array.count);
  if (!values.empty()) std::memcpy(values.data(), array.data.data(), array.data.size());
  return values;
}

std::vector<double> NpzReader::doubles(const std::string& name, const Shape& shape) const {
  if (at(name).type == "<f4") {
    const std::vector<float> values = numbers<float>(name, "<f4", shape);
    return {values.begin(), values.end()};
  }
  return numbers<double>(name, "<f8", shape);
}
std::vector<std::int64_t> NpzReader::integers(const std::string& name, const Shape& shape) const {
  return numbers<std::int64_t>(name, "<i8", shape);
}

std::vector<std::string> NpzReader::texts(const std::string& name) const {
  const Array array = at(name);
  if (!array.type.starts_with("<U") || array.shape.size() > 1)
    throw Error(file(), name, "is no text and no list of texts");
  const std::size_t length = element_size(array.type) / 4;
  std::vector<std::string> texts(array.count);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t k = 0; k < length; ++k) {
      char32_t c = 0;
      std::memcpy(&c, array.data.data() + 4 * (i * length + k), 4);
      if (c > 0x10FFFF || (c >= 0xD800 && c <= 0xDFFF))
        throw Error(file(), name,
                    fmt::format("text {} must hold characters of Unicode, holds number {:#x}", i,
                                static_cast<std::uint32_t>(c)));
      if (c != 0) append_utf8(texts[i], c);
    }
  }
  return texts;
}

std::string NpzReader::text(const std::string& name) const {
  const std::vector<std::string> all = texts(name);
  if (all.size() != 1) throw Error(file(), name, "must be one text");
  return all.front();
}

}  // namespace taxel
