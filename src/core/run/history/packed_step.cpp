// A step as bytes, which unpack to the same bits.
//
// Only results that cannot be computed again with the same bits are written: poses, surfaces, readings, motions. Hits
// of rays and shear are read again from the surfaces, which takes less time than storing them; shear with friction that
// sticks depends on the past and is stored. Polygons are most of a step. Their values are mostly the expected ones (the
// vertices follow those of the previous polygon, the normal is the same, the gradient is that of the tet), and flags
// say which are not.
//
// Large arrays are written past the caches, since the next step needs their content, and the writing of polygons looks
// ahead: tets are far apart in memory, and the destination is in no cache. The largest size is known beforehand, so
// packing allocates nothing.
#include "core/run/history/packed_step.h"

#include <cstring>
#include <type_traits>
#include <utility>

#include "core/run/history/stream_copy.h"
#include "core/sensor/readout/reading.h"

namespace taxel {
namespace {

/// Sizes of one sensor's arrays.
struct SensorCounts {
  std::uint32_t readings = 0, surfaces = 0, motions = 0;
  std::uint32_t slip = 0, shear = 0;  // shear is packed only of friction that sticks: motions do not give it
  std::uint32_t sticking = 0;
};
struct SurfaceCounts {
  std::uint32_t vertices = 0, polygons = 0, filtered_vertices = 0, filtered = 0;
};

// Flags of the values of a polygon that are written only if they are not the expected ones.
constexpr std::uint32_t kFirst = 1;     // the vertices do not follow those of the previous polygon
constexpr std::uint32_t kNormal = 2;    // the normal differs from that of the previous polygon
constexpr std::uint32_t kGradient = 4;  // the gradient differs from that of the tet
constexpr std::uint32_t kTetB = 8;      // the polygon has a tet of the other body
constexpr std::uint32_t kWeight = 16;   // the polygon is a back face that counts in part
constexpr unsigned kPartBits = 5;       // the number of corners is in the bits above

std::uint32_t count(std::size_t n) {
  return static_cast<std::uint32_t>(n);
}

bool same_bits(const dvec3& a, const dvec3& b) {
  return std::memcmp(&a, &b, sizeof(dvec3)) == 0;
}

/// The gradients of a sensor's own field, by tet.
class TetGradients {
 public:
  explicit TetGradients(const SensorModelPtr& model) {
    const auto* soft = model && model->body ? std::get_if<SoftBody>(&model->body->geometry) : nullptr;
    if (soft != nullptr) gradients_ = soft->field->gradients();
  }
  [[nodiscard]] const dvec3* of(int tet) const {
    const auto index = static_cast<std::size_t>(tet);
    return tet >= 0 && index < gradients_.size() ? &gradients_[index] : nullptr;
  }

 private:
  std::span<const dvec3> gradients_;
};

class Sink {
 public:
  explicit Sink(std::byte* to) : to_(to) {}
  template <class T>
  void put(const T* first, std::size_t n) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (n > 0) std::memcpy(to_, first, n * sizeof(T));
    to_ += n * sizeof(T);
  }
  template <class T>
  void put(const T& value) {
    put(&value, 1);
  }
  template <class Container>
  void put_all(const Container& values) {
    put(values.data(), values.size());
  }
  /// Appends a large array past the caches.
  template <class Container>
  void stream_all(const Container& values) {
    const std::size_t size = values.size() * sizeof(values[0]);
    stream_copy(to_, values.data(), size);
    to_ += size;
  }
  [[nodiscard]] std::byte* end() const { return to_; }
  void set_end(std::byte* end) { to_ = end; }

 private:
  std::byte* to_;
};

/// Appends a value in a loop. Bytes may alias the members of a Sink, which would then be loaded again for each value.
template <class T>
std::byte* append(std::byte* to, const T& value) {
  std::memcpy(to, &value, sizeof(T));
  return to + sizeof(T);
}

class Source {
 public:
  explicit Source(const std::byte* from) : from_(from) {}
  template <class T>
  void take(T* to, std::size_t n) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (n > 0) std::memcpy(to, from_, n * sizeof(T));
    from_ += n * sizeof(T);
  }
  template <class T>
  [[nodiscard]] T take() {
    T value;
    take(&value, 1);
    return value;
  }
  template <class Container>
  void take_all(Container& to, std::size_t n) {
    to.resize(n);
    take(to.data(), n);
  }

 private:
  const std::byte* from_;
};

void put_polygons(const std::vector<ContactPolygon>& polygons, const TetGradients& gradients, Sink& sink) {
  std::byte* to = sink.end();
  int first = 0;
  dvec3 normal(0);
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    // Without prefetching, waiting took a third of the time.
    constexpr std::size_t kAhead = 8, kBytesAhead = 1024;
    if (i + kAhead < polygons.size()) __builtin_prefetch(gradients.of(polygons[i + kAhead].tet));
    __builtin_prefetch(to + kBytesAhead, 1);
    const ContactPolygon& polygon = polygons[i];
    const dvec3* gradient = gradients.of(polygon.tet);
    std::uint32_t parts = 0;
    if (polygon.first != first) parts |= kFirst;
    if (!same_bits(polygon.normal, normal)) parts |= kNormal;
    if (gradient == nullptr || !same_bits(polygon.gradient, *gradient)) parts |= kGradient;
    if (polygon.tet_b != -1) parts |= kTetB;
    if (polygon.weight != 1) parts |= kWeight;
    to = append(to, parts | static_cast<std::uint32_t>(polygon.count) << kPartBits);
    to = append(to, polygon.tet);
    to = append(to, polygon.face);
    to = append(to, polygon.area);
    to = append(to, polygon.centroid);
    to = append(to, polygon.pressure);
    if ((parts & kFirst) != 0) to = append(to, polygon.first);
    if ((parts & kNormal) != 0) to = append(to, polygon.normal);
    if ((parts & kGradient) != 0) to = append(to, polygon.gradient);
    if ((parts & kTetB) != 0) to = append(to, polygon.tet_b);
    if ((parts & kWeight) != 0) to = append(to, polygon.weight);
    first = polygon.first + polygon.count;
    normal = polygon.normal;
  }
  sink.set_end(to);
}

void take_polygons(Source& source, const TetGradients& gradients, std::vector<ContactPolygon>& polygons) {
  int first = 0;
  dvec3 normal(0);
  for (ContactPolygon& polygon : polygons) {
    const auto parts = source.take<std::uint32_t>();  // and the number of corners
    polygon.count = static_cast<int>(parts >> kPartBits);
    polygon.tet = source.take<int>();
    polygon.face = source.take<int>();
    polygon.area = source.take<double>();
    polygon.centroid = source.take<dvec3>();
    polygon.pressure = source.take<double>();
    if ((parts & kFirst) != 0) first = source.take<int>();
    if ((parts & kNormal) != 0) normal = source.take<dvec3>();
    polygon.first = first;
    polygon.normal = normal;
    polygon.gradient = (parts & kGradient) != 0 ? source.take<dvec3>() : *gradients.of(polygon.tet);
    polygon.tet_b = (parts & kTetB) != 0 ? source.take<int>() : -1;
    polygon.weight = (parts & kWeight) != 0 ? source.take<float>() : 1.0f;
    first += polygon.count;
  }
}

void put_surface(const ContactSurface& surface, const TetGradients& gradients, Sink& sink) {
  sink.put(SurfaceCounts{count(surface.vertices.size()), count(surface.polygons.size()),
                         count(surface.filtered_vertices.size()), count(surface.filtered.size())});
  sink.stream_all(surface.vertices);
  sink.stream_all(surface.pressure);
  put_polygons(surface.polygons, gradients, sink);
  sink.put(surface.rejected);
  sink.put_all(surface.filtered_vertices);
  sink.put_all(surface.filtered);
}

void take_surface(Source& source, const TetGradients& gradients, ContactSurface& surface) {
  const auto counts = source.take<SurfaceCounts>();
  source.take_all(surface.vertices, counts.vertices);
  source.take_all(surface.pressure, counts.vertices);
  surface.polygons.resize(counts.polygons);
  take_polygons(source, gradients, surface.polygons);
  surface.rejected = source.take<decltype(surface.rejected)>();
  source.take_all(surface.filtered_vertices, counts.filtered_vertices);
  source.take_all(surface.filtered, counts.filtered);
}

void put_sensor(const SensorView& sensor, const SensorModelPtr& model, Sink& sink) {
  const TetGradients gradients(model);
  sink.put(sensor.X_WM);
  sink.put(sensor.force_W);
  sink.put(sensor.uncovered_W);
  const bool can_stick = !sensor.slip.empty() || !sensor.sticking.empty();
  const auto shear = can_stick ? sensor.shear : std::span<const dvec2>();
  sink.put(SensorCounts{count(sensor.readings.size()), count(sensor.surfaces.size()), count(sensor.motions.size()),
                        count(sensor.slip.size()), count(shear.size()), count(sensor.sticking.size())});
  sink.put_all(sensor.readings);
  sink.put_all(sensor.slip);
  sink.put_all(shear);
  sink.put_all(sensor.motions);
  for (const StickingFriction* friction : sensor.sticking) {
    sink.put(friction->reach);
    sink.put(count(friction->roots.size()));
    sink.put_all(friction->roots);
  }
  for (const ContactSurface* surface : sensor.surfaces) put_surface(*surface, gradients, sink);
}

/// Computes hits and shear from the recorded surfaces and motions. The result has the same bits as the recorded step,
/// and computing takes less time than storing.
void read_again(SensorStep& sensor) {
  sensor.hits.clear();
  const SensorModelPtr& model = sensor.model;
  if (!model) return;
  const std::vector<const ContactSurface*> surfaces = surface_pointers(sensor);
  SensorReading reading;
  if (model->layout.readout.shear && sensor.slip.empty() && sensor.sticking.empty()) {
    read_sensor(*model, surfaces, reading, RayPath::fastest, sensor.motions);
    sensor.shear = std::move(reading.shear);
  } else {
    cast_rays(*model, surfaces, RayPath::fastest, reading.workspace, reading.hits);
  }
  sensor.hits = reading.hits.all();
}

/// Needs sensor.model and sensor.time.
void take_sensor(Source& source, SensorStep& sensor) {
  const TetGradients gradients(sensor.model);
  sensor.X_WM = source.take<Pose>();
  sensor.force_W = source.take<dvec3>();
  sensor.uncovered_W = source.take<dvec3>();
  const auto counts = source.take<SensorCounts>();
  source.take_all(sensor.readings, counts.readings);
  source.take_all(sensor.slip, counts.slip);
  source.take_all(sensor.shear, counts.shear);
  source.take_all(sensor.motions, counts.motions);
  sensor.sticking.resize(counts.sticking);
  for (StickingFriction& friction : sensor.sticking) {
    friction.reach = source.take<double>();
    source.take_all(friction.roots, source.take<std::uint32_t>());
  }
  sensor.surfaces.resize(counts.surfaces);
  for (ContactSurface& surface : sensor.surfaces) take_surface(source, gradients, surface);
  read_again(sensor);
}

std::size_t largest_surface_size(const ContactSurface& surface) {
  return sizeof(SurfaceCounts) + surface.vertices.size() * (sizeof(dvec3) + sizeof(double)) +
         surface.polygons.size() * (sizeof(ContactPolygon) + sizeof(std::uint32_t)) + sizeof(surface.rejected) +
         surface.filtered_vertices.size() * sizeof(dvec3) + surface.filtered.size() * sizeof(FilteredPolygon);
}

}  // namespace

std::size_t largest_packed_size(const StepView& view) {
  std::size_t size =
      5 * sizeof(std::uint32_t) + view.constraint_points.size() * sizeof(ConstraintPoints) + sizeof(StepFacts) +
      (view.geom_poses.size() + view.mark_poses.bodies.size() + view.mark_poses.cameras.size()) * sizeof(Pose);
  for (const SensorView& sensor : view.sensors) {
    size += sizeof(Pose) + 2 * sizeof(dvec3) + sizeof(SensorCounts) + sensor.readings.size() * sizeof(double) +
            sensor.slip.size() * sizeof(double) + sensor.shear.size() * sizeof(dvec2) +
            sensor.motions.size() * sizeof(SurfaceMotion);
    for (const StickingFriction* friction : sensor.sticking)
      size += sizeof(double) + sizeof(std::uint32_t) + friction->roots.size() * sizeof(StickingFriction::Root);
    for (const ContactSurface* surface : sensor.surfaces) size += largest_surface_size(*surface);
  }
  return size;
}

std::size_t pack_step(const StepView& view, std::byte* to) {
  Sink sink(to);
  sink.put(count(view.geom_poses.size()));
  sink.put(count(view.sensors.size()));
  sink.put(count(view.constraint_points.size()));
  sink.put(count(view.mark_poses.bodies.size()));
  sink.put(count(view.mark_poses.cameras.size()));
  sink.put_all(view.geom_poses);
  sink.put_all(view.constraint_points);
  sink.put_all(view.mark_poses.bodies);
  sink.put_all(view.mark_poses.cameras);
  sink.put(view.facts);
  for (std::size_t s = 0; s < view.sensors.size(); ++s) put_sensor(view.sensors[s], view.scene->sensors[s], sink);
  return static_cast<std::size_t>(sink.end() - to);
}

void unpack_step(const std::byte* from, Step& step) {
  Source source(from);
  const auto geoms = source.take<std::uint32_t>(), sensors = source.take<std::uint32_t>();
  const auto points = source.take<std::uint32_t>(), bodies = source.take<std::uint32_t>();
  const auto cameras = source.take<std::uint32_t>();
  source.take_all(step.geom_poses, geoms);
  source.take_all(step.constraint_points, points);
  source.take_all(step.mark_poses.bodies, bodies);
  source.take_all(step.mark_poses.cameras, cameras);
  step.facts = source.take<StepFacts>();
  step.sensors.resize(sensors);
  for (std::size_t s = 0; s < step.sensors.size(); ++s) {
    step.sensors[s].model = step.scene->sensors[s];
    step.sensors[s].time = step.time;
    take_sensor(source, step.sensors[s]);
  }
}

}  // namespace taxel
