#include "core/sensor/sensor_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/parallel.h"
#include "core/hydro/fields/pressure_field.h"
#include "core/layout/field/overlap.h"
#include "core/layout/field/receptive_field.h"
#include "core/layout/file/layout_json.h"
#include "core/mesh/repair/repair.h"
#include "core/mesh/repair/repaired_mesh.h"
#include "core/sensor/rays/ray_grid.h"
#include "core/sensor/rays/ray_tiles.h"
#include "core/sensor/rays/tet_table.h"
#include "core/sensor/readout/aggregate.h"
#include "core/sensor/reference/pressure_integral.h"

namespace taxel {

ReadoutTable make_readout_table(const ReceptiveFields& fields, std::vector<int> ray_of_entry,
                                std::vector<double> share) {
  const std::size_t rays = share.size(), taxels = fields.first.size() - 1;
  ReadoutTable table;
  table.ray_of_entry = std::move(ray_of_entry);
  table.share = std::move(share);
  table.first.assign(rays + 1, 0);
  for (const int ray : table.ray_of_entry) ++table.first[at(ray) + 1];
  for (std::size_t r = 0; r < rays; ++r) table.first[r + 1] += table.first[r];
  table.uses.resize(table.ray_of_entry.size());
  std::vector<std::int32_t> filling(table.first.begin(), table.first.end() - 1);
  table.weight_sum.assign(taxels, 0.0);
  table.share_sum.assign(taxels, 0.0);
  table.nearest.assign(taxels, -1);
  for (std::size_t k = 0; k < taxels; ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (int e = fields.first[k]; e < fields.first[k + 1]; ++e) {
      const ReceptiveFields::Entry& entry = fields.entries[at(e)];
      const int ray = table.ray_of_entry[at(e)];
      table.uses[at(filling[at(ray)]++)] = {static_cast<std::int32_t>(k), entry.weight, entry.distance};
      table.weight_sum[k] += entry.weight;
      table.share_sum[k] += table.share[at(ray)];
      if (entry.distance < least) least = entry.distance, table.nearest[k] = ray;
    }
  }
  return table;
}

SkinFieldsPtr make_skin_fields(const Layout& layout, const SensorSkin& skin, const std::vector<int>& region,
                               const HydroBody& body, double depth, IntegralKind kind) {
  auto weights = std::make_shared<const FieldWeights>(layout, *skin.sensed);
  auto fields = std::make_shared<SkinFields>(SkinFields{weights, FaceFields(weights, skin.sensed->mesh()), {}, {}, {}});
  if (kind == IntegralKind::force) {
    // The tets of a pad end at its thickness. Where contact is deeper, guesses are not worth their lists.
    const double thickness = body.material.thickness;
    fields->nearest.emplace(*skin.sensed, thickness > 0 ? std::min(thickness, depth) : depth);
  } else {
    fields->prisms.emplace(skin, region, fields->faces, body, depth);
    fields->whole = PressureIntegral::of_whole_fields(*fields, static_cast<int>(layout.taxels.size()),
                                                      kind == IntegralKind::weighted_mean);
  }
  return fields;
}

namespace {

HydroBodyPtr body_of(const Layout& layout, const RepairedMesh& mesh, SensorCache& cache, const std::string& file) {
  try {
    return cache.body(mesh, layout.material, layout.mesh.repair.refine.value_or(kDefaultRefine), layout.name);
  } catch (const Error& e) {
    throw Error(file, "/material", e.message());
  }
}

void add_problems_of_body(SensorModel& model, const std::string& file) {
  if (const auto* soft = std::get_if<SoftBody>(&model.body->geometry)) {
    for (Problem& p : field_problems(soft->field->report(), file, "/material")) {
      if (p.severity != Severity::note) model.problems.push_back(std::move(p));  // notes are shown on request only
    }
  }
}

/// Returns readout.max_depth, or its default: twice the thickness of a pad, otherwise the largest radius of a taxel
/// (the field of a star reaches to the centre).
double allowed_depth(const SensorModel& model) {
  const double asked = model.layout.readout.max_depth;
  if (asked > 0.0) return asked;
  const Material& material = model.body->material;
  if (material.field == FieldKind::pad && material.thickness > 0.0) return 2.0 * material.thickness;
  double largest = 0.0;
  for (const Taxel& taxel : model.layout.taxels) largest = std::max(largest, taxel.radius);
  return largest;
}

/// Adds one ray per entry of a receptive field.
void add_taxel_rays(SensorModel& model, const SensorSkin& skin, double allowed) {
  for (int k = 0; k < model.taxel_count(); ++k) {
    const dvec3 outward = glm::normalize(model.layout.taxels[at(k)].normal);
    for (int e = model.fields.first[at(k)]; e < model.fields.first[at(k) + 1]; ++e) {
      const int sample = model.fields.entries[at(e)].sample;
      model.readout_table.ray_of_entry[at(e)] = static_cast<int>(model.rays.size());
      model.rays.push_back({sample, model.samples[at(sample)].position, -outward, 0.0});
    }
  }
  parallel_chunks(static_cast<int>(model.rays.size()), 256, [&](int begin, int end) {
    for (int r = begin; r < end; ++r) {
      SensorRay& ray = model.rays[at(r)];
      limit_ray(skin, model.samples[at(ray.sample)].face, model.body->soft(), allowed, ray);
    }
  });
  if (const auto* soft = std::get_if<SoftBody>(&model.body->geometry))
    model.ray_tables.tets = std::make_shared<const TetTable>(*soft->field, model.rays);
}

/// Adds one ray per used sample, shared by its taxels, in the order of the samples.
void add_sample_rays(SensorModel& model, SampleRays& sample_rays) {
  std::vector<int> ray_of_sample(model.samples.size(), -1), used;
  for (const ReceptiveFields::Entry& entry : model.fields.entries) ray_of_sample[at(entry.sample)] = 0;
  for (std::size_t s = 0; s < ray_of_sample.size(); ++s) {
    if (ray_of_sample[s] < 0) continue;
    ray_of_sample[s] = static_cast<int>(used.size());
    used.push_back(static_cast<int>(s));
  }
  for (std::size_t e = 0; e < model.fields.entries.size(); ++e)
    model.readout_table.ray_of_entry[e] = ray_of_sample[at(model.fields.entries[e].sample)];
  SampleRays::Found found = sample_rays.find(used);
  model.rays = std::move(found.rays);
  if (const auto* soft = std::get_if<SoftBody>(&model.body->geometry))
    model.ray_tables.tets = std::make_shared<const TetTable>(*soft->field, model.rays, found.crossings);
}

void add_rays(SensorModel& model, const SensorSkinPtr& skin, const SampleSetPtr& samples, SensorCache& cache) {
  model.readout_table.ray_of_entry.resize(model.fields.entries.size());
  model.max_depth = allowed_depth(model);
  const double allowed = model.max_depth;
  if (model.layout.readout.ray == RayDirection::taxel_normal) {
    add_taxel_rays(model, *skin, allowed);
  } else {
    add_sample_rays(model, *cache.rays(skin, samples, model.body, allowed));
  }
  model.ray_tables.grid = RayGrid::make(model.rays);
  if (!model.ray_tables.grid) model.ray_tables.tiles = std::make_shared<const RayTiles>(model.rays);
  model.readout_table =
      make_readout_table(model.fields, std::move(model.readout_table.ray_of_entry), model.ray_shares());
}

void add_taxels_of_samples(SensorModel& model) {
  const std::vector<ReceptiveFields::Entry>& entries = model.fields.entries;
  // The end of the users of each sample. Users are filled in from the end, so that at last it is their begin.
  std::vector<int> end(model.samples.size() + 1, 0);
  for (const ReceptiveFields::Entry& entry : entries) ++end[at(entry.sample)];
  for (std::size_t s = 1; s < end.size(); ++s) end[s] += end[s - 1];
  std::vector<std::pair<double, int>> users(entries.size());
  for (int k = 0; k < model.taxel_count(); ++k)
    for (int e = model.fields.first[at(k)]; e < model.fields.first[at(k) + 1]; ++e)
      users[at(--end[at(entries[at(e)].sample)])] = {entries[at(e)].distance, k};
  model.taxels_of_sample.resize(model.samples.size());
  for (std::size_t s = 0; s < model.samples.size(); ++s) {
    const auto of_sample = std::span(users).subspan(at(end[s]), at(end[s + 1] - end[s]));
    std::sort(of_sample.begin(), of_sample.end());
    model.taxels_of_sample[s].reserve(of_sample.size());
    for (const auto& [distance, taxel] : of_sample) model.taxels_of_sample[s].push_back(taxel);
  }
}

void note_empty_fields(SensorModel& model, const std::string& file) {
  Problems found;
  for (int k = 0; k < model.taxel_count(); ++k) {
    if (model.fields.first[at(k)] != model.fields.first[at(k) + 1]) continue;
    const std::string pointer = fmt::format("/taxels/{}", k);
    const bool is_reported = std::any_of(model.problems.begin(), model.problems.end(), [&](const Problem& p) {
      return p.code == "field_empty" && (p.pointer == pointer || p.pointer.starts_with(pointer + "/"));
    });
    if (!is_reported)
      found.push_back({file, pointer, Severity::warning, kFieldWithoutSamples,
                       "no sample lies in the receptive field: it will read 0",
                       model.layout.sampling.region->empty() ? "raise /sampling/density"
                                                             : "paint the region there, or raise /sampling/density"});
  }
  name_taxels(model.layout, found);
  model.problems.insert(model.problems.end(), found.begin(), found.end());
}

/// The input of a build.
struct Input {
  const Layout& layout;
  const TriMeshPtr& mesh;
  const std::string& mesh_sha256;
  const std::string& file;
  const std::vector<std::string>* mesh_notes;  ///< notes of reading the mesh, or null
};

/// Returns a region of the loaded mesh as faces of the repaired mesh. If none of its faces is left, the result has a
/// face that does not exist, because an empty region means all faces.
FaceSet repaired_region(const RepairedMesh& repaired, const FaceSet& region) {
  if (repaired.loaded_face_of.empty() || region->empty()) return region;
  std::vector<int> faces = repaired_faces(repaired, *region);
  if (faces.empty()) faces = {repaired.mesh->face_count()};
  return faces;
}

/// Adds the fields for readings that are integrals.
void add_skin_fields(SensorModel& model) {
  const IntegralKind kind = integral_of(model.layout.readout);
  model.skin_fields = kind == IntegralKind::none ? nullptr : skin_fields_for(model, kind);
}

/// Adds the samples and the receptive fields, which do not need the body.
SampleSetPtr add_samples(SensorModel& model, const SensorSkinPtr& skin, SensorCache& cache, const SensorBuild& how) {
  const Sampling& sampling = model.layout.sampling;
  const SampledSkinPtr sampled = cache.sampled(skin, sampled_region(model));
  model.sampled_area = sampled->mesh->area();
  const int count = sample_count(sampling.density, model.sampled_area);
  const auto quality = [&](bool is_known) { return is_known ? SampleQuality::polished : how.quality; };
  model.quality = quality(cache.has_samples(sampled, count, sampling.seed, SampleQuality::polished));
  const std::vector<DenseDisc> dense = dense_fields(model.layout, *skin->sensed);
  if (how.progress != nullptr) how.progress->set_step("Placing samples");
  SampleSetPtr samples = [&] {
    const ProgressPart part(how.progress, 0, dense.empty() ? 1 : 0.5);
    return cache.samples(sampled, count, sampling.seed, model.quality, how.progress);
  }();
  if (!dense.empty()) {
    const ProgressPart part(how.progress, 0.5, 1);
    if (model.quality == SampleQuality::polished)
      model.quality =
          quality(cache.has_dense_samples(samples, {sampling.density, dense, sampling.seed, SampleQuality::polished}));
    samples =
        cache.dense_samples(sampled, samples, {sampling.density, dense, sampling.seed, model.quality}, how.progress);
  }
  model.skin = skin->sensed;
  model.skin_face_of = skin->face_of;
  model.samples = *samples;
  model.fields = make_receptive_fields(model.layout, model.samples, *model.skin);
  add_taxels_of_samples(model);
  model.color_of_taxel = color_fields(model.layout, kTaxelColors);
  return samples;
}

void append(const Problems& found, Problems& problems) {
  problems.insert(problems.end(), found.begin(), found.end());
}

void add_problems_of_mesh(SensorModel& model, Problems found, const Input& input) {
  for (Problem& p : found) {
    p.file = input.file;
    model.problems.push_back(std::move(p));
  }
  for (const std::string& note : *input.mesh_notes)
    model.problems.push_back({input.file, "/mesh/file", Severity::note, "mesh_repaired", note, ""});
}

SensorModelPtr compile(const Input& input, const SensorBuild& how) {
  SensorCache own;
  SensorCache& cache = how.cache != nullptr ? *how.cache : own;
  auto model = std::make_shared<SensorModel>();
  model->layout = input.layout;
  model->loaded = input.mesh;
  model->problems = check_layout_values(input.layout, input.file);
  throw_first_error(model->problems);
  const double begin = how.progress != nullptr ? how.progress->reached() : 0;
  {
    constexpr double kRepair = 0.4;  // about its part of the time where it is not known yet
    const ProgressPart part(how.progress, begin, begin + kRepair * (1 - begin));
    model->repaired = repair_for(input.layout, input.mesh, cache, input.file, how.progress);
  }
  model->mesh = model->repaired->mesh;
  append(repair_problems(model->repaired->report, input.file), model->problems);
  const ProgressPart rest(how.progress, how.progress != nullptr ? how.progress->reached() : 0, 1);
  SensorSkinPtr skin;
  SampleSetPtr samples;
  Problems of_mesh;
  // The body does not need the skin, and the samples do not need the body.
  parallel_all(
      [&] {
        skin = cache.skin(model->mesh, input.layout.sampling.shells);
        const Problems found = check_layout_on_skin(input.layout, {*input.mesh, *model->repaired, *skin->sensed},
                                                    input.mesh_sha256, input.file);
        append(found, model->problems);
        throw_first_error(found);
        samples = add_samples(*model, skin, cache, how);
      },
      [&] { model->body = body_of(input.layout, *model->repaired, cache, input.file); },
      [&] {
        if (input.mesh_notes == nullptr) return;
        of_mesh = cache.mesh_problems(*model->repaired);
        append(check_loaded_mesh(*input.mesh, *model->repaired, input.file), of_mesh);
      });
  add_problems_of_body(*model, input.file);
  add_rays(*model, skin, samples, cache);
  add_skin_fields(*model);
  note_empty_fields(*model, input.file);
  if (input.mesh_notes != nullptr) add_problems_of_mesh(*model, std::move(of_mesh), input);
  if (how.progress != nullptr) how.progress->check(1.0);
  return model;
}

/// Returns SensorModel::sample_share(), with the number of samples of uniform_samples().
double share_of(const SensorModel& model, int sample, double uniform) {
  const SurfaceSample& of = model.samples[at(sample)];
  if (model.layout.sampling.weights == SampleWeights::equal) return of.share;
  return of.area * uniform / model.sampled_area;
}

}  // namespace

FaceSet sampled_region(const SensorModel& model) {
  return repaired_region(*model.repaired, model.layout.sampling.region);
}

SkinFieldsPtr skin_fields_for(const SensorModel& model, IntegralKind kind) {
  return make_skin_fields(model.layout, {model.mesh, model.skin, model.skin_face_of}, *sampled_region(model),
                          *model.body, model.max_depth, kind);
}

double SensorModel::sample_share(int sample) const {
  return share_of(*this, sample, uniform_samples(layout, samples.size(), sampled_area));
}

std::vector<double> SensorModel::ray_shares() const {
  const double uniform = uniform_samples(layout, samples.size(), sampled_area);
  std::vector<double> shares;
  shares.reserve(rays.size());
  for (const SensorRay& ray : rays) shares.push_back(share_of(*this, ray.sample, uniform));
  return shares;
}

Layout layout_on_repaired_mesh(const SensorModel& model) {
  Layout layout = model.layout;
  if (model.mesh == model.loaded) return layout;
  layout.mesh.repair = {};
  layout.mesh.repair.refine = model.layout.mesh.repair.refine;
  layout.sampling.region = repaired_region(*model.repaired, layout.sampling.region);
  return layout;
}

LayoutMesh layout_mesh(const SensorModel& model) {
  return {*model.loaded, *model.repaired, *model.skin};
}

RepairedMeshPtr repair_for(const Layout& layout, const TriMeshPtr& loaded, SensorCache& cache, const std::string& file,
                           Progress* progress) {
  try {
    return cache.repaired(loaded, layout.mesh.repair, layout.material, progress);
  } catch (const Error& e) {
    throw Error(file, e.where().starts_with("/mesh/") ? e.where() : "/mesh/file", e.message());
  }
}

SensorModelPtr build_sensor_model(const Layout& layout, const TriMeshPtr& mesh, const std::string& mesh_sha256,
                                  const std::string& file, const SensorBuild& how) {
  return compile({layout, mesh, mesh_sha256, file, nullptr}, how);
}

SensorSource read_sensor_source(const std::filesystem::path& layout_file) {
  SensorSource source{layout_file.string(), read_layout(layout_file), {}};
  throw_first_error(check_layout_values(source.layout, source.file));
  source.mesh = load_mesh(mesh_path(source.layout, layout_file), source.layout.mesh.scale);
  return source;
}

SensorModelPtr build_sensor_model(const SensorSource& source, const SensorBuild& how) {
  return compile({source.layout, source.mesh.mesh, source.mesh.sha256, source.file, &source.mesh.notes}, how);
}

SensorModelPtr with_readout(const SensorModel& model, const ReadoutChoice& choice) {
  auto other = std::make_shared<SensorModel>(model);
  other->layout.readout = choice.applied_to(model.layout.readout);
  throw_first_error(check_layout_values(other->layout, other->layout.name));
  add_skin_fields(*other);
  return other;
}

SensorModelPtr load_sensor_model(const std::filesystem::path& layout_file, const SensorBuild& how) {
  return build_sensor_model(read_sensor_source(layout_file), how);
}

SensorModelPtr bare_model(const std::string& name, const TriMeshPtr& surface, const HydroBodyPtr& body) {
  const auto model = std::make_shared<SensorModel>();
  model->layout.name = name;
  model->layout.mesh.file = model->layout.name;
  model->layout.frame = {{1, 0, 0}, {0, 0, 1}};
  if (body) model->layout.material = body->material;
  model->loaded = model->mesh = surface;
  model->repaired = std::make_shared<const RepairedMesh>(RepairedMesh{model->mesh, {}, {}, {}, {}});
  model->skin = std::make_shared<const MeshIndex>(model->mesh);
  model->skin_face_of.resize(static_cast<std::size_t>(model->mesh->face_count()));
  std::iota(model->skin_face_of.begin(), model->skin_face_of.end(), 0);
  model->sampled_area = surface->area();
  model->body = body;
  return model;
}

}  // namespace taxel
