#include "core/sim/scene/mjcf_text.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel {
namespace {

struct Entity {
  char character;
  std::string_view text;
};
constexpr std::array<Entity, 5> kEntities{
    {{'&', "&amp;"}, {'"', "&quot;"}, {'\'', "&apos;"}, {'<', "&lt;"}, {'>', "&gt;"}}};

/// Returns the character of an entity with a number, such as "&#10;" or "&#xA;" (ASCII only), or nothing.
std::optional<char> numbered(std::string_view entity) {
  if (entity.size() < 4 || !entity.starts_with("&#") || entity.back() != ';') return std::nullopt;
  const bool hex = entity[2] == 'x';
  int value = 0;
  for (const char c : entity.substr(hex ? 3 : 2, entity.size() - (hex ? 4 : 3))) {
    const std::string_view digits = "0123456789abcdef";
    const std::size_t digit = digits.find(static_cast<char>(c >= 'A' && c <= 'F' ? c - 'A' + 'a' : c));
    if (digit == std::string_view::npos || (!hex && digit > 9)) return std::nullopt;
    value = value * (hex ? 16 : 10) + static_cast<int>(digit);
    if (value > 127) return std::nullopt;
  }
  return static_cast<char>(value);
}

}  // namespace

std::string xml_escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const auto* entity =
        std::find_if(kEntities.begin(), kEntities.end(), [&](const Entity& e) { return e.character == c; });
    if (entity != kEntities.end()) {
      out += entity->text;
    } else if (c == '\n' || c == '\t' || c == '\r') {
      out += "&#" + std::to_string(static_cast<int>(c)) + ";";
    } else {
      out += c;
    }
  }
  return out;
}

std::string xml_unescaped(const std::string& text) {
  std::string out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text[at] == '&' ? text.find(';', at) : std::string::npos;
    const std::string_view entity =
        end == std::string::npos ? std::string_view() : std::string_view(text).substr(at, end - at + 1);
    const auto* found =
        std::find_if(kEntities.begin(), kEntities.end(), [&](const Entity& e) { return e.text == entity; });
    if (found != kEntities.end()) {
      out += found->character;
      at = end + 1;
    } else if (const auto character = numbered(entity)) {
      out += *character;
      at = end + 1;
    } else {
      out += text[at++];
    }
  }
  return out;
}

std::string change_attributes(const std::string& xml,
                              const std::function<std::optional<std::string>(const XmlAttribute&)>& change) {
  std::string out;
  XmlAttribute attribute;
  std::size_t at = 0;
  while (at < xml.size()) {
    if (xml[at] == '<') {  // the name of a tag follows
      const std::size_t end = xml.find_first_of(" \t\n/>", at + 1);
      attribute = {xml.substr(at + 1, std::min(end, xml.size()) - at - 1), "", "", ""};
    }
    if (xml.compare(at, 2, "=\"") != 0) {
      out += xml[at++];
      continue;
    }
    const std::size_t name = xml.find_last_of(" \t\n", at) + 1, begin = at + 2;
    const std::size_t end = std::min(xml.find('"', begin), xml.size());
    attribute.name = xml.substr(name, at - name);
    attribute.previous = attribute.value;
    attribute.value = xml_unescaped(xml.substr(begin, end - begin));
    const std::optional<std::string> changed = change(attribute);
    out += "=\"" + (changed ? xml_escaped(*changed) : xml.substr(begin, end - begin)) + "\"";
    at = end + 1;
  }
  return out;
}

namespace {

namespace fs = std::filesystem;

/// A file name in an element of MJCF.
struct NamedFile {
  std::string name;
  bool model = false;  ///< true if the file is a scene of its own
};

/// Collects the names in MJCF or URDF, parsed as MuJoCo parses it. Collects none if the text is not XML.
class FileNames : public tinyxml2::XMLVisitor {
 public:
  explicit FileNames(const std::string& xml) {
    tinyxml2::XMLDocument document;
    if (document.Parse(xml.data(), xml.size()) == tinyxml2::XML_SUCCESS) document.Accept(this);
  }
  /// Files of the elements `include` and `model`.
  [[nodiscard]] const std::vector<NamedFile>& files() const { return files_; }
  /// Files of all other elements, such as `mesh` and `flexcomp`.
  [[nodiscard]] const std::set<std::string>& assets() const { return assets_; }
  /// Folders in which MuJoCo searches assets, from attributes of `compiler`.
  [[nodiscard]] const std::set<std::string>& folders() const { return folders_; }

 private:
  bool VisitEnter(const tinyxml2::XMLElement& element, const tinyxml2::XMLAttribute* first) override {
    const std::string_view name = element.Name();
    const bool is_scene = name == "include" || name == "model";
    for (const tinyxml2::XMLAttribute* a = first; a != nullptr; a = a->Next()) {
      const std::string_view key = a->Name();
      const char* const value = a->Value();
      if (*value == '\0') continue;
      if (is_scene && key == "file")
        files_.push_back({value, name == "model"});
      else if (key.starts_with("file"))  // also fileright and so on of a texture, and filename of URDF
        assets_.insert(value);
      else if (key.ends_with("dir"))
        folders_.insert(value);
    }
    return true;
  }
  std::vector<NamedFile> files_;
  std::set<std::string> assets_, folders_;
};

/// Adds the files that `file` names, and those that they name. Names are searched next to `scene` first.
void find_included(const fs::path& file, const fs::path& scene, std::set<fs::path>& found) {
  std::string xml;
  try {
    xml = read_file(file);
  } catch (const Error&) {
    return;
  }
  std::error_code ignored;
  const FileNames names(xml);
  for (const NamedFile& named : names.files()) {
    for (const fs::path& from : {scene, file}) {
      const fs::path path = (from.parent_path() / named.name).lexically_normal();
      if (!fs::exists(path, ignored)) continue;
      if (!fs::is_regular_file(path, ignored))
        throw Error(file.string(), fmt::format("{}: is not a regular file", named.name));
      if (path != scene && found.insert(path).second) find_included(path, named.model ? path : scene, found);
      break;
    }
  }
}

/// Finds the elements `replicate`, and `instance` of the plugins of this program.
class ReplicateSearch : public tinyxml2::XMLVisitor {
 public:
  void search(const std::string& xml) {
    tinyxml2::XMLDocument document;
    if (document.Parse(xml.data(), xml.size()) == tinyxml2::XML_SUCCESS) document.Accept(this);
  }
  [[nodiscard]] bool has_replicate() const { return has_replicate_; }
  /// Name of the first instance, or empty.
  [[nodiscard]] const std::string& instance() const { return instance_; }

 private:
  bool VisitEnter(const tinyxml2::XMLElement& element, const tinyxml2::XMLAttribute* /*first*/) override {
    const std::string_view name = element.Name();
    if (name == "replicate") has_replicate_ = true;
    const tinyxml2::XMLNode* const parent = element.Parent();
    if (name != "instance" || parent->ToElement() == nullptr || !instance_.empty()) return true;
    const char* const plugin = parent->ToElement()->Attribute("plugin");
    const char* const own = element.Attribute("name");
    if (plugin != nullptr && own != nullptr && std::string_view(plugin).starts_with("taxel.")) instance_ = own;
    return true;
  }
  bool has_replicate_ = false;
  std::string instance_;
};

/// Returns the names under which MuJoCo may search a name: without a scheme like "package://", and without its folders.
std::vector<fs::path> searched_names(const std::string& name) {
  const std::size_t scheme = name.find("://");
  const fs::path path = scheme == std::string::npos ? name : name.substr(scheme + 3);
  return {path, path.filename()};
}

/// Throws Error if one of the paths is a pipe, a device or a socket, or if none is a file and one is a folder.
void expect_regular(const std::set<fs::path>& paths, const fs::path& file, const std::string& name) {
  bool has_file = false, has_other = false, has_special = false;
  for (const fs::path& path : paths) {
    std::error_code ignored;
    const fs::file_status status = fs::status(path, ignored);
    has_file = has_file || fs::is_regular_file(status);
    has_other = has_other || (fs::exists(status) && !fs::is_regular_file(status));
    has_special = has_special || fs::is_other(status);
  }
  if (has_special || (has_other && !has_file))
    throw Error(file.string(), fmt::format("{}: is not a regular file", name));
}

}  // namespace

std::vector<fs::path> included_files(const fs::path& scene) {
  std::set<fs::path> found;
  find_included(scene, scene, found);
  return {found.begin(), found.end()};
}

void expect_regular_files(const fs::path& scene) {
  std::vector<fs::path> files = included_files(scene);
  files.insert(files.begin(), scene);
  std::vector<FileNames> names;
  std::set<fs::path> near, folders;
  for (const fs::path& file : files) {
    names.emplace_back(read_file(file));
    near.insert(file.parent_path());
  }
  for (const fs::path& folder : near) {
    folders.insert(folder);
    for (const FileNames& one : names)
      for (const std::string& name : one.folders()) folders.insert(folder / name);
  }
  for (std::size_t i = 0; i < files.size(); ++i) {
    for (const std::string& name : names[i].assets()) {
      std::set<fs::path> paths;
      for (const fs::path& folder : folders)
        for (const fs::path& searched : searched_names(name)) paths.insert((folder / searched).lexically_normal());
      expect_regular(paths, files[i], name);
    }
  }
}

bool has_replicates(const fs::path& scene) {
  std::vector<fs::path> files = included_files(scene);
  files.push_back(scene);
  ReplicateSearch found;
  for (const fs::path& file : files) found.search(read_file(file));
  if (found.has_replicate() && !found.instance().empty())
    throw Error(
        scene.string(), "extension",
        fmt::format("MuJoCo crashes on a <replicate> in a scene whose sensors refer to a plugin <instance>, here "
                    "\"{}\": write its <config> elements into the <plugin> under <sensor> instead",
                    found.instance()));
  return found.has_replicate();
}

}  // namespace taxel
