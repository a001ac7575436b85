#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/files.h"
#include "core/base/text/json.h"
#include "core/run/real/column_mapping.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using MappingNode = JsonNode<Json>;

int whole(const MappingNode& node) {
  const double value = node.number();
  if (value != std::floor(value) || std::abs(value) > 1e9) node.wrong("a whole number");
  return static_cast<int>(value);
}

TimeUnit time_unit(const MappingNode& node) {
  const std::string word = node.text();
  for (std::size_t i = 0; i < kTimeUnitWords.size(); ++i)
    if (word == kTimeUnitWords[i]) return static_cast<TimeUnit>(i);
  node.wrong("one of s, ms, us, ns");
}

TaxelColumn taxel_column(const MappingNode& node) {
  node.only({"taxel", "column", "gain", "offset"});
  TaxelColumn taxel{whole(node.at("taxel")), node.at("column").text(), {}, {}};
  if (const auto gain = node.find("gain")) taxel.gain = gain->number();
  if (const auto offset = node.find("offset")) taxel.offset = offset->number();
  return taxel;
}

void read_taxels(const MappingNode& node, ColumnMapping& mapping) {
  for (std::size_t i = 0; i < node.length(); ++i) mapping.taxels.push_back(taxel_column(node.item(i)));
}

}  // namespace

std::string mapping_to_json(const ColumnMapping& m) {
  Json json = {{"format", "column-mapping"},
               {"version", 1},
               {"separator", m.separator},
               {"decimal", m.decimal},
               {"header_lines", m.header_lines},
               {"time", m.time},
               {"time_unit", to_word(m.time_unit)},
               {"rate", json_number<Json>(m.rate, "/rate")},
               {"unit", m.unit},
               {"gain", json_number<Json>(m.gain, "/gain")},
               {"offset", json_number<Json>(m.offset, "/offset")},
               {"taxels", Json::array()}};
  for (std::size_t i = 0; i < m.taxels.size(); ++i) {
    const TaxelColumn& taxel = m.taxels[i];
    const std::string pointer = fmt::format("/taxels/{}", i);
    Json one = {{"taxel", taxel.taxel}, {"column", taxel.column}};
    if (taxel.gain) one["gain"] = json_number<Json>(*taxel.gain, pointer + "/gain");
    if (taxel.offset) one["offset"] = json_number<Json>(*taxel.offset, pointer + "/offset");
    json["taxels"].push_back(std::move(one));
  }
  return json_text(json);
}

ColumnMapping mapping_from_json(const std::string& text, const std::string& file) {
  const Json json = parse_json<Json>(text, file);
  const MappingNode root(json, file);
  root.only({"format", "version", "separator", "decimal", "header_lines", "time", "time_unit", "rate", "unit", "gain",
             "offset", "taxels"});
  if (root.at("format").text() != "column-mapping") root.at("format").wrong("\"column-mapping\"");
  if (whole(root.at("version")) != 1) root.at("version").wrong("1");
  ColumnMapping mapping;
  const auto text_at = [&](const char* key, std::string& to) {
    if (const auto node = root.find(key)) to = node->text();
  };
  const auto number_at = [&](const char* key, double& to) {
    if (const auto node = root.find(key)) to = node->number();
  };
  text_at("separator", mapping.separator);
  text_at("decimal", mapping.decimal);
  if (const auto lines = root.find("header_lines")) mapping.header_lines = whole(*lines);
  text_at("time", mapping.time);
  if (const auto unit = root.find("time_unit")) mapping.time_unit = time_unit(*unit);
  number_at("rate", mapping.rate);
  text_at("unit", mapping.unit);
  number_at("gain", mapping.gain);
  number_at("offset", mapping.offset);
  read_taxels(root.at("taxels"), mapping);
  check_mapping(mapping, file);
  return mapping;
}

ColumnMapping read_mapping(const std::string& file) {
  return mapping_from_json(read_file(file), file);
}

}  // namespace taxel
