#include "fuzz/members.h"

#include <algorithm>
#include <string_view>

#include "core/run/recording/recording_files.h"

namespace taxel::fuzz {
namespace {

/// Consumes up to `count` bytes from the front of `rest`.
std::string take(std::string_view& rest, std::size_t count) {
  const std::string bytes(rest.substr(0, count));
  rest.remove_prefix(bytes.size());
  return bytes;
}

/// Consumes a number of `count` bytes, lowest byte first.
std::size_t take_number(std::string_view& rest, std::size_t count) {
  std::size_t number = 0, shift = 0;
  for (const char c : take(rest, count)) {
    number |= static_cast<std::size_t>(static_cast<unsigned char>(c)) << shift;
    shift += 8;
  }
  return number;
}

}  // namespace

std::string archive_bytes_of(const std::string& input) {
  if (input.starts_with("PK")) return input;
  NpzWriter out;
  std::string_view rest = input;
  while (!rest.empty()) {
    const std::string name = take(rest, take_number(rest, 1));
    out.add_file(name, take(rest, take_number(rest, 2)));
  }
  return out.bytes();
}

ZipArchive archive_of(const std::string& input) {
  return {"input.npz", archive_bytes_of(input)};
}

}  // namespace taxel::fuzz
