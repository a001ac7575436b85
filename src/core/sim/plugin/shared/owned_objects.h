// Objects of owners that may be copied byte by byte, or whose bytes may come back after they are gone.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <mutex>
#include <vector>

namespace taxel {

/// Gives out numbers instead of pointers. A number is valid only for the owner for which it was made and until the
/// object is removed, also if another owner has the same bytes, or a later one the same address. find() takes no lock.
/// May be used from any thread.
class OwnedObjects {
 public:
  /// Returns the number of an object, never 0.
  std::uint64_t add(const void* owner, void* object);
  /// Returns the object of a number, or null if the number is not one of this owner's.
  [[nodiscard]] void* find(const void* owner, std::uint64_t number) const;
  /// Makes a number invalid. Returns the object that it had, or null.
  void* remove(const void* owner, std::uint64_t number);

 private:
  /// A place for one object after another. Its generation grows when an object is removed.
  struct Place {
    std::atomic<std::uint32_t> generation{1};
    std::atomic<const void*> owner{nullptr};
    std::atomic<void*> object{nullptr};
  };
  static constexpr int kBlocks = 24, kFirstBits = 6;  // block k has 64 * 2^k places, 10^9 in all

  [[nodiscard]] Place* place(std::uint32_t index) const;
  std::uint32_t new_index();

  // Blocks are never freed, because a number of an object that is gone may be looked up at any time.
  std::array<std::atomic<Place*>, kBlocks> blocks_{};
  std::mutex mutex_;
  std::vector<std::uint32_t> free_;
  std::uint32_t count_ = 0;
};

}  // namespace taxel
