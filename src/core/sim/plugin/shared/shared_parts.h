// The parts of instances that never change. All data of one model share them, and so do other models with equal parts.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/hash.h"
#include "core/hydro/friction/bristle_skin.h"
#include "core/hydro/hydro_body.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

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
