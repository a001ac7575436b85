#include <nlohmann/json.hpp>

#include "app/cli/validate_report.h"
#include "app/vector_json.h"

namespace taxel::cli {

std::string validate_json(const ClosedFormChecks& checks) {
  using Json = nlohmann::ordered_json;
  Json json;
  json["checks"] = Json::array();
  bool pass = true;
  for (const ClosedFormCheck& check : checks) {
    json["checks"].push_back({{"form", check.form},
                              {"setting", check.setting},
                              {"quantity", check.quantity},
                              {"unit", check.unit},
                              {"computed", check.computed},
                              {"exact", check.exact},
                              {"relation", check.relation == Relation::equal     ? "="
                                           : check.relation == Relation::at_most ? "<="
                                                                                 : ">="},
                              {"error", check.error},
                              {"bound", check.bound},
                              {"pass", check.pass()}});
    pass = pass && check.pass();
  }
  json["pass"] = pass;
  return text_of(json);
}

}  // namespace taxel::cli
