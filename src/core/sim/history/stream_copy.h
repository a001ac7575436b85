// Copies that leave the processor's caches to those who need them.
#pragma once

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace taxel {

/// memcpy for what is not read again soon: whole cache lines are written to memory without being read first. For the
/// same thread to read: no lock makes another one wait for such writes, and a fence that does costs as much as the
/// copy.
inline void stream_copy(std::byte* to, const void* source, std::size_t size) {
  namespace hn = hwy::HWY_NAMESPACE;
  constexpr std::size_t kLine = 64;
  const hn::CappedTag<std::uint8_t, kLine> tag;
  const auto* from = static_cast<const std::byte*>(source);
  std::size_t done = std::min(size, (kLine - reinterpret_cast<std::uintptr_t>(to) % kLine) % kLine);
  if (done > 0) std::memcpy(to, from, done);
  for (; done + kLine <= size; done += kLine) {
    for (std::size_t i = 0; i < kLine; i += hn::Lanes(tag)) {
      const auto bytes = hn::LoadU(tag, reinterpret_cast<const std::uint8_t*>(from + done + i));
      hn::Stream(bytes, tag, reinterpret_cast<std::uint8_t*>(to + done + i));
    }
  }
  if (done < size) std::memcpy(to + done, from + done, size - done);
}

}  // namespace taxel
