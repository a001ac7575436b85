#include "core/base/hash.h"

#include <fmt/format.h>
#include <mbedtls/md.h>

#include <array>
#include <stdexcept>

namespace taxel {

std::string sha256_hex(std::string_view bytes) {
  std::array<unsigned char, 32> digest{};
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  if (mbedtls_md(mbedtls_md_info_from_type(MBEDTLS_MD_SHA256), data, bytes.size(), digest.data()) != 0)
    throw std::runtime_error("SHA-256 failed");
  std::string hex;
  for (const unsigned char byte : digest) hex += fmt::format("{:02x}", byte);
  return hex;
}

}  // namespace taxel
