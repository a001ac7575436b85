#include <nlohmann/json.hpp>

#include "core/layout/file/taxel_clipboard.h"
#include "core/layout/file/taxel_value.h"

namespace taxel {
namespace {

using Json = nlohmann::ordered_json;
using Value = JsonNode<Json>;

constexpr int kClipboardVersion = 1;
constexpr const char* kExpected = "taxels as JSON: copied ones, a layout, an array of taxels, or one taxel";

/// Checks the format and the version of a copied selection or a layout. One taxel or an array has neither.
void check_head(JsonObject<Json>& root) {
  root.optional("format", [](const Value& format) {
    const std::string word = format.text();
    if (word != "taxels" && word != "taxel-layout") format.wrong("\"taxels\" or \"taxel-layout\"");
  });
  root.optional("version", [](const Value& version) {
    if (version.number() != kClipboardVersion) version.wrong("1, the version that this program reads");
  });
}

}  // namespace

std::string taxels_to_json(const std::vector<Taxel>& taxels) {
  Json json = {{"format", "taxels"}, {"version", kClipboardVersion}, {"taxels", Json::array()}};
  for (std::size_t i = 0; i < taxels.size(); ++i)
    json["taxels"].push_back(taxel_json<Json>(taxels[i], fmt::format("/taxels/{}", i)));
  return json_text(json);
}

std::vector<Taxel> parse_taxels(const std::string& text, const std::string& source) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) throw Error(source, fmt::format("is empty; needed are {}", kExpected));
  if (text[begin] != '{' && text[begin] != '[') throw Error(source, fmt::format("holds no {}", kExpected));
  const Json json = parse_json<Json>(text, source);
  const Value root(json, source);
  std::vector<Taxel> taxels;
  const auto read_all = [&](const Value& array) {
    for (std::size_t i = 0; i < array.length(); ++i) taxels.push_back(read_taxel(array.item(i), i));
  };
  if (json.is_array()) {
    read_all(root);
  } else if (json.contains("center")) {
    taxels.push_back(read_taxel(root, 0));
  } else {
    JsonObject<Json> object(root);
    if (!json.contains("taxels")) throw Error(source, fmt::format("holds no {}", kExpected));
    check_head(object);
    read_all(object.required("taxels"));
  }
  if (taxels.empty()) throw Error(source, "holds no taxel");
  return taxels;
}

}  // namespace taxel
