// A value that its copies share.
#pragma once

#include <memory>
#include <utility>

namespace taxel {

/// Behaves like a constant T; copying it copies a pointer. For large parts of values that are copied often.
template <class T>
class SharedValue {
 public:
  SharedValue() = default;                                                       ///< T{}, without an allocation
  SharedValue(T value) : value_(std::make_shared<const T>(std::move(value))) {}  // NOLINT: a T is one
  const T& operator*() const {
    static const T nothing{};
    return value_ ? *value_ : nothing;
  }
  const T* operator->() const { return &**this; }
  bool operator==(const SharedValue& other) const { return value_ == other.value_ || **this == *other; }
  /// Returns an address that copies of one value have in common, or null if nothing was allocated.
  [[nodiscard]] const void* identity() const { return value_.get(); }

 private:
  std::shared_ptr<const T> value_;
};

}  // namespace taxel
