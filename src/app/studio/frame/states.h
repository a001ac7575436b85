// The states of all features of the window: one value of each type.
#pragma once

#include <memory>
#include <unordered_map>
#include <utility>

namespace taxel::ui {

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

  /// Resets the parts of all values that belong to the document. A type names this part PerDocument, or has no such
  /// part.
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
      if constexpr (requires { typename T::PerDocument; }) static_cast<typename T::PerDocument&>(value) = {};
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
