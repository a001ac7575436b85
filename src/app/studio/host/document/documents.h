// Opens files as compiled layouts: projects, layout files, bare meshes, MuJoCo scenes, saved steps, and the project's
// own fingertip, which is built into the program.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/error.h"
#include "core/base/progress.h"
#include "core/document/project.h"
#include "core/layout/layout.h"
#include "core/layout/user_choices.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/topology/mesh_check.h"
#include "core/run/frame.h"
#include "core/sensor/sensor_model.h"

namespace taxel::studio {

/// A mesh as read, and the findings about it.
struct OpenMesh {
  LoadedMesh loaded;
  MeshFindings findings;
};
using OpenMeshPtr = std::shared_ptr<const OpenMesh>;

/// Reads and inspects a mesh. Throws Error as load_mesh() does, or Cancelled.
OpenMeshPtr read_open_mesh(const MeshRef& mesh, Progress* progress = nullptr);

/// Returns whether two references read the same mesh, whatever their repair.
inline bool same_file(const MeshRef& a, const MeshRef& b) {
  return a.file == b.file && a.scale == b.scale && a.sha256 == b.sha256;
}

/// Meshes of an open document by reference, as they were read: undo restores an earlier mesh even if its file has
/// changed since. All functions may be called from any thread.
class OpenMeshes {
 public:
  void clear();
  /// Sets the mesh of this reference from now on, whatever its repair.
  void add(const MeshRef& ref, OpenMeshPtr mesh);
  /// Returns the mesh of this reference, or null if it was not read yet.
  [[nodiscard]] OpenMeshPtr find(const MeshRef& ref) const;
  /// Returns the mesh of this reference, and reads it from its file if it is not known. Throws Error as load_mesh()
  /// does.
  OpenMeshPtr get(const MeshRef& ref);

 private:
  /// Maximum number of meshes that are retained: the newest ones.
  static constexpr std::size_t kMost = 16;
  mutable std::mutex mutex_;  // guards the rest
  std::vector<std::pair<MeshRef, OpenMeshPtr>> meshes_;
};

enum class DocumentKind { layout, project, mesh, scene, frame };

/// Returns the kind of a document by the extension of its file. Throws Error naming the file if it cannot be opened:
/// for a JSON file with another format than a layout, the error names a file next to it that can.
DocumentKind document_kind(const std::filesystem::path& file);

struct LoadedDocument {
  DocumentKind kind = DocumentKind::layout;
  std::string file;                ///< path of the file, or empty for the built-in document
  std::string name;                ///< name for titles
  SensorModelPtr model;            ///< compiled layout, or null for a scene: the simulation compiles its sensors
  ProjectPtr project;              ///< project to edit, or null for a scene or a frame
  OpenMeshPtr mesh;                ///< mesh of the layout, or null for a scene or a frame
  std::string problem;             ///< reason why the document can be viewed and edited but not simulated, or empty
  std::vector<std::string> notes;  ///< messages for the user: guessed units, warnings
  /// Compiles the layout again from the data that were read from the files. May be called from any thread. Throws Error
  /// or Cancelled.
  std::function<SensorModelPtr(const SensorBuild&)> compile;
  SimFramePtr frame = nullptr;            ///< saved step that cannot be simulated; null for other kinds
  std::string repair = {};                ///< summary of the mesh's repair, or empty if nothing was repaired
  std::string state = {};                 ///< state.json of the window when the step was saved, or empty
  SkinChoice skin = {};                   ///< choice of mesh for a layout of another program
  bool frame_is_guess = false;            ///< whether tip and pad are guesses, drawn as arrows until confirmed
  std::vector<std::string> remarks = {};  ///< messages that nobody has to act on, such as welded vertices
  std::optional<Scenario> scenario = {};  ///< scenario of an example; empty for the one that runs already

  /// Returns whether the samples are a preview that is not polished yet.
  [[nodiscard]] bool previewed() const { return model && model->quality == SampleQuality::preview; }
};

/// The mesh of a layout or of a project is not there.
struct MissingMesh : Error {
  MissingMesh(const std::string& layout_file, const std::string& mesh_file)
      : Error(layout_file, "/mesh/file", mesh_file + ": no such file"), mesh(mesh_file) {}
  std::string mesh;  ///< path of the mesh
};

/// Returns whether the file is a layout without a mesh, which must be opened together with a mesh.
bool needs_mesh(const std::filesystem::path& file);

/// Reads and compiles a document. `skin` is used for a file that needs a mesh, or whose mesh is missing. A layout with
/// errors is opened to be edited, with LoadedDocument::problem. Throws Error naming file and field, MissingMesh, or
/// Cancelled.
LoadedDocument load_document(const std::filesystem::path& file, const SkinChoice& skin, const SensorBuild& how);
/// Document that is built into the program, which opens under this name instead of a file: our fingertip with so few
/// samples that a taxel jumps while the force stays, as in the paper, in a fast sweep over an edge.
inline constexpr std::string_view kJumpingTaxel = "built-in: jumping taxel";
/// Returns the document of a layout that has no file on its mesh.
LoadedDocument document_in_memory(Layout layout, LoadedMesh mesh, const SensorBuild& how);
/// Returns our fingertip; with the samples, the field and the sweep of kJumpingTaxel if `jumps`.
LoadedDocument built_in_fingertip(const SensorBuild& how, bool jumps = false);

/// File name and bytes of the fingertip's mesh, which is built into the program.
struct BuiltInMesh {
  std::string name;
  std::string_view bytes;
};
BuiltInMesh built_in_mesh();

/// Returns the messages about the samples of a layout. They are final only if the samples are polished, so
/// LoadedDocument::notes does not contain them.
std::vector<std::string> notes_of_samples(const SensorModel& model);

/// Returns the number of samples per square metre, rounded to one significant digit, with which a bare mesh of this
/// area has enough samples for a view of it.
double density_for(double area);

/// Model of a layout for display, even if the layout can be viewed but not simulated.
struct ShownModel {
  SensorModelPtr model;
  std::string problem;  ///< reason why the layout cannot be simulated, or empty
};

/// Compiles a layout on its mesh as loaded by `compile`. A soft layout whose mesh cannot be repaired, by the layout's
/// own recipe or at all, is compiled as a rigid layout on the mesh as loaded, for viewing and for placing taxels. A
/// soft layout without taxels on a mesh of more than kManySkinTriangles has no body. Throws as `compile` does.
ShownModel shown_model(const Layout& layout, const TriMeshPtr& mesh,
                       const std::function<SensorModelPtr(const Layout&)>& compile);

/// Returns the folder of a batch if a path names one: the file batch.json, or a folder with this file or, if the batch
/// is not finished, with its journal. The result is absolute, without a slash at its end. Does not read the file.
std::optional<std::filesystem::path> batch_folder(const std::filesystem::path& path);

}  // namespace taxel::studio
