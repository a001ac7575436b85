// Changes attribute values in MJCF text. The text must be in the form that MuJoCo writes: no comments, double quotes.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace taxel {

struct XmlAttribute {
  std::string tag;       ///< element name
  std::string name;      ///< attribute name
  std::string value;     ///< value without escapes
  std::string previous;  ///< value of the previous attribute in the same tag, or empty
};

/// Calls `change` for each attribute of the text, and returns the text with the values that `change` returns. If
/// `change` returns nothing, the attribute keeps its value.
std::string change_attributes(const std::string& xml,
                              const std::function<std::optional<std::string>(const XmlAttribute&)>& change);

/// Escape a text for use as an XML attribute value, and undo this.
std::string xml_escaped(const std::string& text);
std::string xml_unescaped(const std::string& text);

}  // namespace taxel
