// Every allocation of this test program is counted, so that a test can show that a call makes none.
#include "counted_new.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace taxel {
namespace {
std::atomic<long> allocations{0};
}
long allocation_count() {
  return allocations.load();
}
void* counted_allocation(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
}  // namespace taxel

void* operator new(std::size_t size) {
  return taxel::counted_allocation(size);
}
void* operator new[](std::size_t size) {
  return taxel::counted_allocation(size);
}
// The standard library asks for its temporary buffers this way: all forms come from one place and go back there.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++taxel::allocations;
  return std::malloc(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  ++taxel::allocations;
  return std::malloc(size);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  std::free(memory);
}
