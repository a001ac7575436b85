// Bytes of glTF files: the chunks of GLB (glTF 2.0, 4.4), and the buffers that a uri names (3.6.1).
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/text/base64.h"
#include "core/base/text/json_text.h"
#include "core/mesh/formats/gltf_model.h"

namespace taxel {
namespace {

constexpr std::size_t kGlbHeader = 12, kChunkGlbHeader = 8;  // lengths [bytes]
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;

std::uint32_t glb_number_at(std::string_view bytes, std::size_t offset) {
  std::uint32_t value = 0;
  std::memcpy(&value, bytes.data() + offset, sizeof value);
  return value;
}

/// Returns the content of the chunk of a type at `offset`, or nothing if it is not there or cut off.
std::optional<std::string_view> chunk_at(std::string_view bytes, std::size_t offset, std::uint32_t type) {
  if (offset > bytes.size() || bytes.size() - offset < kChunkGlbHeader) return std::nullopt;
  const std::size_t length = glb_number_at(bytes, offset), begin = offset + kChunkGlbHeader;
  if (glb_number_at(bytes, offset + 4) != type || length > bytes.size() - begin) return std::nullopt;
  return bytes.substr(begin, length);
}

/// Returns a uri with each %XX replaced by its byte (RFC 3986, 2.1).
std::string without_escapes(const std::string& uri) {
  std::string out;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    unsigned char byte = 0;
    const char* const digits = uri.data() + i + 1;
    if (uri[i] == '%' && i + 2 < uri.size() && std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      out += static_cast<char>(byte);
      i += 2;
    } else {
      out += uri[i];
    }
  }
  return out;
}

}  // namespace

GltfChunks find_gltf_chunks(std::string_view bytes, const std::string& file) {
  if (!bytes.starts_with("glTF")) return {bytes, std::nullopt};
  const auto refuse = [&](const std::string& why) { throw Error(file, "is not valid glTF: " + why); };
  if (bytes.size() < kGlbHeader + kChunkGlbHeader)
    refuse(fmt::format("its header must have {} bytes, there are {}", kGlbHeader + kChunkGlbHeader, bytes.size()));
  if (const std::uint32_t version = glb_number_at(bytes, 4); version != 2)
    refuse(fmt::format("version of GLB must be 2, is {}", version));
  if (const std::uint32_t length = glb_number_at(bytes, 8); length > bytes.size())
    refuse(fmt::format("is cut off: the header announces {} bytes, there are {}", length, bytes.size()));
  const std::optional<std::string_view> json = chunk_at(bytes, kGlbHeader, kJsonChunk);
  if (!json) refuse("its first chunk must be JSON and end within the file");
  return {*json, chunk_at(bytes, kGlbHeader + kChunkGlbHeader + json->size(), kBinaryChunk)};
}

std::string read_gltf_uri(const std::string& uri, const std::string& file, const std::string& pointer) {
  if (uri.starts_with("data:")) {
    const std::size_t comma = uri.find(',');
    const std::string_view head = std::string_view(uri).substr(0, comma);
    if (comma == std::string::npos || !head.ends_with(";base64"))
      throw Error(file, pointer,
                  fmt::format("must begin with \"data:TYPE;base64,\", begins with \"{}\"", uri.substr(0, 40)));
    std::optional<std::string> decoded = from_base64(std::string_view(uri).substr(comma + 1));
    if (!decoded) throw Error(file, pointer, "is not Base64");
    return *std::move(decoded);
  }
  const std::string name = without_escapes(uri);
  if (name.find('\0') != std::string::npos) throw Error(file, pointer, "must be the name of a file, has a zero byte");
  try {
    return read_file(std::filesystem::path(file).parent_path() / name);
  } catch (const Error& error) {
    throw Error(file, pointer, short_quote(name) + ": " + error.message());
  }
}

}  // namespace taxel
