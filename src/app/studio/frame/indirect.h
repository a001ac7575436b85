// A value that lies elsewhere in memory, so that its owner needs only a declaration of its type.
#pragma once

#include <memory>
#include <utility>

namespace taxel::ui {

/// Owns a T and behaves as a member would: copying copies the T, a constant owner gives a constant T, it is never
/// empty, and its T keeps its address. T may be incomplete where the owner is declared, but not where the owner is
/// made, copied or destroyed. Similar to std::indirect of C++26.
template <class T>
class Indirect {
 public:
  Indirect() : value_(std::make_unique<T>()) {}
  Indirect(const Indirect& other) : value_(std::make_unique<T>(*other)) {}
  Indirect(Indirect&& other) : value_(std::make_unique<T>(std::move(*other))) {}
  Indirect& operator=(const Indirect& other) { return **this = *other, *this; }
  Indirect& operator=(Indirect&& other) { return **this = std::move(*other), *this; }
  ~Indirect() = default;

  T& operator*() { return *value_; }
  const T& operator*() const { return *value_; }
  T* operator->() { return value_.get(); }
  const T* operator->() const { return value_.get(); }

 private:
  std::unique_ptr<T> value_;
};

}  // namespace taxel::ui
