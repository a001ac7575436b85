// A cache of the expensive parts of sensor models. None of them depends on the positions of taxels, so that a build
// after an edit of taxels only assigns the samples again.
#pragma once

#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "core/base/memo.h"
#include "core/base/progress.h"
#include "core/hydro/hydro_body.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/layout.h"
#include "core/layout/sampling/poisson_disk.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/repair/repair.h"
#include "core/sensor/rays/sensor_ray.h"

namespace taxel {

class TetCrossings;

/// A mesh and the part of it that is sampled.
struct SensorSkin {
  TriMeshPtr mesh;                          ///< all shells
  std::shared_ptr<const MeshIndex> sensed;  ///< shells that are sampled
  std::vector<int> face_of;                 ///< face of `mesh` for each sensed face
};
using SensorSkinPtr = std::shared_ptr<const SensorSkin>;
using SampleSetPtr = std::shared_ptr<const std::vector<SurfaceSample>>;

/// Returns the skin of a mesh with the shells that are sampled.
SensorSkinPtr make_sensor_skin(const TriMeshPtr& mesh, Shells shells);

/// The faces with samples: the sensed skin, or its faces in a region.
struct SampledSkin {
  TriMeshPtr mesh;
  std::vector<int> face_of;  ///< sensed face for each face of `mesh`; empty if all are equal
};
using SampledSkinPtr = std::shared_ptr<const SampledSkin>;

/// Returns the faces of a skin in a region. `region` lists faces of skin.mesh, ascending. Faces that are not sensed or
/// do not exist are ignored.
SampledSkinPtr make_sampled_skin(const SensorSkin& skin, const std::vector<int>& region);

/// The rays from samples into the body, against the surface normal. The depth of a ray and the tets that it crosses are
/// computed when they are first requested.
class SampleRays {
 public:
  /// `allowed` is the depth by Readout::max_depth [m].
  SampleRays(SensorSkinPtr skin, SampleSetPtr samples, HydroBodyPtr body, double allowed);
  ~SampleRays();

  /// The rays of a request.
  struct Found {
    std::vector<SensorRay> rays;
    /// The tets of each ray, ascending. Empty if the body has no tets.
    std::vector<std::span<const std::int32_t>> crossings;
  };
  /// Returns one ray for each of `samples`. Safe to call from several threads. The spans live as long as this object.
  Found find(std::span<const int> samples);

 private:
  SensorSkinPtr skin_;
  SampleSetPtr samples_;
  HydroBodyPtr body_;
  double allowed_ = 0;
  std::mutex mutex_;
  std::unique_ptr<const TetCrossings> tets_;
  std::vector<SensorRay> rays_;  // by sample; max_depth is negative until it is computed
  std::vector<std::vector<std::int32_t>> crossings_;
};

/// Sets the depth of a ray from `face` of the skin: the allowed depth, or half the distance to the opposite skin. The
/// contact surface of a rigid sensor is in its skin to within rounding, so the rays of a rigid sensor start just
/// outside.
void limit_ray(const SensorSkin& skin, int face, bool soft, double allowed, SensorRay& ray);

/// A cache that is safe to use from several threads. Each function returns a known result for equal arguments.
class SensorCache {
 public:
  /// Keeps the parts of the last `meshes` meshes.
  explicit SensorCache(int meshes = 4) : meshes_(meshes) {}

  /// Returns the mesh of a layout, repaired by the recipe except its `refine`. A rigid layout, whose mesh may be open,
  /// gets the mesh as loaded unless the recipe requests `exact` or `wrap`. The key is the mesh, its faces without area,
  /// the recipe and, if the mesh is open, the thickness. Throws as repair_mesh() does.
  RepairedMeshPtr repaired(const TriMeshPtr& loaded, const RepairRecipe& recipe, const Material& material,
                           Progress* progress);
  /// Returns make_sensor_skin(). The key is the vertices and faces, and `shells`.
  SensorSkinPtr skin(const TriMeshPtr& mesh, Shells shells);
  /// Returns check_layout_mesh() without a file. The key is the vertices and faces of the repaired mesh.
  Problems mesh_problems(const RepairedMesh& repaired);
  /// Returns the body of a whole mesh. The key is its vertices and faces, the material and `refine` (Shape::refine).
  /// Throws as make_body() does.
  HydroBodyPtr body(const RepairedMesh& repaired, const Material& material, double refine, const std::string& name);
  /// Returns make_sampled_skin(). The key is the skin and the region.
  SampledSkinPtr sampled(const SensorSkinPtr& skin, const FaceSet& region);
  /// Returns the samples, with faces of the sensed skin. The key is all arguments but `progress`. Throws as
  /// sample_surface() does.
  SampleSetPtr samples(const SampledSkinPtr& skin, int count, std::uint64_t seed, SampleQuality quality,
                       Progress* progress);
  /// Returns add_dense_samples() for the samples of samples() on a skin. The key is `samples` and `how`. Throws as
  /// add_dense_samples() does.
  SampleSetPtr dense_samples(const SampledSkinPtr& skin, const SampleSetPtr& samples, const DenseSampling& how,
                             Progress* progress);
  /// Returns true if dense_samples() has a result for these arguments.
  [[nodiscard]] bool has_dense_samples(const SampleSetPtr& samples, const DenseSampling& how);
  /// Returns true if samples() has a result for these arguments.
  [[nodiscard]] bool has_samples(const SampledSkinPtr& skin, int count, std::uint64_t seed, SampleQuality quality);
  /// Returns the rays of samples. The key is the samples, the body and `allowed`.
  std::shared_ptr<SampleRays> rays(const SensorSkinPtr& skin, const SampleSetPtr& samples, const HydroBodyPtr& body,
                                   double allowed);

 private:
  struct MeshKey {
    TriMeshPtr mesh;
    bool operator==(const MeshKey& b) const {
      return mesh == b.mesh || (mesh->faces() == b.mesh->faces() && mesh->vertices() == b.mesh->vertices());
    }
  };
  struct RepairKey {
    MeshKey mesh;
    RepairRecipe recipe;
    double thickness = 0;
    bool operator==(const RepairKey& b) const {
      return recipe == b.recipe && thickness == b.thickness && mesh == b.mesh &&
             mesh.mesh->flat_faces() == b.mesh.mesh->flat_faces();
    }
  };
  /// A result, and the loaded mesh that it belongs to.
  struct Repaired {
    TriMeshPtr loaded;
    RepairedMeshPtr repaired;
  };
  struct BodyKey {
    MeshKey mesh;
    Material material;
    double refine = kDefaultRefine;
    std::vector<int> face_numbers;
    bool operator==(const BodyKey&) const = default;
  };
  struct SampledKey {
    SensorSkinPtr skin;
    FaceSet region;
    bool operator==(const SampledKey&) const = default;
  };
  struct SamplesKey {
    SampledSkinPtr skin;
    int count = 0;
    std::uint64_t seed = 0;
    SampleQuality quality{};
    bool operator==(const SamplesKey&) const = default;
  };
  struct DenseKey {
    SampleSetPtr samples;
    DenseSampling how;
    bool operator==(const DenseKey&) const = default;
  };
  struct RaysKey {
    SampleSetPtr samples;
    HydroBodyPtr body;
    double allowed = 0;
    bool operator==(const RaysKey&) const = default;
  };
  struct SkinKey {
    MeshKey mesh;
    Shells shells{};
    bool operator==(const SkinKey&) const = default;
  };
  static constexpr double kSamples = 4e6;  // at most about 300 MB
  double meshes_ = 0;
  Memo<RepairKey, Repaired> repaired_{meshes_};
  Memo<SkinKey, SensorSkinPtr> skins_{meshes_};
  Memo<MeshKey, Problems> mesh_problems_{meshes_};
  Memo<BodyKey, HydroBodyPtr> bodies_{meshes_};
  Memo<SampledKey, SampledSkinPtr> sampled_{meshes_};
  Memo<SamplesKey, SampleSetPtr> samples_{kSamples};
  Memo<DenseKey, SampleSetPtr> dense_samples_{kSamples};
  Memo<RaysKey, std::shared_ptr<SampleRays>> rays_{0.5 * meshes_};  // one for a preview, one for the polished samples
};

}  // namespace taxel
