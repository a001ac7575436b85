#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zip.h>

#include <bit>
#include <charconv>
#include <cstring>
#include <memory>

#include "core/base/error.h"
#include "core/project/recording/npz.h"

namespace taxel {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are read as they lie in memory");

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;

Archive open_archive(const std::string& file) {
  int code = 0;
  Archive archive(zip_open(file.c_str(), ZIP_RDONLY, &code), &zip_discard);
  if (archive != nullptr) return archive;
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  throw Error(file, "cannot be read as .npz: " + why);
}

std::string member_bytes(zip_t* archive, zip_uint64_t member, const std::string& file, const std::string& name) {
  zip_stat_t status;
  zip_stat_init(&status);
  if (zip_stat_index(archive, member, 0, &status) < 0 || (status.valid & ZIP_STAT_SIZE) == 0)
    throw Error(file, name, "is broken");
  constexpr zip_uint64_t kMostDeflated = 1100;  // zlib's largest ratio is 1032
  if (status.size > kMostDeflated * std::filesystem::file_size(file))
    throw Error(file, name, "is broken: it says that it is larger than the file can hold");
  std::string bytes(status.size, '\0');
  const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> in(zip_fopen_index(archive, member, 0), &zip_fclose);
  if (in == nullptr || zip_fread(in.get(), bytes.data(), bytes.size()) != static_cast<zip_int64_t>(bytes.size()))
    throw Error(file, name, "is broken off or damaged");
  return bytes;
}

/// What stands behind `key` in the dictionary of an NPY header; empty where it does not.
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

/// Numbers separated by commas, up to the closing bracket.
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

/// Bytes of one element; 0 for types that are not read.
std::size_t element_size(const std::string& type) {
  if (type == "<f8" || type == "<i8") return 8;
  std::size_t length = 0;
  if (type.starts_with("<U") &&
      std::from_chars(type.data() + 2, type.data() + type.size(), length).ptr == type.data() + type.size())
    return 4 * length;
  return 0;
}

}  // namespace

std::string read_archive_member(const std::filesystem::path& path, const std::string& name) {
  const std::string file = path.string();
  const Archive archive = open_archive(file);
  const zip_int64_t member = zip_name_locate(archive.get(), name.c_str(), ZIP_FL_ENC_UTF_8);
  return member < 0 ? "" : member_bytes(archive.get(), static_cast<zip_uint64_t>(member), file, name);
}

NpzReader::NpzReader(const std::filesystem::path& path) : file_(path.string()) {
  const Archive archive = open_archive(file_);
  const zip_int64_t members = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < members; ++i) {
    const auto member = static_cast<zip_uint64_t>(i);
    const char* const entry = zip_get_name(archive.get(), member, ZIP_FL_ENC_UTF_8);
    std::string name = entry != nullptr ? entry : "";
    if (!name.ends_with(".npy")) continue;
    name.resize(name.size() - 4);
    arrays_[name] = parse(name, member_bytes(archive.get(), member, file_, name));
  }
}

/// NPY 1.0 (NumPy enhancement proposal 1).
NpzReader::Array NpzReader::parse(const std::string& name, const std::string& bytes) const {
  constexpr std::size_t kPrefix = 10;
  if (bytes.size() < kPrefix || bytes.compare(0, 8, std::string("\x93NUMPY\x01\x00", 8)) != 0)
    throw Error(file_, name, "is no array in NPY 1.0");
  const std::size_t header = static_cast<unsigned char>(bytes[8]) + 256U * static_cast<unsigned char>(bytes[9]);
  if (bytes.size() < kPrefix + header) throw Error(file_, name, "is broken off");
  const std::string_view dictionary(bytes.data() + kPrefix, header);
  Array array;
  const std::string_view type = after(dictionary, "'descr': '");
  array.type = type.substr(0, type.find('\''));
  if (element_size(array.type) == 0)
    throw Error(file_, name, fmt::format("has elements of type \"{}\", which are not read", array.type));
  if (after(dictionary, "'fortran_order': ").starts_with("True"))
    throw Error(file_, name, "lies in memory column by column, which is not read");
  if (!parse_shape(after(dictionary, "'shape': ("), array.shape)) throw Error(file_, name, "has no shape");
  array.data = bytes.substr(kPrefix + header);
  std::size_t left = array.data.size() / element_size(array.type);  // no overflow for any shape
  for (const std::size_t n : array.shape) array.count = n == 0 || array.count <= left / n ? array.count * n : left + 1;
  if (array.count * element_size(array.type) != array.data.size())
    throw Error(file_, name, "does not hold as many values as its shape says");
  return array;
}

const NpzReader::Array& NpzReader::at(const std::string& name) const {
  const auto found = arrays_.find(name);
  if (found == arrays_.end()) throw Error(file_, name, "is missing");
  return found->second;
}

template <class T>
std::vector<T> NpzReader::numbers(const std::string& name, const std::string& type, const Shape& shape) const {
  const Array& array = at(name);
  if (array.type != type) throw Error(file_, name, fmt::format("is of type {}, not {}", array.type, type));
  bool fits = array.shape.size() == shape.size();
  for (std::size_t i = 0; fits && i < shape.size(); ++i) fits = shape[i] == kAny || shape[i] == array.shape[i];
  if (!fits) {
    std::vector<std::string> wanted;
    for (const std::size_t n : shape) wanted.push_back(n == kAny ? "any" : fmt::format("{}", n));
    throw Error(file_, name,
                fmt::format("is of shape ({}), must be ({})", fmt::join(array.shape, ", "), fmt::join(wanted, ", ")));
  }
  std::vector<T> values(array.count);
  if (!values.empty()) std::memcpy(values.data(), array.data.data(), array.data.size());
  return values;
}

std::vector<double> NpzReader::doubles(const std::string& name, const Shape& shape) const {
  return numbers<double>(name, "<f8", shape);
}
std::vector<std::int64_t> NpzReader::integers(const std::string& name, const Shape& shape) const {
  return numbers<std::int64_t>(name, "<i8", shape);
}

std::vector<std::string> NpzReader::texts(const std::string& name) const {
  const Array& array = at(name);
  if (!array.type.starts_with("<U") || array.shape.size() > 1)
    throw Error(file_, name, "is no text and no list of texts");
  const std::size_t length = element_size(array.type) / 4;
  std::vector<std::string> texts(array.count);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    for (std::size_t k = 0; k < length; ++k) {
      char32_t c = 0;
      std::memcpy(&c, array.data.data() + 4 * (i * length + k), 4);
      if (c != 0) append_utf8(texts[i], c);
    }
  }
  return texts;
}

std::string NpzReader::text(const std::string& name) const {
  const std::vector<std::string> all = texts(name);
  if (all.size() != 1) throw Error(file_, name, "must be one text");
  return all.front();
}

}  // namespace taxel
