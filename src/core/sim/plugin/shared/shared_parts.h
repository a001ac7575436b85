// The parts of instances that never change. All data of one model share them, and so do other models with equal parts.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "core/base/files.h"
#include "core/base/parallel.h"
#include "core/hydro/bristles.h"
#include "core/hydro/hydro_body.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// Cache of values that live as long as somebody uses them, by key. May be used from any thread.
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
    if (Pointer existing = place->value.lock()) return existing;
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

/// All that determines a part: texts, and hashes of larger contents.
using PartKey = std::vector<std::string>;

/// The body of a geom, its repaired shape, and a sentence on the repair; empty if there was none.
struct NotedBody {
  HydroBodyPtr body;
  Shape shape;
  std::string repair;
};
using NotedBodyPtr = std::shared_ptr<const NotedBody>;
using WarningsPtr = std::shared_ptr<const std::vector<std::string>>;

// Each function returns the part of an equal key if somebody uses it, otherwise that of make(). If several threads
// request a new part, one of them makes it and the others wait. Exceptions of make() are passed on.

SensorModelPtr share_model(const PartKey& key, const std::function<SensorModelPtr()>& make);
NotedBodyPtr share_noted_body(const PartKey& key, const std::function<NotedBody()>& make);
BristleSkinPtr share_bristle_skin(const PartKey& key, const std::function<BristleSkinPtr()>& make);
WarningsPtr share_warnings(const PartKey& key, const std::function<std::vector<std::string>()>& make);

/// While this object lives, instances of this process also take the expensive parts of sensor models from a cache, and
/// leave theirs in it. For a program that compiles the layouts of its scenes itself: it samples each skin once.
class PartsFromCache {
 public:
  /// `cache` must live longer than this object. One object may live at a time.
  explicit PartsFromCache(SensorCache& cache);
  ~PartsFromCache();
  PartsFromCache(const PartsFromCache&) = delete;
  PartsFromCache& operator=(const PartsFromCache&) = delete;
};
/// Returns the cache of the living PartsFromCache, or null.
SensorCache* parts_cache();

/// Returns a hash of numbers, or of structures of numbers.
template <class Number>
std::string hash_of_numbers(std::span<const Number> numbers) {
  const auto bytes = std::as_bytes(numbers);
  return sha256_hex({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

/// Returns a hash of the vertices and faces of a mesh.
std::string hash_of_mesh(const TriMesh& mesh);

}  // namespace taxel
