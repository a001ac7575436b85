// The layouts, meshes and other files that jobs name. Each file is read once.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/document/batch/job.h"
#include "core/sensor/sensor_model.h"

namespace taxel {

/// The layout for jobs that name none.
struct DefaultLayout {
  SensorSource source;
  std::string mesh_bytes = {};  ///< bytes of the mesh file
};
/// Returns the layout for jobs that name none. Throws Error if there is none.
using DefaultSource = std::function<DefaultLayout()>;

/// A mesh file that a batch holds, so that its layouts can be used anywhere.
struct MeshFile {
  std::string name;  ///< SHA-256 of the bytes, with the extension of the file
  std::string bytes;
};

/// Safe to use from several threads.
class JobSources {
 public:
  /// `scene_reader` may be empty if no job names a scene.
  explicit JobSources(DefaultSource default_source = {}, SceneReader scene_reader = {});

  /// Returns the layout in a file, or the default layout if `path` is empty, with its mesh. Throws Error naming the
  /// file, the same error each time.
  const SensorSource& source(const std::string& path);
  /// Returns the JSON text of source(path).layout. Throws as source() does.
  const std::string& layout_json(const std::string& path);
  /// Returns the layout of a job, with the job's changes. Throws Error naming file and JSON pointer.
  Layout changed_layout(const std::string& path, const std::vector<JobChange>& changes);
  /// Returns changed_layout() on its mesh. Throws Error as well if the mesh is another one and cannot be read.
  SensorSource changed_source(const std::string& path, const std::vector<JobChange>& changes);
  /// Returns the layout of a source in a batch: its mesh is meshes/NAME, with the name of mesh_file().
  static std::string portable_json(const SensorSource& source);
  /// Returns the mesh file of a job. Throws Error naming a file that cannot be read.
  MeshFile mesh_file(const std::string& path, const std::vector<JobChange>& changes);
  /// Checks a scene, and returns the facts that the list needs. Throws the errors of the reader, and Error without one.
  SceneFacts scene_facts(const SceneJob& scene);
  /// Returns the SHA-256 of a file's bytes. Throws Error naming the file.
  const std::string& file_sha256(const std::string& path);

  /// Makes a layout known that came from another machine. The file `path` is then never read.
  void put_source(const std::string& path, SensorSource source);
  [[nodiscard]] bool has_source(const std::string& path);
  /// Meshes of changed layouts are read from `copy` instead of `original`.
  void put_copy(const std::string& original, const std::string& copy);
  /// Returns the copy of a file, or the file itself if there is none.
  [[nodiscard]] std::filesystem::path copy_of(const std::filesystem::path& file);

 private:
  /// A result or the error that reading gave.
  struct Read {
    std::shared_ptr<const SensorSource> source;
    std::string json;
    std::string mesh_bytes;  ///< mesh file of the default layout
    std::shared_ptr<const Error> error;
  };
  const Read& read(const std::string& path);

  DefaultSource default_source_;
  SceneReader scene_reader_;
  std::mutex mutex_;
  std::map<std::string, Read> sources_;
  std::map<std::string, std::string> hashes_, copies_;
};

/// Returns a JSON document with changed values. A pointer is relative to the document; the object or array that holds
/// the value must exist. Throws Error("", pointer, ...).
std::string with_changes(const std::string& json, const std::vector<JobChange>& changes);

/// Returns the changes below `root`, "/layout", "/scenario" or "/scene", with pointers relative to `root`.
std::vector<JobChange> changes_below(const std::string& root, const std::vector<JobChange>& changes);

}  // namespace taxel
