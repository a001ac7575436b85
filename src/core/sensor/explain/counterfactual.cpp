#include "core/sensor/explain/counterfactual.h"

#include "core/base/index.h"

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

}  // namespace taxel
