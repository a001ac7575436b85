#include "app/studio/host/document/project_files.h"

#include <fmt/format.h>

#include <cctype>

#include "app/studio/host/document/documents.h"
#include "core/base/files.h"
#include "core/base/hash.h"
#include "core/mesh/formats/mesh_format.h"

namespace taxel::studio {

namespace {

namespace fs = std::filesystem;

bool holds(const fs::path& file, std::string_view bytes) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && fs::file_size(file, ignored) == bytes.size() && read_file(file) == bytes;
}

/// Writes a mesh into a folder, as the first of "fingertip.obj", "fingertip-1.obj", ... that does not exist or holds
/// this mesh already. Returns its path.
std::string written_to(const fs::path& folder, const fs::path& name, std::string_view bytes) {
  fs::path file = folder / name;
  std::error_code ignored;
  for (int number = 1; fs::exists(file, ignored) && !holds(file, bytes); ++number)
    file = folder / fmt::format("{}-{}{}", name.stem().string(), number, name.extension().string());
  if (!holds(file, bytes)) write_file_atomically(file, bytes);
  return file.string();
}

/// Returns the letters and digits of a name, with one dash in place of the characters between them; "layout" if there
/// are none.
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

Project with_mesh_on_disk(Project project, const fs::path& file, const OpenMeshPtr& mesh) {
  const fs::path folder = fs::absolute(file).parent_path();
  const BuiltInMesh built_in = built_in_mesh();
  MeshRef& ref = project.layout.mesh;
  std::error_code ignored;
  if (ref.file == built_in.name) {
    ref.file = written_to(folder, built_in.name, built_in.bytes);
  } else if (mesh && !fs::exists(ref.file, ignored)) {
    const std::string bytes = write_obj(*mesh->loaded.mesh);
    ref = {written_to(folder, fs::path(ref.file).stem().string() + ".obj", bytes), dvec3(1.0), sha256_hex(bytes)};
  }
  return project;
}

SuggestedFile suggested_file(const std::string& file, const std::string& name, const std::string& extension) {
  SuggestedFile suggested;
  std::string stem = file_name_of(name);
  if (!file.empty()) {
    const fs::path path = fs::absolute(file);
    suggested.folder = path.parent_path().string();
    const std::string whole = path.filename().string();
    stem = whole.substr(0, whole.find('.', 1));
  }
  suggested.name = stem + extension;
  return suggested;
}

}  // namespace taxel::studio
