#include <nlohmann/json.hpp>

#include "app/cli/presets_report.h"
#include "app/vector_json.h"

namespace taxel::cli {

std::string presets_json(const std::vector<SensorPreset>& presets) {
  nlohmann::ordered_json json;
  json["presets"] = nlohmann::ordered_json::array();
  for (const SensorPreset& preset : presets) {
    json["presets"].push_back({{"name", preset.name},
                               {"title", preset.layout.name},
                               {"taxels", preset.layout.taxels.size()},
                               {"source", preset.source},
                               {"unverified", preset.unverified}});
  }
  return text_of(json);
}

}  // namespace taxel::cli
