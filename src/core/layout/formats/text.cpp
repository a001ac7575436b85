// Words and numbers of texts, and XML by tinyxml2.

#include "core/layout/formats/text.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <charconv>
#include <cmath>

#include "core/base/error.h"

namespace taxel {

std::vector<std::string_view> split_words(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n\f\v";
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kBlanks); at != std::string_view::npos;) {
    const std::size_t end = text.find_first_of(kBlanks, at);
    words.push_back(text.substr(at, end == std::string_view::npos ? end : end - at));
    at = end == std::string_view::npos ? end : text.find_first_not_of(kBlanks, end);
  }
  return words;
}

std::optional<double> number_of_word(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), value);
  if (read.ec != std::errc() || read.ptr != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string words_of_numbers(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) text += fmt::format("{}{}", text.empty() ? "" : " ", number);
  return text;
}

namespace {

constexpr std::size_t kMaxXmlBytes = 32u << 20;  ///< the parser needs about ten times the memory of its text

std::string shown_attribute(const std::string& text) {
  return text.size() > 60 ? "a long text" : "\"" + text + "\"";
}

/// Returns "mismatched element" for "XML_ERROR_MISMATCHED_ELEMENT".
std::string words_of_error(std::string name) {
  const std::string prefix = "XML_ERROR_";
  if (name.starts_with(prefix)) name.erase(0, prefix.size());
  for (char& c : name) c = c == '_' ? ' ' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return name;
}

}  // namespace

std::string XmlNode::name() const {
  return element_->Name();
}

std::string XmlNode::place(const std::string& attribute) const {
  return fmt::format("line {}, <{}{}{}>", element_->GetLineNum(), element_->Name(), attribute.empty() ? "" : " ",
                     attribute);
}

void XmlNode::fail(const std::string& message, const std::string& attribute) const {
  throw Error(*file_, place(attribute), message);
}

std::optional<std::string> XmlNode::find(const std::string& attribute) const {
  const char* const text = element_->Attribute(attribute.c_str());
  if (text == nullptr) return std::nullopt;
  return text;
}

std::string XmlNode::text(const std::string& attribute) const {
  if (std::optional<std::string> found = find(attribute)) return *found;
  fail("is missing", attribute);
}

std::vector<double> XmlNode::numbers(const std::string& attribute, std::size_t least, std::size_t most) const {
  const std::string written = text(attribute);
  const std::vector<std::string_view> words = split_words(written);
  std::vector<double> numbers;
  for (const std::string_view word : words) {
    const std::optional<double> number = number_of_word(word);
    if (!number || words.size() > most) break;
    numbers.push_back(*number);
  }
  if (numbers.size() != words.size() || numbers.size() < least)
    fail(fmt::format("must be {} finite number{}, is {}",
                     least == most ? fmt::format("{}", most) : fmt::format("{} to {}", least, most),
                     most == 1 ? "" : "s", shown_attribute(written)),
         attribute);
  return numbers;
}

dvec3 XmlNode::vector(const std::string& attribute, const dvec3& if_missing) const {
  if (!find(attribute)) return if_missing;
  const std::vector<double> v = numbers(attribute, 3, 3);
  return {v[0], v[1], v[2]};
}

int XmlNode::integer(const std::string& attribute, int least, int most) const {
  const double value = number(attribute);
  if (value != std::floor(value) || value < least || value > most)
    fail(fmt::format("must be a whole number from {} to {}, is {}", least, most, shown_attribute(text(attribute))),
         attribute);
  return static_cast<int>(value);
}

std::vector<XmlNode> XmlNode::children(const std::string& name) const {
  std::vector<XmlNode> found;
  const char* const wanted = name.empty() ? nullptr : name.c_str();
  for (const tinyxml2::XMLElement* at = element_->FirstChildElement(wanted); at != nullptr;
       at = at->NextSiblingElement(wanted))
    found.emplace_back(*at, *file_);
  return found;
}

std::optional<XmlNode> XmlNode::child(const std::string& name) const {
  const tinyxml2::XMLElement* const found = element_->FirstChildElement(name.c_str());
  if (found == nullptr) return std::nullopt;
  return XmlNode(*found, *file_);
}

XmlFile::XmlFile(const std::string& text, std::string file)
    : file_(std::move(file)), document_(std::make_unique<tinyxml2::XMLDocument>()) {
  if (text.size() > kMaxXmlBytes)
    throw Error(file_, fmt::format("has {} bytes: at most {} of XML are read", text.size(), kMaxXmlBytes));
  document_->Parse(text.data(), text.size());
  if (document_->Error()) {
    const int line = document_->ErrorLineNum();
    throw Error(file_, line > 0 ? fmt::format("line {}", line) : "",
                "is no XML: " + words_of_error(document_->ErrorName()));
  }
  if (document_->RootElement() == nullptr) throw Error(file_, "is no XML: it has no element");
}

XmlFile::~XmlFile() = default;

XmlNode XmlFile::root() const {
  return {*document_->RootElement(), file_};
}

std::string first_element(std::string_view bytes) {
  for (std::size_t at = bytes.find('<'); at != std::string_view::npos; at = bytes.find('<', at + 1)) {
    const std::string_view rest = bytes.substr(at + 1);
    if (rest.starts_with("!--")) {
      const std::size_t end = bytes.find("-->", at);
      if (end == std::string_view::npos) return "";
      at = end;
    } else if (!rest.starts_with('?') && !rest.starts_with('!')) {
      return std::string(rest.substr(0, rest.find_first_of(" \t\r\n/>")));
    }
  }
  return "";
}

std::string xml_attribute(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '&')
      escaped += "&amp;";
    else if (c == '<')
      escaped += "&lt;";
    else if (c == '"')
      escaped += "&quot;";
    else if (c == '\n' || c == '\t' || c == '\r')
      escaped += fmt::format("&#{};", static_cast<int>(c));
    else
      escaped += c;
  }
  return escaped;
}

}  // namespace taxel
