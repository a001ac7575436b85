// A layout compiled for reading: samples, receptive fields, rays, pressure field. Immutable, shared by simulation,
// plugin, command line and viewer. All in the frame M of the mesh file.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "core/base/progress.h"
#include "core/hydro/hydro_body.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/field/field_weights.h"
#include "core/layout/field/receptive_field.h"
#include "core/layout/layout.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/query/closest_point.h"
#include "core/mesh/repair/repair.h"
#include "core/sensor/rays/ray_grid.h"
#include "core/sensor/rays/sensor_ray.h"
#include "core/sensor/rays/tet_table.h"
#include "core/sensor/readout/readout_table.h"
#include "core/sensor/sensor_cache.h"

namespace taxel {

/// So many colours are told apart by everybody.
inline constexpr int kTaxelColors = 24;

struct SensorModel {
  Layout layout;
  RepairedMeshPtr repaired;               ///< the mesh file as repaired, with its report; never null
  TriMeshPtr loaded;                      ///< the mesh as read from the file, which sampling.region counts faces of
  TriMeshPtr mesh;                        ///< repaired->mesh, all shells: `loaded` itself if nothing was repaired
  std::shared_ptr<const MeshIndex> skin;  ///< the shells that are sampled: layout.sampling.shells
  std::vector<int> skin_face_of;          ///< skin face -> face of `mesh`
  HydroBodyPtr body;                      ///< soft (layout.material), frame M
  SampleQuality quality = SampleQuality::polished;
  double sampled_area = 0;                         ///< of layout.sampling.region, or all of the skin [m^2]
  std::vector<SurfaceSample> samples;              ///< on the skin
  ReceptiveFields fields;                          ///< entries name samples
  std::vector<SensorRay> rays;                     ///< one per used sample (and per taxel with ray = taxel_normal)
  std::shared_ptr<const TetTable> tet_table;       ///< of `rays` in the field of `body`; null where it has no tets
  std::shared_ptr<const RayGrid> ray_grid;         ///< of `rays` where they share one direction; otherwise null
  ReadoutTable readout_table;                      ///< what each ray counts in each taxel
  double max_depth = 0;                            ///< readout.max_depth, or its default [m]
  std::shared_ptr<const FieldWeights> weights;     ///< of Aggregate::force; null for others
  std::vector<std::vector<int>> taxels_of_sample;  ///< nearest taxel first; empty: unused
  std::vector<int> color_of_taxel;  ///< color_fields with kTaxelColors; those beyond have their own number
  Problems problems;                ///< warnings and notes, with taxel pointers
  [[nodiscard]] int taxel_count() const { return static_cast<int>(layout.taxels.size()); }
  [[nodiscard]] int color(int taxel) const {
    const auto k = static_cast<std::size_t>(taxel);
    return k < color_of_taxel.size() ? color_of_taxel[k] : taxel;
  }
  /// What one sample counts in an unweighted mean: 1, or its Voronoi area over the mean area where weights are voronoi.
  [[nodiscard]] double sample_share(int sample) const;
  /// Returns sample_share() of each ray's sample.
  [[nodiscard]] std::vector<double> ray_shares() const;
};
using SensorModelPtr = std::shared_ptr<const SensorModel>;

/// Code of the warning that no sample lies in the field of a taxel: unlike all others it depends on the samples.
inline constexpr const char* kFieldWithoutSamples = "field_without_samples";

/// The layout of a model for its repaired mesh, to be written with that mesh: /sampling/region counts the repaired
/// faces, and its recipe has only the values that the repaired mesh still needs. Unchanged if nothing was
/// repaired.
Layout layout_on_repaired_mesh(const SensorModel& model);

/// The mesh of a model for the rules of layout_check. Valid while the model lives.
LayoutMesh layout_mesh(const SensorModel& model);

/// The mesh of a layout as it is used: SensorCache::repaired(). Throws Error that names `file` and /mesh/file, or the
/// pointer of a value of the recipe.
RepairedMeshPtr repair_for(const Layout& layout, const TriMeshPtr& loaded, SensorCache& cache, const std::string& file,
                           Progress* progress = nullptr);

/// How a model is built.
struct SensorBuild {
  SensorBuild(Progress* p = nullptr) : progress(p) {}  // NOLINT: most callers have no more to say
  Progress* progress = nullptr;                        ///< told how far it is; may cancel
  SensorCache* cache = nullptr;                        ///< where parts are found and kept; null: all is made anew
  /// preview: a first reading soon, while another build polishes; of polished samples where the cache has them already.
  SampleQuality quality = SampleQuality::polished;
};

/// Compiles a layout on a mesh. Throws Error for the first problem of severity error; lists the rest. `mesh_sha256` may
/// be empty (unchecked); `file` names the layout in messages. Throws Cancelled through `how.progress`. With a cache, an
/// edit of taxels costs their assignment, and the polished build after a preview its samples and rays; the result is
/// the same with any cache.
SensorModelPtr build_sensor_model(const Layout& layout, const TriMeshPtr& mesh, const std::string& mesh_sha256,
                                  const std::string& file, const SensorBuild& how = {});

/// The same sensor read another way: nothing else of a model depends on layout.readout.aggregate.
SensorModelPtr with_aggregate(const SensorModel& model, Aggregate aggregate);

/// A layout file and its mesh as read: what its models are compiled from.
struct SensorSource {
  std::string file;  ///< names the layout in messages
  Layout layout;
  LoadedMesh mesh;
};

/// Reads layout and mesh files. Throws Error for what cannot be read, and for values that no mesh could make right.
SensorSource read_sensor_source(const std::filesystem::path& layout_file);
/// The same as above, with what there is to say about the mesh itself.
SensorModelPtr build_sensor_model(const SensorSource& source, const SensorBuild& how = {});

/// Reads layout and mesh files and compiles them.
SensorModelPtr load_sensor_model(const std::filesystem::path& layout_file, const SensorBuild& how = {});

}  // namespace taxel
