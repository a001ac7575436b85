// One value of a YAML document that knows its file, line and key, so that every complaint about it names them.
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

  /// "line 8, key geomName"; without a key only the line.
  [[nodiscard]] std::string place() const;
  /// Throws Error with file and place.
  [[noreturn]] void fail(const std::string& message) const;
  [[noreturn]] void fail_expected(const std::string& expected) const;

  [[nodiscard]] const std::string& key() const { return key_; }
  [[nodiscard]] bool is_list() const { return node_.IsSequence(); }
  [[nodiscard]] bool is_map() const { return node_.IsMap(); }
  [[nodiscard]] std::string text() const;
  [[nodiscard]] double number() const;  ///< finite; a quoted number is text
  [[nodiscard]] dvec3 vector() const;   ///< a list of three numbers
  [[nodiscard]] std::vector<YamlValue> items() const;
  /// By key. A key that is listed twice is an error, as YAML has it.
  [[nodiscard]] std::map<std::string, YamlValue> entries() const;

 private:
  [[nodiscard]] std::string shown() const;
  YAML::Node node_;
  const std::string* file_;
  std::string key_;
};

/// All documents of a YAML text. Throws Error with file and line where it is no YAML.
std::vector<YamlValue> parse_yaml(const std::string& text, const std::string& file);

}  // namespace taxel
