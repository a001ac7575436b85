// Changing attribute values in MJCF text that MuJoCo itself has written: one tag at a time, no comments, double quotes.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace taxel {

struct XmlAttribute {
  std::string tag;       ///< element name
  std::string name;      ///< of the attribute
  std::string value;     ///< without escapes
  std::string previous;  ///< value of the attribute before it in the same tag, or empty
};

/// The text with every attribute value for which `change` returns one replaced by it.
std::string change_attributes(const std::string& xml,
                              const std::function<std::optional<std::string>(const XmlAttribute&)>& change);

/// A text as an XML attribute value, and back.
std::string xml_escaped(const std::string& text);
std::string xml_unescaped(const std::string& text);

}  // namespace taxel
