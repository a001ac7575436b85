#include "core/layout/formats/text/yaml_value.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>

#include <charconv>
#include <cmath>
#include <sstream>

#include "core/base/error.h"

namespace taxel {
namespace {

/// Largest size of a file. A sensor description of ten thousand taxels has less than 1 MB, and the parser needs up to
/// three hundred times the memory of its text.
constexpr std::size_t kMaxBytes = 2u << 20;

std::string line_text(const YAML::Mark& mark) {
  return mark.line >= 0 ? fmt::format("line {}", mark.line + 1) : "";
}

/// Throws Error for a text on which the parser does not end: yaml-cpp never consumes a comma outside of brackets and
/// returns empty documents for ever.
class StandstillCheck : public YAML::EventHandler {
 public:
  explicit StandstillCheck(const std::string& file) : file_(file) {}
  void OnDocumentStart(const YAML::Mark& mark) override {
    if (mark.pos == last_) throw Error(file_, line_text(mark), "is no YAML: a document cannot begin here");
    last_ = mark.pos;
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {}
  void OnMapEnd() override {}

 private:
  const std::string& file_;
  int last_ = -1;  ///< position of the previous document in the text
};

void check_for_standstill(const std::string& text, const std::string& file) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  StandstillCheck check(file);
  while (parser.HandleNextDocument(check)) continue;
}

}  // namespace

std::string YamlValue::place() const {
  const std::string line = line_text(node_.Mark());
  if (key_.empty()) return line;
  return line.empty() ? "key " + key_ : line + ", key " + key_;
}

void YamlValue::fail(const std::string& message) const {
  throw Error(*file_, place(), message);
}

std::string YamlValue::shown() const {
  if (node_.IsMap()) return "a map";
  if (node_.IsSequence()) return fmt::format("a list of {}", node_.size());
  if (node_.IsNull()) return "empty";
  const std::string& value = node_.Scalar();
  return value.size() > 60 ? "a long text" : "\"" + value + "\"";
}

void YamlValue::fail_expected(const std::string& expected) const {
  fail(fmt::format("must be {}, is {}", expected, shown()));
}

std::string YamlValue::text() const {
  if (!node_.IsScalar()) fail_expected("a text");
  return node_.Scalar();
}

double YamlValue::number() const {
  const bool quoted = node_.IsScalar() && node_.Tag() == "!";
  if (!node_.IsScalar() || quoted) fail_expected("a number");
  const std::string& written = node_.Scalar();
  const char* const begin = written.data() + (written.starts_with('+') ? 1 : 0);
  const char* const end = written.data() + written.size();
  double value = 0;
  const auto read = std::from_chars(begin, end, value);
  const std::string word = written.substr(
      written.find_first_not_of("+-.") == std::string::npos ? written.size() : written.find_first_not_of("+-."));
  const bool not_finite = word == "nan" || word == "NaN" || word == "NAN" || word == "inf" || word == "Inf" ||
                          word == "INF" || read.ec == std::errc::result_out_of_range;
  if (not_finite) fail_expected("a finite number");
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(value)) fail_expected("a number");
  return value;
}

dvec3 YamlValue::vector() const {
  if (!node_.IsSequence() || node_.size() != 3) fail_expected("a list of 3 numbers");
  const std::vector<YamlValue> parts = items();
  return {parts[0].number(), parts[1].number(), parts[2].number()};
}

std::vector<YamlValue> YamlValue::items() const {
  if (!node_.IsSequence()) fail_expected("a list");
  std::vector<YamlValue> found;
  found.reserve(node_.size());
  for (const YAML::Node& item : node_) found.emplace_back(item, *file_, fmt::format("{}[{}]", key_, found.size()));
  return found;
}

std::map<std::string, YamlValue> YamlValue::entries() const {
  if (!node_.IsMap()) fail_expected("a map");
  std::map<std::string, YamlValue> found;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) YamlValue(entry.first, *file_, key_).fail("a key must be a text");
    const std::string name = entry.first.Scalar();
    const auto [at, fresh] = found.emplace(name, YamlValue(entry.second, *file_, name));
    if (!fresh) YamlValue(entry.first, *file_, name).fail("is listed twice");
  }
  return found;
}

std::vector<YamlValue> parse_yaml(const std::string& text, const std::string& file) {
  if (text.size() > kMaxBytes)
    throw Error(file, fmt::format("has {} bytes: a sensor description has at most {}", text.size(), kMaxBytes));
  try {
    check_for_standstill(text, file);
    std::vector<YamlValue> documents;
    for (const YAML::Node& document : YAML::LoadAll(text)) documents.emplace_back(document, file, "");
    return documents;
  } catch (const YAML::Exception& e) {
    throw Error(file, line_text(e.mark), "is no YAML: " + e.msg);
  }
}

}  // namespace taxel
