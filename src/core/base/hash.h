// SHA-256 of bytes (FIPS 180-4), as lower-case hexadecimal. Computed by mbed TLS.
#pragma once

#include <string>
#include <string_view>

namespace taxel {
std::string sha256_hex(std::string_view bytes);
}  // namespace taxel
