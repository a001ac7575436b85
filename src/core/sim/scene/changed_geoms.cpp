#include "core/sim/scene/changed_geoms.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/base/error.h"
#include "core/base/text/json.h"
#include "core/run/lead.h"

namespace taxel {
namespace {

struct SizedType {
  mjtGeom type = mjGEOM_SPHERE;
  std::size_t sizes = 1;
};
const std::map<std::string, SizedType> kTypes{{"sphere", {mjGEOM_SPHERE, 1}},
                                              {"capsule", {mjGEOM_CAPSULE, 2}},
                                              {"ellipsoid", {mjGEOM_ELLIPSOID, 3}},
                                              {"cylinder", {mjGEOM_CYLINDER, 2}},
                                              {"box", {mjGEOM_BOX, 3}}};

mjsGeom& geom_of(mjSpec* spec, const std::string& name, const std::string& pointer) {
  std::vector<std::string> names;
  for (mjsElement* e = mjs_firstElement(spec, mjOBJ_GEOM); e != nullptr; e = mjs_nextElement(spec, e)) {
    const std::string one = mjs_getString(mjs_getName(e));
    if (one == name) return *mjs_asGeom(e);
    if (!one.empty()) names.push_back(one);
  }
  throw Error("", pointer,
              names.empty() ? "is no geom of the scene: its geoms have no names"
                            : "is no geom of the scene: there are " + quoted_list(names) + meant_name(name, names));
}

void change_shape(mjsGeom& geom, const GeomChange& change, const std::string& pointer) {
  if (!change.type.empty()) {
    geom.type = kTypes.at(change.type).type;
    mjs_setString(geom.meshname, "");
    std::fill_n(geom.fromto, 6, std::numeric_limits<double>::quiet_NaN());
  }
  if (change.size.empty()) return;
  const auto type = std::ranges::find_if(kTypes, [&](const auto& one) { return one.second.type == geom.type; });
  if (type == kTypes.end())
    throw Error("", pointer + "/size", "is of no geom with a size: give a type such as \"sphere\" as well");
  if (change.size.size() != type->second.sizes)
    throw Error("", pointer + "/size",
                fmt::format("must have {} number{} for a {}, has {}", type->second.sizes,
                            type->second.sizes == 1 ? "" : "s", type->first, change.size.size()));
  if (!std::isnan(geom.fromto[0]))
    throw Error("", pointer + "/size", "is set in part by fromto in the scene: give the type of the geom as well");
  std::copy(change.size.begin(), change.size.end(), geom.size);
}

}  // namespace

void change_geoms(CompiledScene& scene, const std::vector<GeomChange>& changes, const std::string& name) {
  for (const GeomChange& change : changes) {
    const std::string pointer = "/geoms/" + escaped_key(change.geom);
    mjsGeom& geom = geom_of(scene.spec.get(), change.geom, pointer);
    change_shape(geom, change, pointer);
    if (change.mass) {
      const mjsBody* body = mjs_getParent(geom.element);
      if (body != nullptr && body->explicitinertial != 0)
        throw Error("", pointer + "/mass", "has no effect: the body has an <inertial> in the scene");
      geom.mass = *change.mass;
    }
    if (change.friction) geom.friction[0] = *change.friction;
  }
  scene.model.reset(mj_compile(scene.spec.get(), nullptr));
  if (scene.model == nullptr) throw Error(name, mjs_getError(scene.spec.get()));
}

}  // namespace taxel
