// A column of numbers that grows at its end and shrinks at its front.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace taxel {

/// A vector whose first values can be removed at a constant mean cost per value.
template <class T>
class Column {
 public:
  Column() = default;
  Column(std::vector<T> values) : all_(std::move(values)) {}  // NOLINT: implicit, as both are lists of values

  [[nodiscard]] std::size_t size() const { return all_.size() - forgotten_; }
  [[nodiscard]] bool empty() const { return size() == 0; }
  [[nodiscard]] std::size_t capacity() const { return all_.capacity(); }
  [[nodiscard]] T* data() { return all_.data() + forgotten_; }
  [[nodiscard]] const T* data() const { return all_.data() + forgotten_; }
  [[nodiscard]] T* begin() { return data(); }
  [[nodiscard]] T* end() { return data() + size(); }
  [[nodiscard]] const T* begin() const { return data(); }
  [[nodiscard]] const T* end() const { return data() + size(); }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }
  [[nodiscard]] const T& front() const { return *begin(); }
  [[nodiscard]] T& back() { return all_.back(); }
  [[nodiscard]] const T& back() const { return all_.back(); }

  void push_back(const T& value) { all_.push_back(value); }
  void append(const T* first, const T* last) { all_.insert(all_.end(), first, last); }
  void forget_front(std::size_t count) {
    forgotten_ += count;
    if (forgotten_ <= size()) return;
    all_.erase(all_.begin(), all_.begin() + static_cast<std::ptrdiff_t>(forgotten_));
    forgotten_ = 0;
  }
  void forget_back(std::size_t count) { all_.resize(all_.size() - count); }
  void clear() { all_.clear(), forgotten_ = 0; }

 private:
  std::vector<T> all_;
  std::size_t forgotten_ = 0;
};

}  // namespace taxel
