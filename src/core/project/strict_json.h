// Reading JSON without guessing: every value that is missing, of the wrong type or unknown is an Error with its JSON
// pointer (RFC 6901). Written over the JSON type, so that the library stays in the *_json.cpp files that use it.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/json_text.h"
#include "core/base/math.h"

namespace taxel {

/// One value of a parsed document, with its place. Borrows `json` and `file`.
template <class Json>
class StrictNode {
 public:
  StrictNode(const Json& json, const std::string& file, std::string pointer = "")
      : json_(&json), file_(&file), pointer_(std::move(pointer)) {}

  [[nodiscard]] const std::string& pointer() const { return pointer_; }

  [[noreturn]] void fail(const std::string& message) const { throw Error(*file_, pointer_, message); }
  [[noreturn]] void fail_at(std::string_view key, const std::string& message) const {
    throw Error(*file_, below(key), message);
  }
  [[noreturn]] void wrong(const std::string& expected) const {
    fail(fmt::format("must be {}, is {}", expected, shown()));
  }

  /// Must be an object that holds no key but these.
  void only(std::initializer_list<std::string_view> keys) const {
    must_be_object();
    for (const auto& item : json_->items()) {
      bool known = false;
      for (const std::string_view key : keys) known = known || item.key() == key;
      if (!known) fail_at(item.key(), "unknown key");
    }
  }
  void must_be_object() const {
    if (!json_->is_object()) wrong("an object");
  }
  [[nodiscard]] std::optional<StrictNode> find(const std::string& key) const {
    const auto it = json_->find(key);
    if (it == json_->end()) return std::nullopt;
    return StrictNode(*it, *file_, below(key));
  }
  [[nodiscard]] StrictNode at(const std::string& key) const {
    if (auto node = find(key)) return *node;
    fail_at(key, "is missing");
  }

  [[nodiscard]] double number() const {
    if (!json_->is_number()) wrong("a number");
    return json_->template get<double>();
  }
  [[nodiscard]] std::string text() const {
    if (!json_->is_string()) wrong("a text");
    return json_->template get<std::string>();
  }
  [[nodiscard]] std::vector<double> numbers(std::size_t count) const {
    if (!json_->is_array() || json_->size() != count) wrong(fmt::format("an array of {} numbers", count));
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
      values.push_back(item(i).number());
    }
    return values;
  }
  [[nodiscard]] dvec3 vector3() const {
    const std::vector<double> v = numbers(3);
    return {v[0], v[1], v[2]};
  }
  /// How many values an array holds.
  [[nodiscard]] std::size_t length() const {
    if (!json_->is_array()) wrong("an array");
    return json_->size();
  }
  [[nodiscard]] StrictNode item(std::size_t i) const {
    return StrictNode((*json_)[i], *file_, below(std::to_string(i)));
  }
  void must_not_be_negative(double value) const {
    if (!(value >= 0)) fail(fmt::format("must not be negative, is {}", value));
  }
  void must_be_positive(double value) const {
    if (!(value > 0)) fail(fmt::format("must be greater than 0, is {}", value));
  }

  /// A value for messages; what holds others by its kind only.
  [[nodiscard]] std::string shown() const {
    if (json_->is_object()) return "an object";
    if (json_->is_array()) return fmt::format("an array of {}", json_->size());
    return json_->dump();
  }

 private:
  [[nodiscard]] std::string below(std::string_view key) const { return pointer_ + "/" + escaped_key(key); }

  const Json* json_;
  const std::string* file_;
  std::string pointer_;
};

}  // namespace taxel
