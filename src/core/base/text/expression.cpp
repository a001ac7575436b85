// Units with their kinds, and a parser of arithmetic with them.
//
// A quantity is a number, a unit as a factor and a power of ten, and a kind: the exponents of metre, kilogram, second
// and radian. Products add exponents; sums need equal kinds. The parser is a recursive descent by the usual precedence:
// sums, products, signs, powers, and then numbers, parentheses, functions and units, where a unit behind a value
// multiplies it ("3 mm", "2 N/4 mm^2").
//
// Pitfall: decimal factors are kept as powers of ten and applied once at the end, and a sum is computed in the finer of
// its two units, so that a number is multiplied and not divided. The depth of nesting is limited.
#include "core/base/text/expression.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string>

#include "core/base/error.h"
#include "core/base/math.h"

namespace taxel {
namespace {

struct Unit {
  std::string_view name;
  int decimal;
  Kind kind;
  double factor = 1;
};

constexpr Unit kUnits[] = {{"nm", -9, kLength},
                           {"um", -6, kLength},
                           {"\u00b5m", -6, kLength},
                           {"\u03bcm", -6, kLength},
                           {"mm", -3, kLength},
                           {"cm", -2, kLength},
                           {"m", 0, kLength},
                           {"in", -4, kLength, 254},
                           {"deg", 0, kAngle, kPi / 180},
                           {"\u00b0", 0, kAngle, kPi / 180},
                           {"rad", 0, kAngle},
                           {"mg", -6, kMass},
                           {"g", -3, kMass},
                           {"kg", 0, kMass},
                           {"us", -6, kTime},
                           {"\u00b5s", -6, kTime},
                           {"\u03bcs", -6, kTime},
                           {"ms", -3, kTime},
                           {"s", 0, kTime},
                           {"min", 0, kTime, 60},
                           {"Hz", 0, kFrequency},
                           {"kHz", 3, kFrequency},
                           {"mN", -3, kForce},
                           {"N", 0, kForce},
                           {"kN", 3, kForce},
                           {"Pa", 0, kPressure},
                           {"hPa", 2, kPressure},
                           {"kPa", 3, kPressure},
                           {"MPa", 6, kPressure},
                           {"GPa", 9, kPressure},
                           {"bar", 5, kPressure}};

struct KindName {
  Kind kind;
  const char* name;
};
constexpr KindName kKindNames[] = {{kPlain, "a number without a unit"},
                                   {kLength, "a length"},
                                   {kAngle, "an angle"},
                                   {kMass, "a mass"},
                                   {kTime, "a time"},
                                   {kFrequency, "a frequency"},
                                   {kForce, "a force"},
                                   {kPressure, "a pressure"},
                                   {{{2, 0, 0, 0}}, "an area"},
                                   {{{-2, 0, 0, 0}}, "a number per area"},
                                   {{{1, 0, -1, 0}}, "a speed"}};

double times_power_of_ten(double v, int decimal) {
  return decimal < 0 ? v / std::pow(10.0, -decimal) : v * std::pow(10.0, decimal);
}

}  // namespace

std::optional<Quantity> unit_named(std::string_view name) {
  for (const Unit& unit : kUnits)
    if (unit.name == name) return Quantity{1, unit.factor, unit.decimal, unit.kind};
  return std::nullopt;
}

std::string name_of(const Kind& kind) {
  for (const KindName& entry : kKindNames)
    if (entry.kind == kind) return entry.name;
  const std::array<const char*, 4> symbols = {"m", "kg", "s", "rad"};
  std::string text = "in";
  for (std::size_t i = 0; i < symbols.size(); ++i)
    if (const int e = kind.exponents[i]; e != 0)
      text += e == 1 ? fmt::format(" {}", symbols[i]) : fmt::format(" {}^{}", symbols[i], e);
  return text;
}

double number_in(const Quantity& q, const Quantity& like) {
  const double number = q.factor == like.factor ? q.number : q.number * (q.factor / like.factor);
  return times_power_of_ten(number, q.decimal - like.decimal);
}

double times_unit(double number, double factor) {
  const double parts = std::round(1 / factor);
  return factor < 1 && 1 / factor == parts ? number / parts : number * factor;
}

Quantity product(const Quantity& a, const Quantity& b, int sign) {
  Quantity out = a;
  out.number = sign > 0 ? a.number * b.number : a.number / b.number;
  out.factor = sign > 0 ? a.factor * b.factor : a.factor / b.factor;
  out.decimal += sign * b.decimal;
  for (std::size_t i = 0; i < out.kind.exponents.size(); ++i) out.kind.exponents[i] += sign * b.kind.exponents[i];
  return out;
}

namespace {

double plain_number(const Quantity& q) {
  return number_in(q, {});
}

bool starts_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (static_cast<unsigned char>(c) & 0x80U) != 0;
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Recursive-descent parser. Each function reads the construct in its name and stops behind it.
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  Quantity all() {
    if (peek() == '\0') fail(at_, "a number is expected");
    const Quantity q = sum();
    if (peek() == ',') fail(at_, "the decimal sign is '.', not ','");
    if (peek() != '\0') fail(at_, fmt::format("'{}' is not expected here", word_here()));
    return q;
  }

  [[noreturn]] void fail(std::size_t at, const std::string& message) const {
    std::size_t character = 1;
    for (std::size_t i = 0; i < at && i < text_.size(); ++i)
      character += (static_cast<unsigned char>(text_[i]) & 0xC0U) != 0x80U;
    throw Error("", fmt::format("character {}", character), message);
  }

 private:
  static constexpr int kMaxDepth = 100;

  char peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool accept(std::string_view token) {
    peek();
    if (text_.substr(at_, token.size()) != token) return false;
    at_ += token.size();
    return true;
  }
  /// Returns the name or the single character at the current position, for messages.
  std::string word_here() {
    peek();
    std::size_t end = at_;
    while (end < text_.size() && starts_name(text_[end])) ++end;
    return std::string(text_.substr(at_, std::max<std::size_t>(end - at_, 1)));
  }

  Quantity sum() {
    if (++depth_ > kMaxDepth) fail(at_, fmt::format("is nested deeper than {} levels", kMaxDepth));
    Quantity left = term();
    while (peek() == '+' || peek() == '-') {
      const std::size_t at = at_;
      const double sign = text_[at_++] == '+' ? 1 : -1;
      const Quantity right = term();
      if (left.kind != right.kind)
        fail(at, fmt::format("{} and {} cannot be added", name_of(left.kind), name_of(right.kind)));
      // The sum is in the finer of the two units: then the other number is multiplied, not divided.
      const Quantity& unit = right.decimal < left.decimal ? right : left;
      const double number = number_in(left, unit) + sign * number_in(right, unit);
      left.factor = unit.factor;
      left.decimal = unit.decimal;
      left.number = number;
    }
    --depth_;
    return left;
  }

  Quantity term() {
    Quantity left = signed_power();
    while (peek() == '*' || peek() == '/') {
      const std::size_t at = at_;
      const int sign = text_[at_++] == '*' ? 1 : -1;
      const Quantity right = signed_power();
      if (sign < 0 && right.number == 0.0) fail(at, "division by zero");
      left = product(left, right, sign);
    }
    return left;
  }

  Quantity signed_power() {
    double sign = 1;
    for (; peek() == '+' || peek() == '-'; ++at_) sign = text_[at_] == '-' ? -sign : sign;
    Quantity q = power();
    q.number *= sign;
    return q;
  }

  Quantity power() {
    const Quantity base = primary();
    const std::size_t at = (peek(), at_);
    if (!accept("^")) return base;
    if (++depth_ > kMaxDepth) fail(at, fmt::format("is nested deeper than {} levels", kMaxDepth));
    const Quantity exponent = signed_power();
    --depth_;
    if (!exponent.kind.plain()) fail(at, "an exponent is a number without a unit");
    return raised(base, plain_number(exponent), at);
  }

  Quantity raised(const Quantity& base, double exponent, std::size_t at) const {
    Quantity out{std::pow(plain_or_own(base), exponent), 1, 0, {}};
    if (std::isnan(out.number)) fail(at, "a negative number has no such power");
    if (base.kind.plain()) return out;
    const double most = 9;
    if (exponent != std::floor(exponent) || std::abs(exponent) > most)
      fail(at, "the power of a unit is a whole number, at most 9");
    const int n = static_cast<int>(exponent);
    out.factor = std::pow(base.factor, n);
    out.decimal = base.decimal * n;
    for (std::size_t i = 0; i < out.kind.exponents.size(); ++i) out.kind.exponents[i] = base.kind.exponents[i] * n;
    return out;
  }
  static double plain_or_own(const Quantity& q) { return q.kind.plain() ? plain_number(q) : q.number; }

  /// Reads a number, a parenthesis, a function, pi or a unit, and the units that follow.
  Quantity primary() {
    const char c = peek();
    Quantity q;
    if (is_digit(c) || c == '.') {
      q = number();
    } else if (accept("(")) {
      q = sum();
      close();
    } else if (starts_name(c)) {
      q = named();
    } else if (c == '\0') {
      fail(at_, "a number is expected, the text ends");
    } else {
      fail(at_, fmt::format("a number is expected, not '{}'", word_here()));
    }
    while (starts_name(peek())) q = product(q, unit(), 1);
    return q;
  }

  void close() {
    if (!accept(")"))
      fail(at_, peek() == '\0' ? "a ')' is missing" : fmt::format("a ')' is expected, not '{}'", word_here()));
  }

  Quantity number() {
    Quantity q;
    const char* const begin = text_.data() + at_;
    const auto read = std::from_chars(begin, text_.data() + text_.size(), q.number);
    if (read.ec == std::errc::result_out_of_range) fail(at_, "is a number that is too large or too small");
    if (read.ec != std::errc()) fail(at_, fmt::format("a number is expected, not '{}'", word_here()));
    at_ += static_cast<std::size_t>(read.ptr - begin);
    if (at_ < text_.size() && (text_[at_] == '.' || is_digit(text_[at_]))) fail(at_, "a number has one decimal point");
    return q;
  }

  std::string_view take_name() {
    peek();
    const std::size_t begin = at_;
    while (at_ < text_.size() && starts_name(text_[at_]) && !superscript()) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  /// Returns 2 or 3 if ² or ³ is at the current position, or 1.
  [[nodiscard]] int superscript() const {
    const std::string_view here = text_.substr(at_, 2);
    return here == "\u00b2" ? 2 : here == "\u00b3" ? 3 : 0;
  }

  Quantity named() {
    const std::size_t at = at_;
    const std::string_view name = take_name();
    if (name == "pi") return {kPi, 1, 0, {}};
    if (peek() == '(') {
      if (const auto q = function(name)) return *q;
      fail(at, fmt::format("there is no function '{}'", name));
    }
    at_ = at;
    return unit();
  }

  /// Reads one unit with its power.
  Quantity unit() {
    peek();
    const std::size_t at = at_;
    const std::string_view name = take_name();
    const std::optional<Quantity> found = unit_named(name);
    if (!found) fail(at, fmt::format("there is no unit '{}'", name));
    if (const int n = superscript(); n != 0) {
      at_ += 2;
      return raised(*found, n, at);
    }
    const std::size_t hat = (peek(), at_);
    if (!accept("^")) return *found;
    const bool negative = accept("-");
    if (!is_digit(peek())) fail(at_, "the power of a unit is a whole number, at most 9");
    const double exponent = number().number;
    return raised(*found, negative ? -exponent : exponent, hat);
  }

  std::optional<Quantity> function(std::string_view name) {
    struct Function {
      std::string_view name;
      double (*compute)(double);
      bool of_angle = false, gives_angle = false;
    };
    static constexpr Function kFunctions[] = {{"sin", std::sin, true},          {"cos", std::cos, true},
                                              {"tan", std::tan, true},          {"asin", std::asin, false, true},
                                              {"acos", std::acos, false, true}, {"atan", std::atan, false, true}};
    const std::size_t at = at_;
    if (name == "abs" || name == "sqrt") {
      Quantity q = argument();
      if (name == "abs") q.number = std::abs(q.number);
      return name == "abs" ? q : root(q, at);
    }
    for (const Function& f : kFunctions) {
      if (f.name != name) continue;
      const Quantity q = argument();
      const Kind needed = f.of_angle ? kAngle : kPlain;
      if (q.kind != needed) fail(at, fmt::format("{} is of {}, not of {}", name, name_of(needed), name_of(q.kind)));
      const double value = f.compute(plain_number(q));
      if (std::isnan(value)) fail(at, fmt::format("{} of {} is not a number", name, plain_number(q)));
      return Quantity{value, 1, 0, f.gives_angle ? kAngle : kPlain};
    }
    return std::nullopt;
  }
  Quantity argument() {
    accept("(");
    const Quantity q = sum();
    close();
    return q;
  }
  Quantity root(const Quantity& q, std::size_t at) const {
    Quantity out{std::sqrt(plain_number(q)), 1, 0, {}};
    if (std::isnan(out.number)) fail(at, "a negative number has no root");
    for (std::size_t i = 0; i < out.kind.exponents.size(); ++i) {
      if (q.kind.exponents[i] % 2 != 0) fail(at, fmt::format("the root of {} has no unit", name_of(q.kind)));
      out.kind.exponents[i] = q.kind.exponents[i] / 2;
    }
    return out;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

double evaluate(std::string_view text, std::string_view unit) {
  Parser parser(text);
  const Quantity result = parser.all();
  const Quantity field = unit.empty() ? Quantity{1, 1, 0, {}} : Parser(unit).all();
  double value = plain_number(result);
  if (!result.kind.plain()) {
    if (result.kind != field.kind)
      parser.fail(0, fmt::format("this is {}, {} is needed", name_of(result.kind), name_of(field.kind)));
    value = number_in(result, field) / field.number;
  }
  if (!std::isfinite(value)) parser.fail(0, "the result is too large");
  return value;
}

}  // namespace taxel
