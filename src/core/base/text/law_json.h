// Pressure laws in JSON: "linear", {"stiffening": k} or {"table": [[strain, pressure], ...]}, pressures in units of the
// modulus.
#pragma once

#include <string>

#include "core/base/pressure_law.h"
#include "core/base/text/json.h"

namespace taxel {

/// Reads a law. Throws Error with the pointer of the value that breaks a rule.
template <class Json>
PressureLaw read_law(const JsonNode<Json>& node) {
  PressureLaw law;
  if (node.is_text()) {
    if (node.text() != "linear")
      node.wrong("\"linear\", {\"stiffening\": k} or {\"table\": [[strain, pressure], ...]}");
    return law;
  }
  node.only({"stiffening", "table"});
  const auto stiffening = node.find("stiffening"), table = node.find("table");
  if (stiffening.has_value() == table.has_value()) node.fail("must have \"stiffening\" or \"table\", one of the two");
  law.kind = stiffening ? LawKind::stiffening : LawKind::table;
  if (stiffening) law.k = stiffening->number();
  for (std::size_t i = 0; table && i < table->length(); ++i) {
    const JsonNode<Json> row = table->item(i);
    if (row.length() != 2) row.wrong("an array of 2 numbers, a strain and a pressure over the modulus");
    law.table.push_back({row.item(0).number(), row.item(1).number()});
  }
  std::string place;
  const std::string problem = law_problem(law, &place);
  if (problem.empty()) return law;
  JsonNode<Json> at = table ? *table : *stiffening;
  for (std::size_t slash = place.find('/', 1); slash != std::string::npos; slash = place.find('/', slash + 1))
    at = at.item(std::stoul(place.substr(slash + 1)));
  at.fail(problem);
}

/// Returns the JSON of a law.
template <class Json>
Json law_json(const PressureLaw& law) {
  if (law.kind == LawKind::linear) return "linear";
  Json json = Json::object();
  if (law.kind == LawKind::stiffening) {
    json["stiffening"] = law.k;
    return json;
  }
  Json rows = Json::array();
  for (const LawPoint& point : law.table) rows.push_back(Json::array({point.strain, point.pressure}));
  json["table"] = std::move(rows);
  return json;
}

}  // namespace taxel
