#include "app/studio/project_files.h"

#include <fmt/format.h>

#include <cctype>

#include "app/studio/documents.h"
#include "core/base/files.h"

namespace taxel::studio {

namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& file, std::string_view bytes) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && fs::file_size(file, ignored) == bytes.size() && read_file(file) == bytes;
}

/// The first of "fingertip.obj", "fingertip-1.obj", ... that is free, or is the mesh already.
fs::path place_for(const BuiltInMesh& mesh, const fs::path& folder) {
  const fs::path name(mesh.name);
  fs::path file = folder / name;
  std::error_code ignored;
  for (int number = 1; fs::exists(file, ignored) && !holds(file, mesh.bytes); ++number)
    file = folder / fmt::format("{}-{}{}", name.stem().string(), number, name.extension().string());
  return file;
}

/// Letters and digits of a name, what is between them as one dash.
std::string file_name_of(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
      text += c;
    } else if (!text.empty() && text.back() != '-') {
      text += '-';
    }
  }
  while (!text.empty() && text.back() == '-') text.pop_back();
  return text.empty() ? "layout" : text;
}

}  // namespace

Project with_mesh_on_disk(Project project, const fs::path& file) {
  const BuiltInMesh mesh = built_in_mesh();
  if (project.layout.mesh.file != mesh.name) return project;
  const fs::path place = place_for(mesh, fs::absolute(file).parent_path());
  if (!holds(place, mesh.bytes)) write_file_atomically(place, mesh.bytes);
  project.layout.mesh.file = place.string();
  return project;
}

SuggestedFile suggested_file(const std::string& file, const std::string& name, bool project) {
  SuggestedFile suggested;
  std::string stem = file_name_of(name);
  if (!file.empty()) {
    const fs::path path = fs::absolute(file);
    suggested.folder = path.parent_path().string();
    const std::string whole = path.filename().string();
    stem = whole.substr(0, whole.find('.', 1));
  }
  suggested.name = stem + (project ? ".taxelproj" : ".taxels.json");
  return suggested;
}

}  // namespace taxel::studio
