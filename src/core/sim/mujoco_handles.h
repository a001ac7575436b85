// Owning handles of MuJoCo's objects.
#pragma once

#include <mujoco/mujoco.h>

#include <memory>
#include <string>
#include <string_view>

#include "core/base/error.h"

namespace taxel {

struct MujocoDeleter {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
  void operator()(mjSpec* s) const { mj_deleteSpec(s); }
};
using ModelHandle = std::unique_ptr<mjModel, MujocoDeleter>;
using DataHandle = std::unique_ptr<mjData, MujocoDeleter>;
using SpecHandle = std::unique_ptr<mjSpec, MujocoDeleter>;

/// Virtual file system: files in memory that MuJoCo's parser can open.
class Vfs {
 public:
  Vfs() { mj_defaultVFS(&vfs_); }
  ~Vfs() { mj_deleteVFS(&vfs_); }
  Vfs(const Vfs&) = delete;
  Vfs& operator=(const Vfs&) = delete;

  /// Adds a file. Throws Error if a file of this name was added before.
  void add(const std::string& name, std::string_view bytes) {
    if (mj_addBufferVFS(&vfs_, name.c_str(), bytes.data(), static_cast<int>(bytes.size())) != 0)
      throw Error(name, "cannot be added to the scene's files");
  }
  [[nodiscard]] const mjVFS* get() const { return &vfs_; }

 private:
  mjVFS vfs_{};
};

}  // namespace taxel
