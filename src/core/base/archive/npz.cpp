#include "core/base/archive/npz.h"

#include <fmt/format.h>
#include <zip.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <memory>

#include "core/base/error.h"

namespace taxel {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they lie in memory");

/// Returns the header of NPY 1.0: magic, version, length, and a Python dictionary padded with blanks to a multiple of
/// 64 bytes.
std::string npy_header(const std::string& type, const NpzWriter::Shape& shape) {
  std::string tuple;
  for (const std::size_t n : shape) tuple += fmt::format("{},", n);
  std::string dictionary = fmt::format("{{'descr': '{}', 'fortran_order': False, 'shape': ({}), }}", type, tuple);
  constexpr std::size_t kPrefix = 10;
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

/// Stores the members uncompressed, with the earliest date that a zip can hold, 1980-01-01 00:00.
void add_member(zip_t* archive, const std::string& name, const std::string& bytes) {
  zip_source_t* source = zip_source_buffer(archive, bytes.data(), bytes.size(), 0);
  if (source == nullptr) fail(archive);
  const zip_int64_t index = zip_file_add(archive, name.c_str(), source, ZIP_FL_ENC_UTF_8);
  if (index < 0) {
    zip_source_free(source);
    fail(archive);
  }
  const auto at = static_cast<zip_uint64_t>(index);
  constexpr zip_uint16_t kFirstDay = (1U << 5) | 1U;
  if (zip_set_file_compression(archive, at, ZIP_CM_STORE, 0) < 0 ||
      zip_file_set_dostime(archive, at, 0, kFirstDay, 0) < 0) {
    fail(archive);
  }
}

}  // namespace

void NpzWriter::add(const std::string& name, const Shape& shape, std::span<const double> values) {
  members_.emplace_back(name + ".npy", npy("<f8", shape, values));
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

std::string NpzWriter::bytes() const {
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
  for (const auto& [name, bytes] : members_) add_member(archive, name, bytes);
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

}  // namespace taxel
