// Small helpers for the programs' *_json.cpp files; the JSON library is theirs to include.
#pragma once

#include <string>

#include "core/base/math.h"

namespace taxel {

/// x y z as an array of the given JSON type.
template <class Json>
Json numbers(const dvec3& v) {
  return Json::array({v.x, v.y, v.z});
}

/// One object, two-space indent, newline at the end. Texts that are no UTF-8 (file names) get replacement characters.
template <class Json>
std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace taxel
