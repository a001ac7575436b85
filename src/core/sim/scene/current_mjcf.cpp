#include "core/sim/scene/current_mjcf.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/layout/formats/urdf.h"
#include "core/sim/mujoco_handles.h"
#include "core/sim/scene/mjcf_text.h"
#include "core/sim/scene/xml_tags.h"

namespace taxel {
namespace {

// The table below is the difference of the schemas that mj_printSchema() gives for MuJoCo 2.2.0, 2.3.7, 3.1.6, 3.3.0
// and 4.0.1, with the reasons of MuJoCo's changelog. The text is searched tag by tag and changed in place, because a
// parser's own printer would lose the line numbers.

/// An attribute that MuJoCo dropped.
struct Dropped {
  std::string_view parent;   ///< element around the attribute's element; empty for any element
  std::string_view element;  ///< element that had the attribute
  std::string_view name;     ///< name of the attribute
  std::string_view renamed;  ///< attributes that now have the value, separated by spaces; empty if there are none
  std::string_view reason;   ///< reason in the note
};

constexpr std::array kDropped{
    Dropped{"", "option", "collision", "", "all pairs are tested, dynamic and predefined ones"},
    Dropped{"", "option", "apirate", "", "MuJoCo never used it"},
    Dropped{"", "option", "mpr_iterations", "ccd_iterations", ""},
    Dropped{"", "option", "mpr_tolerance", "ccd_tolerance", ""},
    Dropped{"option", "flag", "sensornoise", "", "MuJoCo adds no noise to sensors any more"},
    Dropped{"option", "flag", "passive", "spring damper", ""},
    Dropped{"", "compiler", "convexhull", "", "MuJoCo makes convex hulls where it needs them"},
    Dropped{"", "compiler", "exactmeshinertia", "", "each mesh says so by its own attribute inertia"},
    Dropped{"compiler", "lengthrange", "inteval", "interval", ""},
    Dropped{"", "joint", "actuatorforcelimited", "actuatorfrclimited", ""},
    Dropped{"", "joint", "actuatorforcerange", "actuatorfrcrange", ""},
    Dropped{"", "camera", "orthographic", "", "the attribute projection took its place"},
    Dropped{"flex", "contact", "internal", "", "a flex's contact with itself has its own attributes"},
    Dropped{"flexcomp", "contact", "internal", "", "a flex's contact with itself has its own attributes"},
};

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    words.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return words;
}

/// Returns `text` with all characters except line breaks replaced by spaces.
std::string blank(std::string_view text) {
  std::string out(text);
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c != '\n' && c != '\r'; }, ' ');
  return out;
}

/// Search for dropped attributes in one file.
class Search {
 public:
  Search(const std::string& xml, const std::string& file, std::vector<std::string>& notes)
      : xml_(xml), file_(file), notes_(notes) {}

  std::string run() {
    XmlTags tags(xml_);
    XmlTag tag;
    const std::size_t notes = notes_.size();
    while (tags.next(tag)) enter(tag);
    if (!tags.well_formed()) {
      notes_.resize(notes);
      return xml_;
    }
    return changed_text(xml_, changes_);
  }

 private:
  void enter(const XmlTag& tag) {
    if (tag.closes) {
      if (!open_.empty()) open_.pop_back();
      return;
    }
    const std::string_view parent = open_.empty() ? std::string_view() : open_.back();
    for (const XmlTagAttribute& a : tag.attributes) look_up(parent, tag, a);
    if (!tag.empty) open_.push_back(tag.name);
  }

  [[nodiscard]] std::string_view name_of(const XmlTagAttribute& a) const {
    return std::string_view(xml_).substr(a.name, a.name_end - a.name);
  }

  void look_up(std::string_view parent, const XmlTag& tag, const XmlTagAttribute& a) {
    const std::string_view name = name_of(a);
    for (const Dropped& d : kDropped) {
      if (d.element != tag.name || d.name != name || (!d.parent.empty() && d.parent != parent)) continue;
      const std::string_view text = std::string_view(xml_).substr(a.name, a.end - a.name);
      std::string renamed;
      for (const std::string_view word : words_of(d.renamed))
        if (std::none_of(tag.attributes.begin(), tag.attributes.end(),
                         [&](const XmlTagAttribute& other) { return name_of(other) == word; }))
          renamed += fmt::format("{}{}{}", renamed.empty() ? "" : " ", word, text.substr(name.size()));
      changes_.push_back({a.name, a.end, renamed.empty() ? blank(text) : renamed});
      report(d, a, renamed);
    }
  }

  void report(const Dropped& d, const XmlTagAttribute& a, const std::string& renamed) {
    const auto line = 1 + std::count(xml_.begin(), xml_.begin() + static_cast<std::ptrdiff_t>(a.name), '\n');
    const std::string_view value = std::string_view(xml_).substr(a.value, a.value_end - a.value);
    std::string done = renamed.empty() ? fmt::format("it is left out{}{}", d.reason.empty() ? "" : ": ", d.reason)
                                       : fmt::format("it is read as {}", fmt::join(words_of(d.renamed), " and "));
    if (d.name == "collision" && value != "all") done += ", so there may be more contacts than there were";
    notes_.push_back(fmt::format("{}: line {}: {} {}=\"{}\" is no longer known to MuJoCo; {}", file_, line, d.element,
                                 d.name, value, done));
  }

  const std::string& xml_;
  const std::string& file_;
  std::vector<std::string>& notes_;
  std::vector<std::string_view> open_;
  std::vector<TextChange> changes_;
};

}  // namespace

std::string without_dropped_attributes(const std::string& xml, const std::string& file,
                                       std::vector<std::string>& notes) {
  return Search(xml, file, notes).run();
}

std::vector<CurrentMjcf> current_mjcf(const std::filesystem::path& scene, std::vector<std::string>& notes) {
  std::vector<std::filesystem::path> files = included_files(scene);
  files.insert(files.begin(), scene);
  std::vector<CurrentMjcf> changed;
  for (const std::filesystem::path& file : files) {
    const std::size_t before = notes.size();
    std::string text = without_dropped_attributes(read_file(file), file.string(), notes);
    if (notes.size() != before) changed.push_back({file, std::move(text)});
  }
  return changed;
}

namespace {

/// Gives meshes the files that a URDF means: MuJoCo 4 opens no name like "package://hand/meshes/tip.stl". Earlier
/// versions took the file of this name next to the URDF. Names without a file remain, for MuJoCo's own message.
void find_meshes(mjSpec* spec, const std::string& urdf) {
  for (mjsElement* one = mjs_firstElement(spec, mjOBJ_MESH); one != nullptr; one = mjs_nextElement(spec, one)) {
    mjString* file = mjs_asMesh(one)->file;
    const std::string name = mjs_getString(file);
    std::string found = find_link_mesh(name, urdf);
    if (found.empty()) found = find_link_mesh(std::filesystem::path(name).filename().string(), urdf);
    if (!found.empty()) mjs_setString(file, found.c_str());
  }
}

}  // namespace

bool is_urdf(const std::filesystem::path& file) {
  constexpr std::size_t kBytes = 4096;
  const std::string start = read_start(file, kBytes);
  const std::size_t robot = start.find("<robot");
  return robot != std::string::npos && robot < start.find("<mujoco");
}

CurrentMjcf mjcf_of_urdf(const std::filesystem::path& file) {
  std::array<char, 2048> reason{};
  const auto size = static_cast<int>(reason.size());
  const SpecHandle spec(mj_parseXML(file.string().c_str(), nullptr, reason.data(), size));
  if (spec == nullptr) throw Error(file.string(), reason.data());
  find_meshes(spec.get(), file.string());
  const ModelHandle model(mj_compile(spec.get(), nullptr));
  if (model == nullptr) throw Error(file.string(), mjs_getError(spec.get()));
  std::string text(1 << 16, '\0');
  for (;;) {
    const int missing = mj_saveXMLString(spec.get(), text.data(), static_cast<int>(text.size()), reason.data(), size);
    if (missing < 0) throw Error(file.string(), reason.data());
    if (missing == 0) break;
    text.resize(static_cast<std::size_t>(missing) + 1);
  }
  text.resize(text.find('\0'));
  return {file.parent_path() / (file.stem().string() + "+mjcf.xml"), std::move(text)};
}

}  // namespace taxel
