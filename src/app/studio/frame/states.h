// The states of all features of the window: one value of each type.
#pragma once

#include <memory>
#include <unordered_map>
#include <utility>

namespace taxel::ui {

/// A value that lies elsewhere in memory, so that its owner needs only a declaration of its type. Owns a T and behaves
/// as a member would: copying copies the T, a constant owner gives a constant T, it is never empty, and its T keeps its
/// address. T may be incomplete where the owner is declared, but not where the owner is made, copied or destroyed.
/// Similar to std::indirect of C++26.
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

/// Holds one value of each type that was asked for, and copies them all. A feature asks for its own type of state, so
/// that no list has to name it. A value keeps its address. Not safe for threads.
class States {
 public:
  States() = default;
  States(const States& other) { *this = other; }
  States(States&&) noexcept = default;
  States& operator=(const States& other);
  States& operator=(States&&) noexcept = default;
  ~States() = default;

  /// Returns the value of a type. It is as T{} until it is changed.
  template <class T>
  [[nodiscard]] T& get() {
    std::unique_ptr<Holder>& holder = holders_[&kType<T>];
    if (!holder) holder = std::make_unique<Holds<T>>(T{});
    return static_cast<Holds<T>&>(*holder).value;
  }
  template <class T>
  [[nodiscard]] const T& get() const {
    static const T unchanged{};
    const auto found = holders_.find(&kType<T>);
    return found == holders_.end() ? unchanged : static_cast<const Holds<T>&>(*found->second).value;
  }

  /// Resets the parts of all values that belong to the document. A type has a function forget_document(), or names this
  /// part PerDocument, or has no such part.
  void forget_document() {
    for (auto& [type, holder] : holders_) holder->forget_document();
  }

 private:
  struct Holder {
    Holder() = default;
    Holder(const Holder&) = delete;
    Holder& operator=(const Holder&) = delete;
    virtual ~Holder() = default;
    [[nodiscard]] virtual std::unique_ptr<Holder> copy() const = 0;
    virtual void forget_document() = 0;
  };

  template <class T>
  struct Holds final : Holder {
    explicit Holds(T v) : value(std::move(v)) {}
    [[nodiscard]] std::unique_ptr<Holder> copy() const override { return std::make_unique<Holds<T>>(value); }
    void forget_document() override {
      if constexpr (requires { value.forget_document(); })
        value.forget_document();
      else if constexpr (requires { typename T::PerDocument; })
        static_cast<typename T::PerDocument&>(value) = {};
    }
    T value;
  };

  /// Its address identifies the type T.
  template <class T>
  static constexpr char kType = 0;

  std::unordered_map<const char*, std::unique_ptr<Holder>> holders_;
};

inline States& States::operator=(const States& other) {
  if (this == &other) return *this;
  holders_.clear();
  for (const auto& [type, holder] : other.holders_) holders_.emplace(type, holder->copy());
  return *this;
}

}  // namespace taxel::ui
