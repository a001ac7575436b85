#include "app/studio/nouns/study/study_varied.h"

#include <fmt/format.h>

#include "ui/widgets/format.h"

namespace taxel::ui {

std::string value_text(const FieldSpec& parameter, double si) {
  const DisplayUnit unit = display_unit(parameter.quantity);
  const std::string number = fmt::format("{} {:.4g}", parameter.label, shifted_decimal(si, -unit.decimal));
  const std::string_view symbol = unit.symbol;
  if (symbol.starts_with("1/")) return fmt::format("{}{}", number, symbol.substr(1));  // "10/mm2"
  if (symbol.empty() || symbol.starts_with("\u00b0")) return fmt::format("{}{}", number, symbol);
  return fmt::format("{} {}", number, symbol);
}

std::vector<FieldSpec> varied_in(const Scenario& scenario) {
  std::vector<FieldSpec> all;
  visit_fields(scenario, [&](const FieldSpec& field, const auto& value) {
    if constexpr (std::is_same_v<decltype(value), const double&>) all.push_back(field);
  });
  all.push_back({kDensityKey, "Density", "", FieldQuantity::density});
  all.push_back({kSeedKey, "Seed", "", FieldQuantity::number});
  return all;
}

}  // namespace taxel::ui
