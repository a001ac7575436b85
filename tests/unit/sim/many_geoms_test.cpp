// One sensor among many geoms: no touching geom is missed, the force is the sum, and no step allocates.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/base/rng.h"
#include "core/hydro/intersect.h"
#include "core/sim/model/geometry.h"
#include "fixtures/counted_new.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::key;
using test::sensor_extension;
using test::SensorScene;

constexpr double kSphereRadius = 0.02;

/// Returns a geom somewhere around a ball of 20 mm at the origin, touching the ball or not. Every third geom is on a
/// moving body.
std::string random_geom(const CounterRng& rng, std::uint64_t i, const std::string& name) {
  const auto u = [&](std::uint64_t k) { return rng.uniform(20 * i + k); };
  const char* types[] = {"sphere", "box", "capsule", "cylinder", "ellipsoid"};
  const dvec3 away = glm::normalize(dvec3(u(0) - 0.5, u(1) - 0.5, u(2) - 0.5));
  const dvec3 place = (kSphereRadius + 0.06 * u(3) * u(3)) * away;
  const std::string size = fmt::format("{} {} {}", 0.004 + 0.01 * u(4), 0.004 + 0.01 * u(5), 0.004 + 0.01 * u(6));
  const std::string at =
      fmt::format("pos='{} {} {}' quat='{} {} {} {}'", place.x, place.y, place.z, u(7), u(8), u(9), u(10));
  const std::string geom =
      fmt::format("<geom name='{}' type='{}' size='{}' friction='{}'", name, types[i % 5], size, u(11));
  if (i % 3 != 0) return geom + " " + at + "/>";
  return "<body " + at + "><joint type='slide' axis='1 0 0'/>" + geom + "/></body>";
}

std::string scene_of(const std::string& geoms, const std::string& keys, const std::string& moving = "<freejoint/>") {
  return "<mujoco><option gravity='0 0 0'/>" + sensor_extension("ball", keys) +
         "<default><geom contype='0' conaffinity='0' density='8000'/></default><asset><mesh name='ball' "
         "file='ball.obj'/>"
         "</asset><worldbody><body name='ball'>" +
         moving + "<geom name='ball' type='mesh' mesh='ball'/></body>" + geoms + "</worldbody></mujoco>";
}

class ManyGeoms : public testing::Test {
 protected:
  void SetUp() override { s.add_sensor("ball", make_sphere(kSphereRadius, 0.008), {FieldKind::star, 5e4, 0, 2, 0.5}); }
  void compile(const std::string& geoms, const std::vector<std::string>& others, const std::string& keys = "") {
    std::string names;
    for (const std::string& name : others) names += name + " ";
    s.compile(scene_of(geoms, key("others", names) + keys));
    ASSERT_NE(s.model, nullptr) << s.error;
    for (int i = 0; i < s.model->nv; ++i) s.data->qvel[i] = 0.01 * (i % 7 - 3);
  }
  SensorScene s;
};

TEST_F(ManyGeoms, PushTogetherLikeTheSumOfEach) {
  const CounterRng rng(11);
  std::string geoms = "<geom name='floor' type='plane' size='1 1 1' pos='0 0 -0.0195'/>";
  std::vector<std::string> names{"floor"};
  for (std::uint64_t i = 0; i < 12; ++i) {
    names.push_back(fmt::format("g{}", i));
    geoms += random_geom(rng, i, names.back());
  }
  const std::string output = key("output", "wrench area") + key("force", "sense");
  compile(geoms, names, output);
  mj_forward(s.model.get(), s.data.get());
  const std::vector<double> together(s.data->sensordata, s.data->sensordata + 7);
  std::vector<double> sum(7, 0.0);
  int touching = 0;
  for (const std::string& name : names) {
    compile(geoms, {name}, output);
    mj_forward(s.model.get(), s.data.get());
    for (std::size_t i = 0; i < 7; ++i) sum[i] += s.data->sensordata[i];
    touching += s.data->sensordata[6] > 0;
  }
  EXPECT_GT(touching, 2);
  EXPECT_LT(touching, 12);
  for (std::size_t i = 0; i < 7; ++i) EXPECT_NEAR(together[i], sum[i], 1e-12 * (1 + std::abs(sum[i]))) << i;
}

TEST_F(ManyGeoms, MissNoTouchingGeomWhileAllMove) {
  const CounterRng rng(12);
  std::string geoms = "<geom name='floor' type='plane' size='1 1 1' pos='0 0 -0.021'/>";
  std::vector<std::string> names{"floor"};
  for (std::uint64_t i = 0; i < 30; ++i) {
    names.push_back(fmt::format("g{}", i));
    geoms += random_geom(rng, i, names.back());
  }
  compile(geoms, names, key("force", "sense"));
  IntersectWorkspace workspace;
  ContactSurface expected;
  std::size_t touching = 0;
  for (int n = 0; n < 12; ++n) {
    s.step(10);
    if (n == 6) s.model->geom_pos[2] += 0.003;  // the program may move a static geom, such as the floor
    const mjModel& m = *s.model;
    mj_forward(s.model.get(), s.data.get());
    const HydroInstance& sensor = s.sensor();
    const Evaluation& e = sensor.sensed();
    for (std::size_t i = 0; i < sensor.touched().size(); ++i) {
      const TouchedGeom& t = sensor.touched()[i];
      intersect(*sensor.model()->body, *t.body, e.X_WM, geom_pose(m, *s.data, t.geom), expected, workspace);
      EXPECT_EQ(e.pairs[i].surface.polygons.size(), expected.polygons.size()) << names[i];
      EXPECT_EQ(e.pairs[i].surface.area(), expected.area()) << names[i];
      touching += expected.empty() ? 0 : 1;
    }
    EXPECT_LT(e.near.size(), sensor.touched().size());
  }
  EXPECT_GT(touching, 60u);
}

TEST_F(ManyGeoms, PushLikeTheirSumIfTheyShareABody) {
  const std::string box = "<geom name='{}' type='box' size='.01 .01 .01' pos='{} 0 -0.028' density='8000'/>";
  const std::string left = fmt::format(fmt::runtime(box), "left", -0.01),
                    right = fmt::format(fmt::runtime(box), "right", 0.01);
  compile("<body><freejoint/>" + left + right + "</body>", {"left", "right"}, key("output", "wrench area"));
  mj_forward(s.model.get(), s.data.get());
  const Evaluation& e = s.sensor().sensed();
  const Wrench &a = e.pairs.at(0).wrench, &b = e.pairs.at(1).wrench;
  EXPECT_GT(a.force.z, 0.1);
  EXPECT_NEAR(s.data->sensordata[2], a.force.z + b.force.z, 1e-12);
  // Two halves of a bar push like the whole bar. The faces between the halves are inside the pad as well: they push
  // against each other, and their area is counted.
  const Wrench of_left = pressure_wrench(e.pairs[0].surface), of_right = pressure_wrench(e.pairs[1].surface);
  const double halves_area = e.pairs[0].surface.area() + e.pairs[1].surface.area();
  compile("<body><freejoint/><geom name='bar' type='box' size='.02 .01 .01' pos='0 0 -0.028'/></body>", {"bar"});
  mj_forward(s.model.get(), s.data.get());
  const ContactSurface& bar = s.sensor().sensed().pairs.at(0).surface;
  EXPECT_LE(glm::distance(of_left.force + of_right.force, pressure_wrench(bar).force), 1e-10);
  EXPECT_LE(glm::distance(of_left.torque + of_right.torque, pressure_wrench(bar).torque), 1e-12);
  EXPECT_GT(halves_area, 1.1 * bar.area());
}

TEST_F(ManyGeoms, AllocateNothingInAStep) {
  const CounterRng rng(13);
  std::string geoms;
  std::vector<std::string> names;
  for (std::uint64_t i = 0; i < 30; ++i) {
    names.push_back(fmt::format("g{}", i));
    geoms += random_geom(rng, i, names.back());
  }
  compile(geoms, names);
  s.step(8);
  mj_resetData(s.model.get(), s.data.get());
  s.step(8);  // the same steps again
  ASSERT_GT(s.sensor().sensed().near.size(), 5u);
  mj_resetData(s.model.get(), s.data.get());
  const long before = allocation_count();
  s.step(8);
  EXPECT_EQ(allocation_count(), before);
}

}  // namespace
}  // namespace taxel
