// Numbers in lines and attributes of other programs' files, and elements of XML files with their lines.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/math.h"

namespace taxel {

/// Returns the words of a text, which blanks, tabs and line breaks separate.
std::vector<std::string_view> split_words(std::string_view text);

/// Returns the finite number that a whole word is; nothing for other words. A leading plus is allowed.
std::optional<double> number_of_word(std::string_view word);

/// Returns numbers in the shortest form that reads back, separated by blanks.
std::string words_of_numbers(const std::vector<double>& numbers);

}  // namespace taxel

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace taxel {

/// Refers to an element of an XmlFile, which must live longer. Messages name its line.
class XmlNode {
 public:
  XmlNode(const tinyxml2::XMLElement& element, const std::string& file) : element_(&element), file_(&file) {}

  [[nodiscard]] std::string name() const;
  /// Returns the place for messages: "line 8, <taxel>", with the attribute: "line 8, <taxel xyz>".
  [[nodiscard]] std::string place(const std::string& attribute = "") const;
  /// Throws Error naming the file and the place.
  [[noreturn]] void fail(const std::string& message, const std::string& attribute = "") const;

  [[nodiscard]] std::optional<std::string> find(const std::string& attribute) const;
  /// Returns the text of an attribute, empty if there is none.
  [[nodiscard]] std::string text_or_empty(const std::string& attribute) const { return find(attribute).value_or(""); }
  [[nodiscard]] std::string text(const std::string& attribute) const;  ///< throws Error if there is none
  /// Returns the numbers of an attribute, from `least` to `most` of them. Throws Error for another number of them, and
  /// for words that are no finite numbers.
  [[nodiscard]] std::vector<double> numbers(const std::string& attribute, std::size_t least, std::size_t most) const;
  [[nodiscard]] dvec3 vector(const std::string& attribute, const dvec3& if_missing) const;
  [[nodiscard]] double number(const std::string& attribute) const { return numbers(attribute, 1, 1).front(); }
  /// Returns a whole number from `least` to `most`. Throws Error for other texts.
  [[nodiscard]] int integer(const std::string& attribute, int least, int most) const;

  /// Returns the elements directly below with this name, or all of them for an empty name.
  [[nodiscard]] std::vector<XmlNode> children(const std::string& name = "") const;
  [[nodiscard]] std::optional<XmlNode> child(const std::string& name) const;

 private:
  const tinyxml2::XMLElement* element_;
  const std::string* file_;
};

/// A parsed XML file.
class XmlFile {
 public:
  /// Throws Error naming the file, and the line of the mistake, if the text is no XML or larger than 32 MiB.
  XmlFile(const std::string& text, std::string file);
  ~XmlFile();
  XmlFile(const XmlFile&) = delete;
  XmlFile& operator=(const XmlFile&) = delete;
  [[nodiscard]] XmlNode root() const;

 private:
  std::string file_;
  std::unique_ptr<tinyxml2::XMLDocument> document_;
};

/// Returns the name of the first element of an XML text that is complete in these bytes, or empty.
std::string first_element(std::string_view bytes);

/// Returns a text with the characters escaped that an attribute in double quotes cannot hold.
std::string xml_attribute(const std::string& text);

}  // namespace taxel
