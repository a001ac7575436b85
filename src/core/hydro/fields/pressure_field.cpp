// A linear pressure on each tet, and the planes of its faces.
//
// The gradient of a tet follows from three differences of pressure by Cramer's rule. The plane of a face is computed
// from its vertices in the order of their numbers and then turned to the inside of its tet. So both tets at a face have
// the same numbers with opposite signs, to the last bit: a cut by either gives the same line, and the kernel needs no
// tolerance to leave nothing out and count nothing twice.
//
// Neighbours are found by counting sort over the lowest vertex of each face, and by sorting the few faces with the same
// lowest vertex. Three tets at one face are an error. Tets that are inside out are turned and counted, as are tets
// whose pressure does not grow in any direction. Theory: docs/theory/hydro.md, "Pressure fields" and "Half-open faces".
#include "core/hydro/fields/pressure_field.h"

#include <fmt/format.h>

#include <span>
#include <tuple>
#include <utility>

#include "core/base/error.h"
#include "core/base/math.h"
#include "core/base/text/message.h"

namespace taxel {
namespace {

/// Corners of the face opposite to corner i of a positively oriented tet, counter-clockwise seen from inside.
constexpr std::array<std::array<int, 3>, 4> kFaces{{{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};

/// A tet over which the pressure varies by less than this fraction of the largest pressure has no direction of push.
constexpr double kZeroGradient = 1e-9;

double six_volumes_of_tet(const std::vector<dvec3>& x, const ivec4& t) {
  const dvec3& o = x[at(t[0])];
  return glm::dot(glm::cross(x[at(t[1])] - o, x[at(t[2])] - o), x[at(t[3])] - o);
}

/// Sorts three vertex numbers and returns the sign of the permutation.
double sort_face(std::array<int, 3>& face) {
  double sign = 1;
  const auto order = [&](std::size_t i, std::size_t j) {
    if (face[i] <= face[j]) return;
    std::swap(face[i], face[j]);
    sign = -sign;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return sign;
}

/// Returns the face opposite to corner i of a tet: its sorted vertices, and 1 if sorting kept its orientation or -1 if
/// not.
std::pair<std::array<int, 3>, double> sorted_face(const Tet& tet, std::size_t i) {
  const auto& corners = kFaces[i];
  std::array<int, 3> face{tet.vertices[corners[0]], tet.vertices[corners[1]], tet.vertices[corners[2]]};
  const double sign = sort_face(face);
  return {face, sign};
}

/// Computes one plane per face, from its sorted vertices alone.
void set_planes(const std::vector<dvec3>& x, Tet& tet) {
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [face, sign] = sorted_face(tet, i);
    const dvec3& a = x[at(face[0])];
    const dvec3 cross = glm::cross(x[at(face[1])] - a, x[at(face[2])] - a);
    const dvec3 normal = cross / std::sqrt(glm::dot(cross, cross));
    tet.normal[i] = sign * normal;
    tet.offset[i] = sign * -glm::dot(normal, a);
  }
}

/// Computes g from the three differences of pressure along the edges at corner 0, by Cramer's rule.
void set_pressure(const std::vector<dvec3>& x, const std::vector<double>& p, Tet& tet) {
  const dvec3& o = x[at(tet.vertices[0])];
  const dvec3 a = x[at(tet.vertices[1])] - o, b = x[at(tet.vertices[2])] - o, c = x[at(tet.vertices[3])] - o;
  const double p0 = p[at(tet.vertices[0])];
  const double pa = p[at(tet.vertices[1])] - p0, pb = p[at(tet.vertices[2])] - p0, pc = p[at(tet.vertices[3])] - p0;
  const dvec3 bc = glm::cross(b, c);
  tet.gradient = (pa * bc + pb * glm::cross(c, a) + pc * glm::cross(a, b)) / glm::dot(a, bc);
  tet.constant = p0 - glm::dot(tet.gradient, o);
}

double longest_edge(const std::vector<dvec3>& x, const ivec4& t) {
  double longest = 0;
  for (int i = 0; i < 4; ++i) {
    for (int j = i + 1; j < 4; ++j) longest = std::max(longest, glm::distance(x[at(t[i])], x[at(t[j])]));
  }
  return longest;
}

void set_neighbours(int vertex_count, std::vector<Tet>& tets) {
  struct Side {
    int middle, highest, tet, corner;
  };
  const auto face_of = [&](const Tet& tet, int corner) { return sorted_face(tet, at(corner)).first; };
  std::vector<int> first(at(vertex_count) + 1, 0);
  for (Tet& tet : tets) {
    tet.neighbour = ivec4(-1);
    for (int i = 0; i < 4; ++i) ++first[at(face_of(tet, i)[0]) + 1];
  }
  for (std::size_t v = 1; v < first.size(); ++v) first[v] += first[v - 1];
  std::vector<Side> sides(4 * tets.size());
  std::vector<int> next(first.begin(), first.end() - 1);
  for (int t = 0; t < static_cast<int>(tets.size()); ++t) {
    for (int i = 0; i < 4; ++i) {
      const std::array<int, 3> face = face_of(tets[at(t)], i);
      sides[at(next[at(face[0])]++)] = {face[1], face[2], t, i};
    }
  }
  for (int v = 0; v < vertex_count; ++v) {
    const std::span<Side> around(sides.data() + first[at(v)], sides.data() + first[at(v) + 1]);
    std::sort(around.begin(), around.end(), [](const Side& a, const Side& b) {
      return std::tie(a.middle, a.highest, a.tet) < std::tie(b.middle, b.highest, b.tet);
    });
    const auto same = [&](std::size_t i, std::size_t j) {
      return j < around.size() && around[i].middle == around[j].middle && around[i].highest == around[j].highest;
    };
    for (std::size_t i = 0; i < around.size(); ++i) {
      if (!same(i, i + 1)) continue;
      const Side &a = around[i], &b = around[i + 1];
      if (same(i, i + 2))
        throw Error(fmt::format("tets {}, {} and {} share one face", a.tet, b.tet, around[i + 2].tet));
      tets[at(a.tet)].neighbour[a.corner] = b.tet;
      tets[at(b.tet)].neighbour[b.corner] = a.tet;
    }
  }
}

void check_input(const std::vector<dvec3>& vertices, const std::vector<ivec4>& tets, const std::vector<double>& p) {
  if (p.size() != vertices.size())
    throw Error(fmt::format("{} pressures for {} vertices of a pressure field", p.size(), vertices.size()));
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (!is_finite(vertices[v])) throw Error(fmt::format("vertex {} of a pressure field is not finite", v));
    if (!(p[v] >= 0) || !std::isfinite(p[v]))
      throw Error(fmt::format("pressure {} at vertex {} is out of range", p[v], v));
  }
  for (std::size_t t = 0; t < tets.size(); ++t) {
    for (int i = 0; i < 4; ++i) {
      if (tets[t][i] < 0 || at(tets[t][i]) >= vertices.size())
        throw Error(fmt::format("tet {} has no vertex {} (there are {})", t, tets[t][i], vertices.size()));
    }
  }
}

}  // namespace

PressureField::PressureField(std::vector<dvec3> vertices, std::vector<ivec4> tets, std::vector<double> vertex_pressure,
                             FieldReport report)
    : vertices_(std::move(vertices)), vertex_pressure_(std::move(vertex_pressure)), report_(std::move(report)) {
  check_input(vertices_, tets, vertex_pressure_);
  for (const double p : vertex_pressure_) max_pressure_ = std::max(max_pressure_, p);
  tets_.resize(tets.size());
  for (std::size_t t = 0; t < tets.size(); ++t) {
    Tet& tet = tets_[t];
    tet.vertices = tets[t];
    const double volume = six_volumes_of_tet(vertices_, tet.vertices);
    if (!(std::abs(volume) > 0)) throw Error(fmt::format("tet {} of a pressure field has no volume", t));
    if (volume < 0) {
      std::swap(tet.vertices[2], tet.vertices[3]);
      ++report_.inverted;
    }
    tet.size = longest_edge(vertices_, tet.vertices);
    set_planes(vertices_, tet);
    set_pressure(vertices_, vertex_pressure_, tet);
    if (glm::length(tet.gradient) * tet.size <= kZeroGradient * max_pressure_) ++report_.zero_gradient;
    gradients_.push_back(tet.gradient);
    for (int i = 0; i < 4; ++i) bounds_.include(vertices_[at(tet.vertices[i])]);
  }
  set_neighbours(static_cast<int>(vertices_.size()), tets_);
  size_ = bounds_.diagonal();
  report_.tets = static_cast<int>(tets_.size());
  measure_skin_stiffness();
}

void PressureField::measure_skin_stiffness() {
  double area = 0, sum = 0, sum_squares = 0, least = std::numeric_limits<double>::infinity(), most = 0;
  for (const Tet& tet : tets_) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (!is_skin(tet, static_cast<int>(i))) continue;
      const auto face = sorted_face(tet, i).first;
      const dvec3& a = vertices_[at(face[0])];
      const double weight = glm::length(glm::cross(vertices_[at(face[1])] - a, vertices_[at(face[2])] - a));
      const double stiffness = glm::length(tet.gradient);
      area += weight;
      sum += weight * stiffness;
      sum_squares += weight * stiffness * stiffness;
      least = std::min(least, stiffness);
      most = std::max(most, stiffness);
    }
  }
  if (!(sum > 0)) return;
  report_.stiffness_cv = std::sqrt(std::max(0.0, area * sum_squares / (sum * sum) - 1.0));
  report_.stiffness_mean = sum / area;
  report_.stiffness_min = least;
  report_.stiffness_max = most;
  if (!(report_.skin_area > 0)) report_.skin_area = 0.5 * area;
}

Bvh tree_of_tets(const PressureField& field) {
  std::vector<Aabb> boxes(field.tets().size());
  for (std::size_t t = 0; t < boxes.size(); ++t)
    for (int i = 0; i < 4; ++i) boxes[t].include(field.vertices()[at(field.tets()[t].vertices[i])]);
  Bvh tree;
  tree.build(boxes, 1);
  return tree;
}

bool PressureField::is_skin(const Tet& tet, int corner) const {
  if (tet.neighbour[corner] >= 0) return false;
  for (int i = 0; i < 4; ++i) {
    if (i != corner && vertex_pressure_[at(tet.vertices[i])] != 0) return false;
  }
  return true;
}

namespace {

const char* plural(int count) {
  return count == 1 ? "" : "s";
}

/// Returns for example "13 faces (0.2 mm\u00b2, 0.1 % of the skin) between (..) mm and (..) mm".
std::string part_text(const SkinPart& part, double skin_area) {
  return fmt::format("{} face{} ({}, {:.3g} % of the skin) between {} and {}", part.faces, plural(part.faces),
                     in_mm2(part.area), 100 * part.area / skin_area, place_in_mm(part.bounds.lo),
                     place_in_mm(part.bounds.hi));
}

/// Returns for example "face 12, (1, 2, 3) mm". A face that the repair added has no number in the file.
std::string worst_face_text(const SkinPart& part) {
  const std::string face =
      part.worst_face < 0 ? "a face that the repair filled in" : fmt::format("face {}", part.worst_face);
  return fmt::format("{}, {}", face, place_in_mm(part.worst_place));
}

/// Returns for example "; 0.1 H deep 1 +- 0.003 times E depth/H, 0.25 H deep 0.99 +- 0.02; no tets 0.25 H below 4 %, 1
/// H below 78 % of the skin (depth pieces serve contact there)".
std::string press_text(const FieldReport& report) {
  std::string felt, missing;
  for (const FieldReport::PressError& press : report.press_errors) {
    if (press.deviation > 0 || press.mean != 1)
      felt += fmt::format("{} {:.3g} H deep {:.3g} +- {:.2g}", felt.empty() ? ";" : ",", press.part, press.mean,
                          press.deviation);
    if (press.without_tets >= 0.001)
      missing += fmt::format("{} {:.3g} H below {:.2g} %", missing.empty() ? "; no tets" : ",", press.part,
                             100 * press.without_tets);
  }
  if (!felt.empty()) felt += " times E depth/H";
  if (!missing.empty()) missing += " of the skin (depth pieces serve contact there)";
  return felt + missing;
}

/// Returns the sentence about a pad: its two-layer faces and its error of depth.
std::string pad_text(const FieldReport& report) {
  if (!report.core) return "";
  const std::string layers =
      report.two_layer_faces > 0
          ? fmt::format("two layers of prisms below {} face{}", report.two_layer_faces, plural(report.two_layer_faces))
          : std::string("one layer of prisms");
  std::string text = fmt::format("; {}, {:.2g} % of the modulus away from E depth/H (root mean square)", layers,
                                 100 * report.depth_error_rms);
  if (report.refined_faces > 0)
    text += fmt::format("; {} face{} added by refinement", report.refined_faces, plural(report.refined_faces));
  if (report.caps > 0) text += fmt::format("; tents above {} face{}", report.caps, plural(report.caps));
  return text + press_text(report);
}

void add_limits(const FieldReport& report, const std::string& file, const std::string& pointer, Problems& out) {
  if (report.thickness > report.deepest && report.core) {
    out.push_back({file, pointer, Severity::warning, "field_thicker_than_body",
                   fmt::format("the pad is {} thick, more than half of the body's smallest extent, {}: it "
                               "ends in the middle, where the pressure is below the modulus",
                               in_mm(report.thickness), in_mm(report.deepest)),
                   "a thickness in metres, below that"});
  }
  if (report.limited.faces > 0) {
    out.push_back(
        {file, pointer, Severity::note, "field_thickness_limited",
         fmt::format("the pad is thinner than {} at {}: {:.3g} of it is left at {}", in_mm(report.thickness),
                     part_text(report.limited, report.skin_area), report.least_part, worst_face_text(report.limited)),
         ""});
  }
  if (report.bare.faces > 0) {
    out.push_back(
        {file, pointer, Severity::note, "field_bare",
         fmt::format("{} have no tets, folded or edge on: depth pieces serve contact there; the largest is {}",
                     part_text(report.bare, report.skin_area), worst_face_text(report.bare)),
         ""});
  }
}

}  // namespace

Problems field_problems(const FieldReport& report, const std::string& file, const std::string& pointer) {
  constexpr double kUneven = 0.06;
  Problems out;
  out.push_back(
      {file, pointer, Severity::note, "field_report",
       fmt::format("pressure field of {} tets; stiffness {:.4g} Pa/m, from {:.4g} to {:.4g}, varies by {:.2g} % "
                   "over the skin{}",
                   report.tets, report.stiffness_mean, report.stiffness_min, report.stiffness_max,
                   100 * report.stiffness_cv, pad_text(report)),
       ""});
  if (report.inverted > 0) {
    out.push_back({file, pointer, Severity::warning, "field_inverted",
                   fmt::format("{} of {} tets of the pressure field were inside out and have been turned: it overlaps "
                               "itself there",
                               report.inverted, report.tets),
                   "use a pad"});
  }
  if (report.zero_gradient > 0) {
    out.push_back(
        {file, pointer, Severity::warning, "field_zero_gradient",
         fmt::format("{} of {} tets of the pressure field have no pressure that grows inward: nothing is felt "
                     "in them",
                     report.zero_gradient, report.tets),
         "give the tets vertices inside of the body"});
  }
  add_limits(report, file, pointer, out);
  if (report.core && report.stiffness_cv > kUneven) {
    out.push_back({file, pointer, Severity::warning, "field_uneven",
                   fmt::format("the pad's stiffness varies by {:.2g} % over the skin", 100 * report.stiffness_cv),
                   "a thinner pad, or a finer mesh where it is sharp"});
  }
  for (const std::string& note : report.notes) out.push_back({file, pointer, Severity::note, "field_note", note, ""});
  return out;
}

}  // namespace taxel
