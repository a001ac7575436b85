// The pressure law on a contact surface, polygon by polygon.
//
// Against a rigid body the surface is the rigid one whatever the law is, and the strain e is linear on each polygon. So
// no tet has to be divided: polygons are cut along lines of equal strain, and each part gets the law's mean and slope.
// The cuts are at the same strains in all polygons, so readings change continuously as they move.
//
// Pitfalls. A regression line of a convex law is negative at the rim of a contact, where e = 0, so its slope is limited
// there. Parts smaller than rounding errors are dropped; their area is lost, which is below 1e-12 of the polygon's.
// Theory: docs/theory/hydro.md, "Pressure laws".
#include "core/hydro/kernel/law_pass.h"

#include <algorithm>
#include <array>

#include "core/base/math.h"
#include "core/hydro/quadrature.h"

namespace taxel {
namespace {

constexpr double kSmallestPart = 1e-12;  // of the polygon's area

/// The function from the kernel's pressures to those of the laws on one polygon.
class PressureOfPolygon {
 public:
  PressureOfPolygon(const LawsOfSurface& laws, std::size_t number, double middle) : laws_(laws) {
    if (laws.pieces.law == nullptr) return;
    const double own = matched_slope(middle), other = laws.ratios[number] * laws.scale.slope(middle);
    matched_part_ = other / (own + other);
  }
  [[nodiscard]] double at(double linear) const {
    if (matched_part_ == 0) return laws_.scale.at(linear);
    const double own = laws_.matched.at(laws_.pieces.inverse(linear));
    return matched_part_ * own + (1 - matched_part_) * laws_.scale.at(linear);
  }
  [[nodiscard]] double slope(double linear) const {
    if (matched_part_ == 0) return laws_.scale.slope(linear);
    return matched_part_ * matched_slope(linear) + (1 - matched_part_) * laws_.scale.slope(linear);
  }

 private:
  [[nodiscard]] double matched_slope(double linear) const {
    const double own = laws_.pieces.inverse(linear);
    return laws_.matched.slope(own) / laws_.pieces.slope(own);
  }

  const LawsOfSurface& laws_;
  double matched_part_ = 0;
};

/// Computes the polygons of one surface.
class LawPass {
 public:
  LawPass(const LawsOfSurface& laws, ContactSurface& surface, LawMemory& memory)
      : laws_(laws), s_(surface), m_(memory) {}

  void run(std::vector<double>& slopes) {
    m_.vertices.clear();
    m_.pressure.clear();
    m_.polygons.clear();
    m_.slopes.clear();
    const std::size_t first_slope = s_.polygons.size() - slopes.size();
    for (std::size_t i = 0; i < s_.polygons.size(); ++i) {
      const std::size_t before = m_.polygons.size();
      add(s_.polygons[i], PressureOfPolygon(laws_, i, s_.polygons[i].pressure));
      if (i < first_slope) continue;
      for (std::size_t k = before; k < m_.polygons.size(); ++k)
        m_.slopes.push_back(slopes[i - first_slope] * m_.factors[k - before]);
    }
    s_.vertices.swap(m_.vertices);
    s_.pressure.swap(m_.pressure);
    s_.polygons.swap(m_.polygons);
    slopes.swap(m_.slopes);
  }

 private:
  void add(const ContactPolygon& polygon, const PressureOfPolygon& law) {
    m_.factors.clear();
    m_.corners.clear();
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (int i = 0; i < polygon.count; ++i) {
      const dvec3& x = s_.vertices[at(polygon.first + i)];
      const double linear =
          std::max(0.0, polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid));  // rounding at the rim
      m_.corners.push_back({x, linear});
      least = std::min(least, linear);
      most = std::max(most, linear);
    }
    double low = 0;
    for (std::size_t i = 0; i <= laws_.levels.size(); ++i) {
      const bool is_last = i == laws_.levels.size();
      const double high = is_last ? std::numeric_limits<double>::infinity() : laws_.levels[i];
      if (most > low && least < high) {
        const bool is_whole = least >= low && most <= high;
        if (is_whole) return add_part(polygon, law, m_.corners, true);
        cut(m_.corners, low, 1, m_.below);
        cut(m_.below, high, -1, m_.part);
        if (m_.part.size() >= 3) add_part(polygon, law, m_.part, false);
      }
      low = high;
    }
    if (most == 0) add_part(polygon, law, m_.corners, true);
  }

  /// Keeps the part of a polygon in which sign (p - level) >= 0.
  static void cut(const std::vector<LawCorner>& from, double level, int sign, std::vector<LawCorner>& to) {
    to.clear();
    for (std::size_t i = 0; i < from.size(); ++i) {
      const LawCorner &a = from[i], &b = from[(i + 1) % from.size()];
      const bool is_in = sign * a.linear >= sign * level;
      if (is_in) to.push_back(a);
      if (is_in == (sign * b.linear >= sign * level) || a.linear == level || b.linear == level) continue;
      // From the lower end: neighbours divide a common edge at the same point.
      const LawCorner &low = a.linear < b.linear ? a : b, &high = a.linear < b.linear ? b : a;
      to.push_back({low.x + (level - low.linear) / (high.linear - low.linear) * (high.x - low.x), level});
    }
  }

  void add_part(const ContactPolygon& polygon, const PressureOfPolygon& law, const std::vector<LawCorner>& corners,
                bool is_whole) {
    ContactPolygon part = polygon;
    if (!is_whole && !measure(corners, part)) return;
    const double factor = fit(corners, polygon, law, part);
    part.first = static_cast<int>(m_.vertices.size());
    part.count = static_cast<int>(corners.size());
    for (const LawCorner& corner : corners) {
      m_.vertices.push_back(corner.x);
      m_.pressure.push_back(law.at(corner.linear));
    }
    part.gradient = factor * polygon.gradient;
    m_.polygons.push_back(part);
    m_.factors.push_back(factor);
  }

  /// Sets area and centroid of a part. Returns false if it has no area.
  static bool measure(const std::vector<LawCorner>& corners, ContactPolygon& part) {
    double area = 0;
    dvec3 moment(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const dvec3 a = corners[i].x - corners[0].x, b = corners[i + 1].x - corners[0].x;
      const double triangle = 0.5 * glm::dot(glm::cross(a, b), part.normal);
      area += triangle;
      moment += triangle / 3 * (a + b);
    }
    if (!(area > kSmallestPart * part.area)) return false;
    part.area = area;
    part.centroid = corners[0].x + moment / area;
    return true;
  }

  /// Sets the pressure of a part at its centroid to the mean of the law, and returns the slope of the regression line
  /// of the law over the linear pressure: sum (p - mean)(q - middle)/sum (q - middle)^2, q = E e.
  double fit(const std::vector<LawCorner>& corners, const ContactPolygon& whole, const PressureOfPolygon& law,
             ContactPolygon& part) const {
    const double middle = whole.pressure + glm::dot(whole.gradient, part.centroid - whole.centroid);
    double least = std::numeric_limits<double>::infinity(), weight = 0, sum = 0, spread = 0, product = 0;
    for (const LawCorner& corner : corners) least = std::min(least, corner.linear);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const LawCorner &a = corners[0], &b = corners[i], &c = corners[i + 1];
      const double area = glm::dot(glm::cross(b.x - a.x, c.x - a.x), part.normal);
      for (const QuadraturePoint& q : kTriangleDegree4) {
        const double linear = q.u * a.linear + q.v * b.linear + (1 - q.u - q.v) * c.linear;
        const double p = law.at(linear), w = q.weight * area;
        weight += w;
        sum += w * p;
        spread += w * (linear - middle) * (linear - middle);
        product += w * p * (linear - middle);
      }
    }
    const double tangent = law.slope(middle);
    if (!(weight > 0)) {
      part.pressure = law.at(middle);
      return tangent;
    }
    part.pressure = sum / weight;
    constexpr double kFlat = 1e-6;  // relative spread of the pressure below which the tangent is the slope
    double slope = spread > kFlat * kFlat * middle * middle * weight ? product / spread : tangent;
    if (slope * (middle - least) > part.pressure) slope = part.pressure / (middle - least);
    return slope;
  }

  const LawsOfSurface& laws_;
  ContactSurface& s_;
  LawMemory& m_;
};

}  // namespace

void follow_laws(const LawsOfSurface& laws, ContactSurface& surface, std::vector<double>& slopes, LawMemory& memory) {
  LawPass(laws, surface, memory).run(slopes);
}

}  // namespace taxel
