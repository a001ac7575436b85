// Cache for the last few results of an expensive function.
#pragma once

#include <list>
#include <mutex>
#include <optional>
#include <utility>

namespace taxel {

/// Keeps values by key, the most recently used one first. It is meant for a handful of keys that compare with ==, and
/// may be used from any thread.
template <class Key, class Value>
class Memo {
 public:
  /// The sum of cost(value) of the kept values is at most `capacity`; the newest value is always kept.
  explicit Memo(double capacity) : capacity_(capacity) {}

  /// Returns the value of an equal key, or the result of make(). make() runs without a lock: if two threads request the
  /// same key at the same time, both may call it.
  template <class Make, class Cost>
  Value get(const Key& key, const Make& make, const Cost& cost) {
    if (std::optional<Value> found = find(key)) return *std::move(found);
    Value made = make();
    const std::lock_guard lock(mutex_);
    entries_.push_front({key, made, cost(made)});
    total_ += entries_.front().cost;
    while (entries_.size() > 1 && total_ > capacity_) {
      total_ -= entries_.back().cost;
      entries_.pop_back();
    }
    return made;
  }
  template <class Make>
  Value get(const Key& key, const Make& make) {
    return get(key, make, [](const Value&) { return 1.0; });
  }
  [[nodiscard]] bool has(const Key& key) { return find(key).has_value(); }

 private:
  struct Entry {
    Key key;
    Value value;
    double cost = 1;
  };
  std::optional<Value> find(const Key& key) {
    const std::lock_guard lock(mutex_);
    for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
      if (!(entry->key == key)) continue;
      entries_.splice(entries_.begin(), entries_, entry);
      return entry->value;
    }
    return std::nullopt;
  }

  std::mutex mutex_;
  std::list<Entry> entries_;
  double capacity_ = 0, total_ = 0;
};

}  // namespace taxel
