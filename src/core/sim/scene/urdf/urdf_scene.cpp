#include "core/sim/scene/urdf/urdf_scene.h"

#include <array>

#include "core/base/files.h"
#include "core/layout/formats/urdf/link_mesh.h"
#include "core/sim/mujoco_handles.h"

namespace taxel {
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
