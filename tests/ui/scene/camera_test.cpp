// The camera: projection, orbit, pan, zoom and framing.
#include "ui/scene/camera.h"

#include <gtest/gtest.h>

#include "core/base/random_pose.h"
#include "core/base/rng.h"

namespace taxel::ui {
namespace {

constexpr int kWidth = 800, kHeight = 560;

Camera random_camera(int number, bool rolled = false) {
  const CounterRng rng(7, static_cast<std::uint64_t>(number));
  Camera camera;
  camera.target = {rng.uniform(0) - 0.5, rng.uniform(1) - 0.5, rng.uniform(2) - 0.5};
  camera.azimuth_deg = 360 * rng.uniform(3) - 180;
  camera.elevation_deg = 178 * rng.uniform(4) - 89;
  camera.distance = 0.01 + rng.uniform(5);
  camera.fov_deg = 20 + 60 * rng.uniform(6);
  if (rolled) camera.roll_deg = 360 * rng.uniform(7) - 180;
  camera.orthographic = number % 3 == 0;
  return camera;
}

TEST(Camera, InvertsProjectWithThePixelRay) {
  for (int i = 0; i < 200; ++i) {
    const Camera camera = random_camera(i, i % 2 != 0);
    const CounterRng rng(8, static_cast<std::uint64_t>(i));
    const dvec2 pixel(kWidth * rng.uniform(0), kHeight * rng.uniform(1));
    const Ray ray = camera.pixel_ray(pixel.x, pixel.y, kWidth, kHeight);
    EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-14);
    const double t = camera.distance * (0.1 + 3 * rng.uniform(2));
    const dvec3 back = camera.project(ray.origin + t * ray.direction, kWidth, kHeight);
    EXPECT_NEAR(back.x, pixel.x, 1e-8);
    EXPECT_NEAR(back.y, pixel.y, 1e-8);
    EXPECT_GT(back.z, 0);
  }
}

TEST(Camera, DrawsParallelLinesInParallelWithoutPerspective) {
  Camera camera = random_camera(1);
  const double perspective = camera.pixel_size(camera.distance, kHeight);
  camera.orthographic = true;
  EXPECT_NEAR(camera.pixel_size(camera.distance, kHeight), perspective, 1e-15) << "as large at the target";
  const glm::dmat4 view = camera.view();
  const dvec3 up(view[0][1], view[1][1], view[2][1]), back(view[0][2], view[1][2], view[2][2]);
  for (const double nearer : {-2.0, 0.0, 0.5, 5.0}) {
    const dvec3 from = camera.target + nearer * camera.distance * back;
    const dvec3 a = camera.project(from, kWidth, kHeight);
    const dvec3 b = camera.project(from + 0.1 * camera.distance * up, kWidth, kHeight);
    EXPECT_NEAR(a.x, 0.5 * kWidth, 1e-7) << nearer;
    EXPECT_NEAR(a.y, 0.5 * kHeight, 1e-7);
    EXPECT_NEAR(a.y - b.y, 0.1 * camera.distance / perspective, 1e-6) << "the same length at every depth";
    EXPECT_GT(a.z, camera.near_plane()) << "nothing is behind the eye";
  }
}

TEST(Camera, LooksFromAnyPose) {
  for (int i = 0; i < 200; ++i) {
    const CounterRng rng(11, static_cast<std::uint64_t>(i));
    Pose X_WC = random_pose(11, i, 1);
    if (i % 4 == 0) X_WC.q = glm::angleAxis(360 * rng.uniform(7), dvec3(0, 0, 1));  // looks straight down
    if (i % 4 == 1) X_WC.q = glm::angleAxis(kPi, dvec3(0, 1, 0)) * glm::angleAxis(rng.uniform(7), dvec3(0, 0, 1));
    const double depth = 0.01 + rng.uniform(8);
    Camera camera;
    camera.look_from(X_WC, depth);
    const glm::dmat4 pose = glm::inverse(camera.view());
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(glm::distance(dvec3(pose[axis]), X_WC.rotation()[axis]), 0, 1e-12) << i;
    EXPECT_NEAR(glm::distance(dvec3(pose[3]), X_WC.p), 0, 1e-12);
    EXPECT_NEAR(glm::distance(camera.target, X_WC * dvec3(0, 0, -depth)), 0, 1e-12);
  }
}

TEST(Camera, ProjectsLikeTheMatricesOfOpenGl) {
  for (int i = 0; i < 200; ++i) {
    const Camera camera = random_camera(i, i % 2 != 0);
    const CounterRng rng(9, static_cast<std::uint64_t>(i));
    const Ray ray = camera.pixel_ray(kWidth * rng.uniform(0), kHeight * rng.uniform(1), kWidth, kHeight);
    const double to_target = camera.orthographic ? glm::distance(camera.eye(), camera.target) : 0;
    const dvec3 p = ray.origin + (to_target + camera.distance * (0.5 + rng.uniform(2))) * ray.direction;
    const glm::dvec4 clip = camera.projection(static_cast<double>(kWidth) / kHeight) * camera.view() * glm::dvec4(p, 1);
    const dvec3 pixel = camera.project(p, kWidth, kHeight);
    EXPECT_NEAR(0.5 * kWidth * (1 + clip.x / clip.w), pixel.x, 1e-8);
    EXPECT_NEAR(0.5 * kHeight * (1 - clip.y / clip.w), pixel.y, 1e-8);
    const double depth = camera.orthographic ? pixel.z : clip.w;  // an orthographic projection has no depth in w
    EXPECT_NEAR(depth, pixel.z, 1e-9);
    EXPECT_GT(clip.z, -clip.w);  // not clipped by the near plane
    EXPECT_LT(clip.z, clip.w);
  }
}

TEST(Camera, ShowsTheTargetInTheMiddleAndZUp) {
  for (int i = 0; i < 50; ++i) {
    const Camera camera = random_camera(i);
    const dvec3 middle = camera.project(camera.target, kWidth, kHeight);
    EXPECT_NEAR(middle.x, 0.5 * kWidth, 1e-9);
    EXPECT_NEAR(middle.y, 0.5 * kHeight, 1e-9);
    EXPECT_NEAR(middle.z, glm::distance(camera.eye(), camera.target), 1e-11);
    const dvec3 above = camera.project(camera.target + 0.01 * camera.distance * dvec3(0, 0, 1), kWidth, kHeight);
    EXPECT_NEAR(above.x, middle.x, 1e-9);
    EXPECT_LT(above.y, middle.y);  // pixel rows run downward
  }
}

TEST(Camera, OrbitsByAnglesAloneAndStopsBeforeThePoles) {
  Camera camera = random_camera(1);
  const Camera before = camera;
  camera.orbit(120, -35);
  EXPECT_NE(camera.azimuth_deg, before.azimuth_deg);
  EXPECT_NE(camera.elevation_deg, before.elevation_deg);
  camera.azimuth_deg = before.azimuth_deg;
  camera.elevation_deg = before.elevation_deg;
  EXPECT_EQ(camera, before);
  camera.orbit(0, 1e6);
  EXPECT_LT(camera.elevation_deg, 90);
  EXPECT_TRUE(is_finite(camera.eye()));
  camera.orbit(1e6, -1e7);
  EXPECT_GT(camera.elevation_deg, -90);
  EXPECT_LE(std::abs(camera.azimuth_deg), 180);
}

TEST(Camera, ZoomsWithAFixedPixel) {
  for (int i = 0; i < 50; ++i) {
    Camera camera = random_camera(i, i % 2 != 0);
    const CounterRng rng(17, static_cast<std::uint64_t>(i));
    const double x = kWidth * rng.uniform(0), y = kHeight * rng.uniform(1);
    const dvec3 level = camera.point_under(x, y, kWidth, kHeight), seen = camera.project(level, kWidth, kHeight);
    EXPECT_NEAR(seen.x, x, 1e-7);
    EXPECT_NEAR(seen.y, y, 1e-7);
    EXPECT_NEAR(seen.z, glm::distance(camera.eye(), camera.target), 1e-9) << "at the depth of the target";
    const Ray ray = camera.pixel_ray(x, y, kWidth, kHeight);
    const dvec3 nearer = level - 0.3 * camera.distance * ray.direction;
    const double before = camera.distance;
    camera.zoom_at(3 * rng.uniform(2) - 1.5, nearer);
    EXPECT_NE(camera.distance, before);
    const dvec3 after = camera.project(nearer, kWidth, kHeight);
    EXPECT_NEAR(after.x, x, 1e-7);
    EXPECT_NEAR(after.y, y, 1e-7);
  }
}

TEST(Camera, OrbitsAlongTheImageWhateverItsRoll) {
  for (const double roll : {0.0, 90.0, 180.0, -37.0}) {
    Camera camera;
    camera.elevation_deg = roll == 0 ? 0 : 30;
    camera.roll_deg = roll;
    const dvec3 front = camera.target + 0.1 * (camera.eye() - camera.target);
    const dvec3 before = camera.project(front, kWidth, kHeight);
    camera.orbit(10, 0);
    const dvec3 after = camera.project(front, kWidth, kHeight);
    EXPECT_GT(after.x, before.x + 1) << roll;
    EXPECT_NEAR(after.y, before.y, 0.05 * (after.x - before.x)) << roll;
    camera.orbit(0, 10);
    EXPECT_GT(camera.project(front, kWidth, kHeight).y, after.y + 1) << roll;
    EXPECT_LT(glm::distance(camera.target, Camera{}.target), 1e-12);
  }
}

TEST(Camera, PansThePointUnderThePointer) {
  for (int i = 0; i < 50; ++i) {
    Camera camera = random_camera(i);
    const dvec3 point = camera.target;  // a point at the target's depth, which follows exactly
    camera.pan(37, -21, kHeight);
    const dvec3 pixel = camera.project(point, kWidth, kHeight);
    EXPECT_NEAR(pixel.x, 0.5 * kWidth + 37, 1e-8);
    EXPECT_NEAR(pixel.y, 0.5 * kHeight - 21, 1e-8);
  }
}

TEST(Camera, KeepsTheHeightInAHorizontalPan) {
  Camera camera = random_camera(3);
  const double z = camera.target.z;
  camera.pan(10, 40, kHeight, true);
  EXPECT_NEAR(camera.target.z, z, 1e-15);
}

TEST(Camera, ZoomsByAFactorThatTheOppositeZoomUndoes) {
  Camera camera = random_camera(4);
  const Camera before = camera;
  camera.zoom(3);
  EXPECT_LT(camera.distance, before.distance);
  camera.zoom(-3);
  EXPECT_NEAR(camera.distance, before.distance, 1e-12);
  camera.zoom(1e4);
  EXPECT_GT(camera.distance, 0);
}

TEST(Camera, FramesTheWholeBox) {
  for (int i = 0; i < 50; ++i) {
    Camera camera = random_camera(i);
    const Aabb box{{-0.01, -0.02, 0.003}, {0.02, 0.05, 0.04}};
    camera.frame(box);
    for (int k = 0; k < 8; ++k) {
      const dvec3 corner((k & 1) != 0 ? box.hi.x : box.lo.x, (k & 2) != 0 ? box.hi.y : box.lo.y,
                         (k & 4) != 0 ? box.hi.z : box.lo.z);
      const dvec3 pixel = camera.project(corner, kWidth, kHeight);
      EXPECT_GT(pixel.z, 0);
      EXPECT_TRUE(pixel.x > 0 && pixel.x < kWidth && pixel.y > 0 && pixel.y < kHeight);
    }
  }
  Camera camera;
  const Camera before = camera;
  camera.frame(Aabb{});
  EXPECT_EQ(camera, before);
}

}  // namespace
}  // namespace taxel::ui
