#include "core/hydro/body_cache.h"

#include <map>
#include <mutex>
#include <tuple>

namespace taxel {
namespace {

using Key = std::tuple<ShapeType, std::array<double, 3>, double, FieldKind, FaceRule, std::array<double, 4>>;

Key key_of(const Shape& shape, const Material& m) {
  return {shape.type, {shape.size.x, shape.size.y, shape.size.z},         shape.resolution, m.field,
          m.faces,    {m.modulus, m.thickness, m.dissipation, m.friction}};
}

/// A body under a name of its own, which keeps alive the one that others find.
struct Named {
  HydroBody body;
  HydroBodyPtr first;
};

HydroBodyPtr under_name(HydroBodyPtr first, const std::string& name) {
  auto named = std::make_shared<Named>(*first, first);
  named->body.name = name;
  return {named, &named->body};
}

class BodyCache {
 public:
  HydroBodyPtr find_or_make(const Shape& shape, const Material& material, const std::string& name) {
    const Key key = key_of(shape, material);
    const std::lock_guard lock(mutex_);
    if (const auto found = bodies_.find(key); found != bodies_.end()) {
      if (HydroBodyPtr first = found->second.lock()) return under_name(std::move(first), name);
    }
    HydroBodyPtr made = make_body(shape, material, name);
    std::erase_if(bodies_, [](const auto& entry) { return entry.second.expired(); });
    bodies_[key] = made;
    return under_name(std::move(made), name);
  }

 private:
  std::mutex mutex_;
  std::map<Key, std::weak_ptr<const HydroBody>> bodies_;
};

}  // namespace

HydroBodyPtr share_body(const Shape& shape, const Material& material, const std::string& name) {
  const bool primitive = shape.type != ShapeType::mesh && shape.type != ShapeType::tets;
  if (!primitive) return make_body(shape, material, name);
  static BodyCache cache;
  return cache.find_or_make(shape, material, name);
}

}  // namespace taxel
