#include "core/sensor/sensor_cache.h"

#include <algorithm>

#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/mesh/repair/repaired_mesh.h"
#include "core/sensor/rays/tet_table.h"
#include "core/sensor/stored_samples.h"

namespace taxel {
namespace {

/// Returns the distance from a sample along `direction` to the opposite skin: to the first face that is hit from
/// inside.
double opposite_skin(const MeshIndex& skin, const dvec3& origin, const dvec3& direction, int face) {
  const int limit = 16;  // faces met from outside on the way: folds that graze the start
  // A ray that starts on an edge or a corner meets the faces there at once, one after the other. The step leads past
  // all of them.
  const double least_step = 1e-12 * skin.mesh().bounds().diagonal();
  double travelled = 0.0;
  for (int i = 0; i < limit; ++i) {
    const auto hit = skin.cast_except(Ray{origin + travelled * direction, direction}, face);
    if (!hit) break;
    travelled += std::max(hit->t, least_step);
    face = hit->face;
    if (glm::dot(direction, skin.mesh().face_normals()[at(face)]) > 0.0) return travelled;
  }
  return std::numeric_limits<double>::infinity();
}

}  // namespace

SensorSkinPtr make_sensor_skin(const TriMeshPtr& mesh, Shells shells) {
  auto skin = std::make_shared<SensorSkin>();
  skin->mesh = mesh;
  const std::vector<int> outer = outer_shells(*mesh);
  if (shells == Shells::all || static_cast<int>(outer.size()) == mesh->shell_count()) {
    skin->sensed = std::make_shared<const MeshIndex>(mesh);
    skin->face_of.resize(at(mesh->face_count()));
    for (int f = 0; f < mesh->face_count(); ++f) skin->face_of[at(f)] = f;
  } else {
    auto faces = std::make_shared<TriMesh>(extract_shells(*mesh, outer, &skin->face_of));
    skin->sensed = std::make_shared<MeshIndex>(std::move(faces));
  }
  return skin;
}

SampledSkinPtr make_sampled_skin(const SensorSkin& skin, const std::vector<int>& region) {
  if (region.empty()) return std::make_shared<const SampledSkin>(skin.sensed->mesh_ptr(), std::vector<int>());
  std::vector<int> faces;  // both lists ascend
  for (std::size_t f = 0; f < skin.face_of.size(); ++f)
    if (std::binary_search(region.begin(), region.end(), skin.face_of[f])) faces.push_back(static_cast<int>(f));
  auto mesh = std::make_shared<const TriMesh>(extract_faces(skin.sensed->mesh(), faces));
  return std::make_shared<const SampledSkin>(std::move(mesh), std::move(faces));
}

void limit_ray(const SensorSkin& skin, int face, bool soft, double allowed, SensorRay& ray) {
  const double lead = soft ? 0.0 : 1e-6 * skin.sensed->mesh().bounds().diagonal();
  ray.max_depth = std::min(allowed, 0.5 * opposite_skin(*skin.sensed, ray.origin, ray.direction, face)) + lead;
  ray.origin -= lead * ray.direction;
}

SampleRays::SampleRays(SensorSkinPtr skin, SampleSetPtr samples, HydroBodyPtr body, double allowed)
    : skin_(std::move(skin)),
      samples_(std::move(samples)),
      body_(std::move(body)),
      allowed_(allowed),
      rays_(samples_->size()),
      crossings_(samples_->size()) {
  for (SensorRay& ray : rays_) ray.max_depth = -1.0;
}

SampleRays::~SampleRays() = default;

SampleRays::Found SampleRays::find(std::span<const int> samples) {
  const std::lock_guard lock(mutex_);
  const auto* soft = std::get_if<SoftBody>(&body_->geometry);
  std::vector<int> missing;
  for (const int s : samples)
    if (rays_[at(s)].max_depth < 0.0) missing.push_back(s);
  if (soft != nullptr && tets_ == nullptr && !missing.empty())
    tets_ = std::make_unique<const TetCrossings>(*soft->field);
  parallel_chunks(static_cast<int>(missing.size()), 256, [&](int begin, int end) {
    std::vector<std::int32_t> found;
    for (int i = begin; i < end; ++i) {
      const int s = missing[at(i)];
      const SurfaceSample& sample = (*samples_)[at(s)];
      SensorRay ray{s, sample.position, -sample.normal, 0.0};
      limit_ray(*skin_, sample.face, body_->soft(), allowed_, ray);
      if (tets_) tets_->find(ray, found);
      crossings_[at(s)] = found;
      rays_[at(s)] = ray;
    }
  });
  Found found;
  found.rays.reserve(samples.size());
  if (tets_) found.crossings.reserve(samples.size());
  for (const int s : samples) {
    found.rays.push_back(rays_[at(s)]);
    if (tets_) found.crossings.emplace_back(crossings_[at(s)]);
  }
  return found;
}

RepairedMeshPtr SensorCache::repaired(const TriMeshPtr& loaded, const RepairRecipe& recipe, const Material& material,
                                      Progress* progress) {
  const bool asked = recipe.level == RepairLevel::exact || recipe.level == RepairLevel::wrap;
  if (!material.compliant() && !asked) return as_loaded(loaded);
  RepairKey key{{loaded}, recipe, loaded->closed() ? 0.0 : material.thickness};
  key.recipe.refine.reset();
  const Repaired cached = repaired_.get(key, [&] {
    return Repaired{loaded, repair_mesh(loaded, recipe, key.thickness, progress)};
  });
  if (cached.repaired->mesh != cached.loaded || cached.loaded == loaded) return cached.repaired;
  auto unchanged = std::make_shared<RepairedMesh>(*cached.repaired);  // the repaired mesh is equal
  unchanged->mesh = loaded;
  return unchanged;
}

SensorSkinPtr SensorCache::skin(const TriMeshPtr& mesh, Shells shells) {
  return skins_.get({{mesh}, shells}, [&] { return make_sensor_skin(mesh, shells); });
}

Problems SensorCache::mesh_problems(const RepairedMesh& repaired) {
  return mesh_problems_.get({repaired.mesh}, [&] { return check_layout_mesh(repaired, ""); });
}

HydroBodyPtr SensorCache::body(const RepairedMesh& repaired, const Material& material, double refine,
                               const std::string& name) {
  return bodies_.get({{repaired.mesh}, material, refine, repaired.loaded_face_of}, [&] {
    Shape shape;
    shape.type = ShapeType::mesh;
    shape.mesh = repaired.mesh;
    shape.face_numbers = repaired.loaded_face_of;
    shape.refine = refine;
    return make_body(shape, material, name);
  });
}

SampledSkinPtr SensorCache::sampled(const SensorSkinPtr& skin, const FaceSet& region) {
  return sampled_.get({skin, region}, [&] { return make_sampled_skin(*skin, *region); });
}

SampleSetPtr SensorCache::samples(const SampledSkinPtr& skin, int count, std::uint64_t seed, SampleQuality quality,
                                  Progress* progress) {
  return samples_.get(
      {skin, count, seed, quality},
      [&] {
        auto samples = stored_samples(*skin->mesh, count, seed, quality,
                                      [&] { return sample_surface(*skin->mesh, count, seed, progress, quality); });
        if (!skin->face_of.empty())
          for (SurfaceSample& sample : samples) sample.face = skin->face_of[at(sample.face)];
        return std::make_shared<const std::vector<SurfaceSample>>(std::move(samples));
      },
      [](const SampleSetPtr& set) { return static_cast<double>(set->size()); });
}

SampleSetPtr SensorCache::dense_samples(const SampledSkinPtr& skin, const SampleSetPtr& samples,
                                        const DenseSampling& how, Progress* progress) {
  return dense_samples_.get(
      {samples, how},
      [&] {
        std::vector<SurfaceSample> own = *samples;
        const std::vector<int>& face_of = skin->face_of;  // ascends
        if (!face_of.empty())
          for (SurfaceSample& s : own)
            s.face = static_cast<int>(std::lower_bound(face_of.begin(), face_of.end(), s.face) - face_of.begin());
        auto dense = stored_dense_samples(*skin->mesh, own, how,
                                          [&] { return add_dense_samples(*skin->mesh, own, how, progress); });
        if (!face_of.empty())
          for (SurfaceSample& s : dense) s.face = face_of[at(s.face)];
        return std::make_shared<const std::vector<SurfaceSample>>(std::move(dense));
      },
      [](const SampleSetPtr& set) { return static_cast<double>(set->size()); });
}

bool SensorCache::has_dense_samples(const SampleSetPtr& samples, const DenseSampling& how) {
  return dense_samples_.has({samples, how});
}

bool SensorCache::has_samples(const SampledSkinPtr& skin, int count, std::uint64_t seed, SampleQuality quality) {
  return samples_.has({skin, count, seed, quality});
}

std::shared_ptr<SampleRays> SensorCache::rays(const SensorSkinPtr& skin, const SampleSetPtr& samples,
                                              const HydroBodyPtr& body, double allowed) {
  return rays_.get({samples, body, allowed},
                   [&] { return std::make_shared<SampleRays>(skin, samples, body, allowed); });
}

}  // namespace taxel
