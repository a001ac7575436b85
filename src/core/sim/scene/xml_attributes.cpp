#include "core/sim/scene/xml_attributes.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace taxel {
namespace {

struct Entity {
  char character;
  std::string_view text;
};
constexpr std::array<Entity, 5> kEntities{
    {{'&', "&amp;"}, {'"', "&quot;"}, {'\'', "&apos;"}, {'<', "&lt;"}, {'>', "&gt;"}}};

/// Returns the character of an entity with a number, such as "&#10;" or "&#xA;" (ASCII only), or nothing.
std::optional<char> numbered(std::string_view entity) {
  if (entity.size() < 4 || !entity.starts_with("&#") || entity.back() != ';') return std::nullopt;
  const bool hex = entity[2] == 'x';
  int value = 0;
  for (const char c : entity.substr(hex ? 3 : 2, entity.size() - (hex ? 4 : 3))) {
    const std::string_view digits = "0123456789abcdef";
    const std::size_t digit = digits.find(static_cast<char>(c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c));
    if (digit == std::string_view::npos || (!hex && digit > 9)) return std::nullopt;
    value = value * (hex ? 16 : 10) + static_cast<int>(digit);
    if (value > 127) return std::nullopt;
  }
  return static_cast<char>(value);
}

}  // namespace

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto* entity =
        std::find_if(kEntities.begin(), kEntities.end(), [&](const Entity& e) { return e.character == c; });
    if (entity != kEntities.end()) {
      out += entity->text;
    } else if (c == '\n' || c == '\t' || c == '\r') {
      out += "&#" + std::to_string(static_cast<int>(c)) + ";";
    } else {
      out += c;
    }
  }
  return out;
}

std::string xml_unescaped(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text[at] == '&' ? text.find(';', at) : std::string::npos;
    const std::string_view entity =
        end == std::string::npos ? std::string_view() : std::string_view(text).substr(at, end - at + 1);
    const auto* known =
        std::find_if(kEntities.begin(), kEntities.end(), [&](const Entity& e) { return e.text == entity; });
    if (known != kEntities.end()) {
      out += known->character;
      at = end + 1;
    } else if (const auto character = numbered(entity)) {
      out += *character;
      at = end + 1;
    } else {
      out += text[at++];
    }
  }
  return out;
}

std::string change_attributes(const std::string& xml,
                              const std::function<std::optional<std::string>(const XmlAttribute&)>& change) {
  std::string out;
  XmlAttribute attribute;
  std::size_t at = 0;
  while (at < xml.size()) {
    if (xml[at] == '<') {  // the name of a tag follows
      const std::size_t end = xml.find_first_of(" \t\n/>", at + 1);
      attribute = {xml.substr(at + 1, std::min(end, xml.size()) - at - 1), "", "", ""};
    }
    if (xml.compare(at, 2, "=\"") != 0) {
      out += xml[at++];
      continue;
    }
    const std::size_t name = xml.find_last_of(" \t\n", at) + 1, begin = at + 2;
    const std::size_t end = std::min(xml.find('"', begin), xml.size());
    attribute.name = xml.substr(name, at - name);
    attribute.previous = attribute.value;
    attribute.value = xml_unescaped(xml.substr(begin, end - begin));
    const std::optional<std::string> changed = change(attribute);
    out += "=\"" + (changed ? xml_escaped(*changed) : xml.substr(begin, end - begin)) + "\"";
    at = end + 1;
  }
  return out;
}

}  // namespace taxel
