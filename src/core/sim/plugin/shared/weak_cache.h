// Cache of values that live as long as somebody uses them.
#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "core/base/parallel.h"

namespace taxel {

/// Keeps the values that are in use, by key. May be used from any thread.
template <class Key, class Value>
class WeakCache {
 public:
  using Pointer = std::shared_ptr<const Value>;

  /// Returns the value of an equal key if somebody uses it, otherwise the result of make(), a Pointer. If several
  /// threads request the same new key, one of them calls make() and the others wait. Other keys do not wait. An
  /// exception of make() is passed on, and the next request calls make() again.
  template <class Make>
  Pointer get(const Key& key, const Make& make) {
    const std::shared_ptr<Place> place = place_of(key);
    const std::lock_guard lock(place->mutex);
    if (Pointer known = place->value.lock()) return known;
    Pointer made;
    isolated([&] { made = make(); });  // otherwise this thread might begin a task that requests the key again
    place->value = made;
    return made;
  }

  /// Returns the number of keys that are remembered. Keys without a value are forgotten when a new key is requested.
  [[nodiscard]] std::size_t size() {
    const std::lock_guard lock(mutex_);
    return places_.size();
  }

 private:
  struct Place {
    std::mutex mutex;
    std::weak_ptr<const Value> value;
  };

  std::shared_ptr<Place> place_of(const Key& key) {
    const std::lock_guard lock(mutex_);
    if (const auto found = places_.find(key); found != places_.end()) return found->second;
    std::erase_if(places_, [](const auto& entry) { return is_unused(*entry.second); });
    return places_.emplace(key, std::make_shared<Place>()).first->second;
  }
  static bool is_unused(Place& place) {
    const std::unique_lock lock(place.mutex, std::try_to_lock);  // a locked place has a value soon
    return lock.owns_lock() && place.value.expired();
  }

  std::mutex mutex_;
  std::map<Key, std::shared_ptr<Place>> places_;
};

}  // namespace taxel
