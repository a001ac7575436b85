#include "app/studio/features/study/study_varied.h"

#include <fmt/format.h>

#include <algorithm>

#include "ui/widgets/format.h"

namespace taxel::ui {

std::string_view Varied::unit_text() const {
  const std::size_t at = name.find('(');
  return at == std::string_view::npos ? std::string_view() : name.substr(at + 1, name.size() - at - 2);
}

std::string Varied::with(double si) const {
  const std::string_view plain = name.substr(0, name.find(" ("));
  const std::string number = fmt::format("{} {:.4g}", plain, shifted_decimal(si, -unit.decimal));
  const std::string_view text = unit_text();
  if (text.starts_with("1/")) return fmt::format("{}{}", number, text.substr(1));  // "10/mm2"
  if (text.empty() || text.starts_with("\u00b0")) return fmt::format("{}{}", number, text);
  return fmt::format("{} {}", number, text);
}

std::vector<Varied> varied_in(const Scenario& scenario) {
  std::vector<Varied> all;
  for (const ScenarioField& field : scenario_fields()) {
    for (const ScenarioParameter& parameter : scenario_parameters()) {
      if (parameter.value == field.value && parameter.used_by(scenario))
        all.push_back({parameter.key, field.name, field.unit, field.value});
    }
  }
  all.push_back({kDensityKey, "Density (1/mm\u00b2)", {"1/mm^2", 6, -1}});
  all.push_back({kSeedKey, "Seed", {"", 0, -1}});
  return all;
}

}  // namespace taxel::ui
