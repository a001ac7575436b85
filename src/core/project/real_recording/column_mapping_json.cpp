#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <set>

#include "core/base/files.h"
#include "core/project/real_recording/column_mapping.h"
#include "core/project/strict_json.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using MappingNode = StrictNode<Json>;
constexpr std::array<const char*, 4> kUnits{"s", "ms", "us", "ns"};  // as TimeUnit has them

TaxelColumn taxel_column(const MappingNode& node) {
  node.only_keys({"taxel", "column", "gain", "offset"});
  TaxelColumn taxel{node.key("taxel").integer(), node.key("column").text(), {}, {}};
  if (node.has("gain")) taxel.gain = node.key("gain").number();
  if (node.has("offset")) taxel.offset = node.key("offset").number();
  return taxel;
}

}  // namespace

std::string mapping_to_json(const ColumnMapping& m) {
  Json json = {{"format", "column-mapping"},
               {"version", 1},
               {"separator", m.separator},
               {"decimal", m.decimal},
               {"header_lines", m.header_lines},
               {"time", m.time},
               {"time_unit", kUnits.at(static_cast<std::size_t>(m.time_unit))},
               {"rate", json_number<Json>(m.rate, "/rate")},
               {"unit", m.unit},
               {"gain", json_number<Json>(m.gain, "/gain")},
               {"offset", json_number<Json>(m.offset, "/offset")},
               {"taxels", Json::array()}};
  for (const TaxelColumn& taxel : m.taxels) {
    Json one = {{"taxel", taxel.taxel}, {"column", taxel.column}};
    if (taxel.gain) one["gain"] = json_number<Json>(*taxel.gain, "/taxels/gain");
    if (taxel.offset) one["offset"] = json_number<Json>(*taxel.offset, "/taxels/offset");
    json["taxels"].push_back(std::move(one));
  }
  return json_text(json);
}

}  // namespace taxel
