// Zip archives by libzip, and NumPy arrays in them: writing, then reading.

#include "core/base/archive/npz.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <zip.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <memory>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel {
namespace {

[[noreturn]] void fail(const std::string& file, zip_error_t& error) {
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  throw Error(file, "cannot be read as .npz: " + why);
}

}  // namespace

ZipArchive::ZipArchive(const std::filesystem::path& path) : ZipArchive(path.string(), read_file(path)) {}

ZipArchive::ZipArchive(std::string file, std::string bytes, std::uint64_t free_bytes)
    : file_(std::move(file)), bytes_(std::make_shared<const std::string>(std::move(bytes))), free_bytes_(free_bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes_->data(), bytes_->size(), 0, &error);
  if (source == nullptr) fail(file_, error);
  // ZIP_CHECKCONS compares the header of each member with the directory of the archive. Without it, a flipped bit in a
  // name would hide an array.
  zip_t* const archive = zip_open_from_source(source, ZIP_RDONLY | ZIP_CHECKCONS, &error);
  if (archive == nullptr) {
    zip_source_free(source);
    fail(file_, error);
  }
  archive_.reset(archive, &zip_discard);
  list_members();
}

void ZipArchive::list_members() {
  const zip_int64_t count = zip_get_num_entries(archive_.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t status;
    zip_stat_init(&status);
    const auto index = static_cast<zip_uint64_t>(i);
    const char* const name = zip_get_name(archive_.get(), index, ZIP_FL_ENC_UTF_8);
    constexpr zip_uint64_t kNeeded = ZIP_STAT_SIZE | ZIP_STAT_CRC;
    if (name == nullptr || zip_stat_index(archive_.get(), index, 0, &status) < 0 || (status.valid & kNeeded) != kNeeded)
      throw Error(file_, fmt::format("member {} of the archive is broken", i));
    if (!members_.try_emplace(name, Member{index, status.size}).second)
      throw Error(file_, name, "is twice in the archive");
  }
}

std::string ZipArchive::read(const std::string& name) const {
  const auto found = members_.find(name);
  if (found == members_.end()) throw Error(file_, name, "is missing");
  const Member& member = found->second;
  std::uint64_t others = 0;
  for (const auto& [other, size] : unpacked_) others += other == name ? 0 : size;
  const std::uint64_t most = free_bytes_ + kMaxRatio * bytes_->size();
  if (member.size > most || others > most - member.size)
    throw Error(file_, name,
                fmt::format("announces {} bytes; of an archive of {} bytes at most {} are unpacked, {} are already",
                            member.size, bytes_->size(), most, others));
  unpacked_[name] = member.size;
  std::string bytes(member.size, '\0');
  char beyond = 0;
  const std::unique_ptr<zip_file_t, decltype(&zip_fclose)> in(zip_fopen_index(archive_.get(), member.index, 0),
                                                              &zip_fclose);
  // Libzip compares the checksum when a read reaches the end of the member, so one more read is needed after the bytes.
  if (in == nullptr || zip_fread(in.get(), bytes.data(), bytes.size()) != static_cast<zip_int64_t>(bytes.size()) ||
      zip_fread(in.get(), &beyond, 1) != 0)
    throw Error(file_, name, "is broken off or damaged: its content differs from its checksum");
  return bytes;
}

namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written and read as they lie in memory");

constexpr std::size_t kPrefix = 10;  // bytes of an array before its dictionary: magic, version and length

/// Returns the header of NPY 1.0: magic, version, length, and a Python dictionary padded with blanks to a multiple of
/// 64 bytes.
std::string npy_header(const std::string& type, const NpzWriter::Shape& shape) {
  std::string tuple;
  for (const std::size_t n : shape) tuple += fmt::format("{},", n);
  std::string dictionary = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, tuple);
  while ((kPrefix + dictionary.size() + 1) % 64 != 0) dictionary += ' ';
  dictionary += '\n';
  std::string header("\x93NUMPY\x01\x00", 8);
  header += static_cast<char>(dictionary.size() & 0xff);
  header += static_cast<char>(dictionary.size() >> 8);
  return header + dictionary;
}

template <class T>
std::string npy(const std::string& type, const NpzWriter::Shape& shape, std::span<const T> values) {
  std::size_t count = 1;
  for (const std::size_t n : shape) count *= n;
  if (count != values.size()) throw Error(fmt::format("array of {} values does not fill its shape", values.size()));
  std::string bytes = npy_header(type, shape);
  const std::size_t header = bytes.size();
  bytes.resize(header + values.size_bytes());
  if (!values.empty()) std::memcpy(bytes.data() + header, values.data(), values.size_bytes());
  return bytes;
}

/// Returns the code points of UTF-8 text. A byte that is not valid becomes U+FFFD.
std::u32string code_points(const std::string& text) {
  std::u32string points;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80           ? 1
                               : (lead >> 5) == 0x6  ? 2
                               : (lead >> 4) == 0xe  ? 3
                               : (lead >> 3) == 0x1e ? 4
                                                     : 0;
    char32_t point = length == 1 ? lead : static_cast<char32_t>(lead & (0x7fU >> length));
    bool good = length > 0 && i + length <= text.size();
    for (std::size_t k = 1; good && k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      good = (next >> 6) == 0x2;
      point = (point << 6) | (next & 0x3fU);
    }
    points += good ? point : U'\uFFFD';
    i += good ? length : 1;
  }
  return points;
}

std::string npy_text(const NpzWriter::Shape& shape, const std::vector<std::string>& texts) {
  std::vector<std::u32string> all;
  std::size_t longest = 1;
  for (const std::string& text : texts) {
    all.push_back(code_points(text));
    longest = std::max(longest, all.back().size());
  }
  std::u32string block;
  for (std::u32string& text : all) {
    text.resize(longest, U'\0');
    block += text;
  }
  std::string bytes = npy_header(fmt::format("<U{}", longest), shape);
  bytes.append(reinterpret_cast<const char*>(block.data()), block.size() * sizeof(char32_t));
  return bytes;
}

[[noreturn]] void fail(zip_error_t& error) {
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  throw Error("", "npz", why);
}
[[noreturn]] void fail(zip_t* archive) {
  const std::string why = zip_strerror(archive);
  zip_discard(archive);
  throw Error("", "npz", why);
}

/// Adds a member with the earliest date that a zip can hold, 1980-01-01 00:00.
void add_member(zip_t* archive, const std::string& name, const std::string& bytes, NpzWriter::Packing packing) {
  zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  if (source == nullptr) fail(archive);
  const zip_int64_t index = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    fail(archive);
  }
  const auto at = static_cast<zip_uint64_t>(index);
  constexpr zip_uint16_t kFirstDay = (1U << 5) | 1U;
  constexpr zip_uint32_t kFastest = 1;
  const bool is_stored = packing == NpzWriter::Packing::stored;
  if (zip_set_file_compression(archive, at, is_stored ? ZIP_CM_STORE : ZIP_CM_DEFLATE, is_stored ? 0 : kFastest) < 0 ||
      zip_file_set_dostime(archive, at, 0, kFirstDay, 0) < 0) {
    fail(archive);
  }
}

}  // namespace

void NpzWriter::add(const std::string& name, const Shape& shape, std::span<const double> values) {
  members_.emplace_back(name + ".npy", npy("<f8", shape, values));
}
void NpzWriter::add(const std::string& name, const Shape& shape, std::span<const float> values) {
  members_.emplace_back(name + ".npy", npy("<f4", shape, values));
}
void NpzWriter::add(const std::string& name, const Shape& shape, std::span<const std::int64_t> values) {
  members_.emplace_back(name + ".npy", npy("<i8", shape, values));
}
void NpzWriter::add(const std::string& name, const std::vector<std::string>& texts) {
  members_.emplace_back(name + ".npy", npy_text({texts.size()}, texts));
}
void NpzWriter::add(const std::string& name, const std::string& text) {
  members_.emplace_back(name + ".npy", npy_text({}, {text}));
}

std::string NpzWriter::bytes(Packing packing) const {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* buffer = zip_source_buffer_create(nullptr, 0, 0, &error);
  if (buffer == nullptr) fail(error);
  const std::unique_ptr<zip_source_t, decltype(&zip_source_free)> kept(buffer, &zip_source_free);
  zip_source_keep(buffer);  // the archive takes one reference, `kept` holds the other
  zip_t* archive = zip_open_from_source(buffer, ZIP_TRUNCATE, &error);
  if (archive == nullptr) {
    zip_source_free(buffer);
    fail(error);
  }
  for (const auto& [name, bytes] : members_) add_member(archive, name, bytes, packing);
  if (zip_close(archive) < 0) fail(archive);

  zip_stat_t status;
  zip_stat_init(&status);
  if (zip_source_open(buffer) < 0 || zip_source_stat(buffer, &status) < 0) throw Error("npz: the archive was not made");
  std::string result(status.size, '\0');
  const zip_int64_t read = zip_source_read(buffer, result.data(), result.size());
  zip_source_close(buffer);
  if (read != static_cast<zip_int64_t>(result.size())) throw Error("npz: the archive cannot be read back");
  return result;
}

namespace {

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
std::vector<T> NpzReader::numbers(const std::string& name, const Array& array, const std::string& type,
                                  const Shape& shape) const {
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
  const Array array = at(name);
  if (array.type == "<f4") {
    const std::vector<float> values = numbers<float>(name, array, "<f4", shape);
    return {values.begin(), values.end()};
  }
  return numbers<double>(name, array, "<f8", shape);
}
std::vector<std::int64_t> NpzReader::integers(const std::string& name, const Shape& shape) const {
  return numbers<std::int64_t>(name, at(name), "<i8", shape);
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
