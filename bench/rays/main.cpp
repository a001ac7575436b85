// Time of rays and readings on recorded frames, compared with Embree and the paper's scheme, on one core. Prints a
// table in Markdown.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <functional>

#include "core/sensor/readout/reading.h"
#include "rays/frames.h"
#include "rays/peers.h"
#include "unit/sensor/ray_oracles.h"

namespace {
using namespace taxel;
using namespace taxel::bench;

constexpr int kRounds = 20;
constexpr double kDepthTolerance = 1e-6;  // Embree works in single precision [m]

/// Returns the processor time of this thread, which other programs do not change [us].
double now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return 1e6 * static_cast<double>(t.tv_sec) + 1e-3 * static_cast<double>(t.tv_nsec);
}

struct Times {
  double median = 0, p99 = 0;  // [us]
};
Times summary(std::vector<double> samples) {
  std::sort(samples.begin(), samples.end());
  const auto at = [&](double part) {
    return samples[static_cast<std::size_t>(part * static_cast<double>(samples.size() - 1))];
  };
  return {at(0.5), at(0.99)};
}

/// Reads a whole frame, so that it is in the caches like a surface that was just computed.
double touch(const std::vector<ContactSurface>& frame) {
  double sum = 0;
  for (const ContactSurface& surface : frame) {
    for (const dvec3& v : surface.vertices) sum += v.x;
    for (const ContactPolygon& polygon : surface.polygons) sum += polygon.area + polygon.tet;
  }
  return sum;
}

using Way = std::function<void(const std::vector<const ContactSurface*>&)>;

/// Measures all ways one after another in each round, so that changes of the machine's speed affect all of them.
std::vector<Times> time_ways(const Path& path, const std::vector<Way>& ways) {
  std::vector<std::vector<double>> samples(ways.size());
  double sum = 0;
  for (int round = -2; round < kRounds; ++round) {
    for (std::size_t w = 0; w < ways.size(); ++w) {
      for (const auto& frame : path.frames) {
        const auto list = pointers(frame);
        sum += touch(frame);
        const double start = now();
        ways[w](list);
        if (round >= 0) samples[w].push_back(now() - start);
      }
    }
  }
  if (std::isnan(sum)) fmt::print(stderr, "a frame is not finite\n");
  std::vector<Times> times;
  for (std::vector<double>& of_way : samples) times.push_back(summary(std::move(of_way)));
  return times;
}

Way casting(RayCaster& caster) {
  return [&caster](const auto& list) { caster.cast(list); };
}

/// Number of rays whose result differs from brute force in double precision: in surface, polygon or any bit of the
/// depth.
struct Differences {
  long exact = 0;  ///< differing rays of our own two paths
  long peer = 0;   ///< differing rays of the peer: hit or miss, or depth by more than the tolerance
};

bool same(const RayHit& a, const RayHit& b) {
  return a.surface == b.surface && a.polygon == b.polygon && a.depth == b.depth && a.pressure == b.pressure;
}

Differences compare(const SensorModel& sensor, const Path& path, RayCaster& table, RayCaster& tree, RayCaster& peer) {
  Differences d;
  for (const auto& frame : path.frames) {
    const auto list = pointers(frame);
    const WithoutTrees brute_force(list);
    for (RayCaster* caster : {&table, &tree, &peer}) caster->cast(list);
    const auto a = table.hits(), b = tree.hits(), c = peer.hits();
    for (std::size_t r = 0; r < sensor.rays.size(); ++r) {
      const RayHit expected = brute_force.cast(sensor.rays[r]);
      d.exact += !same(a[r], expected) + !same(b[r], expected);
      d.peer += expected.hit() != c[r].hit() || std::abs(expected.depth - c[r].depth) > kDepthTolerance;
    }
  }
  return d;
}

void print_class(const SensorModelPtr& sensor, Object object) {
  const auto table = make_own(*sensor, RayPath::tet_table), tree = make_own(*sensor, RayPath::bvh);
  const auto paper = make_paper(*sensor);
  const auto embree = make_embree(*sensor);
  for (const Path& path : record_paths(*sensor, object)) {
    SensorReading reading;
    std::vector<Way> ways{casting(*table), casting(*tree), casting(*paper),
                          [&](const auto& list) { read_sensor(*sensor, list, reading); }};
    for (const auto& variant : embree) ways.push_back(casting(*variant));
    const std::vector<Times> times = time_ways(path, ways);
    const Times &t = times[0], &b = times[1], &p = times[2], &r = times[3];
    Times best;
    RayCaster* best_variant = nullptr;
    for (std::size_t i = 0; i < embree.size(); ++i) {
      const Times& e = times[4 + i];
      if (best_variant == nullptr || e.median < best.median) best = e, best_variant = embree[i].get();
    }
    const Differences d = compare(*sensor, path, *table, *tree, best_variant ? *best_variant : *paper);
    const std::string of_embree =
        best_variant ? fmt::format("{:.0f} / {:.0f} ({})", best.median, best.p99, best_variant->name()) : "absent";
    const std::string ratio = best_variant ? fmt::format("**{:.1f}**", best.median / t.median) : "";
    fmt::print(
        "| {} | {:.0f} | {} | {:.1f} / {:.1f} | {:.1f} / {:.1f} | {:.0f} / {:.0f} | {:.0f} / {:.0f} | {} | {} | "
        "**{:.0f}** | {} | {} |\n",
        path.name, path.mean_polygons(), sensor->rays.size(), t.median, t.p99, r.median, r.p99, b.median, b.p99,
        p.median, p.p99, of_embree, ratio, p.median / t.median, d.exact, d.peer);
    std::fflush(stdout);
  }
}

/// Prints the table of flat arrays: raster path, tet table and trees.
void print_flat(const std::string& name, Object object) {
  const SensorModelPtr sensor = preset_sensor(name);
  const auto raster = make_own(*sensor, RayPath::raster), table = make_own(*sensor, RayPath::tet_table),
             tree = make_own(*sensor, RayPath::bvh);
  for (const Path& path : record_flat_paths(*sensor, object)) {
    const std::vector<Times> times = time_ways(path, {casting(*raster), casting(*table), casting(*tree)});
    const Times &r = times[0], &t = times[1], &b = times[2];
    const Differences d = compare(*sensor, path, *raster, *table, *tree);
    fmt::print(
        "| {}, {} | {} | {:.0f} | {} | {:.1f} / {:.1f} | {:.1f} / {:.1f} | {:.0f} / {:.0f} | **{:.1f}** | {} |\n", name,
        object == Object::box ? "box" : "sphere", path.name, path.mean_polygons(), sensor->rays.size(), r.median, r.p99,
        t.median, t.p99, b.median, b.p99, t.median / r.median, d.exact + d.peer);
    std::fflush(stdout);
  }
}

void print_curved() {
  fmt::print(
      "Times of one step in microseconds of processor time, median / 99 %. Each way pays for its own conversion.\n\n");
  fmt::print(
      "| path | polygons | rays | tet table | and reading | BVH | paper's scheme | Embree's best | Embree / table | "
      "paper / table | rays unlike brute force: ours | the peer's, in single precision |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const int rays : {1000, 10000}) {
    const SensorModelPtr sensor = fingertip_with_rays(rays);
    for (const Object object : {Object::box, Object::sphere}) print_class(sensor, object);
  }
  if (make_embree(*fingertip_with_rays(100)).empty())
    fmt::print("\nskipped: Embree 3 was not found when this was built (Debian libembree-dev)\n");
}

void print_flat_arrays() {
  fmt::print(
      "\nFlat arrays of the presets, pressed and slid on:\n\n"
      "| array and object | path | polygons | rays | raster | tet table | BVH | table / raster | rays unlike brute "
      "force |"
      "\n| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n");
  for (const char* name : {"xela-4x4", "myrmex"})
    for (const Object object : {Object::box, Object::sphere}) print_flat(name, object);
}

}  // namespace

/// `bench_rays [flat|curved]` prints only one of the two tables.
int main(int argc, char** argv) {
  const std::string only = argc > 1 ? argv[1] : "";
  if (only != "flat") print_curved();
  if (only != "curved") print_flat_arrays();
  return 0;
}
