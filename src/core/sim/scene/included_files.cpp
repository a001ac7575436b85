#include "core/sim/scene/included_files.h"

#include <fmt/format.h>
#include <tinyxml2.h>

#include <set>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel {
namespace {

namespace fs = std::filesystem;

/// A file name in an element of MJCF.
struct NamedFile {
  std::string name;
  bool model = false;  ///< true if the file is a scene of its own
};

/// Collects the file names of the elements `include` and `model` of MJCF, parsed as MuJoCo parses it. Collects none if
/// the text is not XML.
class FileNames : public tinyxml2::XMLVisitor {
 public:
  explicit FileNames(const std::string& xml) {
    tinyxml2::XMLDocument document;
    if (document.Parse(xml.data(), xml.size()) == tinyxml2::XML_SUCCESS) document.Accept(this);
  }
  [[nodiscard]] const std::vector<NamedFile>& files() const { return files_; }

 private:
  bool VisitEnter(const tinyxml2::XMLElement& element, const tinyxml2::XMLAttribute* /*first*/) override {
    const std::string_view name = element.Name();
    const char* const file = element.Attribute("file");
    if (file != nullptr && *file != '\0' && (name == "include" || name == "model"))
      files_.push_back({file, name == "model"});
    return true;
  }
  std::vector<NamedFile> files_;
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

}  // namespace

std::vector<fs::path> included_files(const fs::path& scene) {
  std::set<fs::path> found;
  find_included(scene, scene, found);
  return {found.begin(), found.end()};
}

}  // namespace taxel
