// Repairs of taxels and subtaxels, and of taxels whose mesh was replaced.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/document/fixes.h"
#include "core/layout/generators/place.h"

namespace taxel {
namespace {

constexpr double kMillimetres = 1000.0;

/// The place of a problem in a layout: a taxel, or one of its subtaxels.
struct Place {
  std::size_t taxel = 0;
  std::optional<std::size_t> subtaxel;
};

/// Reads "/taxels/3..." and "/taxels/3/subtaxels/1...".
std::optional<Place> place_of(const std::string& pointer, const Layout& layout) {
  Place place;
  const char* const end = pointer.data() + pointer.size();
  const auto index_after = [&](std::string_view start, const char* at, std::size_t& index) -> const char* {
    const std::string_view rest(at, static_cast<std::size_t>(end - at));
    if (!rest.starts_with(start)) return nullptr;
    const auto read = std::from_chars(at + start.size(), end, index);
    return read.ec == std::errc() ? read.ptr : nullptr;
  };
  const char* const behind = index_after("/taxels/", pointer.data(), place.taxel);
  if (behind == nullptr || place.taxel >= layout.taxels.size()) return std::nullopt;
  std::size_t subtaxel = 0;
  if (index_after("/subtaxels/", behind, subtaxel) != nullptr) {
    if (subtaxel >= layout.taxels[place.taxel].subtaxels.size()) return std::nullopt;
    place.subtaxel = subtaxel;
  }
  return place;
}

/// The values that a taxel and a subtaxel share.
struct Disc {
  dvec3 center, normal;
  double radius;
};
template <class T>
Disc disc_of(const T& t) {
  return {t.center, t.normal, t.radius};
}

struct OnSkin {
  dvec3 position, normal;
};
/// Returns the place on the skin with the smooth normal, or with the face's normal if the two differ so much that
/// layout_check would report the angle, or would find no sample with a normal near that of the receptive field.
OnSkin nearest_on(const MeshIndex& skin, const dvec3& center, double max_angle_deg = 180.0) {
  const SurfacePoint at = skin.closest_point(center);
  const dvec3 smooth = smooth_normal(skin.mesh(), at),
              face = skin.mesh().face_normals()[static_cast<std::size_t>(at.face)];
  const double steep = 53.0, part = 0.9;  // degrees; the limit of the check is 60
  const double least_cosine = std::cos(std::min(steep, part * max_angle_deg) * kPi / 180.0);
  return {at.position, glm::dot(smooth, face) < least_cosine ? face : smooth};
}

/// Returns the median of the valid radii of the other taxels.
std::optional<double> usual_radius(const Layout& layout) {
  std::vector<double> radii;
  for (const Taxel& taxel : layout.taxels)
    if (taxel.radius > 0.0 && std::isfinite(taxel.radius)) radii.push_back(taxel.radius);
  if (radii.empty()) return std::nullopt;
  std::sort(radii.begin(), radii.end());
  return radii[radii.size() / 2];
}

/// The repair of one problem of a disc.
class TaxelFix {
 public:
  TaxelFix(const Problem& problem, const Project& project, const MeshIndex* skin, const Place& place)
      : problem_(problem), project_(project), skin_(skin), place_(place), taxel_(project.layout.taxels[place.taxel]) {
    disc_ = place.subtaxel ? disc_of(taxel_.subtaxels[*place.subtaxel]) : disc_of(taxel_);
  }

  std::optional<Fix> make() {
    const std::string& code = problem_.code;
    if (code == "duplicate_place") return delete_duplicate();
    if (code == "center_off_surface") return move_to_surface();
    if (code == "normal_points_inward" || code == "normal_off_surface" || code == "zero_normal") return take_normal();
    if (code == "not_finite" && problem_.pointer.ends_with("/normal")) return take_normal();
    if (code == "field_empty") return put_on_surface();
    if (code == "radius_not_positive") return mend_radius();
    if (code == "radius_exceeds_body") return shrink_radius();
    if (code == "field_without_samples") return reach_samples();
    if (code == "subtaxel_larger") return resized(taxel_.radius, "the taxel's own");
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::string name() const {
    return place_.subtaxel ? fmt::format("subtaxel {} of taxel {}", *place_.subtaxel, taxel_.id)
                           : fmt::format("taxel {}", taxel_.id);
  }
  /// Returns the edit that gives the disc these values.
  [[nodiscard]] Edit set(const Disc& disc) const {
    TaxelChange change;
    change.id = taxel_.id;
    if (place_.subtaxel) {
      change.subtaxels = taxel_.subtaxels;
      (*change.subtaxels)[*place_.subtaxel] = {disc.center, disc.normal, disc.radius};
      return SetTaxels{{change}, false};
    }
    if (disc.center != disc_.center) change.center = disc.center;
    if (!(disc.normal == disc_.normal)) change.normal = disc.normal;
    const bool only_radius = !change.center && !change.normal;
    if (only_radius) change.radius = disc.radius;
    return SetTaxels{{change}, only_radius};
  }
  [[nodiscard]] OnSkin nearest() const {
    return nearest_on(*skin_, disc_.center, project_.layout.receptive_field.max_angle_deg);
  }
  [[nodiscard]] bool on_skin() const { return skin_ != nullptr && is_finite(disc_.center); }

  std::optional<Fix> move_to_surface() const {
    if (!on_skin()) return std::nullopt;
    const dvec3 to = nearest().position;
    return Fix{
        fmt::format("Move {} to the surface, by {:.3g} mm", name(), glm::distance(to, disc_.center) * kMillimetres),
        set({to, disc_.normal, disc_.radius})};
  }
  std::optional<Fix> take_normal() const {
    if (!on_skin()) return std::nullopt;
    return Fix{fmt::format("Give {} the normal of the surface", name()),
               set({disc_.center, nearest().normal, disc_.radius})};
  }
  std::optional<Fix> put_on_surface() const {
    if (!on_skin()) return std::nullopt;
    const OnSkin to = nearest();
    return Fix{fmt::format("Put {} on the surface, with its normal", name()),
               set({to.position, to.normal, disc_.radius})};
  }
  [[nodiscard]] Fix resized(double radius, const std::string& why) const {
    return {fmt::format("Set the radius of {} to {:.4g} mm, {}", name(), radius * kMillimetres, why),
            set({disc_.center, disc_.normal, radius})};
  }
  std::optional<Fix> mend_radius() const {
    if (disc_.radius < 0.0 && std::isfinite(disc_.radius)) return resized(-disc_.radius, "without the sign");
    if (const auto usual = usual_radius(project_.layout)) return resized(*usual, "the median of the taxels");
    return resized(Taxel().radius, "the default");
  }
  /// Returns a repair of a radius in millimetres or micrometres that was read as metres.
  std::optional<Fix> shrink_radius() const {
    if (skin_ == nullptr) return std::nullopt;
    for (const double unit : {1e-3, 1e-6})
      if (disc_.radius * unit < skin_->mesh().bounds().diagonal())
        return resized(disc_.radius * unit,
                       unit == 1e-3 ? "as if it was in millimetres" : "as if it was in micrometres");
    return std::nullopt;
  }
  /// Returns a repair with a radius of three times the distance of samples, 1/sqrt(density): about thirty samples.
  std::optional<Fix> reach_samples() const {
    const double radius = 3.0 / std::sqrt(project_.layout.sampling.density);
    if (!(radius > disc_.radius) || !std::isfinite(radius)) return std::nullopt;
    return resized(radius, "three times the distance of the samples");
  }
  std::optional<Fix> delete_duplicate() const {
    return Fix{fmt::format("Delete taxel {}", taxel_.id), DeleteTaxels{{taxel_.id}}};
  }

  const Problem& problem_;
  const Project& project_;
  const MeshIndex* skin_;
  Place place_;
  const Taxel& taxel_;
  Disc disc_{};
};

}  // namespace

std::optional<Fix> fix_of_taxel(const Problem& problem, const Project& project, const MeshIndex* skin) {
  const std::optional<Place> place = place_of(problem.pointer, project.layout);
  if (!place) return std::nullopt;
  return TaxelFix(problem, project, skin, *place).make();
}

TaxelChange projected(const Taxel& taxel, const MeshIndex& skin) {
  TaxelChange change;
  change.id = taxel.id;
  if (is_finite(taxel.center)) {
    const OnSkin to = nearest_on(skin, taxel.center);
    change.center = to.position;
    change.normal = to.normal;
  }
  if (taxel.subtaxels.empty()) return change;
  change.subtaxels = taxel.subtaxels;
  for (Subtaxel& subtaxel : *change.subtaxels) {
    if (!is_finite(subtaxel.center)) continue;
    const OnSkin to = nearest_on(skin, subtaxel.center);
    subtaxel.center = to.position;
    subtaxel.normal = to.normal;
  }
  return change;
}

SurfaceDistances distances_to(const MeshIndex& skin, const Layout& layout) {
  SurfaceDistances distances;
  double sum = 0;
  for (const Taxel& taxel : layout.taxels) {
    if (!is_finite(taxel.center)) continue;
    const double distance = skin.closest_point(taxel.center).distance;
    sum += distance;
    if (distances.taxels++ == 0 || distance > distances.largest) {
      distances.largest = distance;
      distances.farthest = taxel.id;
    }
  }
  if (distances.taxels > 0) distances.mean = sum / distances.taxels;
  return distances;
}

std::string distances_text(const SurfaceDistances& distances) {
  constexpr double kMillimetres = 1e3;
  if (distances.taxels == 0) return {};
  if (distances.taxels == 1)
    return fmt::format("Taxel {} lies {:.3g} mm from its surface", distances.farthest,
                       kMillimetres * distances.largest);
  return fmt::format("{} taxels lie {:.3g} mm from its surface on average, taxel {} the farthest with {:.3g} mm",
                     distances.taxels, kMillimetres * distances.mean, distances.farthest,
                     kMillimetres * distances.largest);
}

SetTaxels projected_onto(const MeshIndex& skin, const Layout& layout) {
  SetTaxels edit;
  edit.twins_follow = false;
  for (const Taxel& taxel : layout.taxels) edit.changes.push_back(projected(taxel, skin));
  return edit;
}

}  // namespace taxel
