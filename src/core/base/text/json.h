// JSON text as all files of the project have it, and a strict reader: a value that is missing or of the wrong type is
// an Error with its JSON pointer (RFC 6901), and a key that no reader consumes is either an error (JsonNode::only) or
// kept (JsonObject::keep_unknown). All are templates over the JSON type, so that the library stays in the *_json.cpp
// files that use it; Json is nlohmann::ordered_json there.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/text/words.h"

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

/// Returns the word, number or character that contains the byte at `at`, as a message quotes it.
inline std::string quoted_word(const std::string& text, std::size_t at) {
  const auto is_part = [&](std::size_t i) {
    const auto c = static_cast<unsigned char>(text[i]);
    return c >= 0x80 || std::isalnum(c) != 0 || c == '_' || c == '.' || c == '+' || c == '-';
  };
  if (static_cast<unsigned char>(text[at]) < 0x20) return text[at] == '\n' ? "end of a line" : "control character";
  if (text[at] == '"') return "quotation mark";
  std::size_t begin = at, end = at + 1;
  if (is_part(at)) {
    while (begin > 0 && is_part(begin - 1)) --begin;
    while (end < text.size() && is_part(end)) ++end;
  }
  return fmt::format("\"{}\"", short_quote(text.substr(begin, end - begin)));
}

/// Returns why a text is no JSON if the parser gave up after `read` bytes. Versions of the library word their own
/// reasons differently.
inline std::string json_problem(const std::string& text, std::size_t read) {
  if (!is_utf8(text)) return "is not JSON: must be encoded as UTF-8";
  if (read == 0 || read > text.size()) return "is not JSON: ends too early";
  return "is not JSON: unexpected " + quoted_word(text, read - 1);
}

/// Returns the first number of a JSON text that no double holds: its place and its end. Both are the end of the text if
/// there is none.
inline std::pair<std::size_t, std::size_t> find_large_number(const std::string& text) {
  constexpr std::string_view kNumber = "0123456789+-.eE";
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '"') {
      for (++at; at < text.size() && text[at] != '"'; ++at)
        if (text[at] == '\\') ++at;
      continue;
    }
    if (kNumber.substr(0, 12).find(text[at]) == std::string_view::npos) continue;
    const std::size_t end = std::min(text.find_first_not_of(kNumber, at), text.size());
    const std::string_view number = std::string_view(text).substr(at, end - at);
    double value = 0;
    const bool is_out_of_range =
        std::from_chars(number.data(), number.data() + number.size(), value).ec == std::errc::result_out_of_range;
    if (is_out_of_range && number.find("e-") == std::string_view::npos && number.find("E-") == std::string_view::npos)
      return {at, end};
    at = end - 1;
  }
  return {text.size(), text.size()};
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
    throw Error(file, fmt::format("line {}, column {}", line, column), json_problem(text, e.byte));
  } catch (const typename Json::exception&) {  // a number that no double holds
    const auto [begin, end] = find_large_number(text);
    const auto [line, column] = line_and_column(text, begin + 1);
    throw Error(file, fmt::format("line {}, column {}", line, column),
                fmt::format("is not JSON: the number {} is too large", short_quote(text.substr(begin, end - begin))));
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

/// Unknown parts of a document: the JSON of each by its pointer.
using UnknownJson = std::map<std::string, std::string>;

/// One value of a parsed document and the pointer to it. References the document, the file's name and `unknown`, to
/// which JsonObject::keep_unknown() adds.
template <class Json>
class JsonNode {
 public:
  JsonNode(const Json& json, const std::string& file, UnknownJson* unknown = nullptr, std::string pointer = "")
      : json_(&json), file_(&file), unknown_(unknown), pointer_(std::move(pointer)) {}

  [[nodiscard]] const std::string& pointer() const { return pointer_; }
  [[nodiscard]] const Json& json() const { return *json_; }

  [[noreturn]] void fail(const std::string& message) const { throw Error(*file_, pointer_, message); }
  [[noreturn]] void fail_at(std::string_view key, const std::string& message) const {
    throw Error(*file_, below(key), message);
  }
  /// Throws Error for a key that the object lacks. The message names a key of the object that resembles it.
  [[noreturn]] void fail_missing(std::string_view key) const {
    for (const auto& item : json_->items())
      if (const std::string meant = meant_word(item.key(), {&key, 1}); !meant.empty())
        fail_at(key, fmt::format("is missing; there is \"{}\"{}", short_quote(item.key()), meant));
    fail_at(key, "is missing");
  }
  [[noreturn]] void wrong(const std::string& expected) const {
    fail(fmt::format("must be {}, is {}", expected, shown()));
  }

  /// Throws Error unless the value is an object without other keys than these. The message names the known key that an
  /// unknown one resembles.
  void only(std::initializer_list<std::string_view> keys) const {
    must_be_object();
    for (const auto& item : json_->items()) {
      bool is_allowed = false;
      for (const std::string_view key : keys) is_allowed = is_allowed || item.key() == key;
      if (!is_allowed) fail_at(item.key(), "unknown key" + meant_word(item.key(), {keys.begin(), keys.size()}));
    }
  }
  void must_be_object() const {
    if (!json_->is_object()) wrong("an object");
  }
  [[nodiscard]] std::optional<JsonNode> find(const std::string& key) const {
    const auto it = json_->find(key);
    if (it == json_->end()) return std::nullopt;
    return JsonNode(*it, *file_, unknown_, below(key));
  }
  [[nodiscard]] JsonNode at(const std::string& key) const {
    if (auto node = find(key)) return *node;
    fail_missing(key);
  }

  [[nodiscard]] double number() const {
    if (!json_->is_number()) wrong("a number");
    return json_->template get<double>();
  }
  [[nodiscard]] bool flag() const {
    if (!json_->is_boolean()) wrong("true or false");
    return json_->template get<bool>();
  }
  [[nodiscard]] bool is_text() const { return json_->is_string(); }
  [[nodiscard]] std::string text() const {
    if (!json_->is_string()) wrong("a text");
    return json_->template get<std::string>();
  }
  [[nodiscard]] std::uint64_t natural() const {
    if (json_->is_number_unsigned()) return json_->template get<std::uint64_t>();
    const double exact_limit = 0x1.0p53;
    const double v = json_->is_number_float() ? json_->template get<double>() : -1.0;
    if (!(v >= 0.0 && v <= exact_limit && v == std::floor(v))) wrong("a whole number, 0 or more");
    return static_cast<std::uint64_t>(v);
  }
  [[nodiscard]] int small_integer() const {
    const double v = json_->is_number() ? json_->template get<double>() : 0.5;
    const double limit = std::numeric_limits<int>::max();
    if (!(v == std::floor(v) && std::abs(v) <= limit)) wrong("a whole number of at most 31 bits");
    return static_cast<int>(v);
  }
  /// Returns the value of an enumeration that has words_of(E). Throws Error for an unknown word.
  template <class E>
  [[nodiscard]] E word() const {
    const std::optional<E> value = from_word<E>(text());
    if (!value) wrong("one of " + word_list<E>());
    return *value;
  }
  /// Returns the number of values in an array. Throws Error if the value is no array.
  [[nodiscard]] std::size_t length() const {
    if (!json_->is_array()) wrong("an array");
    return json_->size();
  }
  [[nodiscard]] JsonNode item(std::size_t i) const {
    return JsonNode((*json_)[i], *file_, unknown_, below(std::to_string(i)));
  }
  [[nodiscard]] std::vector<double> numbers(std::size_t count) const {
    if (!json_->is_array() || json_->size() != count) wrong(fmt::format("an array of {} numbers", count));
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) values.push_back(item(i).number());
    return values;
  }
  [[nodiscard]] dvec3 vector3() const {
    const std::vector<double> v = numbers(3);
    return {v[0], v[1], v[2]};
  }

  /// Returns the value for messages: a short value as text, a long one as its kind.
  [[nodiscard]] std::string shown() const {
    const std::string text = json_line(*json_);
    if (text.size() <= 60) return text;
    if (json_->is_array()) return fmt::format("an array of {}", json_->size());
    return json_->is_object() ? "an object" : fmt::format("a long {}", json_->type_name());
  }

  /// Adds the keys of this object that are not in `consumed_keys` to the unknown parts of the document.
  void keep_unknown(const std::set<std::string, std::less<>>& consumed_keys) const {
    for (const auto& [key, value] : json_->items())
      if (unknown_ != nullptr && !consumed_keys.contains(key)) (*unknown_)[below(key)] = json_line(value);
  }

 private:
  [[nodiscard]] std::string below(std::string_view key) const { return pointer_ + "/" + escaped_key(key); }

  const Json* json_;
  const std::string* file_;
  UnknownJson* unknown_;
  std::string pointer_;
};

/// Throws Error that names the node unless its value is in the range.
template <class Json>
void must_not_be_negative(const JsonNode<Json>& node, double value) {
  if (!(value >= 0)) node.fail(fmt::format("must not be negative, is {}", value));
}
template <class Json>
void must_be_positive(const JsonNode<Json>& node, double value) {
  if (!(value > 0)) node.fail(fmt::format("must be greater than 0, is {}", value));
}

/// An object whose keys are consumed one by one; keep_unknown() keeps the rest.
template <class Json>
class JsonObject {
 public:
  using Value = JsonNode<Json>;
  explicit JsonObject(const Value& node) : node_(node) { node_.must_be_object(); }

  /// Calls consume(value) if the key exists.
  template <class Consume>
  void optional(const char* key, const Consume& consume) {
    consumed_keys_.insert(key);
    if (const std::optional<Value> value = node_.find(key)) consume(*value);
  }
  [[nodiscard]] Value required(const char* key) {
    consumed_keys_.insert(key);
    return node_.at(key);
  }
  void number(const char* key, std::optional<double>& out) {
    optional(key, [&](const Value& v) { out = v.number(); });
  }
  void number(const char* key, double& out) {
    optional(key, [&](const Value& v) { out = v.number(); });
  }
  void vector(const char* key, dvec3& out) {
    optional(key, [&](const Value& v) { out = v.vector3(); });
  }
  void text(const char* key, std::string& out) {
    optional(key, [&](const Value& v) { out = v.text(); });
  }
  template <class E>
  void word(const char* key, E& out) {
    optional(key, [&](const Value& v) { out = v.template word<E>(); });
  }
  /// Calls read(JsonObject&) with the object of a key that may be missing, and keeps the keys that it does not consume.
  template <class F>
  void part(const char* key, const F& read) {
    optional(key, [&](const auto& value) {
      JsonObject object(value);
      read(object);
      object.keep_unknown();
    });
  }
  void keep_unknown() const { node_.keep_unknown(consumed_keys_); }

 private:
  Value node_;
  std::set<std::string, std::less<>> consumed_keys_;
};

}  // namespace taxel
