#include <nlohmann/json.hpp>

#include "app/cli/check_report.h"
#include "app/vector_json.h"

namespace taxel::cli {

std::string problems_json(const Problems& problems) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["problems"] = Json::array();
  for (const Problem& problem : problems) {
    json["problems"].push_back({{"file", problem.file},
                                {"pointer", problem.pointer},
                                {"severity", to_string(problem.severity)},
                                {"code", problem.code},
                                {"message", problem.message},
                                {"fix", problem.fix}});
  }
  return text_of(json);
}

}  // namespace taxel::cli
