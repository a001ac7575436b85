// Single values of a layout by their JSON pointers.
#include "app/python/handles.h"

#include <nlohmann/json.hpp>

#include "core/base/error.h"
#include "core/base/text/json.h"
#include "core/base/text/words.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/file/layout_json.h"
#include "core/layout/file/layout_keys.h"

namespace taxel::python {
namespace {

using Json = nlohmann::ordered_json;

Json::json_pointer parse_pointer(const LayoutHandle& layout, const std::string& pointer) {
  try {
    return Json::json_pointer(pointer);
  } catch (const Json::exception&) {
    throw Error(layout.file, pointer, "is not a JSON pointer, such as /material/modulus");
  }
}

bool is_at_or_below(const std::string& place, const std::string& pointer) {
  return place.starts_with(pointer) && (place.size() == pointer.size() || place[pointer.size()] == '/');
}

/// Throws Error for a key that no reader of a layout knows, and that the layout did not have before.
void refuse_unknown_keys(const Layout& before, const Layout& changed, const std::string& file) {
  for (const auto& [place, value] : changed.unknown) {
    if (before.unknown.contains(place)) continue;
    const std::size_t key = place.rfind('/');
    throw Error(file, place,
                "is an unknown key, which has no effect" +
                    meant_word(place.substr(key + 1), known_layout_keys(place.substr(0, key))));
  }
}

}  // namespace

std::string value_of(const LayoutHandle& layout, const std::string& pointer) {
  const Json json = Json::parse(layout_to_json(*layout.value));
  const Json::json_pointer place = parse_pointer(layout, pointer);
  if (!json.contains(place)) throw Error(layout.file, pointer, "is not in the layout");
  return json.at(place).dump();
}

Layout with_value(const LayoutHandle& layout, const std::string& pointer, const std::string& json_text) {
  Json json = Json::parse(layout_to_json(*layout.value));
  const Json value = parse_json<Json>(json_text, layout.file);
  try {
    json[parse_pointer(layout, pointer)] = value;
  } catch (const Json::exception&) {
    throw Error(layout.file, pointer, "is not a place in the layout");
  }
  Layout changed = parse_layout(json.dump(), layout.file);
  refuse_unknown_keys(*layout.value, changed, layout.file);
  for (const Problem& p : check_layout_values(changed, layout.file)) {
    if (p.severity == Severity::error && is_at_or_below(p.pointer, pointer)) throw Error(p.file, p.pointer, p.message);
  }
  return changed;
}

}  // namespace taxel::python
