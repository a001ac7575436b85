// Other readings of the same two contacts, from which verdict.cpp finds the cause of a change: with another field,
// other samples, another angle or other settings.
//
// Each function changes one thing and reads the recorded contact surfaces again; nothing is simulated. Uniform
// stiffness gives each polygon the pressure k depth at the place where it is, which is right for a rigid body, whose
// surface lies there whatever the field is. Between two soft bodies the surface itself would move, so nothing is said
// then. Remedies are tried from the smallest change to the largest and stop at the first one that brings the change
// below nine tenths of the limit; the margin is for the largest reading, which a remedy changes too.
//
// Cost: readings of two contacts, and the compilation of a sensor for each remedy that changes samples or fields; the
// cache keeps the parts that stay. Pitfall: a remedy that cannot be compiled is no error of the explanation, and is
// skipped or ends the trials.
#include "core/sensor/explain/counterfactual.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/sensor/readout/aggregate.h"
#include "core/sensor/readout/reading.h"

namespace taxel {
namespace {

const PressureField* field_of(const SensorModel& model) {
  const auto* soft = std::get_if<SoftBody>(&model.body->geometry);
  return soft != nullptr ? soft->field.get() : nullptr;
}

}  // namespace

InvertedTets::InvertedTets(const SensorModel& model) : skin_(model.skin) {
  const PressureField* field = field_of(model);
  if (field == nullptr || field->report().inverted == 0) return;
  tets_.resize(field->tets().size());
  faces_.resize(at(skin_->mesh().face_count()));
  for (std::size_t t = 0; t < tets_.size(); ++t) {
    const Tet& tet = field->tets()[t];
    for (int corner = 0; corner < 4; ++corner) {
      if (!field->is_skin(tet, corner)) continue;
      dvec3 middle(0);
      for (int i = 0; i < 4; ++i)
        if (i != corner) middle += field->vertices()[at(tet.vertices[i])] / 3.0;
      const int face = skin_->closest_point(middle).face;
      if (!(glm::dot(tet.normal[at(corner)], skin_->mesh().face_normals()[at(face)]) > 0)) continue;
      tets_[t] = true;
      faces_[at(face)] = true;
    }
  }
}

bool InvertedTets::concern(const ContactPolygon& polygon) const {
  if (tets_.empty() || polygon.tet < 0) return false;
  return tets_[at(polygon.tet)] || faces_[at(skin_->closest_point(polygon.centroid).face)];
}

bool field_is_suspect(const SensorModel& model) {
  const PressureField* field = field_of(model);
  return field != nullptr && (model.layout.material.field == FieldKind::star || field->report().inverted > 0);
}

bool between_soft_bodies(const ContactSurface& surface) {
  if (surface.empty()) return false;
  const ContactPolygon& first = surface.polygons.front();
  if (first.tet_b >= 0) return true;
  if (first.face >= 0) return false;
  constexpr double kOnePlane = 1e-6;  // largest difference of normals
  return std::any_of(surface.polygons.begin(), surface.polygons.end(), [&](const ContactPolygon& p) {
    return glm::length(glm::cross(p.normal, first.normal)) > kOnePlane;
  });
}

OtherSurfaces with_even_stiffness(const SensorModel& model, std::span<const ContactSurface* const> surfaces) {
  const PressureField* field = field_of(model);
  const double stiffness = field != nullptr ? field->report().stiffness_mean : 0.0;
  const auto* soft = std::get_if<SoftBody>(&model.body->geometry);
  const bool ends = field != nullptr && model.layout.material.field == FieldKind::pad && !soft->depth;
  const double thickness = ends ? field->report().thickness : std::numeric_limits<double>::infinity();
  OtherSurfaces out;
  out.surfaces.resize(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    out.pointers.push_back(surfaces[i] != nullptr ? &out.surfaces[i] : nullptr);
    if (surfaces[i] == nullptr) continue;
    out.surfaces[i] = *surfaces[i];
    for (ContactPolygon& p : out.surfaces[i].polygons) {
      const SignedPoint near = model.skin->signed_point(p.centroid);
      const double depth = std::max(0.0, -near.signed_distance);
      dvec3 inward = -model.skin->mesh().face_normals()[at(near.point.face)];
      if (depth > 0) inward = (p.centroid - near.point.position) / depth;
      const double counting = static_cast<double>(p.weight) * stiffness;
      p.pressure = counting * std::min(depth, thickness);
      p.gradient = depth < thickness ? counting * inward : dvec3(0);
    }
  }
  return out;
}

double reading_of(const SensorModel& model, int taxel, const SensorStep& step) {
  SensorReading reading;
  read_sensor(model, surface_pointers(step), reading);
  return reading.values[static_cast<std::size_t>(taxel)];
}

namespace {

double change_of(const SensorModel& model, int taxel, const SensorStep& before, const SensorStep& now) {
  return reading_of(model, taxel, now) - reading_of(model, taxel, before);
}

}  // namespace

std::optional<SamplesNeeded> samples_that_cure(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                               const SensorStep& now, double limit, DenserModels& made,
                                               SensorCache& cache, Progress* progress) {
  std::optional<SamplesNeeded> tried;
  const double asked = static_cast<double>(model->samples.size());
  for (const double factor : kTriedFactors) {
    if (factor * asked > kMaxTriedSamples) break;
    SensorModelPtr& denser = made[factor];
    try {
      if (!denser) denser = with_samples_times(factor, model, cache, progress);
    } catch (const Error&) {
      break;  // the samples cannot be made
    }
    const double samples = static_cast<double>(denser->samples.size());
    double change = change_of(*denser, taxel, before, now);
    if (aggregate_spec(model->layout.readout.aggregate).grows_with_samples && samples > 0) change *= asked / samples;
    tried = SamplesNeeded{samples, factor, change, std::abs(change) <= kCureMargin * limit};
    if (tried->cures) break;
  }
  return tried;
}

SensorModel without_angle_limit(const SensorModel& model) {
  SensorModel other(model);
  other.layout.receptive_field.max_angle_deg = kTriedAngles.back();
  other.layout.receptive_field.angle_falloff_deg = 0.0;
  if (other.skin_fields != nullptr) other.skin_fields = skin_fields_for(other, integral_of(other.layout.readout));
  return other;
}

std::optional<AngleTried> angle_that_cures(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                           const SensorStep& now, double limit, SensorCache& cache,
                                           Progress* progress) {
  std::optional<AngleTried> tried;
  for (const double angle : kTriedAngles) {
    if (!(angle > model->layout.receptive_field.max_angle_deg)) continue;
    Layout layout = model->layout;
    layout.receptive_field.max_angle_deg = angle;
    SensorBuild how(progress);
    how.cache = &cache;
    how.quality = model->quality;
    try {
      const SensorModelPtr wider = build_sensor_model(layout, model->loaded, "", layout.name, how);
      const double change = change_of(*wider, taxel, before, now);
      tried = AngleTried{angle, change, std::abs(change) <= kCureMargin * limit};
    } catch (const Error&) {
      break;  // the layout cannot be compiled
    }
    if (tried->cures) break;
  }
  return tried;
}

double change_with_voronoi_weights(const SensorModel& model, int taxel, const SensorStep& before,
                                   const SensorStep& now) {
  SensorModel other(model);
  other.layout.sampling.weights = SampleWeights::voronoi;
  other.fields = make_receptive_fields(other.layout, other.samples, *other.skin);
  other.readout_table = make_readout_table(other.fields, model.readout_table.ray_of_entry, other.ray_shares());
  return change_of(other, taxel, before, now);
}

namespace {

/// Returns the settings in the order in which they are tried: those that change the fewest readings first.
std::vector<SettingTried> settings_for(const Layout& layout, int taxel) {
  std::vector<SettingTried> settings;
  const ReceptiveFieldRule& own = layout.receptive_field;
  const auto add = [&](std::string text) -> SettingTried& {
    settings.push_back({std::move(text), own, layout.readout});
    return settings.back();
  };
  constexpr double kAllAngles = 180;  // the limit of the angle that cuts nothing [degrees]
  if (own.max_angle_deg < kAllAngles) {
    if (own.normals == FieldNormals::face)
      add("angles from normals interpolated over the faces").field.normals = FieldNormals::interpolated;
    for (const double falloff : kTriedFalloffs) {
      if (!(falloff > own.angle_falloff_deg && falloff <= own.max_angle_deg)) continue;
      ReceptiveFieldRule& rule =
          add(fmt::format("a roll-off of {:g} degrees over interpolated normals", falloff)).field;
      rule.normals = FieldNormals::interpolated;
      rule.angle_falloff_deg = falloff;
    }
  }
  const Readout& readout = layout.readout;
  if (readout.aggregate != Aggregate::force) {
    if (readout.ray == RayDirection::surface_normal && readout.method == ReadingMethod::samples)
      add("rays along the taxel's normal").readout.ray = RayDirection::taxel_normal;
    if (readout.method == ReadingMethod::samples && readout.ray == RayDirection::surface_normal &&
        aggregate_spec(readout.aggregate).integral != IntegralKind::none)
      add("exact readings").readout.method = ReadingMethod::exact;
  }
  if (layout.taxels[at(taxel)].subtaxels.empty())
    for (const double factor : kTriedRadii)
      add(fmt::format("a radius of {:.3g} mm", 1e3 * factor * layout.taxels[at(taxel)].radius)).radius = factor;
  return settings;
}

}  // namespace

SensorModel with_interpolated_angles(const SensorModel& model) {
  SensorModel other(model);
  other.layout.receptive_field.normals = FieldNormals::interpolated;
  if (other.skin_fields != nullptr) other.skin_fields = skin_fields_for(other, integral_of(other.layout.readout));
  return other;
}

std::vector<SettingTried> settings_against_edges(const SensorModelPtr& model, int taxel, const SensorStep& before,
                                                 const SensorStep& now, double limit, SensorCache& cache,
                                                 Progress* progress) {
  const double sum = before.readings[at(taxel)] + now.readings[at(taxel)];
  std::vector<SettingTried> tried;
  for (SettingTried& setting : settings_for(model->layout, taxel)) {
    Layout layout = model->layout;
    layout.receptive_field = setting.field;
    layout.readout = setting.readout;
    layout.taxels[at(taxel)].radius *= setting.radius;
    SensorBuild how(progress);
    how.cache = &cache;
    how.quality = model->quality;
    try {
      const SensorModelPtr other = build_sensor_model(layout, model->loaded, "", layout.name, how);
      const double was = reading_of(*other, taxel, before), is = reading_of(*other, taxel, now);
      if (!(was + is > 0)) continue;  // the taxel no longer feels the contact
      setting.change = sum / (was + is) * (is - was);
      setting.cures = std::abs(setting.change) <= kCureMargin * limit;
    } catch (const Error&) {
      continue;  // the layout cannot be compiled
    }
    tried.push_back(setting);
    if (setting.cures) break;
  }
  return tried;
}

}  // namespace taxel
