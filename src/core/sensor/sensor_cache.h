// The expensive parts of sensor models, none of which depends on where the taxels are: kept from one model to the next,
// so that an edit of taxels only assigns the samples anew.
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
#include "core/sensor/rays/tet_crossings.h"

namespace taxel {

/// A mesh and the part of it that is sampled.
struct SensorSkin {
  TriMeshPtr mesh;                          ///< all shells
  std::shared_ptr<const MeshIndex> sensed;  ///< of those that are sampled
  std::vector<int> face_of;                 ///< sensed face -> face of `mesh`
};
using SensorSkinPtr = std::shared_ptr<const SensorSkin>;
using SampleSetPtr = std::shared_ptr<const std::vector<SurfaceSample>>;

SensorSkinPtr make_sensor_skin(const TriMeshPtr& mesh, Shells shells);

/// Where samples lie: the sensed skin, or those of its faces that a region names.
struct SampledSkin {
  TriMeshPtr mesh;
  std::vector<int> face_of;  ///< face of `mesh` -> sensed face; empty: they are the same
};
using SampledSkinPtr = std::shared_ptr<const SampledSkin>;

/// `region`: faces of skin.mesh, ascending; those that are not sensed, or not there, are left out.
SampledSkinPtr make_sampled_skin(const SensorSkin& skin, const std::vector<int>& region);

/// Rays from samples into the body, against the surface normal: how deep each may go and which tets it crosses, found
/// when first asked for.
class SampleRays {
 public:
  /// `allowed`: of Readout::max_depth [m].
  SampleRays(SensorSkinPtr skin, SampleSetPtr samples, HydroBodyPtr body, double allowed);

  struct Found {
    std::vector<SensorRay> rays;
    std::vector<std::span<const std::int32_t>>
        crossings;  ///< tets of each ray, ascending; empty where the body has no tets
  };
  /// One ray for each of `samples`. From any thread; the spans live as long as this object.
  Found find(std::span<const int> samples);

 private:
  SensorSkinPtr skin_;
  SampleSetPtr samples_;
  HydroBodyPtr body_;
  double allowed_ = 0;
  std::mutex mutex_;
  std::unique_ptr<const TetCrossings> tets_;
  std::vector<SensorRay> rays_;  // by sample; max_depth < 0: not found yet
  std::vector<std::vector<std::int32_t>> crossings_;
};

/// Sets the depth of a ray from `face` of the skin: the allowed one, or halfway to the opposite skin. The contact
/// surface of a rigid sensor lies in its skin, to within rounding: its rays start just outside.
void limit_ray(const SensorSkin& skin, int face, bool soft, double allowed, SensorRay& ray);

/// From any thread.
class SensorCache {
 public:
  /// The mesh of a layout as it is used: repaired by the recipe, of which `refine` does not count, for a soft layout;
  /// as loaded for a rigid one, which need not be closed, unless the recipe asks for `exact` or `wrap`. By the mesh,
  /// its faces without area, recipe and, if the mesh is open, thickness. Throws as repair_mesh() does.
  RepairedMeshPtr repaired(const TriMeshPtr& loaded, const RepairRecipe& recipe, const Material& material,
                           Progress* progress);
  /// Skin of a mesh: by its vertices and faces, and which shells.
  SensorSkinPtr skin(const TriMeshPtr& mesh, Shells shells);
  /// Result of check_layout_mesh() without a file: by the vertices and faces of the repaired mesh.
  Problems mesh_problems(const RepairedMesh& repaired);
  /// Body of a whole mesh: by its vertices and faces, material and `refine` (Shape::refine). Throws as make_body does.
  HydroBodyPtr body(const RepairedMesh& repaired, const Material& material, double refine, const std::string& name);
  /// The part of a skin that is sampled: by skin and region.
  SampledSkinPtr sampled(const SensorSkinPtr& skin, const FaceSet& region);
  /// Samples, with faces of the sensed skin: by what is sampled, count, seed and quality. Throws as sample_surface
  /// does.
  SampleSetPtr samples(const SampledSkinPtr& skin, int count, std::uint64_t seed, SampleQuality quality,
                       Progress* progress);
  /// Whether samples() would find them.
  [[nodiscard]] bool has_samples(const SampledSkinPtr& skin, int count, std::uint64_t seed, SampleQuality quality);
  /// By what it is made of.
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
  /// A result under the mesh that it was made of.
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
  static constexpr double kEntries = 4, kSamples = 4e6;  // about 300 MB
  Memo<RepairKey, Repaired> repaired_{kEntries};
  Memo<SkinKey, SensorSkinPtr> skins_{kEntries};
  Memo<MeshKey, Problems> mesh_problems_{kEntries};
  Memo<BodyKey, HydroBodyPtr> bodies_{kEntries};
  Memo<SampledKey, SampledSkinPtr> sampled_{kEntries};
  Memo<SamplesKey, SampleSetPtr> samples_{kSamples};
  Memo<RaysKey, std::shared_ptr<SampleRays>> rays_{2};  // one for a preview, one for what replaces it
};

}  // namespace taxel
