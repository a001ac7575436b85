#include "core/layout/generators/pattern_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "core/base/text/expression.h"

namespace taxel {
namespace {

constexpr double kRadiusOfPitch = 0.8;  ///< default radius of a receptive field in pitches

std::string unit_of(const FieldSpec& field) {
  if (field.quantity == FieldQuantity::length) return "m";
  return field.quantity == FieldQuantity::angle ? "deg" : "";
}

template <class Value>
std::string text_of(const Value& value) {
  if constexpr (std::is_enum_v<Value>)
    return std::string(to_word(value));
  else if constexpr (std::is_same_v<Value, std::string>)
    return value;
  else
    return fmt::format("{}", value);
}

/// Returns the value of a text with arithmetic and units. Throws Error naming the key.
double number_of(const FieldSpec& field, const std::string& text) {
  try {
    return evaluate(text, unit_of(field));
  } catch (const Error& error) {
    throw Error("", field.key, fmt::format("\"{}\": {}", text, error.message()));
  }
}

template <class Value>
void set_value(const FieldSpec& field, const std::string& text, Value& value) {
  if constexpr (std::is_same_v<Value, std::string>) {
    value = text;
  } else if constexpr (std::is_same_v<Value, bool>) {
    if (text != "true" && text != "false")
      throw Error("", field.key, fmt::format("must be true or false, is \"{}\"", text));
    value = text == "true";
  } else if constexpr (std::is_enum_v<Value>) {
    const auto word = from_word<Value>(text);
    if (!word) throw Error("", field.key, fmt::format("must be one of {}, is \"{}\"", word_list<Value>(), text));
    value = *word;
  } else {
    const double number = number_of(field, text);
    if constexpr (std::is_integral_v<Value>) {
      const double low = std::is_signed_v<Value> ? -2e9 : 0.0, high = 2e9;
      if (number != std::floor(number) || number < low || number > high)
        throw Error("", field.key, fmt::format("must be a whole number, is \"{}\"", text));
    }
    value = static_cast<Value>(number);
  }
}

std::string_view word_of(const PatternShape& shape) {
  return std::visit([](const auto& kind) { return std::remove_cvref_t<decltype(kind)>::kWord; }, shape);
}

/// Returns a pattern of the kind with default values. Throws Error for an unknown kind.
Pattern default_pattern(std::string_view kind) {
  for (const PatternShape& shape : each_alternative<PatternShape>()) {
    if (word_of(shape) != kind) continue;
    Pattern pattern;
    pattern.shape = shape;
    return pattern;
  }
  const std::vector<std::string> words = pattern_words();
  const std::vector<std::string_view> candidates(words.begin(), words.end());
  throw Error(
      "", "pattern",
      fmt::format("must be one of {}, is \"{}\"{}", fmt::join(words, ", "), kind, meant_word(kind, candidates)));
}

std::vector<std::string> keys_of(const Pattern& pattern) {
  std::vector<std::string> keys;
  visit_fields(pattern, [&](const FieldSpec& field, const auto& /*value*/) { keys.emplace_back(field.key); });
  return keys;
}

/// Sets the radius from the pitch, or from the smaller one of two pitches.
void set_radius_by_pitch(Pattern& pattern) {
  double pitch = std::numeric_limits<double>::infinity();
  visit_fields(pattern, [&](const FieldSpec& field, auto& value) {
    if constexpr (std::is_same_v<decltype(value), double&>)
      if (std::string_view(field.key).ends_with("pitch")) pitch = std::min(pitch, value);
  });
  if (std::isfinite(pitch)) pattern.radius = kRadiusOfPitch * pitch;
}

}  // namespace

std::vector<std::string> pattern_words() {
  std::vector<std::string> words;
  for (const PatternShape& shape : each_alternative<PatternShape>()) words.emplace_back(word_of(shape));
  return words;
}

std::vector<PatternFieldHelp> pattern_fields() {
  std::vector<PatternFieldHelp> all;
  for (const PatternShape& shape : each_alternative<PatternShape>()) {
    Pattern pattern;
    pattern.shape = shape;
    visit_fields(pattern, [&](const FieldSpec& field, const auto& value) {
      auto known = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.key == field.key; });
      if (known == all.end()) {
        all.push_back({field.key, field.help, unit_of(field), text_of(value), {}});
        known = all.end() - 1;
      }
      known->kinds.emplace_back(word_of(shape));
    });
  }
  return all;
}

Pattern pattern_of_texts(std::string_view kind, const PatternTexts& values) {
  Pattern pattern = default_pattern(kind);
  const std::vector<std::string> keys = keys_of(pattern);
  bool has_radius = false;
  for (const auto& [key, text] : values) {
    if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
      const std::vector<std::string_view> candidates(keys.begin(), keys.end());
      throw Error("", key,
                  fmt::format("is no value of the pattern {}, which has {}{}", kind, fmt::join(keys, ", "),
                              meant_word(key, candidates)));
    }
    has_radius = has_radius || key == "radius";
    visit_fields(pattern, [&, wanted = std::string_view(key), given = std::string_view(text)](const FieldSpec& field,
                                                                                              auto& value) {
      if (wanted == field.key) set_value(field, std::string(given), value);
    });
  }
  if (!has_radius) set_radius_by_pitch(pattern);
  return pattern;
}

}  // namespace taxel
