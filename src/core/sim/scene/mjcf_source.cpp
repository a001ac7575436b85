#include "core/sim/scene/mjcf_source.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/sim/scene/mjcf_text.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kIndent = "  ";  // of a level that is added

/// Returns the spaces before a position, back to the begin of its line; nothing if there is other text.
std::optional<std::string> indent_before(const std::string& text, std::size_t at) {
  const std::size_t line = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  const std::string spaces = text.substr(line, at - line);
  if (spaces.find_first_not_of(" \t") != std::string::npos) return std::nullopt;
  return spaces;
}

}  // namespace

MjcfSource::MjcfSource(const fs::path& scene, const std::vector<CurrentMjcf>& replaced) : replaced_(replaced) {
  read(scene, -1, -1);
}

std::string_view MjcfSource::name(int element) const {
  return elements_[static_cast<std::size_t>(element)].tag.name;
}

const XmlTagAttribute* MjcfSource::find(int element, std::string_view attribute) const {
  const MjcfElement& one = elements_[static_cast<std::size_t>(element)];
  const std::string_view text = files_[static_cast<std::size_t>(one.file)].text;
  for (const XmlTagAttribute& a : one.tag.attributes)
    if (text.substr(a.name, a.name_end - a.name) == attribute) return &a;
  return nullptr;
}

std::optional<std::string> MjcfSource::value(int element, std::string_view attribute) const {
  const XmlTagAttribute* a = find(element, attribute);
  if (a == nullptr) return std::nullopt;
  const MjcfElement& one = elements_[static_cast<std::size_t>(element)];
  return xml_unescaped(files_[static_cast<std::size_t>(one.file)].text.substr(a->value, a->value_end - a->value));
}

bool MjcfSource::is_in_world(int element) const {
  for (int up = elements_[static_cast<std::size_t>(element)].parent; up >= 0;
       up = elements_[static_cast<std::size_t>(up)].parent) {
    const std::string_view around = name(up);
    if (around == "worldbody") return true;
    if (around != "body" && around != "frame" && around != "replicate" && around != "include") return false;
  }
  return false;
}

fs::path MjcfSource::found(const std::string& name, int file) const {
  std::error_code ignored;
  const fs::path next_to_scene = (files_.front().path.parent_path() / name).lexically_normal();
  if (fs::exists(next_to_scene, ignored)) return next_to_scene;
  return (files_[static_cast<std::size_t>(file)].path.parent_path() / name).lexically_normal();
}

void MjcfSource::read(const fs::path& path, int include, int parent) {
  const auto other = std::ranges::find(replaced_, path, &CurrentMjcf::file);
  const bool is_replaced = other != replaced_.end();
  MjcfFile& file =
      files_.emplace_back(MjcfFile{path, is_replaced ? other->text : read_file(path), is_replaced, include});
  const int number = static_cast<int>(files_.size()) - 1;
  // The root of an included file is no element: its children belong to the element around <include>.
  std::vector<int> open;
  bool is_in_root = false;
  XmlTags tags(file.text);
  for (XmlTag tag; tags.next(tag);) {
    if (tag.closes) {
      if (open.size() == (include < 0 ? 1U : 0U)) file.close_of_root = tag.begin;
      if (!open.empty()) open.pop_back();
      continue;
    }
    const int around = open.empty() ? parent : open.back();
    if (include >= 0 && !is_in_root) {
      is_in_root = true;
      continue;
    }
    const int element = static_cast<int>(elements_.size());
    elements_.push_back({tag, around, number});
    if (!tag.empty) open.push_back(element);
    if (tag.name != "include") continue;
    const fs::path target = found(value(element, "file").value_or(""), number);
    std::error_code ignored;
    const bool is_known = std::ranges::any_of(files_, [&](const MjcfFile& one) { return one.path == target; });
    if (fs::is_regular_file(target, ignored) && !is_known) read(target, element, around);
  }
  if (!tags.well_formed()) throw Error(path.string(), "is not well-formed XML");
  if (include < 0 && !elements_.empty() && elements_.front().tag.empty) file.close_of_root = std::string::npos;
}

void MjcfChanges::set(int element, const std::string& attribute, const std::string& value) {
  const MjcfElement& one = source_.elements()[static_cast<std::size_t>(element)];
  const std::string& text = source_.files()[static_cast<std::size_t>(one.file)].text;
  std::vector<TextChange>& changes = changes_[static_cast<std::size_t>(one.file)];
  if (const XmlTagAttribute* old = source_.find(element, attribute)) {
    changes.push_back({old->value, old->value_end, xml_escaped(value)});
    return;
  }
  const std::size_t name_end = one.tag.begin + 1 + one.tag.name.size();
  const bool is_first = attribute == "name" || one.tag.attributes.empty();
  const std::size_t at = is_first ? name_end : one.tag.attributes.back().end;
  const char quote = one.tag.attributes.empty() ? '"' : text[one.tag.attributes.front().value - 1];
  changes.push_back({at, at, fmt::format(" {0}={1}{2}{1}", attribute, quote, xml_escaped(value))});
}

void MjcfChanges::insert_before(int element, const std::string& text) {
  const MjcfElement& one = source_.elements()[static_cast<std::size_t>(element)];
  changes_[static_cast<std::size_t>(one.file)].push_back({one.tag.begin, one.tag.begin, text});
}

void MjcfChanges::append(const std::vector<std::string>& lines) {
  if (lines.empty()) return;
  const MjcfFile& scene = source_.files().front();
  if (scene.close_of_root == std::string::npos) throw Error(scene.path.string(), "its root element is empty");
  const std::string newline = scene.text.find("\r\n") != std::string::npos ? "\r\n" : "\n";
  std::string indent(kIndent);
  for (const MjcfElement& one : source_.elements())
    if (one.parent == 0 && one.file == 0)
      if (const auto spaces = indent_before(scene.text, one.tag.begin); spaces && !spaces->empty()) {
        indent = *spaces;
        break;
      }
  const std::optional<std::string> before = indent_before(scene.text, scene.close_of_root);
  std::string text = before ? "" : newline;
  for (const std::string& line : lines) {
    const std::size_t levels = line.find_first_not_of(' ') / kIndent.size();
    text += indent;
    for (std::size_t i = 0; i < levels; ++i) text += indent.front() == '\t' ? "\t" : kIndent;
    text += line.substr(levels * kIndent.size()) + newline;
  }
  const std::size_t at = scene.close_of_root - (before ? before->size() : 0);
  changes_.front().push_back({at, at, text});
}

std::string MjcfChanges::text(int file) const {
  return changed_text(source_.files()[static_cast<std::size_t>(file)].text, changes_[static_cast<std::size_t>(file)]);
}

}  // namespace taxel
