// Copies bytes by stores that do not go through the caches, a cache line at a time.
//
// Such stores need whole aligned lines, so the bytes before the first line of the destination and behind the last one
// are copied in the ordinary way. Worth it for large arrays that are not read soon: an ordinary copy first reads the
// destination and evicts other data.
#include "core/run/history/stream_copy.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/run/history/stream_copy.cpp"
#include <hwy/foreach_target.h>
// The line above includes this file once per instruction set: it stays first.
#include <hwy/highway.h>

#include <cstdint>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace taxel::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

void run_stream_copy(std::byte* to, const std::byte* from, std::size_t size) {
  constexpr std::size_t kLine = 64;
  const hn::CappedTag<std::uint8_t, kLine> tag;
  const std::size_t rest = (kLine - reinterpret_cast<std::uintptr_t>(to) % kLine) % kLine;
  std::size_t done = rest < size ? rest : size;
  if (done > 0) std::memcpy(to, from, done);
  for (; done + kLine <= size; done += kLine) {
    for (std::size_t i = 0; i < kLine; i += hn::Lanes(tag)) {
      const auto bytes = hn::LoadU(tag, reinterpret_cast<const std::uint8_t*>(from + done + i));
      hn::Stream(bytes, tag, reinterpret_cast<std::uint8_t*>(to + done + i));
    }
  }
  if (done < size) std::memcpy(to + done, from + done, size - done);
}

}  // namespace taxel::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace taxel {
HWY_EXPORT(run_stream_copy);

void stream_copy(std::byte* to, const void* from, std::size_t size) {
  HWY_DYNAMIC_DISPATCH(run_stream_copy)(to, static_cast<const std::byte*>(from), size);
}
}  // namespace taxel
#endif
