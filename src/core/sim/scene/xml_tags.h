// The tags of an XML text with their positions, so that the text can be changed in place: a parser's own printer would
// lose comments, spaces and line numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace taxel {

/// Position of an attribute in the text: the name is at [name, name_end), the value at [value, value_end), and the
/// closing quote ends at `end`.
struct XmlTagAttribute {
  std::size_t name = 0, name_end = 0, value = 0, value_end = 0, end = 0;
};

/// Position of a tag in the text.
struct XmlTag {
  std::string_view name;
  std::vector<XmlTagAttribute> attributes;
  bool closes = false;    ///< true for "</name>"
  bool empty = false;     ///< true for "<name/>"
  std::size_t begin = 0;  ///< position of "<"
  std::size_t end = 0;    ///< position after the tag
};

/// Reads the tags of XML one after another. Stops at text that is not XML. The text must outlive the tags.
class XmlTags {
 public:
  explicit XmlTags(std::string_view text) : text_(text) {}

  /// Reads the next tag. Returns false at the end of the text, or if the text is not well formed; then well_formed() is
  /// false.
  bool next(XmlTag& tag);
  [[nodiscard]] bool well_formed() const { return well_formed_; }

 private:
  bool skip(std::string_view begin, std::string_view end);
  void skip_spaces();
  bool read(XmlTag& tag);
  bool read_attribute(XmlTag& tag);

  std::string_view text_;
  std::size_t at_ = 0;
  bool well_formed_ = true;
};

/// Replacement of [begin, end) by a text.
struct TextChange {
  std::size_t begin = 0, end = 0;
  std::string text;
};

/// Returns the text with changes, which must not overlap. Insertions at one place keep their order.
std::string changed_text(const std::string& text, std::vector<TextChange> changes);

}  // namespace taxel
