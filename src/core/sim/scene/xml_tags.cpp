#include "core/sim/scene/xml_tags.h"

#include <algorithm>

namespace taxel {
namespace {

constexpr std::string_view kSpaces = " \t\r\n";

}  // namespace

bool XmlTags::next(XmlTag& tag) {
  while (true) {
    at_ = text_.find('<', at_);
    if (at_ == std::string_view::npos) return false;
    if (skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>") || skip("<!", ">")) continue;
    well_formed_ = well_formed_ && read(tag);
    return well_formed_;
  }
}

bool XmlTags::skip(std::string_view begin, std::string_view end) {
  if (!text_.substr(at_).starts_with(begin)) return false;
  const std::size_t found = text_.find(end, at_ + begin.size());
  well_formed_ = well_formed_ && found != std::string_view::npos;
  at_ = found == std::string_view::npos ? text_.size() : found + end.size();
  return true;
}

void XmlTags::skip_spaces() {
  at_ = std::min(text_.find_first_not_of(kSpaces, at_), text_.size());
}

bool XmlTags::read(XmlTag& tag) {
  tag = {};
  tag.begin = at_++;
  tag.closes = at_ < text_.size() && text_[at_] == '/';
  if (tag.closes) ++at_;
  const std::size_t name_end = text_.find_first_of(" \t\r\n/>", at_);
  if (name_end == std::string_view::npos) return false;
  tag.name = text_.substr(at_, name_end - at_);
  at_ = name_end;
  for (skip_spaces(); at_ < text_.size() && text_[at_] != '>'; skip_spaces()) {
    if (text_[at_] == '/') {
      tag.empty = true;
      ++at_;
      continue;
    }
    if (!read_attribute(tag)) return false;
  }
  tag.end = ++at_;
  return at_ <= text_.size();
}

bool XmlTags::read_attribute(XmlTag& tag) {
  XmlTagAttribute a;
  a.name = at_;
  a.name_end = text_.find_first_of(" \t\r\n=/>", at_);
  if (a.name_end == std::string_view::npos || a.name_end == a.name) return false;
  at_ = a.name_end;
  skip_spaces();
  if (at_ >= text_.size() || text_[at_] != '=') return false;
  ++at_;
  skip_spaces();
  if (at_ >= text_.size() || (text_[at_] != '"' && text_[at_] != '\'')) return false;
  a.value = at_ + 1;
  a.value_end = text_.find(text_[at_], a.value);
  if (a.value_end == std::string_view::npos) return false;
  at_ = a.end = a.value_end + 1;
  tag.attributes.push_back(a);
  return true;
}

std::string changed_text(const std::string& text, std::vector<TextChange> changes) {
  std::ranges::stable_sort(changes, {}, &TextChange::begin);
  std::string out;
  std::size_t at = 0;
  for (const TextChange& change : changes) {
    out.append(text, at, change.begin - at).append(change.text);
    at = change.end;
  }
  return out.append(text, at);
}

}  // namespace taxel
