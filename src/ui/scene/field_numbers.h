// Numbers of the overlays about receptive fields; the panel writes them.
#pragma once

#include <optional>
#include <vector>

#include <glm/glm.hpp>

namespace taxel::ui {

/// Area [m^2] of the skin that one field covers by each metric, summed over the taxels.
struct FieldComparison {
  double euclidean = 0, geodesic = 0;
  double euclidean_only = 0;  ///< inside the Euclidean field only [m^2]
  int differing = 0;          ///< number of taxels with more than 1 % of the field there
};

/// Areas of the skin by the number of receptive fields that contain them.
struct CoverageNumbers {
  std::vector<double> area_of_overlap;  ///< area [m^2] by number of taxels
  double area = 0;                      ///< area of the skin [m^2]
  double overlap = 0;                   ///< mean number of taxels over the covered area
};

/// Angles between the normals of the taxels and of the skin below them.
struct NormalNumbers {
  double largest_deg = 0, mean_deg = 0;
  int largest_taxel = -1;  ///< taxel with the largest angle, in layout order, or -1
  double limit_deg = 0;    ///< limit of the layout, at which the colours end
};

/// Numbers of the traction arrows.
struct TractionNumbers {
  int polygons = 0;
  double largest_pressure = 0, largest_friction = 0;  ///< largest values [Pa]
  double metres_per_pascal = 0;                       ///< length of arrows per pressure
  bool friction_known = false;                        ///< false if friction was not recorded; then none is drawn
};

/// Numbers of the marks that were drawn for all sensors together.
struct MarkCounts {
  int arrows = 0;   ///< taxels with an arrow along their normal
  int discs = 0;    ///< receptive fields that glow with their reading
  int rings = 0;    ///< receptive fields with a rim
  int samples = 0;  ///< samples at most; those that look away are not drawn
  int forces = 0;   ///< net forces
  bool operator==(const MarkCounts&) const = default;
};

/// Numbers of the active overlays, for the first sensor in the frame.
struct FieldNumbers {
  bool due = false;  ///< a map is active and not computed yet
  std::optional<FieldComparison> comparison;
  std::optional<CoverageNumbers> coverage;
  std::optional<NormalNumbers> normals;
  std::optional<TractionNumbers> tractions;  ///< numbers of the selected sensor
  MarkCounts marks;
};

/// Colour (sRGB) of a spot in the fields of `taxels` taxels, different from the colours of single taxels. From
/// `kMostOverlap` on the colour is the same.
inline constexpr int kMostOverlap = 6;
glm::vec3 overlap_color(int taxels);
/// Returns the colour of skin inside the Euclidean field only.
glm::vec3 euclidean_only_color();
/// Returns the colour of an angle between normals: the lighter four fifths of the map up to the limit, and a colour
/// that the map does not have above the limit.
glm::vec3 normal_color(double angle_deg, double limit_deg);

}  // namespace taxel::ui
