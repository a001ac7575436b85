#include "core/sensor/explain/edges/edge_advice.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/index.h"
#include "core/sensor/explain/advice.h"
#include "core/sensor/readout/aggregate.h"

namespace taxel {
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
