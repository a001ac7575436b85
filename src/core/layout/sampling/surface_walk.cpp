// Straight lines over a mesh, and the surface around a point unfolded into the plane.
//
// A straightest line (Polthier, Schmies 1998) crosses each face to the edge that it reaches first and goes on in the
// plane of the next face, in the direction that is parallel when both are unfolded. A walk that circles around a vertex
// by rounding ends after a number of faces.
//
// A chart unfolds the faces around a point over their edges, the nearest edge first, each face once. Where the surface
// is developable every face gets the same place over any edge, and distances are exact; around a corner a face is laid
// out from the side that is nearest to the point, which is the shortest way in most cases. Cost: in proportion to the
// faces within the radius. This is enough for samplers, which need distances a few faces around each sample many times;
// exact geodesic distances are in core/mesh/geodesic.h.
#include "core/layout/sampling/surface_walk.h"

namespace taxel {
namespace {

double squared_length(const dvec2& v) {
  return glm::dot(v, v);
}

/// Squared distance of the origin from a segment.
double from_origin(const dvec2& a, const dvec2& b) {
  const dvec2 edge = b - a;
  const double length = squared_length(edge);
  const double t = length > 0.0 ? glm::clamp(-glm::dot(a, edge) / length, 0.0, 1.0) : 0.0;
  return squared_length(a + t * edge);
}

}  // namespace

SurfaceGraph::SurfaceGraph(const TriMesh& mesh) : mesh_(mesh), sides_(3 * mesh.faces().size()), flat_(sides_.size()) {
  lay_flat();
}

void SurfaceGraph::lay_flat() {
  for (int f = 0; f < mesh_.face_count(); ++f) {
    const dvec3& normal = mesh_.face_normals()[static_cast<std::size_t>(f)];
    for (int c = 0; c < 3; ++c) {
      Side& mine = sides_[side(f, c)];
      const dvec3 &a = mesh_.vertex(f, c), to_apex = mesh_.vertex(f, (c + 2) % 3) - a;
      mine.along = mesh_.vertex(f, (c + 1) % 3) - a;
      mine.length = glm::length(mine.along);
      mine.along /= mine.length;
      mine.outward = glm::cross(mine.along, normal);
      flat_[side(f, c)].across = mesh_.topology().twin(3 * f + c);
      flat_[side(f, c)].apex = dvec2(glm::dot(to_apex, mine.along), -glm::dot(to_apex, mine.outward)) / mine.length;
    }
  }
}

SurfaceStep SurfaceGraph::walk(SurfaceStep at, dvec3 way) const {
  int came_from = -1;
  for (int steps = 0; steps < 4 * mesh_.face_count() + 16; ++steps) {  // ends a walk round and round a point
    double part = 1.0;
    int exit = -1;
    for (int c = 0; c < 3; ++c) {
      const dvec3& outward = sides_[side(at.face, c)].outward;
      const double speed = glm::dot(way, outward);
      if (c == came_from || !(speed > 0.0)) continue;
      const double t = std::max(0.0, glm::dot(mesh_.vertex(at.face, c) - at.position, outward) / speed);
      if (t < part) part = t, exit = c;
    }
    at.position += part * way;
    if (exit < 0) return at;
    const int entered = flat_[side(at.face, exit)].across;
    if (entered < 0) return at;
    way = turn((1.0 - part) * way, at.face, exit);
    at.face = entered / 3;
    came_from = entered % 3;
  }
  return at;
}

SurfaceChart::SurfaceChart(const SurfaceGraph& graph)
    : graph_(graph), image_of_(static_cast<std::size_t>(graph.mesh().face_count()), -1), stamp_(image_of_.size(), 0) {}

void SurfaceChart::unfold(const SurfaceStep& origin, const dvec3& u, const dvec3& v, double radius) {
  ++round_;
  images_.clear();
  bucket_ = 0;
  const double limit = radius * radius;
  Image first;
  for (int c = 0; c < 3; ++c) {
    const dvec3 apart = graph_.mesh().vertex(origin.face, c) - origin.position;
    first[static_cast<std::size_t>(c)] = {glm::dot(u, apart), glm::dot(v, apart)};
  }
  add(origin.face, first, limit);
  for (; bucket_ < buckets_.size(); ++bucket_) {
    while (!buckets_[bucket_].empty()) {
      const Entry entry = buckets_[bucket_].back();
      buckets_[bucket_].pop_back();
      if (!has(entry.side / 3)) pass(entry, limit);
    }
  }
}

/// Lays the entered face next to the face that was left.
void SurfaceChart::pass(const Entry& entry, double limit) {
  const auto& entered = graph_.flat_[static_cast<std::size_t>(entry.side)];
  const Image& from = images_[static_cast<std::size_t>(entry.image)];
  const auto out = static_cast<std::size_t>(entered.across % 3), in = static_cast<std::size_t>(entry.side % 3);
  const dvec2 begin = from[(out + 1) % 3], along = from[out] - begin;  // the edge runs the other way there
  Image image;
  image[in] = begin;
  image[(in + 1) % 3] = from[out];
  image[(in + 2) % 3] = begin + entered.apex.x * along + entered.apex.y * dvec2(-along.y, along.x);
  add(entry.side / 3, image, limit);
}

void SurfaceChart::add(int face, const Image& image, double limit) {
  stamp_[static_cast<std::size_t>(face)] = round_;
  image_of_[static_cast<std::size_t>(face)] = static_cast<int>(images_.size());
  images_.push_back(image);
  for (int c = 0; c < 3; ++c) {
    const int across = graph_.flat_[SurfaceGraph::side(face, c)].across;
    if (across < 0 || has(across / 3)) continue;
    const double distance =
        from_origin(image[static_cast<std::size_t>(c)], image[static_cast<std::size_t>((c + 1) % 3)]);
    if (!(distance < limit)) continue;
    const auto nearest = static_cast<std::size_t>(distance / limit * static_cast<double>(buckets_.size()));
    buckets_[std::clamp(nearest, bucket_, buckets_.size() - 1)].push_back(
        {across, image_of_[static_cast<std::size_t>(face)]});
  }
}

bool SurfaceChart::find(const SurfaceStep& place, dvec2& flat) const {
  if (!has(place.face)) return false;
  const Image& image = images_[static_cast<std::size_t>(image_of_[static_cast<std::size_t>(place.face)])];
  const auto& first = graph_.sides_[SurfaceGraph::side(place.face, 0)];
  const dvec3 apart = place.position - graph_.mesh().vertex(place.face, 0);
  const dvec2 along = (image[1] - image[0]) / first.length;
  flat = image[0] + glm::dot(apart, first.along) * along - glm::dot(apart, first.outward) * dvec2(-along.y, along.x);
  return true;
}

}  // namespace taxel
