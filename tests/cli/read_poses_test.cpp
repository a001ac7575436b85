// taxel read --poses: a table of poses becomes a table of readings, with the bits of single contacts.
#include <fmt/format.h>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

constexpr const char* kBall =
    R"("b": {"shape": {"type": "sphere", "size": [0.004]}, "pos": [0, %, 0.012], "quat": [0.6, 0, 0.8, 0]}})";

/// Writes a case with the ball at this y and returns its name.
std::string ball_case(const fs::path& folder, const std::string& y) {
  std::string text = std::string(R"({"format": "contact-case", "version": 1, "a": {}, )") + kBall;
  text.replace(text.find('%'), 1, y);
  write_text(folder / "ball.json", text);
  return "ball.json";
}

TEST(ReadPoses, GivesTheBitsOfReadForEachPose) {
  const fs::path folder = finger_on_box();
  const std::vector<std::string> places{"-0.0104", "-0.0106", "-0.02"};  // two presses, and one pose without contact
  std::string poses = "x [mm],y [m],z,qw,qx,qy,qz\n";
  for (const std::string& y : places) poses += "0," + y + ",0.012,0.6,0,0.8,0\n";
  write_text(folder / "poses.csv", poses);
  const Json report = taxel_json(
      {"read", "fingertip.taxels.json", ball_case(folder, "0"), "--poses", "poses.csv", "--out", "out.csv"}, folder);
  EXPECT_EQ(report["poses"], 3);
  EXPECT_EQ(report["touching"], 2);
  EXPECT_EQ(report["taxels"], 12);
  EXPECT_EQ(report["unit"], "Pa");
  const Table table = read_csv(folder / "out.csv");
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Json single = taxel_json({"read", "fingertip.taxels.json", ball_case(folder, places[i])}, folder);
    for (std::size_t k = 0; k < 12; ++k)
      EXPECT_EQ(table.at(fmt::format("taxel_{}", k)).at(i), single["reading"][k]) << i;
    EXPECT_EQ(table.at("force_x").at(i), single["force"][0]) << i;
    EXPECT_EQ(table.at("force_y").at(i), single["force"][1]) << i;
    EXPECT_EQ(table.at("torque_z").at(i), single["torque"][2]) << i;
    EXPECT_EQ(table.at("area").at(i), single["area"]) << i;
  }
  EXPECT_GT(table.at("area").at(0), 0);
  const std::string two_threads = file_text(folder / "out.csv");
  taxel_json(
      {"read", "fingertip.taxels.json", "ball.json", "--poses", "poses.csv", "--out", "one.csv", "--threads", "1"},
      folder);
  EXPECT_EQ(file_text(folder / "one.csv"), two_threads);
}

TEST(ReadPoses, RefusesWrongTablesAndMovingBodies) {
  const fs::path folder = finger_on_box();
  const auto refused = [&](const std::string& text, const std::string& line) {
    write_text(folder / "poses.csv", text);
    expect_refusal(taxel({"read", "fingertip.taxels.json", ball_case(folder, "0"), "--poses", "poses.csv", "--out",
                          "out.csv", "--quiet"},
                         folder),
                   line);
    EXPECT_FALSE(fs::exists(folder / "out.csv"));
  };
  refused("x,y,z,qw,qx,qy,qz\n0,0,0,1,0,0,inf\n",
          "taxel: poses.csv: line 2, column qz: must be a finite number, is \"inf\"");
  refused("x,y,z,qw,qx,qy,qz\n0,0,0,1,1,0,0\n",
          "taxel: poses.csv: line 2, column qw: the quaternion w x y z must have length 1, has 1.41421");
  refused("x,y,z,qw,qx,qy,qz\n", "taxel: poses.csv: holds no pose: the table has no row below its heads");
  write_text(folder / "moving.json", R"({"format": "contact-case", "version": 1, "a": {},
    "b": {"shape": {"type": "sphere", "size": [0.004]}, "linear_velocity": [0, 0, 1]}})");
  expect_refusal(
      taxel({"read", "fingertip.taxels.json", "moving.json", "--poses", "poses.csv", "--out", "out.csv"}, folder),
      "taxel: moving.json: /b/linear_velocity: must be 0 with --poses, whose contacts are at rest: leave it out");
  const Outcome alone = taxel({"read", "fingertip.taxels.json", "ball.json", "--poses", "poses.csv"}, folder);
  EXPECT_EQ(alone.status, 2);
  EXPECT_NE(alone.err.find("--out"), std::string::npos) << alone.err;
}

}  // namespace
}  // namespace taxel::test
