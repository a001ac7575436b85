// The reports of commands as JSON.
#include <nlohmann/json.hpp>
#include <vector>

#include "app/cli/report_writer.h"
#include "core/base/text/json.h"

namespace taxel::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string indented(const Json& json, int spaces) {
  return json.dump(spaces, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace

struct ReportWriter::Tree {
  Json root = Json::object();
  std::vector<Json*> open{&root};  // the objects and arrays that contain the next value, outermost first

  /// Adds a null to the innermost object or array. Arrays ignore the key.
  Json& add(std::string_view key) const {
    Json& parent = *open.back();
    return parent.is_array() ? parent.emplace_back() : parent[std::string(key)];
  }
};

ReportWriter::ReportWriter() : tree_(std::make_unique<Tree>()) {}
ReportWriter::~ReportWriter() = default;

void ReportWriter::put(std::string_view key, const Scalar& value) {
  std::visit([&](const auto& scalar) { tree_->add(key) = scalar; }, value);
}

void ReportWriter::open(std::string_view key, Kind kind) {
  Json& added = tree_->add(key);
  added = kind == Kind::array ? Json::array() : Json::object();
  tree_->open.push_back(&added);
}

void ReportWriter::close() {
  tree_->open.pop_back();
}

void ReportWriter::keys_of(const std::string& json_text) {
  const Json object = Json::parse(json_text);
  for (const auto& [key, value] : object.items()) tree_->add(key) = value;
}

std::string ReportWriter::text(JsonStyle style) const {
  if (style == JsonStyle::short_arrays) return json_text(tree_->root);
  if (style == JsonStyle::one_line) return json_line(tree_->root) + "\n";
  return indented(tree_->root, style == JsonStyle::indented ? 2 : 1);
}

}  // namespace taxel::cli
