// The alternatives of a std::variant whose types are the kinds of a thing: shapes, scenarios, patterns.
#pragma once

#include <cstddef>
#include <utility>
#include <variant>
#include <vector>

namespace taxel {

/// Returns one value of each alternative with default values, in the order of the variant.
template <class Variant>
std::vector<Variant> each_alternative() {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    return std::vector<Variant>{Variant(std::in_place_index<I>)...};
  }
  (std::make_index_sequence<std::variant_size_v<Variant>>());
}

}  // namespace taxel
