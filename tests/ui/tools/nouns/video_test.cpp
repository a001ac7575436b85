// A video of recorded steps: which steps it takes, the names of its images, and the folder that remains.
#include "app/studio/nouns/video/video_maker.h"

#include <gtest/gtest.h>

#include "app/studio/nouns/video/video_commands.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "fixtures/temp_folder.h"

namespace taxel::studio {
namespace {

/// Returns the plan of images of every 20th step, of a view of 640 x 480 pixels.
VideoPlan every_20th_step(const test::TempFolder& folder, const StepRange& steps) {
  ui::VideoState settings;
  settings.every = 20;
  settings.source.width = 640, settings.source.height = 480;
  return plan_video((folder / "frames").string(), steps, settings);
}

/// Returns the message of the refusal of a plan, or an empty text.
std::string refusal(const VideoPlan& plan, double free_bytes = 1e12) {
  try {
    check_plan(plan, free_bytes);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

const gl::RgbImage kOnePixel{1, 1, {10, 20, 30}};

TEST(VideoMaker, TakesEveryNthStepOfTheRange) {
  const test::TempFolder folder;
  InlineExecutor executor;
  VideoMaker video(every_20th_step(folder, {10, 59}), 33, executor);
  for (const std::uint64_t step : {10U, 30U, 50U}) {
    EXPECT_EQ(video.wanted(), step);
    video.add(kOnePixel);
  }
  EXPECT_FALSE(video.wanted());
  EXPECT_EQ(video.shown_before(), 33U);
}

TEST(VideoMaker, TakesTheLastStepIfItIsDue) {
  const test::TempFolder folder;
  InlineExecutor executor;
  const VideoMaker video(every_20th_step(folder, {10, 50}), 10, executor);
  EXPECT_EQ(video.progress().total, 3U);
  EXPECT_EQ(video.progress().done, 0U);
  EXPECT_FALSE(video.progress().encoding);
}

TEST(VideoMaker, KeepsTheImagesInAFolder) {
  const test::TempFolder folder;
  InlineExecutor executor;
  VideoMaker video(every_20th_step(folder, {1, 30}), 1, executor);
  while (video.wanted()) video.add(kOnePixel);
  executor.run_posted();
  EXPECT_FALSE(std::filesystem::exists(folder / "frames/frame_000001.png")) << "before the video is complete";
  const std::optional<VideoMade> made = video.finish();
  ASSERT_TRUE(made && made->complete);
  EXPECT_TRUE(made->text.starts_with("2 PNG frames are in ")) << made->text;
  EXPECT_TRUE(std::filesystem::exists(folder / "frames/frame_000001.png"));
  EXPECT_TRUE(std::filesystem::exists(folder / "frames/frame_000002.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "frames/frame_000003.png"));
}

TEST(VideoMaker, LeavesNothingIfItIsCancelled) {
  const test::TempFolder folder;
  InlineExecutor executor;
  {
    VideoMaker video(every_20th_step(folder, {1, 30}), 1, executor);
    video.add(kOnePixel);
    executor.run_posted();
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(VideoPlan, TakesFormatAndSizeFromNameAndSettings) {
  EXPECT_EQ(format_of("a/b.webp"), ui::VideoFormat::webp);
  EXPECT_EQ(format_of("a/b.mp4"), ui::VideoFormat::mp4);
  EXPECT_EQ(format_of("b.gif"), ui::VideoFormat::gif);
  EXPECT_EQ(format_of("b.mp4.d"), ui::VideoFormat::png);
  EXPECT_EQ(with_format("a/b.mp4", ui::VideoFormat::gif), "a/b.gif");
  EXPECT_EQ(with_format("a/b.gif", ui::VideoFormat::png), "a/b");
  EXPECT_EQ(with_format("a/b.webp", ui::VideoFormat::mp4), "a/b.mp4");
  EXPECT_EQ(with_format("a/b.mp4", ui::VideoFormat::webp), "a/b.webp");
  EXPECT_EQ(with_format("a/b", ui::VideoFormat::mp4), "a/b.mp4");
  EXPECT_EQ(with_format("", ui::VideoFormat::gif), "video.gif");
  ui::VideoState settings;
  settings.source.width = 640, settings.source.height = 480;
  const auto size = [&] {
    const VideoPlan plan = plan_video("v.mp4", {0, 99}, settings);
    return std::pair(plan.width, plan.height);
  };
  EXPECT_EQ(size(), std::pair(640, 480));
  settings.size = ui::VideoSize::hd;
  EXPECT_EQ(size(), std::pair(1280, 720));
  settings.size = ui::VideoSize::full_hd;
  EXPECT_EQ(size(), std::pair(1920, 1080));
  settings.size = ui::VideoSize::custom;
  settings.width = 1000, settings.height = 500;
  EXPECT_EQ(size(), std::pair(1000, 500));
  settings.every = 10;
  EXPECT_TRUE(
      plan_text(plan_video("v", {0, 99}, settings)).starts_with("10 frames, 0.2 s, 1000 x 500 pixels, at most "));
  settings.source.timestep = 0.001;
  EXPECT_TRUE(plan_text(plan_video("v", {0, 99}, settings)).starts_with("10 frames, 0.2 s at 0.5 x real time, "));
  settings.every = 20;
  EXPECT_TRUE(plan_text(plan_video("v", {0, 99}, settings)).starts_with("5 frames, 0.1 s in real time, "));
}

TEST(VideoPlan, ShowsTheContactUnlessAllStepsAreChosen) {
  ui::VideoState settings;
  settings.source.steps = {0, 999};
  EXPECT_EQ(chosen_steps(settings), (StepRange{0, 999})) << "there is no contact";
  settings.source.contact = StepRange{200, 400};
  EXPECT_EQ(chosen_steps(settings), (StepRange{200, 400}));
  settings.steps = ui::VideoSteps::all;
  EXPECT_EQ(chosen_steps(settings), (StepRange{0, 999}));
  settings.steps = ui::VideoSteps::period;
  settings.source.period = StepRange{300, 350};
  EXPECT_EQ(chosen_steps(settings), (StepRange{300, 350}));
}

TEST(VideoPlan, RefusesAnImpossiblePlanWithTheRemedy) {
  const test::TempFolder folder;
  VideoPlan plan = every_20th_step(folder, {0, 99});
  EXPECT_EQ(refusal(plan), "");
  EXPECT_EQ(estimated_bytes(plan), 5 * 640 * 480);
  EXPECT_NE(refusal(plan, 1e6).find("5 frames need up to "), std::string::npos) << refusal(plan, 1e6);
  EXPECT_NE(refusal(plan, 1e6).find("choose fewer frames, a smaller size or a folder on another disk"),
            std::string::npos);
  VideoPlan wide = plan;
  wide.width = 9000;
  EXPECT_NE(refusal(wide).find("16 to 8192 pixels, are 9000 x 480: choose another size"), std::string::npos);
  VideoPlan fast = plan;
  fast.path = (folder / "v.webp").string();
  fast.rate = 61;
  EXPECT_NE(refusal(fast).find("at most 60 frames per second"), std::string::npos) << refusal(fast);
  fast.rate = 60;
  EXPECT_EQ(refusal(fast), "");
  VideoPlan empty = plan;
  empty.steps.clear();
  EXPECT_NE(refusal(empty).find("run the scene first"), std::string::npos);
  VideoPlan onto_folder = plan;
  onto_folder.path = (folder / "v.mp4").string();
  std::filesystem::create_directory(onto_folder.path);
  EXPECT_NE(refusal(onto_folder).find("is a folder: choose another name"), std::string::npos);
}

TEST(VideoPlan, ShowsAShortRunSlowlyInAFilm) {
  const VideoPlan film = plan_film("film-1.mp4", {5, 34}, {});
  ASSERT_EQ(film.steps.size(), 240U);
  EXPECT_EQ(film.steps.front(), 5U);
  EXPECT_EQ(film.steps.back(), 34U);
  EXPECT_TRUE(std::is_sorted(film.steps.begin(), film.steps.end()));
  EXPECT_EQ(film.width, 1920);
  EXPECT_EQ(film.height, 1080);
  EXPECT_TRUE(film.annotated && film.orbit);
  EXPECT_EQ(plan_film("f", {7, 7}, {}).steps.back(), 7U);
}

TEST(FilmCamera, TurnsOnceAroundTheContact) {
  ui::Camera first;
  first.target = {1, 0, 0};
  first.azimuth_deg = 30;
  ui::FilmCamera film(first);
  const dvec3 contact(0, 0.02, 0.01);
  const ui::Camera begin = film.next(0, contact);
  EXPECT_EQ(begin.target, contact) << "looks at the contact at once";
  EXPECT_NEAR(begin.azimuth_deg, 30, 1e-12);
  EXPECT_NEAR(film.next(0.5, contact).azimuth_deg, -150, 1e-12);
  const ui::Camera end = film.next(1, contact);
  EXPECT_NEAR(end.azimuth_deg, 30, 1e-12) << "a whole turn";
  EXPECT_EQ(end.distance, first.distance);
  EXPECT_EQ(film.next(0.1, std::nullopt).target, contact) << "stays without contact";
  const dvec3 later = film.next(0.2, contact + dvec3(0.01, 0, 0)).target;
  EXPECT_GT(later.x, 0) << "follows";
  EXPECT_LT(later.x, 0.005) << "smoothly";
}

TEST(FilmCamera, FindsTheMiddleOfAContactWithoutPressure) {
  SimFrame frame;
  EXPECT_FALSE(ui::contact_center(frame));
  SensorStep& sensor = frame.sensors.emplace_back();
  sensor.X_WM.p = {0, 0, 1};
  ContactSurface& surface = sensor.surfaces.emplace_back();
  for (int i = 0; i < 3; ++i) surface.vertices.push_back(dvec3(0));
  surface.polygons.resize(2);
  for (ContactPolygon& polygon : surface.polygons) polygon.count = 3;
  surface.polygons[0].area = 3;
  surface.polygons[1].area = 1;
  surface.polygons[1].centroid = {0.4, 0, 0};
  EXPECT_LT(glm::distance(*ui::contact_center(frame), dvec3(0.1, 0, 1)), 1e-12);
}

}  // namespace
}  // namespace taxel::studio
