// Inputs that once took quadratic or cubic time. The limit is far above the time that they take today, and far below
// the time that they took.
#include <sys/resource.h>

#include <cmath>
#include <sstream>

#include "cli/taxel_program.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

// Processor time of all threads. The sanitizers take up to ten times as long.
#ifdef __SANITIZE_ADDRESS__
constexpr double kMaxSeconds = 40;
#else
constexpr double kMaxSeconds = 4;
#endif

double seconds_of_children() {
  rusage usage{};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

Outcome expect_quick(const std::vector<std::string>& arguments, const fs::path& folder) {
  const double before = seconds_of_children();
  Outcome outcome = taxel(arguments, folder);
  EXPECT_LT(seconds_of_children() - before, kMaxSeconds) << arguments.back();
  return outcome;
}

/// Returns the OBJ text of tetrahedra, or of single triangles, on a lattice.
std::string obj_of_shells(int count, bool closed) {
  std::ostringstream obj;
  for (int i = 0; i < count; ++i) {
    const int x = 3 * (i % 22), y = 3 * (i / 22 % 22), z = 3 * (i / 484);
    for (int c = 0; c < (closed ? 4 : 3); ++c)
      obj << "v " << x + (c == 1) << ' ' << y + (c == 2) << ' ' << z + (c == 3) << '\n';
    const int first = (closed ? 4 : 3) * i + 1;
    if (!closed) obj << "f " << first << ' ' << first + 1 << ' ' << first + 2 << '\n';
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    for (const auto& f : faces)
      if (closed) obj << "f " << first + f[0] << ' ' << first + f[1] << ' ' << first + f[2] << '\n';
  }
  return obj.str();
}

TEST(QuickInput, IsReadInTimeForMeshesOfManyShells) {
  const fs::path folder = test_folder();
  write_text(folder / "shells.obj", obj_of_shells(10000, true));
  write_text(folder / "sheets.obj", obj_of_shells(2000, false));
  const Outcome shells = expect_quick({"mesh", "shells.obj"}, folder);
  EXPECT_EQ(shells.status, 0) << shells.err;
  EXPECT_NE(shells.out.find("10000"), std::string::npos) << shells.out;
  EXPECT_EQ(expect_quick({"mesh", "sheets.obj"}, folder).status, 0);
}

TEST(QuickInput, IsReadInTimeForPolygonsOfManyCorners) {
  const fs::path folder = test_folder();
  constexpr int kCorners = 64000;
  std::ostringstream obj;
  for (int i = 0; i < kCorners; ++i)
    obj << "v " << std::cos(2 * M_PI * i / kCorners) << ' ' << std::sin(2 * M_PI * i / kCorners) << " 0\n";
  obj << 'f';
  for (int i = 1; i <= kCorners; ++i) obj << ' ' << i;
  write_text(folder / "disc.obj", obj.str());
  EXPECT_EQ(expect_quick({"mesh", "disc.obj"}, folder).status, 0);
}

TEST(QuickInput, IsCheckedInTimeForManyTaxelsInOnePlace) {
  const fs::path folder = test_folder();
  Json taxels = Json::array();
  Json taxel = Json::parse(file_text(fingertip_layout()))["taxels"][0];
  for (int i = 0; i < 8000; ++i) {
    taxel["id"] = i;
    taxels.push_back(taxel);
  }
  const fs::path layout =
      changed_layout(folder, Json::array({{{"op", "replace"}, {"path", "/taxels"}, {"value", taxels}}}));
  const Outcome outcome = expect_quick({"check", layout.string()}, folder);
  EXPECT_NE((outcome.out + outcome.err).find("/taxels/7999/center: warning: is the same place as /taxels/0"),
            std::string::npos);
}

TEST(QuickInput, IsRefusedInTimeForObjectsOfManyKeys) {
  const fs::path folder = test_folder();
  Json layout = Json::parse(file_text(fingertip_layout()));
  for (int i = 0; i < 100000; ++i) layout["key" + std::to_string(i)] = i;
  write_text(folder / "keys.taxels.json", layout.dump());
  expect_refusal(expect_quick({"samples", "keys.taxels.json"}, folder),
                 "taxel: keys.taxels.json: has an object of more than 10000 keys");
}

}  // namespace
}  // namespace taxel::test
