// JSON text as all files of the project have it. The functions are templates over the JSON type, so that the library
// stays in the *_json.cpp files that use it; Json is nlohmann::ordered_json there.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"

namespace taxel {

/// Largest depth of nested arrays and objects in a layout or a case. Deeper documents are refused because printing
/// recurses.
inline constexpr int kMaxJsonNesting = 64;

/// Largest number of keys of an object. The library searches all keys, which it keeps in order, for each new one.
inline constexpr std::size_t kMaxJsonKeys = 10'000;

/// True if a text is well-formed UTF-8 (RFC 3629), the only text that a JSON file can hold.
inline bool is_utf8(std::string_view text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const std::size_t length = lead < 0x80         ? 1
                               : lead >> 5 == 0x6  ? 2
                               : lead >> 4 == 0xE  ? 3
                               : lead >> 3 == 0x1E ? 4
                                                   : 0;
    if (length == 0 || i + length > text.size()) return false;
    char32_t point = length == 1 ? lead : lead & (0x7FU >> length);
    for (std::size_t k = 1; k < length; ++k) {
      const auto next = static_cast<unsigned char>(text[i + k]);
      if (next >> 6 != 0x2) return false;
      point = (point << 6) | (next & 0x3FU);
    }
    constexpr char32_t kFirst[] = {0, 0, 0x80, 0x800, 0x10000};  // first code point by length
    if (point < kFirst[length] || point > 0x10FFFF || (point >= 0xD800 && point <= 0xDFFF)) return false;
    i += length;
  }
  return true;
}

/// A key as part of a JSON pointer (RFC 6901).
inline std::string escaped_key(std::string_view key) {
  std::string out;
  for (const char c : key) {
    if (c == '~')
      out += "~0";
    else if (c == '/')
      out += "~1";
    else
      out += c;
  }
  return out;
}

/// Line and column, both from 1, of the byte before `offset` (where the parser gave up).
inline std::pair<int, int> line_and_column(const std::string& text, std::size_t offset) {
  int line = 1, column = 1;
  for (std::size_t i = 0; i + 1 < std::min(offset, text.size() + 1); ++i) {
    const bool continues_character = (static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U;
    if (text[i] == '\n')
      ++line, column = 1;
    else if (!continues_character)
      ++column;
  }
  return {line, column};
}

/// Returns a quotation for a message. Of a long text only the beginning and the end are quoted, cut between characters
/// of UTF-8.
inline std::string short_quote(const std::string& text) {
  constexpr std::size_t kMax = 240, kHead = 150, kTail = 70;
  if (text.size() <= kMax) return text;
  const auto boundary = [&](std::size_t at) {
    while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) --at;
    return at;
  };
  return text.substr(0, boundary(kHead)) + " ... " + text.substr(boundary(text.size() - kTail));
}

/// Parses a whole text. Throws Error with line and column if the text is not JSON, and Error if it would be read
/// ambiguously (a repeated key), could not be printed again (deep nesting) or would take quadratic time (objects of
/// many keys).
template <class Json>
Json parse_json(const std::string& text, const std::string& file, int max_nesting = kMaxJsonNesting) {
  std::vector<std::set<std::string>> keys;
  const typename Json::parser_callback_t watch = [&](int depth, typename Json::parse_event_t event, Json& parsed) {
    if (depth > max_nesting) throw Error(file, fmt::format("is nested deeper than {} levels", max_nesting));
    if (event == Json::parse_event_t::object_start) keys.emplace_back();
    if (event == Json::parse_event_t::object_end) keys.pop_back();
    if (event == Json::parse_event_t::key && keys.back().size() >= kMaxJsonKeys)
      throw Error(file, fmt::format("has an object of more than {} keys", kMaxJsonKeys));
    if (event == Json::parse_event_t::key && !keys.back().insert(parsed.template get<std::string>()).second)
      throw Error(file, fmt::format("has the key {} twice in one object", short_quote(parsed.dump())));
    return true;
  };
  try {
    return Json::parse(text, watch);
  } catch (const typename Json::parse_error& e) {
    const auto [line, column] = line_and_column(text, e.byte);
    std::string why = e.what();
    const std::size_t detail = why.find(": ");
    if (detail != std::string::npos) why = why.substr(detail + 2);
    throw Error(file, fmt::format("line {}, column {}", line, column), "is not JSON: " + short_quote(why));
  } catch (const typename Json::exception& e) {  // a number that no double holds
    std::string why = e.what();
    const std::size_t detail = why.find("] ");
    throw Error(file, "is not JSON: " + short_quote(detail == std::string::npos ? why : why.substr(detail + 2)));
  }
}

/// Returns the shortest text that reads back exactly; whole numbers have no decimal point. Throws Error with the
/// pointer if the number is not finite.
template <class Json>
Json json_number(double v, const std::string& pointer) {
  if (!std::isfinite(v)) throw Error("", pointer, fmt::format("must be finite to be written, is {}", v));
  const double exact_limit = 1e15;
  if (v == std::floor(v) && std::abs(v) < exact_limit && !(v == 0.0 && std::signbit(v)))
    return static_cast<std::int64_t>(v);
  return v;
}

template <class Json>
Json json_vector(const dvec3& v, const std::string& pointer) {
  return {json_number<Json>(v.x, pointer + "/0"), json_number<Json>(v.y, pointer + "/1"),
          json_number<Json>(v.z, pointer + "/2")};
}

/// Returns a value on one line.
template <class Json>
std::string json_line(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <class Json>
void print_json(const Json& json, const std::string& indent, std::string& out) {
  const bool nested = json.is_structured() && std::any_of(json.begin(), json.end(), [&](const Json& item) {
                        return json.is_object() || item.is_structured();
                      });
  if (!json.is_structured() || json.empty()) {
    out += json_line(json);
    return;
  }
  const std::string inner = indent + "  ";
  const char* separator = "";
  out += json.is_object() ? "{" : "[";
  for (const auto& [key, item] : json.items()) {
    out += separator;
    if (nested) out += "\n" + inner;
    if (json.is_object()) out += json_line(Json(key)) + ": ";
    print_json(item, inner, out);
    separator = nested ? "," : ", ";
  }
  if (nested) out += "\n" + indent;
  out += json.is_object() ? "}" : "]";
}

/// Returns a document indented by two spaces, with one key per line, arrays of plain values on one line and a newline
/// at the end.
template <class Json>
std::string json_text(const Json& json) {
  std::string text;
  print_json(json, "", text);
  return text + "\n";
}

}  // namespace taxel
