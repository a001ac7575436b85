// The project's own fingertip. The surface is a stack of superellipse sections
//
//   |x / a(z)|^q + |(y - y0) / b(z)|^q = 1,   a(z) = A sqrt(1 - (z/L)^m),
//
// with separate height b and exponents q, m for the pad (y < y0) and the nail side (y > y0): the sections shrink
// smoothly to the tip, which is round because of the square root. The parameters were fitted to the twelve taxel
// centres and normals published for the original finger (formats of the paper's sensor file): the surface is within
// 0.3 mm and 6 degrees of them. A rounded rim joins the flat base. Lengths here are in millimetres, those of the mesh
// in metres.
#include <array>

#include "core/base/index.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/ring_surface.h"

namespace taxel {
namespace {

constexpr double kLength = 30.5;      // L
constexpr double kCenterY = 0.9;      // y0
constexpr double kRimRadius = 1.5;    // radius between side and base
constexpr double kTargetEdge = 1.42;  // target edge length: about 2000 triangles

struct Axis {
  double size, power;  // A and m
};
constexpr Axis kSide{8.9, 6.0}, kPad{8.0, 4.4}, kNail{7.5, 3.0};
constexpr double kPadExponent = 2.1, kNailExponent = 2.5;  // q

/// One section across the finger.
struct Section {
  double side = 0, pad = 0, nail = 0;  // half widths
  double z = 0;
};

double half_width(const Axis& axis, double z) {
  return axis.size * std::sqrt(std::max(0.0, 1.0 - std::pow(z / kLength, axis.power)));
}

Section section_at(double z) {
  return {half_width(kSide, z), half_width(kPad, z), half_width(kNail, z), z};
}

Section shrunk(const Section& s, double by) {
  return {s.side - by, s.pad - by, s.nail - by, s.z};
}

/// The meridian in three stretches, each for u in [0, 1]: base disc from its centre, rounded rim, side up to the tip.
Section base_section(double u) {
  const Section rim = shrunk(section_at(0), kRimRadius);
  return {u * rim.side, u * rim.pad, u * rim.nail, 0};
}
Section rim_section(double u) {
  const double angle = 0.5 * kPi * u;
  return shrunk(section_at(kRimRadius * (1 - std::cos(angle))), kRimRadius * (1 - std::sin(angle)));
}
Section side_section(double u) {
  return section_at(kRimRadius + (kLength - kRimRadius) * std::sin(0.5 * kPi * u));
}

/// Returns the mean distance between two neighbouring sections over the side, pad and nail meridians.
double step_length(const Section& a, const Section& b) {
  const double dz = b.z - a.z;
  return (2 * std::hypot(b.side - a.side, dz) + std::hypot(b.pad - a.pad, dz) + std::hypot(b.nail - a.nail, dz)) / 4;
}

/// Returns the sections along one stretch without the first one, evenly spaced by mean arc length, at most about
/// `spacing` apart.
template <class Stretch>
std::vector<Section> evenly(const Stretch& stretch, double spacing) {
  constexpr int kSamples = 2000;
  std::vector<double> length(kSamples + 1, 0.0);
  for (int i = 1; i <= kSamples; ++i)
    length[at(i)] = length[at(i - 1)] + step_length(stretch(static_cast<double>(i - 1) / kSamples),
                                                    stretch(static_cast<double>(i) / kSamples));
  const int count = std::max(1, static_cast<int>(std::lround(length.back() / spacing)));
  std::vector<Section> sections;
  for (int k = 1, i = 0; k <= count; ++k) {
    const double wanted = length.back() * k / count;
    while (i + 1 < kSamples && length[at(i + 1)] < wanted) ++i;
    const double part = (wanted - length[at(i)]) / (length[at(i + 1)] - length[at(i)]);
    sections.push_back(stretch(k == count ? 1.0 : (i + part) / kSamples));
  }
  return sections;
}

/// Returns a point of the right half of a section. The angle is -pi/2 at the pad's ridge, 0 at the side, pi/2 on the
/// nail.
dvec3 section_point(const Section& s, double angle) {
  const double c = std::max(0.0, std::cos(angle)), n = std::sin(angle);
  const double power = 2.0 / (n < 0 ? kPadExponent : kNailExponent);
  const double height = n < 0 ? -s.pad * std::pow(-n, power) : s.nail * std::pow(n, power);
  return {s.side * std::pow(c, power), kCenterY + height, s.z};
}

/// Converts to metres on a grid of nanometres, so that coordinates are equal on every machine and short in a file.
dvec3 to_grid(const dvec3& p_mm) {
  return glm::round(p_mm * 1.0e6) / 1.0e9 + 0.0;
}

/// Returns points of the right half of a section, evenly spaced by arc length. The number of steps changes only if the
/// steps would differ too much from kTargetEdge: aligned rings make no valleys along the straight part.
std::vector<dvec3> half_ring(const Section& s, int& steps) {
  constexpr int kSamples = 2000;
  std::vector<dvec3> points(kSamples + 1);
  std::vector<double> length(kSamples + 1, 0.0);
  for (int i = 0; i <= kSamples; ++i) {
    points[at(i)] = section_point(s, kPi * (static_cast<double>(i) / kSamples - 0.5));
    if (i > 0) length[at(i)] = length[at(i - 1)] + glm::distance(points[at(i - 1)], points[at(i)]);
  }
  constexpr double kShortest = 0.8, kLongest = 1.1;  // smallest and largest edge length as a fraction of kTargetEdge
  const double step = length.back() / (steps * kTargetEdge);
  if (step < kShortest || step > kLongest)
    steps = std::max(3, static_cast<int>(std::lround(length.back() / kTargetEdge)));
  std::vector<dvec3> ring;
  for (int k = 0, i = 0; k <= steps; ++k) {
    const double wanted = length.back() * k / steps;
    while (i + 1 < kSamples && length[at(i + 1)] < wanted) ++i;
    const double part = std::clamp((wanted - length[at(i)]) / (length[at(i + 1)] - length[at(i)]), 0.0, 1.0);
    ring.push_back(to_grid(glm::mix(points[at(i)], points[at(i + 1)], part)));
  }
  ring.front().x = ring.back().x = 0;
  return ring;
}

}  // namespace

TriMesh make_fingertip() {
  const double spacing = kTargetEdge * std::sqrt(0.75);  // rows of equilateral triangles
  std::vector<Section> sections = evenly(base_section, spacing);
  for (const Section& s : evenly(rim_section, spacing)) sections.push_back(s);
  for (const Section& s : evenly(side_section, spacing)) sections.push_back(s);
  sections.pop_back();  // the tip, a point
  MirroredRingSurface surface;
  surface.add_half_ring({to_grid({0, kCenterY, 0})});
  int steps = 1;
  for (const Section& s : sections) surface.add_half_ring(half_ring(s, steps));
  surface.add_half_ring({to_grid({0, kCenterY, kLength})});
  return surface.mesh();
}

}  // namespace taxel
