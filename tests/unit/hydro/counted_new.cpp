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
