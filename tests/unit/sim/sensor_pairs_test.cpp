// Two sensors against each other: both sense one surface, and one wrench moves both.
#include <gtest/gtest.h>

#include <map>

#include "core/base/rng.h"
#include "core/hydro/intersect.h"
#include "fixtures/sensor_scene.h"

namespace taxel {
namespace {

using test::key;
using test::SensorScene;

constexpr double kRadius = 0.05, kSoft = 1e5, kStiff = 4e5, kPress = 0.004;

struct Declared {
  std::string name, keys;
};

std::string instance(const Declared& sensor) {
  const std::string geom = sensor.name.substr(0, sensor.name.find('#'));
  return "<instance name='" + sensor.name + "'>" + key("layout", geom + ".taxels.json") + key("geom", geom) +
         key("output", "readings wrench area") + sensor.keys + "</instance>";
}

/// Material of the balls.
struct Balls {
  double edge = 0.006;  ///< edge of their triangles [m]
  Material upper{FieldKind::star, kSoft, 0, 2.0, 0.8}, lower{FieldKind::star, kStiff, 0, 0.5, 0.4};
};

/// Two balls of one mesh. The taxel of each is where it touches the other one; "lower" is upside down. Gravity is off.
class TwoBalls {
 public:
  /// Declares sensors and bodies in these orders.
  explicit TwoBalls(const std::vector<Declared>& sensors, std::vector<std::string> bodies = {"upper", "lower"},
                    const Balls& made = {}) {
    const TriMesh ball = scaled_to_volume(make_sphere(kRadius, made.edge), 4.0 / 3 * kPi * std::pow(kRadius, 3));
    add_sensor("upper", ball, made.upper);
    add_sensor("lower", ball, made.lower);
    std::string extension, declared, world;
    for (const Declared& sensor : sensors) {
      extension += instance(sensor);
      declared += "<plugin plugin='taxel.sensor' instance='" + sensor.name + "'/>";
    }
    for (const std::string& body : bodies) {
      const bool up = body == "upper";
      world += "<body name='" + body + "' pos='" + (up ? "0.003 0.001 0.096" : "0 0 0") + "' quat='" +
               (up ? "1 0 0 0" : "0 1 0 0") + "'><freejoint/>" +
               "<inertial mass='2' pos='0 0 0' diaginertia='2e-3 2e-3 2e-3'/><geom name='" + body +
               "' type='mesh' mesh='" + body + "' contype='0' conaffinity='0'/></body>";
    }
    s.compile("<mujoco><option timestep='0.001' gravity='0 0 0'/><extension><plugin plugin='taxel.sensor'>" +
              extension +
              "</plugin></extension><asset><mesh name='upper' file='upper.obj'/><mesh name='lower' file='lower.obj'/>"
              "</asset><worldbody>" +
              world + "</worldbody><sensor>" + declared + "</sensor></mujoco>");
  }
  [[nodiscard]] HydroInstance& sensor(const std::string& name) const {
    for (int i = 0; i < s.model->nplugin; ++i)
      if (s.sensor(i).config().name == name) return s.sensor(i);
    throw Error("no sensor " + name);
  }
  /// Returns the index of a free body in qvel and the forces.
  [[nodiscard]] int velocity_of(const std::string& body) const {
    return s.model->body_dofadr[mj_name2id(s.model.get(), mjOBJ_BODY, body.c_str())];
  }
  [[nodiscard]] mjtNum* position_of(const std::string& body) const {
    const int joint = s.model->body_jntadr[mj_name2id(s.model.get(), mjOBJ_BODY, body.c_str())];
    return s.data->qpos + s.model->jnt_qposadr[joint];
  }
  void place_on_axis() {
    for (int i = 0; i < 3; ++i) position_of("upper")[i] = i < 2 ? 0 : 2 * kRadius - kPress;
  }
  /// Rotates a body about its own origin, by less than a taxel's radius.
  void turn(const std::string& body, const CounterRng& rng, std::uint64_t n) {
    dquat q = body == "upper" ? dquat(1, 0, 0, 0) : dquat(0, 1, 0, 0);
    for (std::uint64_t i = 0; i < 3; ++i) {
      dvec3 axis(0);
      axis[static_cast<int>(i)] = 1;
      q = glm::angleAxis(0.3 * rng.uniform(6 * n + 2 * i + (body == "upper")) - 0.15, axis) * q;
    }
    const mjtNum values[4] = {q.w, q.x, q.y, q.z};
    std::copy_n(values, 4, position_of(body) + 3);
  }
  void forward() { mj_forward(s.model.get(), s.data.get()); }
  void set_moving() {
    mjtNum *upper = s.data->qvel + velocity_of("upper"), *lower = s.data->qvel + velocity_of("lower");
    const mjtNum of_upper[6] = {0.05, -0.02, -0.02, 1, 3, -2}, of_lower[6] = {-0.02, 0.03, 0.01, -1, 0.5, 1};
    std::copy_n(of_upper, 6, upper);
    std::copy_n(of_lower, 6, lower);
  }
  /// Returns the wrench of the pair on this sensor, in the world about the origin.
  [[nodiscard]] Wrench felt(const std::string& name) const {
    const Evaluation& e = sensor(name).sensed();
    Wrench sum;
    for (const PairState& pair : e.pairs) {
      const dvec3 force = e.X_WM.rotate(pair.wrench.force);
      sum.force += force;
      sum.torque += e.X_WM.rotate(pair.wrench.torque) + glm::cross(e.X_WM.p, force);
    }
    return sum;
  }
  /// Returns the force that moves a body.
  [[nodiscard]] dvec3 moving(const std::string& body) const {
    const mjtNum* f = s.data->qfrc_passive + velocity_of(body);
    return {f[0], f[1], f[2]};
  }

  SensorScene s;

 private:
  void add_sensor(const std::string& name, const TriMesh& mesh, const Material& material) {
    s.add_sensor(name, mesh, material);
    const std::filesystem::path file = s.folder / (name + ".taxels.json");
    Layout layout = read_layout(file);
    layout.sampling.density = 3e4;
    write_layout(file, layout);
  }
};

const std::vector<Declared> kBoth{{"upper", key("others", "lower")}, {"lower", key("others", "upper")}};

double largest_hit(const HydroInstance& sensor) {
  double largest = 0;
  for (const RayHit& hit : sensor.reading().hits.all()) largest = std::max(largest, hit.pressure);
  return largest;
}

void expect_opposite(const Wrench& a, const Wrench& b, double tolerance) {
  EXPECT_GT(glm::length(a.force), 0.1);
  EXPECT_LE(glm::length(a.force + b.force), tolerance * glm::length(a.force));
  EXPECT_LE(glm::length(a.torque + b.torque), tolerance * kRadius * glm::length(a.force));
}

TEST(SensorPairs, EqualTheClosedFormOfTwoSoftSpheres) {
  // The surface is curved, so friction would act on bodies that begin to separate.
  TwoBalls balls(kBoth, {"upper", "lower"},
                 {0.003, {FieldKind::star, kSoft, 0, 0, 0}, {FieldKind::star, kStiff, 0, 0, 0}});
  ASSERT_NE(balls.s.model, nullptr) << balls.s.error;
  // A7: E 1e5 and 4e5 Pa, R 50 mm for both, x 4 mm. The balls are rotated slightly each time, so that no single place
  // of the meshes decides.
  const double F = 1.9568, area = 620.317e-6, p0 = 6400;
  const CounterRng rng(5);
  constexpr int kPoses = 20;
  double mean_force = 0;
  for (std::uint64_t n = 0; n < kPoses; ++n) {
    balls.place_on_axis();
    for (const char* name : {"upper", "lower"}) balls.turn(name, rng, n);
    balls.forward();
    mean_force += balls.felt("upper").force.z / kPoses;
    expect_opposite(balls.felt("upper"), balls.felt("lower"), 1e-12);
    EXPECT_LE(glm::distance(balls.moving("upper"), balls.felt("upper").force), 1e-12 * F);  // once to each
    EXPECT_LE(glm::distance(balls.moving("lower"), balls.felt("lower").force), 1e-12 * F);
    for (const char* name : {"upper", "lower"}) {
      const HydroInstance& sensor = balls.sensor(name);
      EXPECT_NEAR(sensor.sensed().pairs.at(0).surface.area(), area, 0.03 * area) << name;
      EXPECT_NEAR(largest_hit(sensor), p0, 0.1 * p0) << name;  // rays are 6 mm apart
      EXPECT_GT(sensor.reading().values.at(0), 0) << name;
    }
  }
  EXPECT_NEAR(mean_force, F, 0.001 * F);
}

TEST(SensorPairs, ReadOneSurface) {
  TwoBalls balls(kBoth);
  ASSERT_NE(balls.s.model, nullptr) << balls.s.error;
  balls.s.step(5);
  const Evaluation &upper = balls.sensor("upper").sensed(), &lower = balls.sensor("lower").sensed();
  const ContactSurface &a = upper.pairs.at(0).surface, &b = lower.pairs.at(0).surface;
  ASSERT_EQ(a.polygons.size(), b.polygons.size());
  ASSERT_GT(a.polygons.size(), 20u);
  for (std::size_t i = 0; i < a.polygons.size(); ++i) {
    const ContactPolygon &p = a.polygons[i], &q = b.polygons[i];
    EXPECT_EQ(p.area, q.area);
    EXPECT_EQ(p.pressure, q.pressure);
    EXPECT_EQ(p.tet, q.tet_b);
    EXPECT_EQ(p.tet_b, q.tet);
    EXPECT_LE(glm::distance(upper.X_WM * p.centroid, lower.X_WM * q.centroid), 1e-14);
    EXPECT_LE(glm::length(upper.X_WM.rotate(p.normal) + lower.X_WM.rotate(q.normal)), 1e-14);
    const dvec3 &v = b.vertices[static_cast<std::size_t>(q.first)],
                &w = b.vertices[static_cast<std::size_t>(q.first) + 1],
                &x = b.vertices[static_cast<std::size_t>(q.first) + 2];
    EXPECT_GE(glm::dot(glm::cross(w - v, x - v), q.normal), -1e-12 * q.area) << "counter-clockwise";
  }
  // The surface that the lower sensor computes itself assigns its own tets to the same polygons.
  ContactSurface own;
  IntersectWorkspace workspace;
  intersect(*balls.sensor("lower").model()->body, *balls.sensor("upper").model()->body, lower.X_WM, upper.X_WM, own,
            workspace);
  const auto key_of = [](const ContactPolygon& p) { return std::pair(p.tet, p.tet_b); };
  std::map<std::pair<int, int>, double> mirrored, computed;
  for (const ContactPolygon& p : b.polygons) mirrored[key_of(p)] += p.area * p.pressure;
  for (const ContactPolygon& p : own.polygons) computed[key_of(p)] += p.area * p.pressure;
  for (const auto& [tets, push] : computed) EXPECT_NEAR(mirrored[tets], push, 1e-9);
}

TEST(SensorPairs, HaveOppositeForcesWhileTheyMove) {
  for (const char* integrator : {"Euler", "RK4", "implicitfast"}) {
    TwoBalls balls(kBoth);
    ASSERT_NE(balls.s.model, nullptr) << balls.s.error;
    balls.s.model->opt.integrator = std::string(integrator) == "RK4"     ? mjINT_RK4
                                    : std::string(integrator) == "Euler" ? mjINT_EULER
                                                                         : mjINT_IMPLICITFAST;
    balls.set_moving();
    for (int n = 0; n < 20; ++n) {
      balls.s.step();
      expect_opposite(balls.felt("upper"), balls.felt("lower"), 1e-12);
      EXPECT_LE(glm::length(balls.moving("upper") + balls.moving("lower")), 1e-12 * glm::length(balls.moving("upper")));
    }
    EXPECT_GT(std::abs(balls.felt("upper").force.x), 0.1);  // friction acts
  }
}

/// Returns wrenches and readings of both sensors, by name, at first and after some steps.
std::vector<double> outcome(const std::vector<Declared>& sensors, const std::vector<std::string>& bodies) {
  TwoBalls balls(sensors, bodies);
  if (balls.s.model == nullptr) throw Error(balls.s.error);
  balls.set_moving();
  std::vector<double> values;
  for (const int steps : {1, 9}) {
    balls.s.step(steps);
    for (const char* name : {"upper", "lower"}) {
      const Wrench w = balls.felt(name);
      for (int i = 0; i < 3; ++i) values.insert(values.end(), {w.force[i], w.torque[i] / kRadius});
      values.push_back(balls.sensor(name).reading().values.at(0) * 1e-3);
      values.push_back(balls.sensor(name).sensed().pairs.at(0).surface.area() * 1e3);
    }
  }
  return values;
}

TEST(SensorPairs, DoNotDependOnTheOrderOfDeclaration) {
  const std::vector<Declared> swapped{kBoth[1], kBoth[0]};
  const std::vector<double> first = outcome(kBoth, {"upper", "lower"});
  const std::vector<double> sensors = outcome(swapped, {"upper", "lower"});
  const std::vector<double> bodies = outcome(kBoth, {"lower", "upper"});
  EXPECT_GT(std::abs(first[4]), 0.5);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_NEAR(sensors[i], first[i], 1e-10) << i;
    EXPECT_NEAR(bodies[i], first[i], 1e-10) << i;
  }
}

TEST(SensorPairs, NeedOnlyOneSensorThatNamesTheOther) {
  const std::vector<double> both = outcome(kBoth, {"upper", "lower"});
  const std::vector<double> upper = outcome({kBoth[0], {"lower", ""}}, {"upper", "lower"});
  const std::vector<double> lower = outcome({{"upper", ""}, kBoth[1]}, {"upper", "lower"});
  EXPECT_EQ(upper, both);
  EXPECT_EQ(lower, both);
}

TEST(SensorPairs, MoveBothBodiesIfOneSensorAppliesForces) {
  const std::string sense = key("force", "sense");
  const std::vector<double> both = outcome(kBoth, {"upper", "lower"});
  const std::vector<double> by_lower = outcome({{"upper", kBoth[0].keys + sense}, kBoth[1]}, {"upper", "lower"});
  const std::vector<double> by_upper = outcome({kBoth[0], {"lower", kBoth[1].keys + sense}}, {"upper", "lower"});
  EXPECT_EQ(by_lower, both);  // the lower one computes the pair in both cases
  // Within the tolerance of the solver.
  for (std::size_t i = 0; i < both.size(); ++i) EXPECT_NEAR(by_upper[i], both[i], 1e-7);

  TwoBalls balls({{"upper", kBoth[0].keys + sense}, {"lower", kBoth[1].keys + sense}});
  ASSERT_NE(balls.s.model, nullptr) << balls.s.error;
  balls.s.step(3);
  expect_opposite(balls.felt("upper"), balls.felt("lower"), 1e-12);
  for (const char* name : {"upper", "lower"}) {
    EXPECT_EQ(balls.moving(name), dvec3(0));
    EXPECT_GT(balls.sensor(name).reading().values.at(0), 0);
  }
}

TEST(SensorPairs, ReadIfPassiveForcesAreOff) {
  for (const bool first_lower : {false, true}) {
    TwoBalls balls(first_lower ? std::vector<Declared>{kBoth[1], kBoth[0]} : kBoth);
    ASSERT_NE(balls.s.model, nullptr) << balls.s.error;
    balls.s.model->opt.disableflags |= mjDSBL_SPRING | mjDSBL_DAMPER;
    for (const double depth : {0.003, 0.0045}) {
      balls.position_of("upper")[2] = 2 * kRadius - depth;
      balls.forward();
      expect_opposite(balls.felt("upper"), balls.felt("lower"), 1e-12);
      const double p0 = depth * kSoft / kRadius * kStiff / (kSoft + kStiff);
      for (const char* name : {"upper", "lower"}) EXPECT_NEAR(largest_hit(balls.sensor(name)), p0, 0.1 * p0);
    }
  }
}

TEST(SensorPairs, PushOnceIfTwoSensorsAreOnOneGeom) {
  TwoBalls once(kBoth), twice({kBoth[0], kBoth[1], {"upper#2", key("others", "lower")}});
  ASSERT_NE(twice.s.model, nullptr) << twice.s.error;
  once.s.step(3);
  twice.s.step(3);
  EXPECT_LE(glm::distance(twice.moving("lower"), once.moving("lower")), 1e-12);
  EXPECT_LE(glm::distance(twice.moving("upper"), once.moving("upper")), 1e-12);
  EXPECT_NEAR(twice.sensor("upper#2").reading().values.at(0), once.sensor("upper").reading().values.at(0), 1e-6);
  EXPECT_NEAR(twice.felt("upper#2").force.z, once.felt("upper").force.z, 0.02);  // without the implicit step
}

TEST(SensorPairs, WorkForARigidSensorAgainstASoftOne) {
  TwoBalls balls(kBoth, {"upper", "lower"}, {0.003, {FieldKind::star, kSoft, 0, 0, 0}, {FieldKind::star, 0, 0, 0, 0}});
  ASSERT_NE(balls.s.model, nullptr) << balls.s.error;
  balls.place_on_axis();
  balls.forward();
  // A1 approximately, because the plane is a sphere.
  const double F = kPi * kSoft * kPress * kPress * (1 - 2 * kPress / (3 * kRadius));
  EXPECT_NEAR(balls.felt("upper").force.z, 0.5 * F, 0.05 * F);
  expect_opposite(balls.felt("upper"), balls.felt("lower"), 1e-12);
  for (const char* name : {"upper", "lower"})
    EXPECT_NEAR(largest_hit(balls.sensor(name)), kSoft * kPress / kRadius, 0.1 * kSoft * kPress / kRadius) << name;

  TwoBalls rigid(kBoth, {"upper", "lower"}, {0.006, {}, {}});
  EXPECT_EQ(rigid.s.model, nullptr);
  EXPECT_NE(rigid.s.error.find("both rigid"), std::string::npos) << rigid.s.error;
}

TEST(SensorPairs, UseTheMaterialsOfTheLayouts) {
  TwoBalls balls({{"upper", kBoth[0].keys + key("materials", R"({"lower": {"modulus": 1}})")}, kBoth[1]});
  ASSERT_NE(balls.s.model, nullptr) << balls.s.error;
  ASSERT_EQ(balls.sensor("upper").warnings().size(), 1u);
  EXPECT_NE(balls.sensor("upper").warnings()[0].find("\"lower\""), std::string::npos);
  balls.place_on_axis();
  balls.forward();
  EXPECT_NEAR(balls.felt("lower").force.z, -1.9568, 0.1);  // less friction; a modulus of 1 Pa would give nothing
  const PairProperties& pair = balls.sensor("upper").touched().at(0).properties;
  EXPECT_DOUBLE_EQ(pair.dissipation, (kStiff * 2.0 + kSoft * 0.5) / (kSoft + kStiff));
  EXPECT_DOUBLE_EQ(pair.friction, 2 * 0.8 * 0.4 / 1.2);
}

TEST(SensorPairs, ContinueInCopiesWithTheirOwnSensors) {
  TwoBalls balls(kBoth);
  ASSERT_NE(balls.s.model, nullptr) << balls.s.error;
  balls.set_moving();
  balls.s.step(5);
  const mjModel& m = *balls.s.model;
  DataHandle copy(mj_copyData(nullptr, &m, balls.s.data.get()));
  DataHandle bitwise(mj_copyData(nullptr, &m, balls.s.data.get()));
  const std::vector<std::uintptr_t> entries(bitwise->plugin_data, bitwise->plugin_data + m.nplugin);
  for (int i = 0; i < m.nplugin; ++i) bitwise->plugin_data[i] = balls.s.data->plugin_data[i];
  const auto run = [&](mjData& d) {
    std::vector<double> out;
    for (int n = 0; n < 5; ++n) {
      mj_step(&m, &d);
      out.insert(out.end(), d.sensordata, d.sensordata + m.nsensordata);
    }
    return out;
  };
  const std::vector<double> expected = run(*balls.s.data);
  balls.s.data.reset();
  EXPECT_EQ(run(*copy), expected);
  EXPECT_EQ(run(*bitwise), expected);
  for (int i = 0; i < m.nplugin; ++i) {  // frees the sensors that pickling loses
    const std::uintptr_t made = bitwise->plugin_data[i];
    bitwise->plugin_data[i] = entries[static_cast<std::size_t>(i)];
    mjp_getPlugin(kPluginName, nullptr)->destroy(bitwise.get(), i);
    bitwise->plugin_data[i] = made;
  }
}

}  // namespace
}  // namespace taxel
