// JSON values that know where in their document they stand, for files whose unknown keys are kept. Written over the
// JSON type, like core/base/json_text.h.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/math.h"
#include "core/layout/words.h"

namespace taxel {

/// A value for messages: short values as they are, long ones by their kind.
template <class Json>
std::string shown_json(const Json& value) {
  const std::string text = json_line(value);
  if (text.size() <= 60) return text;
  return value.is_object() ? "an object" : value.is_array() ? "an array" : "a long " + std::string(value.type_name());
}

/// What all readers of one document share.
struct JsonDocument {
  std::string file;
  std::map<std::string, std::string> unknown;
};

/// One JSON value and the pointer to it.
template <class Json>
class JsonValue {
 public:
  JsonValue(const Json& json, std::string pointer, JsonDocument& document)
      : json_(json), pointer_(std::move(pointer)), document_(document) {}

  [[noreturn]] void fail(const std::string& expected) const {
    throw Error(document_.file, pointer_, fmt::format("must be {}, is {}", expected, shown_json(json_)));
  }
  [[nodiscard]] double number() const {
    if (!json_.is_number()) fail("a number");
    return json_.template get<double>();
  }
  [[nodiscard]] bool flag() const {
    if (!json_.is_boolean()) fail("true or false");
    return json_.template get<bool>();
  }
  [[nodiscard]] bool is_text() const { return json_.is_string(); }
  [[nodiscard]] std::string text() const {
    if (!json_.is_string()) fail("a text");
    return json_.template get<std::string>();
  }
  [[nodiscard]] std::uint64_t natural() const {
    if (json_.is_number_unsigned()) return json_.template get<std::uint64_t>();
    const double exact_limit = 0x1.0p53;
    const double v = json_.is_number_float() ? json_.template get<double>() : -1.0;
    if (!(v >= 0.0 && v <= exact_limit && v == std::floor(v))) fail("a whole number, 0 or more");
    return static_cast<std::uint64_t>(v);
  }
  [[nodiscard]] int small_integer() const {
    const double v = json_.is_number() ? json_.template get<double>() : 0.5;
    const double limit = std::numeric_limits<int>::max();
    if (!(v == std::floor(v) && std::abs(v) <= limit)) fail("a whole number of at most 31 bits");
    return static_cast<int>(v);
  }
  [[nodiscard]] dvec3 vector() const {
    if (!json_.is_array() || json_.size() != 3) fail("an array of 3 numbers");
    return {item(0).number(), item(1).number(), item(2).number()};
  }
  template <class E>
  [[nodiscard]] E word() const {
    if (!json_.is_string()) fail("a text");
    const std::optional<E> value = from_word<E>(json_.template get<std::string>());
    if (!value) fail("one of " + word_list<E>());
    return *value;
  }
  [[nodiscard]] std::size_t array_size() const {
    if (!json_.is_array()) fail("an array");
    return json_.size();
  }
  [[nodiscard]] JsonValue item(std::size_t i) const { return {json_[i], fmt::format("{}/{}", pointer_, i), document_}; }

 protected:
  const Json& json_;
  std::string pointer_;
  JsonDocument& document_;
};

/// An object whose keys are taken one by one; what is left over at the end is kept as unknown.
template <class Json>
class JsonObject : public JsonValue<Json> {
 public:
  using Value = JsonValue<Json>;
  explicit JsonObject(const Value& value) : Value(value) {
    if (!json_.is_object()) fail("an object");
  }
  /// Calls take(value) where the key stands; the default stays otherwise.
  template <class Take>
  void optional(const char* key, const Take& take) {
    known_.insert(key);
    const auto found = json_.find(key);
    if (found != json_.end()) take(Value(*found, pointer_ + "/" + key, document_));
  }
  [[nodiscard]] Value required(const char* key) {
    known_.insert(key);
    const auto found = json_.find(key);
    if (found == json_.end()) throw Error(document_.file, pointer_ + "/" + key, "is missing");
    return {*found, pointer_ + "/" + key, document_};
  }
  void number(const char* key, std::optional<double>& out) {
    optional(key, [&](const Value& v) { out = v.number(); });
  }
  void number(const char* key, double& out) {
    optional(key, [&](const Value& v) { out = v.number(); });
  }
  void vector(const char* key, dvec3& out) {
    optional(key, [&](const Value& v) { out = v.vector(); });
  }
  void text(const char* key, std::string& out) {
    optional(key, [&](const Value& v) { out = v.text(); });
  }
  template <class E>
  void word(const char* key, E& out) {
    optional(key, [&](const Value& v) { out = v.template word<E>(); });
  }
  void keep_unknown() const {
    for (const auto& [key, value] : json_.items())
      if (!known_.contains(key)) document_.unknown[pointer_ + "/" + escaped_key(key)] = json_line(value);
  }

 private:
  using Value::document_;
  using Value::fail;
  using Value::json_;
  using Value::pointer_;
  std::set<std::string> known_;
};

}  // namespace taxel
