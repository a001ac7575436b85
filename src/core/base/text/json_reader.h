// Strict JSON reader: a value that is missing or of the wrong type is an Error with its JSON pointer (RFC 6901), and a
// key that no reader consumes is either an error (JsonNode::only) or kept (JsonObject::keep_unknown). It is a template
// over the JSON type, so that the library stays in the *_json.cpp files that use it.
#pragma once

#include <fmt/format.h>

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
#include "core/base/text/json_text.h"
#include "core/base/text/nearest_word.h"
#include "core/base/text/words.h"

namespace taxel {

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
      bool known = false;
      for (const std::string_view key : keys) known = known || item.key() == key;
      if (!known) fail_at(item.key(), "unknown key" + meant_word(item.key(), {keys.begin(), keys.size()}));
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
  [[nodiscard]] bool is_array() const { return json_->is_array(); }
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
  void must_not_be_negative(double value) const {
    if (!(value >= 0)) fail(fmt::format("must not be negative, is {}", value));
  }
  void must_be_positive(double value) const {
    if (!(value > 0)) fail(fmt::format("must be greater than 0, is {}", value));
  }

  /// Returns the value for messages: a short value as text, a long one as its kind.
  [[nodiscard]] std::string shown() const {
    const std::string text = json_line(*json_);
    if (text.size() <= 60) return text;
    if (json_->is_array()) return fmt::format("an array of {}", json_->size());
    return json_->is_object() ? "an object" : fmt::format("a long {}", json_->type_name());
  }

  /// Adds the keys of this object that are not `known` to the unknown parts of the document.
  void keep_unknown(const std::set<std::string, std::less<>>& known) const {
    for (const auto& [key, value] : json_->items())
      if (unknown_ != nullptr && !known.contains(key)) (*unknown_)[below(key)] = json_line(value);
  }

 private:
  [[nodiscard]] std::string below(std::string_view key) const { return pointer_ + "/" + escaped_key(key); }

  const Json* json_;
  const std::string* file_;
  UnknownJson* unknown_;
  std::string pointer_;
};

/// An object whose keys are consumed one by one; keep_unknown() keeps the rest.
template <class Json>
class JsonObject {
 public:
  using Value = JsonNode<Json>;
  explicit JsonObject(const Value& node) : node_(node) { node_.must_be_object(); }

  /// Calls consume(value) if the key exists.
  template <class Consume>
  void optional(const char* key, const Consume& consume) {
    known_.insert(key);
    if (const std::optional<Value> value = node_.find(key)) consume(*value);
  }
  [[nodiscard]] Value required(const char* key) {
    known_.insert(key);
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
  void keep_unknown() const { node_.keep_unknown(known_); }

 private:
  Value node_;
  std::set<std::string, std::less<>> known_;
};

}  // namespace taxel
