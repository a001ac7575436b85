// Division of tets at surfaces of equal pressure.
//
// A surface of equal pressure cuts a tet in a plane. Both sides are convex polyhedra, whose tets are those of the
// pulling triangulation: from the vertex with the lowest index to the triangles of all faces without this vertex, and a
// face is a fan from its own vertex with the lowest index. So two tets that share a face divide the face in the same
// way, whatever their order. Vertices on an edge are shared by all tets around the edge.
#include "core/hydro/fields/pressure_field.h"

#include <algorithm>
#include <map>

#include "core/base/math.h"

namespace taxel {
namespace {

constexpr double kOnSurface = 1e-9;  // of the largest pressure: a vertex so close to a surface is on it

class PressureLayers {
 public:
  explicit PressureLayers(const PressureField& field)
      : vertices_(field.vertices()),
        pressure_(field.vertex_pressure()),
        on_surface_(kOnSurface * field.max_pressure()) {
    for (const Tet& tet : field.tets()) {
      parents_.push_back(static_cast<int>(tets_.size()));
      tets_.push_back(tet.vertices);
    }
  }

  /// Divides all tets at one pressure.
  void divide(double level) {
    level_ = level;
    middle_.clear();
    std::vector<ivec4> tets;
    std::vector<int> parents;
    tets.swap(tets_);
    parents.swap(parents_);
    for (std::size_t t = 0; t < tets.size(); ++t) {
      const ivec4& tet = tets[t];
      bool below = false, above = false;
      for (int i = 0; i < 4; ++i) {
        below = below || side(tet[i]) < 0;
        above = above || side(tet[i]) > 0;
      }
      if (below && above) {
        add_side(tet, -1);
        add_side(tet, 1);
      } else {
        tets_.push_back(tet);
      }
      parents_.resize(tets_.size(), parents[t]);
    }
  }

  [[nodiscard]] const std::vector<dvec3>& vertices() const { return vertices_; }
  [[nodiscard]] const std::vector<ivec4>& tets() const { return tets_; }
  [[nodiscard]] const std::vector<double>& pressure() const { return pressure_; }
  [[nodiscard]] const std::vector<int>& parents() const { return parents_; }

 private:
  using Loop = std::vector<int>;

  [[nodiscard]] int side(int vertex) const {
    const double d = pressure_[at(vertex)] - level_;
    return d < -on_surface_ ? -1 : d > on_surface_ ? 1 : 0;
  }
  /// Returns the vertex where an edge passes the level.
  int middle(int a, int b) {
    if (a > b) std::swap(a, b);
    const auto [place, is_new] = middle_.try_emplace({a, b}, static_cast<int>(vertices_.size()));
    if (is_new) {
      const double t = (level_ - pressure_[at(a)]) / (pressure_[at(b)] - pressure_[at(a)]);
      vertices_.push_back(vertices_[at(a)] + t * (vertices_[at(b)] - vertices_[at(a)]));
      pressure_.push_back(level_);
    }
    return place->second;
  }
  /// Returns the part of a face on one side of the level, counter-clockwise as the face.
  Loop part_of(const ivec3& face, int sign) {
    Loop loop;
    for (int i = 0; i < 3; ++i) {
      const int a = face[i], b = face[(i + 1) % 3];
      if (side(a) * sign >= 0) loop.push_back(a);
      if (side(a) * side(b) < 0) loop.push_back(middle(a, b));
    }
    return loop;
  }
  /// Adds the tets of the part of a tet on one side of the level.
  void add_side(const ivec4& t, int sign) {
    const std::array<ivec3, 4> faces{ivec3(t[1], t[2], t[3]), ivec3(t[0], t[3], t[2]), ivec3(t[0], t[1], t[3]),
                                     ivec3(t[0], t[2], t[1])};
    std::vector<Loop> loops;
    Loop on;  // vertices of the cut
    for (const ivec3& face : faces) {
      Loop loop = part_of(face, sign);
      for (const int v : loop)
        if (side(v) == 0 && std::find(on.begin(), on.end(), v) == on.end()) on.push_back(v);
      if (loop.size() >= 3) loops.push_back(std::move(loop));
    }
    if (on.size() >= 3) loops.push_back(in_order(on, loops));
    add_pulled(loops);
  }
  /// Returns the vertices of the cut in the order of the edges that the other faces have there.
  [[nodiscard]] Loop in_order(const Loop& on, const std::vector<Loop>& loops) const {
    std::map<int, int> next;  // the cut has each edge in the opposite direction of the face next to it
    for (const Loop& loop : loops) {
      bool is_whole = true;
      for (const int v : loop) is_whole = is_whole && side(v) == 0;
      if (is_whole) return {};  // a face of the tet is the cut itself
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int a = loop[i], b = loop[(i + 1) % loop.size()];
        if (side(a) == 0 && side(b) == 0) next[b] = a;
      }
    }
    Loop ordered{on.front()};
    while (ordered.size() < on.size() && next.contains(ordered.back())) ordered.push_back(next[ordered.back()]);
    return ordered;
  }
  void add_pulled(const std::vector<Loop>& loops) {
    int apex = std::numeric_limits<int>::max();
    for (const Loop& loop : loops)
      for (const int v : loop) apex = std::min(apex, v);
    for (const Loop& loop : loops) {
      if (loop.size() < 3 || std::find(loop.begin(), loop.end(), apex) != loop.end()) continue;
      const std::size_t n = loop.size();
      const auto first = static_cast<std::size_t>(std::min_element(loop.begin(), loop.end()) - loop.begin());
      for (std::size_t i = 1; i + 1 < n; ++i)
        add_tet({loop[first], loop[(first + i) % n], loop[(first + i + 1) % n], apex});
    }
  }
  void add_tet(ivec4 t) {
    const auto x = [&](int i) { return vertices_[at(t[i])]; };
    const double volume = glm::dot(glm::cross(x(1) - x(0), x(2) - x(0)), x(3) - x(0));
    if (volume == 0) return;
    if (volume < 0) std::swap(t[0], t[1]);
    tets_.push_back(t);
  }

  std::vector<dvec3> vertices_;
  std::vector<double> pressure_;
  std::vector<ivec4> tets_;
  std::vector<int> parents_;
  double on_surface_ = 0, level_ = 0;
  std::map<std::pair<int, int>, int> middle_;
};

}  // namespace

DividedField divide_field(const PressureField& field, const PressureLaw& table, double modulus) {
  PressureLayers layers(field);
  for (std::size_t i = 0; i + 1 < table.table.size(); ++i) layers.divide(modulus * table.table[i].strain);
  std::vector<double> pressures;
  for (const double p : layers.pressure()) pressures.push_back(modulus * table.pressure(p / modulus));
  FieldReport report;
  report.thickness = field.report().thickness;
  report.deepest = field.report().deepest;
  report.core = field.report().core;
  return {std::make_shared<const PressureField>(layers.vertices(), layers.tets(), std::move(pressures), report),
          layers.parents()};
}

}  // namespace taxel
