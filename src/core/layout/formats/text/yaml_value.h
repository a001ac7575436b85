// A value of a YAML document with its file, line and key, which messages name.
#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/base/math.h"

namespace taxel {

class YamlValue {
 public:
  YamlValue(YAML::Node node, const std::string& file, std::string key)
      : node_(std::move(node)), file_(&file), key_(std::move(key)) {}

  /// Returns the place for messages: "line 8, key geomName", or the line only without a key.
  [[nodiscard]] std::string place() const;
  /// Throws Error naming the file and the place.
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_expected(const std::string& expected) const;

  [[nodiscard]] const std::string& key() const { return key_; }
  [[nodiscard]] bool is_list() const { return node_.IsSequence(); }
  [[nodiscard]] bool is_map() const { return node_.IsMap(); }
  [[nodiscard]] std::string text() const;
  [[nodiscard]] double number() const;  ///< finite number; a quoted number is a text
  [[nodiscard]] dvec3 vector() const;   ///< list of three numbers
  [[nodiscard]] std::vector<YamlValue> items() const;
  /// Returns the values by key. Throws Error if a key is listed twice.
  [[nodiscard]] std::map<std::string, YamlValue> entries() const;

 private:
  [[nodiscard]] std::string shown() const;
  YAML::Node node_;
  const std::string* file_;
  std::string key_;
};

/// Returns the documents of a YAML text. Throws Error naming the file and the line if the text is not YAML.
std::vector<YamlValue> parse_yaml(const std::string& text, const std::string& file);

}  // namespace taxel
