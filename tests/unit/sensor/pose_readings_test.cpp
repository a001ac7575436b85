// Readings at many poses: the bits of single contacts whatever the threads, rays from the samples as an oracle, tables
// of poses, and objects that are prepared once.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "core/base/error.h"
#include "core/base/random_pose.h"
#include "core/mesh/make/primitives.h"
#include "core/mesh/query/closest_point.h"
#include "core/sensor/contact_case/case_objects.h"
#include "core/sensor/contact_case/pose_readings.h"
#include "core/sensor/readout/reading.h"
#include "fixtures/strip.h"
#include "fixtures/touches.h"

namespace taxel {
namespace {

constexpr double kBallRadius = 0.0037;

const SensorModelPtr& strip() {
  static const SensorModelPtr model = test::strip_model();
  return model;
}

/// Returns 91 poses of a ball on the strip: 13 places along x, 7 depths up to 1.4 mm, each with its own rotation.
std::vector<Pose> ball_poses() {
  std::vector<Pose> poses;
  for (int place = 0; place < 13; ++place)
    for (int depth = 1; depth <= 7; ++depth) {
      Pose X = random_pose(7, static_cast<int>(poses.size()), 0);
      X.p = {0.001 * (place - 6), 0.0004, 0.006 + kBallRadius - 0.0002 * depth};
      poses.push_back(X);
    }
  return poses;
}

/// Returns the readings of one contact by the functions of a single case.
std::vector<double> read_single(const SensorModel& model, const HydroBody& object, const Pose& X_MO,
                                ContactResult& result) {
  ContactCase contact_case;
  contact_case.b.X_WB = X_MO;
  IntersectWorkspace workspace;
  evaluate_contact(contact_case, *model.body, object, result, workspace);
  const ContactSurface* const surfaces[] = {&result.surface};
  const SurfaceMotion motions[] = {{combine(model.body->material, object.material), {}}};
  SensorReading reading;
  read_sensor(model, surfaces, reading, RayPath::fastest, motions);
  return reading.values;
}

void expect_rows_of_single_contacts(const SensorModel& model, const HydroBody& object, const std::vector<Pose>& poses) {
  const PoseReadings all = read_poses(model, object, poses, {1});
  ASSERT_EQ(all.pose_count(), poses.size());
  ASSERT_EQ(all.taxels, model.taxel_count());
  std::size_t touching = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    ContactResult single;
    const std::vector<double> values = read_single(model, object, poses[i], single);
    for (std::size_t k = 0; k < values.size(); ++k) EXPECT_EQ(all.readings[i * values.size() + k], values[k]) << i;
    for (int c = 0; c < 3; ++c) {
      EXPECT_EQ(all.wrenches[6 * i + at(c)], single.wrench_W.force[c]) << i;
      EXPECT_EQ(all.wrenches[6 * i + 3 + at(c)], single.wrench_W.torque[c]) << i;
    }
    EXPECT_EQ(all.areas[i], single.surface.area()) << i;
    if (!single.surface.empty()) ++touching;
  }
  EXPECT_GE(touching, poses.size() / 2);
  for (const int threads : {0, 2, 5}) {
    const PoseReadings other = read_poses(model, object, poses, {threads});
    EXPECT_EQ(other.readings, all.readings) << threads;
    EXPECT_EQ(other.wrenches, all.wrenches) << threads;
    EXPECT_EQ(other.areas, all.areas) << threads;
  }
}

TEST(PoseReadings, HasTheBitsOfSingleContactsForAnyThreads) {
  std::vector<Pose> poses = ball_poses();
  poses.push_back({dquat(1, 0, 0, 0), dvec3(0, 0, 0.05)});  // without contact
  poses.push_back(poses.front());
  const HydroBodyPtr ball = make_body(test::ball_shape(kBallRadius), {}, "ball");
  expect_rows_of_single_contacts(*strip(), *ball, poses);
  for (const Aggregate how : {Aggregate::weighted_mean, Aggregate::force, Aggregate::max})
    expect_rows_of_single_contacts(
        *with_readout(*strip(),
                      {how, how == Aggregate::weighted_mean ? std::optional(ReadingMethod::exact) : std::nullopt}),
        *ball, {poses[0], poses[45], poses[91], poses[90]});
}

TEST(PoseReadings, HasTheBitsOfSingleContactsWithASoftObject) {
  Material soft;
  soft.modulus = 3e4;
  soft.field = FieldKind::medial_axis;
  soft.dissipation = 5;
  const HydroBodyPtr ball = make_body(test::ball_shape(kBallRadius), soft, "ball");
  std::vector<Pose> poses = ball_poses();
  poses.resize(20);
  expect_rows_of_single_contacts(*strip(), *ball, poses);
}

/// The faces of a mesh at a pose, for rays along -z.
class FacesFromAbove {
 public:
  FacesFromAbove(const TriMesh& mesh, const Pose& X_MO) {
    const RigidTransform X(X_MO);
    for (const ivec3& face : mesh.faces()) {
      std::array<dvec3, 3> corners;
      for (int i = 0; i < 3; ++i) corners[at(i)] = X(mesh.vertices()[at(face[i])]);
      faces_.push_back(corners);
    }
  }
  /// Returns the depth at which a ray from x leaves the mesh, or 0 without intersection: the largest root among the
  /// faces, by Cramer's rule.
  [[nodiscard]] double exit_depth(const dvec3& x) const {
    double depth = 0;
    for (const auto& [a, b, c] : faces_) {
      const dvec2 e(b - a), f(c - a), q(x - a);
      const double det = e.x * f.y - e.y * f.x;
      if (det == 0) continue;
      const double u = (q.x * f.y - q.y * f.x) / det, v = (e.x * q.y - e.y * q.x) / det;
      if (u < 0 || v < 0 || u + v > 1) continue;
      depth = std::max(depth, x.z - (a.z + u * (b.z - a.z) + v * (c.z - a.z)));
    }
    return depth;
  }

 private:
  std::vector<std::array<dvec3, 3>> faces_;
};

/// Returns weighted means of E d / H at the samples of each taxel, with d from the rays.
std::vector<double> read_by_rays(const SensorModel& model, const FacesFromAbove& object) {
  std::vector<double> pressures(model.samples.size(), -1), readings;
  for (std::size_t k = 0; k < 3; ++k) {
    double sum = 0, weights = 0;
    for (int e = model.fields.first[k]; e < model.fields.first[k + 1]; ++e) {
      const ReceptiveFields::Entry& entry = model.fields.entries[at(e)];
      double& pressure = pressures[at(entry.sample)];
      if (pressure < 0)
        pressure = test::kStripModulus / test::kStripPad * object.exit_depth(model.samples[at(entry.sample)].position);
      sum += entry.weight * pressure;
      weights += entry.weight;
    }
    readings.push_back(sum / weights);
  }
  return readings;
}

// For a rigid object, one ray from each sample onto the object gives the pressure E d / H: on a flat pad, d is the
// depth at which the ray leaves the object. No polygon is made.
TEST(PoseReadings, AgreesWithRaysFromTheSamplesOntoTheObject) {
  const SensorModel& model = *strip();
  const HydroBodyPtr ball = make_body(test::ball_shape(kBallRadius), {}, "ball");
  const TriMesh& mesh = std::get<RigidMesh>(ball->geometry).index->mesh();
  const std::vector<Pose> poses = ball_poses();
  const PoseReadings all = read_poses(model, *ball, poses);
  double largest = 0, worst = 0;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const std::vector<double> rays = read_by_rays(model, FacesFromAbove(mesh, poses[i]));
    for (std::size_t k = 0; k < 3; ++k) {
      const double value = all.readings[3 * i + k];
      largest = std::max(largest, value);
      worst = std::max(worst, std::abs(value - rays[k]));
    }
  }
  ASSERT_GT(largest, 1000);
  EXPECT_LT(worst, 1e-7 * largest);  // both have the facets of the ball
}

std::string message_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(PoseReadings, RefusesPosesThatAreNotValidAndRigidPairs) {
  const HydroBodyPtr ball = make_body(test::ball_shape(kBallRadius), {}, "ball");
  std::vector<Pose> poses(3);
  poses[2].p.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] { read_poses(*strip(), *ball, poses); }), "/poses/2: must be finite");
  poses[1].q = dquat(2, 0, 0, 0);
  EXPECT_EQ(message_of([&] { read_poses(*strip(), *ball, poses); }),
            "/poses/1: the quaternion w x y z must have length 1, has 2");
  EXPECT_EQ(read_poses(*strip(), *ball, {}).pose_count(), 0U);
  Layout rigid = strip()->layout;
  rigid.material.modulus = 0;
  const SensorModelPtr model = build_sensor_model(rigid, strip()->mesh, "", "strip");
  EXPECT_EQ(message_of([&] { read_poses(*model, *ball, {}); }),
            "/material/modulus: must be greater than 0: the layout and the object are both rigid");
}

TEST(PosesFromRows, NormalisesAsAContactCase) {
  const double rows[] = {0.1, 0.2, 0.3, 0.7071, 0.7071, 0, 0, 0, 0, 0, 0.6, 0, 0.8, 0};
  const std::vector<Pose> poses = poses_from_rows(rows);
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[0].q, unit_quaternion(0.7071, 0.7071, 0, 0));
  EXPECT_NEAR(glm::length(poses[0].q), 1, 1e-15);
  EXPECT_EQ(poses[1].q, dquat(0.6, 0, 0.8, 0));  // keeps its bits
  EXPECT_EQ(poses[0].p, dvec3(0.1, 0.2, 0.3));
}

TEST(PosesTable, ReadsColumnsInAnyOrderWithUnits) {
  std::vector<std::string> unread;
  const std::vector<Pose> poses = parse_poses_csv(
      "name;qw;qx;qy;qz;z_um;x [mm];y\nsecond;0;1;0;0;0;0;0\nfirst;1;0;0;0;1500;37;0,25\n", "poses.csv", &unread);
  ASSERT_EQ(poses.size(), 2U);
  EXPECT_EQ(poses[1].p, dvec3(0.037, 0.25, 0.0015));
  EXPECT_EQ(poses[0].q, dquat(0, 1, 0, 0));
  EXPECT_EQ(unread, std::vector<std::string>{"name"});
}

TEST(PosesTable, NamesTheFieldThatIsNotValid) {
  const auto error = [](const std::string& text) { return message_of([&] { parse_poses_csv(text, "poses.csv"); }); };
  const std::string heads = "x,y,z,qw,qx,qy,qz\n";
  EXPECT_EQ(error(heads + "0,0,0,1,0,0,0\n0,nan,0,1,0,0,0\n"),
            "poses.csv: line 3, column y: must be a finite number, is \"nan\"");
  EXPECT_EQ(error(heads + "0,0,low,1,0,0,0\n"), "poses.csv: line 2, column z: must be a finite number, is \"low\"");
  EXPECT_EQ(error(heads + "0,0,0,1,0,0\n"), "poses.csv: line 2, column qz: is missing");
  EXPECT_EQ(error(heads + "0,0,0,0.5,0,0,0\n"),
            "poses.csv: line 2, column qw: the quaternion w x y z must have length 1, has 0.5");
  EXPECT_EQ(error(heads), "poses.csv: holds no pose: the table has no row below its heads");
  EXPECT_EQ(error(""), "poses.csv: holds no pose: the table is empty");
  EXPECT_EQ(error("x,y,z\n0,0,0\n"),
            "poses.csv: line 1, column qw: is missing: a pose has the quaternion qw, qx, qy, qz, which is 1, 0, 0, 0 "
            "without rotation");
  EXPECT_EQ(error("x,y,qw,qx,qy,qz\n0,0,1,0,0,0\n"), "poses.csv: line 1, column z: is missing: a pose has x, y and z");
  EXPECT_EQ(error("x,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n"), "poses.csv: line 1, column x: is in the table twice");
  EXPECT_EQ(error("x [kPa],y,z,qw,qx,qy,qz\n0,0,0,1,0,0,0\n"),
            "poses.csv: line 1, column x: unit must be a length such as mm, is \"kPa\"");
  EXPECT_EQ(error(heads + "1e9,0,0,1,0,0,0\n"), "poses.csv: line 2, column x: must be at most 1e+06 m, is 1000000000");
}

TEST(PosesTable, IsReadFromItsOwnOutput) {
  const HydroBodyPtr ball = make_body(test::ball_shape(kBallRadius), {}, "ball");
  const std::vector<Pose> poses = ball_poses();
  const std::string text = pose_readings_to_csv(strip()->layout, poses, read_poses(*strip(), *ball, poses));
  EXPECT_EQ(text.substr(0, text.find('\n')),
            "x,y,z,qw,qx,qy,qz,force_x,force_y,force_z,torque_x,torque_y,torque_z,area,taxel_0,taxel_1,taxel_2");
  const std::vector<Pose> again = parse_poses_csv(text, "readings.csv");
  ASSERT_EQ(again.size(), poses.size());
  for (std::size_t i = 0; i < poses.size(); ++i) {
    EXPECT_EQ(again[i].p, poses[i].p);
    EXPECT_LT(glm::length(again[i].q - poses[i].q), 1e-15);
  }
}

double height_of(const MadeBody& made) {
  return std::get<RigidMesh>(made.body->geometry).index->mesh().bounds().hi.z;
}

MadeBodyPtr prepared(const std::string& text) {
  const ContactCase contact_case = parse_case_object(text);
  return share_case_body(contact_case, contact_case.b, "object");
}

TEST(CaseObject, IsPreparedOnceForEqualContent) {
  const std::string ball = R"({"shape": {"type": "sphere", "size": [0.004]}})";
  const MadeBodyPtr first = prepared(ball);
  EXPECT_EQ(prepared(R"({"shape": {"size": [0.004], "type": "sphere"}, "pos": [1, 2, 3]})"), first);
  EXPECT_NE(prepared(R"({"shape": {"type": "sphere", "size": [0.0041]}})"), first);
  EXPECT_NE(prepared(R"({"shape": {"type": "sphere", "size": [0.004]}, "resolution": 0.001})"), first);
  EXPECT_NE(prepared(R"({"shape": {"type": "sphere", "size": [0.004]}, "material": {"modulus": 1e5}})"), first);
  EXPECT_NE(prepared(R"({"shape": {"type": "sphere", "size": [0.004]}, "material": {"friction": 0.1}})"), first);
}

TEST(CaseObject, IsPreparedAgainForAnotherFileContent) {
  const std::filesystem::path file = std::filesystem::temp_directory_path() / "taxel_case_object_test.stl";
  const auto write = [&](double height) {
    std::ofstream(file) << "solid s\n";
    std::ofstream out(file, std::ios::app);
    const dvec3 v[4] = {{0, 0, 0}, {0.01, 0, 0}, {0, 0.01, 0}, {0, 0, height}};
    for (const ivec3& f : {ivec3(0, 2, 1), ivec3(0, 1, 3), ivec3(1, 2, 3), ivec3(2, 0, 3)}) {
      out << "facet normal 0 0 0\nouter loop\n";
      for (int i = 0; i < 3; ++i) out << "vertex " << v[f[i]].x << " " << v[f[i]].y << " " << v[f[i]].z << "\n";
      out << "endloop\nendfacet\n";
    }
    out << "endsolid s\n";
  };
  const std::string text = R"({"shape": {"type": "mesh", "file": ")" + file.string() + R"("}})";
  write(0.01);
  const MadeBodyPtr first = prepared(text);
  EXPECT_EQ(prepared(text), first);
  write(0.02);
  const MadeBodyPtr second = prepared(text);
  EXPECT_NE(second, first);
  EXPECT_EQ(height_of(*first), 0.01);
  EXPECT_EQ(height_of(*second), 0.02);
  std::filesystem::remove(file);
}

TEST(CaseObject, ReportsWrongKeysFromTheObjectOn) {
  EXPECT_EQ(message_of([] { prepared(R"({"material": {}})"); }).substr(0, 6), "/shape");
  EXPECT_EQ(message_of([] { prepared(R"({"shape": {"type": "sphere", "size": [0]}})"); }).substr(0, 13),
            "/shape/size/0");
}

TEST(CaseObject, IsTheShapeOfACase) {
  const auto name = [](const std::string& a, const std::string& b) {
    return object_of_case(
        parse_contact_case(R"({"format": "contact-case", "version": 1, "a": )" + a + R"(, "b": )" + b + "}", "c.json"));
  };
  const std::string ball = R"({"shape": {"type": "sphere", "size": [0.004]}})",
                    layout = R"({"layout": "x.taxels.json"})";
  EXPECT_EQ(name("{}", ball), "b");
  EXPECT_EQ(name(layout, ball), "b");
  EXPECT_EQ(name(ball, layout), "a");
  EXPECT_EQ(message_of([&] { name(ball, ball); }), "c.json: /a: must be the layout, without a shape: it is the sensor");
  EXPECT_EQ(message_of([&] { name("{}", layout); }), "c.json: /b: must be a shape: it is the touched object");
}

}  // namespace
}  // namespace taxel
