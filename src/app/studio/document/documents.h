// What can be opened, and how it becomes a compiled layout: projects, layout files, bare meshes, MuJoCo scenes, steps
// that were saved, and the project's own fingertip that travels inside the program.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "app/studio/document/open_meshes.h"
#include "core/document/project.h"
#include "core/layout/file/skin_choice.h"
#include "core/run/frame.h"
#include "core/sensor/sensor_model.h"

namespace taxel::studio {

enum class DocumentKind { layout, project, mesh, scene, frame };

/// By the file's extension. Throws Error naming the file where it cannot be opened.
DocumentKind document_kind(const std::filesystem::path& file);

struct LoadedDocument {
  DocumentKind kind = DocumentKind::layout;
  std::string file;                ///< empty: built in
  std::string name;                ///< for titles
  SensorModelPtr model;            ///< null for a scene: the simulation compiles its sensors
  ProjectPtr project;              ///< what is edited; null for a scene or a frame
  OpenMeshPtr mesh;                ///< under its layout; null for a scene or a frame
  std::string problem;             ///< why it can be looked at and edited, but not simulated
  std::vector<std::string> notes;  ///< what the user should know: guessed units, warnings
  /// Compiles the layout again, of what was read from the files. From any thread. Throws Error or Cancelled.
  std::function<SensorModelPtr(const SensorBuild&)> compile;
  SimFramePtr frame = nullptr;  ///< a step that was saved, with nothing to simulate; null for all else
  std::string repair = {};      ///< what a repair did to its mesh; empty: nothing
  std::string state = {};       ///< of the window when it was saved (state.json); empty: unknown
  SkinChoice skin = {};         ///< on which a layout of another program was put
  bool frame_is_guess = false;  ///< tip and pad are not from a file: shown as arrows until they are confirmed

  /// Shows samples that are yet to be polished.
  [[nodiscard]] bool previewed() const { return model && model->quality == SampleQuality::preview; }
};

/// Whether the file is a layout that holds no mesh, which has to be opened with one.
bool needs_mesh(const std::filesystem::path& file);

/// Reads and compiles. `skin`: for a file that needs a mesh. Throws Error naming file and field, or Cancelled.
LoadedDocument load_document(const std::filesystem::path& file, const SkinChoice& skin, const SensorBuild& how);
LoadedDocument built_in_fingertip(const SensorBuild& how);

/// The fingertip's mesh, which travels inside the program: its file name and its bytes.
struct BuiltInMesh {
  std::string name;
  std::string_view bytes;
};
BuiltInMesh built_in_mesh();

/// What the samples of a layout have to say: known for good only when they are polished, so not in
/// LoadedDocument::notes.
std::vector<std::string> notes_of_samples(const SensorModel& model);

/// Samples per square metre, one significant digit, that give a bare mesh of this area a picture's worth of them.
double density_for(double area);

}  // namespace taxel::studio
