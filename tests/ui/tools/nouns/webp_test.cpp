// WebP films, decoded again: colours, number of images and times; and images that are encoded on workers.
#include "app/studio/host/webp.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <future>
#include <thread>

#include "app/studio/nouns/video/image_queue.h"
#include "app/studio/nouns/video/video_maker.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "fixtures/temp_folder.h"
#include "fixtures/webp_frames.h"

namespace taxel::studio {
namespace {

constexpr int kWide = 96, kHigh = 64;

/// Returns an image whose left half is red, and whose right half has a blue square that moves down by 4 pixels with
/// each number.
gl::RgbImage numbered_image(int number) {
  gl::RgbImage image{kWide, kHigh, {}};
  for (int y = 0; y < kHigh; ++y) {
    for (int x = 0; x < kWide; ++x) {
      const bool is_square = x >= 64 && x < 80 && y >= 4 * number && y < 4 * number + 16;
      const std::array<unsigned char, 3> color = x < kWide / 2 ? std::array<unsigned char, 3>{200, 30, 40}
                                                 : is_square   ? std::array<unsigned char, 3>{20, 60, 220}
                                                               : std::array<unsigned char, 3>{240, 240, 240};
      image.rgb.insert(image.rgb.end(), color.begin(), color.end());
    }
  }
  return image;
}

/// Expects the colours of numbered_image() in the middle of its areas.
void expect_number(const test::WebpFrame& frame, int number) {
  const auto near = [&](int x, int y, const std::array<int, 3>& color) {
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(frame.pixel(x, y)[c], color[c], 6) << "image " << number << " at " << x << ", " << y;
  };
  near(24, 32, {200, 30, 40});
  near(72, 4 * number + 8, {20, 60, 220});
  near(72, number < 6 ? 58 : 5, {240, 240, 240});
}

/// Returns the plan of a film of 12 images of 96 x 64 pixels, 30 a second.
VideoPlan small_film(const std::string& path) {
  VideoPlan plan;
  plan.path = path;
  plan.width = kWide, plan.height = kHigh;
  plan.rate = 30;
  for (std::uint64_t step = 0; step < 12; ++step) plan.steps.push_back(step);
  return plan;
}

void add_images(VideoMaker& maker, JobExecutor& executor) {
  for (int number = 0; maker.wanted(); ++number) {
    if (!maker.has_room()) executor.run_posted();
    maker.add(numbered_image(number));
  }
}

TEST(WebpFilm, ShowsEachImageAtItsTimeInItsColours) {
  WebpFilm film(kWide, kHigh);
  for (int i = 0; i < 10; ++i) film.add(numbered_image(i), 40 * i);
  film.add(numbered_image(9), 400);
  const auto frames = test::webp_frames(film.finish(440));
  ASSERT_EQ(frames.size(), 10U) << "equal images are one";
  EXPECT_EQ(frames.back().end_ms, 440);
  for (int i = 0; i < 10; ++i) {
    EXPECT_EQ(frames[static_cast<std::size_t>(i)].begin_ms, 40 * i);
    expect_number(test::frame_at(frames, 40 * i + 20), i);
  }
}

TEST(WebpFilm, RefusesASizeThatTheFormatCannotHold) {
  EXPECT_THROW(WebpFilm(20000, 10), Error);
}

TEST(VideoMaker, WritesAWebpFilmAsAWhole) {
  const test::TempFolder folder;
  InlineExecutor executor;
  VideoMaker maker(small_film((folder / "film.webp").string()), 0, executor);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path())) << "no file before the end";
  add_images(maker, executor);
  EXPECT_FALSE(maker.finish()) << "images wait";
  EXPECT_TRUE(maker.progress().encoding);
  executor.run_posted();
  const std::optional<VideoMade> made = maker.finish();
  ASSERT_TRUE(made && made->complete);
  EXPECT_NE(made->text.find("film.webp with 12 frames, "), std::string::npos) << made->text;
  const auto frames = test::webp_frames(read_file(folder / "film.webp"));
  ASSERT_EQ(frames.size(), 12U);
  EXPECT_EQ(frames.back().end_ms, 400) << "12 images of 1/30 s";
  EXPECT_EQ(frames[1].begin_ms, 33);
  EXPECT_EQ(frames[2].begin_ms, 67) << "rounding does not add up";
  for (int i = 0; i < 12; ++i) expect_number(frames[static_cast<std::size_t>(i)], i);
}

TEST(VideoMaker, LeavesNoFilmIfItIsCancelled) {
  const test::TempFolder folder;
  InlineExecutor executor;
  {
    VideoMaker maker(small_film((folder / "film.webp").string()), 0, executor);
    add_images(maker, executor);
  }
  EXPECT_FALSE(executor.busy()) << "the images that waited are dropped";
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(VideoMaker, LeavesNoFilmOnAFullDisk) {
  const test::TempFolder folder;
  InlineExecutor executor;
  VideoMaker maker(small_film((folder / "film.webp").string()), 0, executor);
  add_images(maker, executor);
  executor.run_posted();
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{500, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  std::string message;
  try {
    static_cast<void>(maker.finish());
  } catch (const Error& error) {
    message = error.what();
  }
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(message, (folder / "film.webp").string() + ": writing failed: File too large");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

// Nobody can write into a file as if it were a folder, whereas root may write into every folder.
TEST(VideoMaker, RefusesAFolderThatCannotBeWrittenBeforeTheFirstImage) {
  const test::TempFolder folder;
  write_file_atomically(folder / "file", "");
  InlineExecutor executor;
  try {
    const VideoMaker maker(small_film((folder / "file/film.webp").string()), 0, executor);
    ADD_FAILURE() << "not refused";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find(": choose another folder"), std::string::npos) << error.what();
  }
}

TEST(ImageQueue, UsesImagesInOrderWithoutHoldingUpTheirThread) {
  JobPool pool;
  std::promise<void> go;
  std::shared_future<void> gone = go.get_future().share();
  std::vector<int> widths;
  std::vector<std::thread::id> threads;
  ImageQueue queue(pool, [&](const gl::RgbImage& image) {
    gone.wait();
    widths.push_back(image.width);
    threads.push_back(std::this_thread::get_id());
  });
  for (int i = 0; queue.has_room(); ++i) queue.add({i, 1, {}});  // returns although the function still waits
  EXPECT_FALSE(queue.is_empty());
  go.set_value();
  while (!queue.is_empty()) std::this_thread::yield();
  ASSERT_GE(widths.size(), 4U);
  for (std::size_t i = 0; i < widths.size(); ++i) {
    EXPECT_EQ(widths[i], static_cast<int>(i));
    EXPECT_NE(threads[i], std::this_thread::get_id());
  }
}

TEST(ImageQueue, KeepsTheFirstErrorAndUsesNoFurtherImage) {
  InlineExecutor executor;
  int used = 0;
  ImageQueue queue(executor, [&](const gl::RgbImage& image) {
    ++used;
    if (image.width == 1) throw Error("film.webp", "writing failed");
  });
  for (int i = 0; i < 3; ++i) queue.add({i, 1, {}});
  EXPECT_NO_THROW(queue.check());
  executor.run_posted();
  EXPECT_EQ(used, 2);
  EXPECT_TRUE(queue.is_empty());
  EXPECT_THROW(queue.check(), Error);
}

}  // namespace
}  // namespace taxel::studio
