#include "core/sim/plugin/shared/shared_parts.h"

#include <atomic>

namespace taxel {
namespace {
std::atomic<SensorCache*> living_cache = nullptr;
}

PartsFromCache::PartsFromCache(SensorCache& cache) {
  living_cache = &cache;
}

PartsFromCache::~PartsFromCache() {
  living_cache = nullptr;
}

SensorCache* parts_cache() {
  return living_cache;
}

SensorModelPtr share_model(const PartKey& key, const std::function<SensorModelPtr()>& make) {
  static WeakCache<PartKey, SensorModel> cache;
  return cache.get(key, make);
}

NotedBodyPtr share_noted_body(const PartKey& key, const std::function<NotedBody()>& make) {
  static WeakCache<PartKey, NotedBody> cache;
  return cache.get(key, [&] { return std::make_shared<const NotedBody>(make()); });
}

BristleSkinPtr share_bristle_skin(const PartKey& key, const std::function<BristleSkinPtr()>& make) {
  static WeakCache<PartKey, BristleSkin> cache;
  return cache.get(key, make);
}

WarningsPtr share_warnings(const PartKey& key, const std::function<std::vector<std::string>()>& make) {
  static WeakCache<PartKey, std::vector<std::string>> cache;
  return cache.get(key, [&] { return std::make_shared<const std::vector<std::string>>(make()); });
}

std::string hash_of_mesh(const TriMesh& mesh) {
  return hash_of_numbers(std::span(mesh.vertices())) + hash_of_numbers(std::span(mesh.faces()));
}

}  // namespace taxel
