// A layout compiled for reading: samples, receptive fields, rays and pressure field, and the functions that build it
// from layout and mesh. Immutable, and shared by simulation, plugin, command line and viewer. All values are in the
// frame M of the mesh file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/hydro/hydro_body.h"
#include "core/layout/check/layout_check.h"
#include "core/layout/field/receptive_field.h"
#include "core/layout/user_choices.h"
#include "core/mesh/mesh_io.h"
#include "core/mesh/repair/repair.h"
#include "core/sensor/rays/sensor_ray.h"
#include "core/sensor/reference/skin_fields.h"
#include "core/sensor/sensor_cache.h"

namespace taxel {

class RayGrid;
class RayTiles;
class TetTable;

/// The receptive fields by ray instead of by taxel: the uses of each ray, in compressed rows, and the sums over each
/// taxel's field. Summed once, so that the cost of a reading depends on the hits only.
struct ReadoutTable {
  /// A taxel that uses a ray.
  struct Use {
    std::int32_t taxel = 0;
    double weight = 0;    ///< ReceptiveFields::Entry::weight [m^2]
    double distance = 0;  ///< distance of the sample from the taxel's centre [m]
  };
  std::vector<int> ray_of_entry;       ///< ray of each of ReceptiveFields::entries
  std::vector<std::int32_t> first{0};  ///< offsets: the uses of ray r are [first[r], first[r + 1])
  std::vector<Use> uses;
  std::vector<double> share;                  ///< SensorModel::sample_share() of each ray's sample
  std::vector<double> weight_sum, share_sum;  ///< sums over each taxel's whole field
  std::vector<std::int32_t> nearest;          ///< ray of each taxel's nearest sample, -1 for an empty field
};

/// Builds the table of receptive fields. `ray_of_entry` has the ray of each entry, `share` the share of each ray.
ReadoutTable make_readout_table(const ReceptiveFields& fields, std::vector<int> ray_of_entry,
                                std::vector<double> share);

/// Number of colours of taxels that everybody can distinguish.
inline constexpr int kTaxelColors = 24;

/// The rays of a sensor by places (rays/cast_rays.h). A part is null if no path needs it.
struct RayTables {
  std::shared_ptr<const TetTable> tets;   ///< by tet of the body; null without tets
  std::shared_ptr<const RayTiles> tiles;  ///< by neighbours; null with a grid
  std::shared_ptr<const RayGrid> grid;    ///< by cell; null unless directions are equal
};

/// The compiled model of one sensor.
struct SensorModel {
  Layout layout;
  RepairedMeshPtr repaired;               ///< the mesh file as repaired, with its report; never null
  TriMeshPtr loaded;                      ///< mesh of the file, whose faces sampling.region lists
  TriMeshPtr mesh;                        ///< repaired->mesh with all shells; `loaded` if nothing was repaired
  std::shared_ptr<const MeshIndex> skin;  ///< sampled shells, by layout.sampling.shells
  std::vector<int> skin_face_of;          ///< face of `mesh` for each face of the skin
  HydroBodyPtr body;                      ///< body of layout.material, frame M; null if only to be viewed
  SampleQuality quality = SampleQuality::polished;
  double sampled_area = 0;                         ///< area of sampled_region(), or of the skin [m^2]
  std::vector<SurfaceSample> samples;              ///< points on the skin
  ReceptiveFields fields;                          ///< samples of each taxel with their weights
  std::vector<SensorRay> rays;                     ///< one per used sample; one per entry with ray = taxel_normal
  RayTables ray_tables;                            ///< lists in which contact polygons find their rays
  ReadoutTable readout_table;                      ///< uses of each ray
  double max_depth = 0;                            ///< readout.max_depth, or its default [m]
  SkinFieldsPtr skin_fields;                       ///< for readings that are integrals, otherwise null
  std::vector<std::vector<int>> taxels_of_sample;  ///< taxels of each sample, the nearest first
  std::vector<int> color_of_taxel;                 ///< result of color_fields() with kTaxelColors
  Problems problems;                               ///< warnings and notes, with taxel pointers

  [[nodiscard]] int taxel_count() const { return static_cast<int>(layout.taxels.size()); }
  /// Returns the number of a taxel's colour. A taxel added after color_of_taxel has its own number.
  [[nodiscard]] int color(int taxel) const {
    const auto k = static_cast<std::size_t>(taxel);
    return k < color_of_taxel.size() ? color_of_taxel[k] : taxel;
  }
  /// Returns the weight of a sample in an unweighted mean: 1, or with Voronoi weights its area over the mean area.
  [[nodiscard]] double sample_share(int sample) const;
  /// Returns sample_share() of each ray's sample.
  [[nodiscard]] std::vector<double> ray_shares() const;
};
using SensorModelPtr = std::shared_ptr<const SensorModel>;

/// Returns the sampled faces of the model's mesh, ascending; empty for all of the skin.
FaceSet sampled_region(const SensorModel& model);

/// Computes the fields that an integral other than IntegralKind::none needs.
SkinFieldsPtr skin_fields_for(const SensorModel& model, IntegralKind kind);

/// Code of the warning about a taxel without samples. It is the only warning that depends on the samples.
inline constexpr const char* kFieldWithoutSamples = "field_without_samples";

/// Returns the layout of a model for its repaired mesh, to be written with that mesh: /sampling/region lists faces of
/// the repaired mesh, and the recipe has only the values that the repaired mesh needs. Returns the layout unchanged if
/// nothing was repaired.
Layout layout_on_repaired_mesh(const SensorModel& model);

/// Returns the mesh of a model for the rules of layout_check. The result is valid as long as the model.
LayoutMesh layout_mesh(const SensorModel& model);

/// Returns the repaired mesh of a layout: SensorCache::repaired(). Throws Error naming `file` and /mesh/file, or the
/// pointer of a value of the recipe.
RepairedMeshPtr repair_for(const Layout& layout, const TriMeshPtr& loaded, SensorCache& cache, const std::string& file,
                           Progress* progress = nullptr);

/// Options of building a model.
struct SensorBuild {
  SensorBuild(Progress* p = nullptr) : progress(p) {}  // NOLINT: most callers set nothing else
  Progress* progress = nullptr;                        ///< gets the progress and may cancel; or null
  SensorCache* cache = nullptr;                        ///< cache of parts between builds, or null
  /// A preview is ready soon, while another build polishes the samples. If the cache has polished samples, a preview
  /// takes them.
  SampleQuality quality = SampleQuality::polished;
};

/// Compiles a layout on a mesh. Lists all problems below severity error. An empty `mesh_sha256` is not checked; `file`
/// is the layout's name in messages. With a cache, a build after an edit of taxels assigns samples only, and a polished
/// build after a preview makes samples and rays only. The result does not depend on the cache. Throws Error for the
/// first problem of severity error, and Cancelled through `how.progress`.
SensorModelPtr build_sensor_model(const Layout& layout, const TriMeshPtr& mesh, const std::string& mesh_sha256,
                                  const std::string& file, const SensorBuild& how = {});

/// Returns the model with another aggregate or method. No other part of a model depends on them. Throws Error for a
/// choice that the layout does not allow.
SensorModelPtr with_readout(const SensorModel& model, const ReadoutChoice& choice);

/// A layout file and its mesh as read, from which models are compiled.
struct SensorSource {
  std::string file;  ///< name of the layout in messages
  Layout layout;
  LoadedMesh mesh;
};

/// Reads layout and mesh files. Throws Error: a file cannot be read, or a value is wrong on any mesh.
SensorSource read_sensor_source(const std::filesystem::path& layout_file);
/// Compiles a layout and mesh as read, and adds the notes on the mesh to the problems. Throws as above.
SensorModelPtr build_sensor_model(const SensorSource& source, const SensorBuild& how = {});

/// Reads layout and mesh files and compiles them. Throws as above.
SensorModelPtr load_sensor_model(const std::filesystem::path& layout_file, const SensorBuild& how = {});

/// Computes the receptive fields of a layout as functions on the skin, for an integral other than IntegralKind::none.
/// `region` lists the sampled faces of skin.mesh, ascending; empty for all. `depth` is SensorModel::max_depth [m].
SkinFieldsPtr make_skin_fields(const Layout& layout, const SensorSkin& skin, const std::vector<int>& region,
                               const HydroBody& body, double depth, IntegralKind kind);

/// Returns the model of a sensor with this body but without taxels, samples and rays, for viewers and recordings, which
/// show sensors; `surface` is drawn for it.
/// Without a body (null), the model is only for viewing: it has no contact.
SensorModelPtr bare_model(const std::string& name, const TriMeshPtr& surface, const HydroBodyPtr& body);

}  // namespace taxel
