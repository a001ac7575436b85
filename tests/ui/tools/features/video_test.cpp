// A video of recorded steps: which steps it takes, the names of its images, and the folder that remains.
#include "app/studio/features/video/video_maker.h"

#include <gtest/gtest.h>

#include "app/studio/features/video/video_state.h"
#include "fixtures/temp_folder.h"

namespace taxel::studio {
namespace {

/// Every 20th step, at 50 images per second.
ui::VideoState every_20th_step() {
  ui::VideoState settings;
  settings.every = 20;
  return settings;
}

TEST(VideoMaker, TakesEveryNthStepOfTheRange) {
  const test::TempFolder folder;
  VideoMaker video((folder / "frames").string(), {10, 59}, every_20th_step(), 33);
  for (const std::uint64_t step : {10U, 30U, 50U}) {
    EXPECT_EQ(video.wanted(), step);
    video.taken();
  }
  EXPECT_FALSE(video.wanted());
  EXPECT_EQ(video.shown_before(), 33U);
}

TEST(VideoMaker, TakesTheLastStepIfItIsDue) {
  const test::TempFolder folder;
  const VideoMaker video((folder / "frames").string(), {10, 50}, every_20th_step(), 10);
  EXPECT_EQ(video.progress().total, 3U);
  EXPECT_EQ(video.progress().done, 0U);
  EXPECT_FALSE(video.progress().encoding);
}

TEST(VideoMaker, NumbersImagesFromOne) {
  const test::TempFolder folder;
  VideoMaker video((folder / "frames").string(), {1, 100}, every_20th_step(), 1);
  EXPECT_TRUE(video.next_file().ends_with("/frame_000001.png"));
  video.taken();
  EXPECT_TRUE(video.next_file().ends_with("/frame_000002.png"));
}

TEST(VideoMaker, KeepsTheImagesInAFolder) {
  const test::TempFolder folder;
  VideoMaker video((folder / "frames").string(), {1, 30}, every_20th_step(), 1);
  while (video.wanted()) {
    write_file_atomically(video.next_file(), "image");
    video.taken();
  }
  EXPECT_FALSE(std::filesystem::exists(folder / "frames/frame_000001.png")) << "before the video is complete";
  const std::optional<VideoMade> made = video.finish();
  ASSERT_TRUE(made && made->complete);
  EXPECT_TRUE(made->text.starts_with("2 PNG frames are in ")) << made->text;
  EXPECT_TRUE(std::filesystem::exists(folder / "frames/frame_000002.png"));
}

TEST(VideoMaker, LeavesNothingIfItIsCancelled) {
  const test::TempFolder folder;
  {
    const VideoMaker video((folder / "frames").string(), {1, 30}, every_20th_step(), 1);
    write_file_atomically(video.next_file(), "image");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace taxel::studio
