// Videos: an image of each requested step, and an encoder if one is installed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

#include "fixtures/webp_frames.h"
#include "script_lines.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

const Lines kOpenDialog{press("File"), kIdle, press("Export"), kIdle, press("Export video..."), kIdle};

/// Returns lines that type a number into a field of the dialog.
Lines number_of(const std::string& field, const std::string& number) {
  return {R"({"event": "double_click", "at": {"widget": ")" + field + R"("}})", key("a", kCtrl), type(number), kIdle};
}

/// Returns lines that type the name of the video and press Enter.
Lines write_to(const std::string& file) {
  return {press("Path"), key("a", kCtrl), type(file), kIdle, key("Enter"), kIdle, kIdle};
}

/// Returns lines that choose File > Export > Export video, every ten steps, and press Enter.
Lines video_of(const std::string& file) {
  return joined({kOpenDialog, number_of("Frame every N steps", "10"), write_to(file)});
}

/// Returns lines that choose a size of the video in the dialog.
Lines size_of(const std::string& width, const std::string& height) {
  return joined({{press("Size"), kIdle, press("Custom"), kIdle},
                 number_of("Video width", width),
                 number_of("Video height", height)});
}
const Lines kSomeSteps{R"({"do": "wait_time", "time": 0.03})", key("Space"), kIdle};

/// Returns a layout that is quickly compiled and drawn.
std::vector<std::string> coarse_sensor(const StudioProgram& studio) {
  Json layout = Json::parse(file_text(kLayoutFile));
  layout["mesh"]["file"] = kMeshFile;
  layout["sampling"]["density"] = 1e5;
  write_text(studio.folder() / "coarse.taxels.json", layout.dump());
  return {"coarse.taxels.json"};
}

std::size_t pictures_in(const fs::path& folder) {
  std::size_t count = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    count += entry.path().extension() == ".png" ? 1 : 0;
  return count;
}

TEST(Video, HasAnImageOfEveryTenthStepAtAnySpeed) {
  const StudioProgram studio;
  studio.play(joined(
      {kSomeSteps, {dump("before.json")}, video_of((studio.folder() / "series").string()), {dump("after.json")}}));
  const Json before = studio.state("before.json")["simulation"], after = studio.state("after.json")["simulation"];
  const std::size_t last = before["history"]["last"];
  EXPECT_EQ(pictures_in(studio.folder() / "series"), last / 10 + 1);
  EXPECT_EQ(after["step"], before["step"]) << "the displayed step is restored";
  const Picture first = studio.picture("series/frame_000001.png"), fourth = studio.picture("series/frame_000004.png");
  EXPECT_EQ(first.width, studio.state("before.json")["view"]["width"]);
  EXPECT_NE(first.rgb, fourth.rgb) << "the finger moved";
  EXPECT_NE(studio.state("after.json")["messages"].dump().find("PNG frames are in"), std::string::npos);
}

/// A program named ffmpeg in its own folder, which is first in PATH.
class EncoderInPath {
 public:
  explicit EncoderInPath(const fs::path& folder, const std::string& body) {
    if (const char* path = std::getenv("PATH")) before_ = path;
    fs::create_directories(folder);
    if (!body.empty()) {
      write_text(folder / "ffmpeg", "#!/bin/sh\n" + body);
      fs::permissions(folder / "ffmpeg", fs::perms::owner_all);
      ::setenv("PATH", (folder.string() + ":" + before_).c_str(), 1);
    } else {
      ::setenv("PATH", folder.c_str(), 1);
    }
  }
  ~EncoderInPath() { ::setenv("PATH", before_.c_str(), 1); }
  EncoderInPath(const EncoderInPath&) = delete;
  EncoderInPath& operator=(const EncoderInPath&) = delete;

 private:
  std::string before_;
};

/// An encoder that accepts the sample with which it is tried, and then runs `body`.
std::string after_the_sample(const std::string& body) {
  return "for last; do :; done\ncase \"$last\" in *sample.*) echo sample > \"$last\"; exit 0;; esac\n" + body;
}

TEST(Video, GivesImagesToTheEncoderAndTheNameToItsFile) {
  const StudioProgram studio;
  const EncoderInPath encoder(studio.folder() / "bin",
                              after_the_sample("printf '%s\\n' \"$@\" > \"" + (studio.folder() / "arguments").string() +
                                               "\"\necho video > \"$last\"\n"));
  studio.play(joined({kSomeSteps, video_of((studio.folder() / "my film.mp4").string()), {dump("state.json")}}),
              coarse_sensor(studio));
  EXPECT_EQ(file_text(studio.folder() / "my film.mp4"), "video\n");
  EXPECT_FALSE(fs::exists(studio.folder() / "my film_frames")) << "its pictures go with it";
  const std::string arguments = file_text(studio.folder() / "arguments");
  EXPECT_NE(arguments.find("-framerate\n50\n-i\n"), std::string::npos) << arguments;
  EXPECT_NE(arguments.find("frame_%06d.png"), std::string::npos);
}

TEST(Video, OffersNoExportWithoutAnEncoderAndGivesOneAdvice) {
  const StudioProgram studio;
  const EncoderInPath none(studio.folder() / "empty", "");
  const Lines name{press("Path"), key("a", kCtrl), type((studio.folder() / "film.gif").string()), kIdle};
  studio.play(joined({kSomeSteps,
                      kOpenDialog,
                      number_of("Frame every N steps", "10"),
                      name,
                      {key("Enter"), kIdle, press("Export"), kIdle, kIdle, dump("none.json"), press("Format"), kIdle,
                       press("WebP"), kIdle, press("Export"), kIdle, kIdle, dump("webp.json")}}),
              coarse_sensor(studio));
  const Json none_state = studio.state("none.json"), webp = studio.state("webp.json");
  EXPECT_TRUE(none_state["file_dialog"]["open"]) << "neither Enter nor the button closes it";
  EXPECT_EQ(none_state["messages"].dump().find("ffmpeg"), std::string::npos) << none_state["messages"];
  EXPECT_EQ(none_state["file_dialog"]["error"], "") << "the reason is there once";
  EXPECT_NE(none_state["widgets"].dump().find(
                "GIF needs ffmpeg, which is not installed: install ffmpeg, or choose WebP or PNG frames"),
            std::string::npos);
  EXPECT_FALSE(webp["file_dialog"]["open"]);
  EXPECT_TRUE(fs::exists(studio.folder() / "film.webp")) << "WebP needs no other program";
  EXPECT_FALSE(fs::exists(studio.folder() / "film.gif"));
}

TEST(Video, HasTheStepsOfATypedPeriod) {
  const StudioProgram studio;
  const Lines period{press("Steps"), kIdle, press("From ... to"), kIdle};
  const auto from_to = [](const std::string& from, const std::string& to) {
    return joined({number_of("From (s)", from), number_of("To (s)", to)});
  };
  studio.play(joined({kSomeSteps,
                      kOpenDialog,
                      period,
                      {dump("whole.json")},
                      from_to("0.02", "0.01"),
                      {key("Enter"), kIdle, press("Export"), kIdle, kIdle, dump("empty.json")},
                      from_to("0.01", "0.02"),
                      number_of("Frame every N steps", "5"),
                      write_to((studio.folder() / "series").string()),
                      {dump("state.json")}}),
              coarse_sensor(studio));
  EXPECT_EQ(pictures_in(studio.folder() / "series"), 3U) << "0.010, 0.015 and 0.020 s";
  const Json whole = studio.state("whole.json"), empty = studio.state("empty.json");
  EXPECT_EQ(whole["video"]["from"], 0.0);
  EXPECT_EQ(whole["video"]["to"], whole["simulation"]["time"]);
  EXPECT_TRUE(empty["file_dialog"]["open"]) << "there is nothing to export";
  EXPECT_NE(empty["widgets"].dump().find("No step is recorded from 0.02 s to 0.01 s: type times from 0 s to "),
            std::string::npos);
}

TEST(Video, QuotesAnEncoderThatCannotEncodeTheFormat) {
  const StudioProgram studio;
  const EncoderInPath unable(studio.folder() / "bin", "echo 'Unknown encoder libx264' >&2\nexit 1\n");
  studio.play(joined({kSomeSteps, video_of((studio.folder() / "film.mp4").string()), {dump("unable.json")}}),
              coarse_sensor(studio));
  EXPECT_FALSE(fs::exists(studio.folder() / "film_frames"));
  EXPECT_NE(studio.state("unable.json")["messages"].dump().find(
                "ffmpeg cannot encode it (Unknown encoder libx264): choose another format or PNG frames"),
            std::string::npos);
}

// Nobody can make a folder in a file, whereas root may write into every folder.
TEST(Video, NamesAFolderThatCannotBeWritten) {
  const StudioProgram studio;
  write_text(studio.folder() / "locked", "");
  studio.play(joined({kSomeSteps, video_of((studio.folder() / "locked/series").string()), {dump("locked.json")}}),
              coarse_sensor(studio));
  EXPECT_NE(studio.state("locked.json")["messages"].dump().find(": choose another folder"), std::string::npos);
}

TEST(Video, KeepsTheImagesAndQuotesAFailedEncoder) {
  const StudioProgram studio;
  const EncoderInPath failing(studio.folder() / "bin", after_the_sample("echo 'no such codec' >&2\nexit 3\n"));
  studio.play(joined({kSomeSteps, video_of((studio.folder() / "bad.mp4").string()), {dump("bad.json")}}),
              coarse_sensor(studio));
  EXPECT_FALSE(fs::exists(studio.folder() / "bad.mp4"));
  EXPECT_GE(pictures_in(studio.folder() / "bad_frames"), 4U);
  EXPECT_NE(studio.state("bad.json")["messages"].dump().find("ffmpeg failed (no such codec)"), std::string::npos);
}

TEST(Video, DrawsTimeAndLegendInTheChosenSize) {
  const StudioProgram studio;
  const auto series = [&](const std::string& name, const Lines& settings) {
    return joined({kOpenDialog, settings, write_to((studio.folder() / name).string())});
  };
  const Lines size{press("Size"),
                   kIdle,
                   press("1280 x 720"),
                   kIdle,
                   press("Time, force and legend"),
                   kIdle,
                   press("Bars of readings"),
                   kIdle};
  studio.play(
      joined({kSomeSteps,
              series("plain", size),
              {press("Close"), kIdle},  // the message takes a line from the view, which decides the lines' width
              series("noted", {press("Time, force and legend"), kIdle}),
              {press("Close"), kIdle},
              series("barred", {press("Time, force and legend"), kIdle, press("Bars of readings"), kIdle}),
              {dump("state.json")}}),
      coarse_sensor(studio));
  EXPECT_FALSE(studio.state("state.json")["video"]["annotated"]);
  EXPECT_TRUE(studio.state("state.json")["video"]["bars"]);
  const Picture plain = studio.picture("plain/frame_000002.png"), noted = studio.picture("noted/frame_000002.png");
  ASSERT_EQ(plain.width, 1280);
  ASSERT_EQ(plain.height, 720);
  ASSERT_EQ(noted.width, 1280);
  // Only the corners with the time (lower left), the legend (upper right) and the bars (lower right) differ.
  const auto changes = [&](const Picture& other) {
    std::array<int, 4> changed{};  // time, legend, bars, elsewhere
    for (int y = 0; y < 720; ++y)
      for (int x = 0; x < 1280; ++x)
        if (plain.pixel(x, y) != other.pixel(x, y))
          ++changed[x < 250 && y > 640 ? 0 : x > 900 && y < 270 ? 1 : x > 500 && y > 540 ? 2 : 3];
    return changed;
  };
  const std::array<int, 4> by_notes = changes(noted), by_bars = changes(studio.picture("barred/frame_000002.png"));
  EXPECT_GT(by_notes[0], 800);
  EXPECT_GT(by_notes[1], 20'000) << "two colour bars";
  EXPECT_EQ(by_notes[2] + by_notes[3], 0);
  EXPECT_GT(by_bars[2], 20'000);
  EXPECT_EQ(by_bars[0] + by_bars[1] + by_bars[3], 0);
}

TEST(Video, ShowsTheContactInAWebpFilmLikeItsImages) {
  const StudioProgram studio;
  const Lines settings = joined({kOpenDialog, number_of("Frame every N steps", "10"), size_of("400", "300")});
  studio.play(joined({{R"({"do": "wait_time", "time": 2.2})", key("Space"), kIdle},
                      settings,
                      write_to((studio.folder() / "series").string()),
                      video_of((studio.folder() / "film.webp").string()),
                      {dump("state.json")}}),
              coarse_sensor(studio));
  const Json state = studio.state("state.json"), history = state["simulation"]["history"];
  const Json& event = history["events"][0];
  ASSERT_EQ(event["what"][0], "contact_begins");
  const int begin = event["step"].get<int>() - 100, last = history["last"].get<int>();  // 0.1 s before the touch
  const int count = (last - begin) / 10 + 1;
  ASSERT_EQ(static_cast<int>(pictures_in(studio.folder() / "series")), count);
  const auto frames = webp_frames(file_text(studio.folder() / "film.webp"));
  EXPECT_EQ(frames.back().end_ms, 20 * count) << "50 images a second";
  EXPECT_NE(state["messages"].dump().find("film.webp with " + std::to_string(count) + " frames"), std::string::npos);
  for (int i = 0; i < count; ++i) {
    const Picture image = studio.picture(fmt::format("series/frame_{:06}.png", i + 1));
    const WebpFrame& frame = frame_at(frames, 20 * i + 10);
    ASSERT_EQ(frame.width, 400);
    ASSERT_EQ(frame.height, 300);
    double error = 0;
    for (int y = 0; y < 300; ++y)
      for (int x = 0; x < 400; ++x)
        for (std::size_t c = 0; c < 3; ++c) error += std::abs(image.pixel(x, y)[c] - frame.pixel(x, y)[c]);
    EXPECT_LT(error / (3.0 * 400 * 300), 4) << "image " << i << ", of which a fifth is text and bars";
  }
  EXPECT_FALSE(fs::exists(studio.folder() / "film_frames"));
}

// A run of 2.2 s with an image every 8 steps, in slow motion.
TEST(Video, TakesLessThanFiveMegabytesForFiveSeconds) {
  const StudioProgram studio;
  studio.play(joined({{R"({"do": "wait_time", "time": 2.2})", key("Space"), kIdle},
                      kOpenDialog,
                      {press("Steps"), kIdle, press("All"), kIdle},
                      number_of("Frame every N steps", "8"),
                      size_of("1000", "600"),
                      write_to((studio.folder() / "film.webp").string())}),
              {kLayoutFile});
  const std::string film = file_text(studio.folder() / "film.webp");
  EXPECT_GT(webp_frames(film).back().end_ms, 5000);
  EXPECT_LT(film.size(), 5'000'000U);
  RecordProperty("bytes", static_cast<int>(film.size()));
}

TEST(Video, SaysWhichFormatsNeedFfmpeg) {
  const StudioProgram studio;
  const EncoderInPath none(studio.folder() / "empty", "");
  studio.play(joined({kSomeSteps, kOpenDialog, {press("Format"), kIdle, dump("formats.json"), press("PNG frames")}}),
              coarse_sensor(studio));
  const std::string widgets = studio.state("formats.json")["widgets"].dump();
  for (const char* label : {"\"WebP\"", "\"MP4: ffmpeg is not installed\"", "\"GIF: ffmpeg is not installed\""})
    EXPECT_NE(widgets.find(label), std::string::npos) << label;
  EXPECT_NE(widgets.find("no contact: all steps"), std::string::npos);
}

TEST(Video, TurnsAroundTheContactByOneKey) {
  const StudioProgram studio;
  const EncoderInPath encoder(studio.folder() / "bin",
                              after_the_sample("cp \"$(dirname \"$last\")\"/frame_00000[12].png \"$(dirname "
                                               "\"$last\")\"/frame_000120.png \"" +
                                               studio.folder().string() + "\"\necho video > \"$last\"\n"));
  const Lines small = joined({kOpenDialog, size_of("160", "120"), {press("Cancel"), kIdle}});
  studio.play(
      joined({kSomeSteps, small, {dump("before.json"), key("p", kCtrlShift), kIdle, kIdle, dump("after.json")}}),
      coarse_sensor(studio));
  EXPECT_EQ(file_text(studio.folder() / "film-1.mp4"), "video\n");
  EXPECT_EQ(studio.state("before.json")["camera"], studio.state("after.json")["camera"]) << "the view stays";
  EXPECT_NE(studio.state("after.json")["messages"].dump().find("film-1.mp4 with 240 frames"), std::string::npos);
  const Picture begin = studio.picture("frame_000001.png"), half = studio.picture("frame_000120.png");
  EXPECT_EQ(begin.width, 160);
  EXPECT_EQ(begin.height, 120);
  EXPECT_NE(begin.rgb, half.rgb);
}

TEST(Video, SaysThatAFilmNeedsARun) {
  const StudioProgram studio;
  studio.play({key("p", kCtrlShift), kIdle, dump("none.json")}, {"--empty"});
  EXPECT_NE(studio.state("none.json")["messages"].dump().find("There is no recorded step to make a film of."),
            std::string::npos);
}

TEST(Video, LeavesNothingIfCancelled) {
  for (const char* name : {"series", "film.webp"}) {
    const StudioProgram studio;
    Lines video = video_of((studio.folder() / name).string());
    video.resize(video.size() - 2);  // without waiting for the video
    studio.play(joined({kSomeSteps,
                        video,
                        {R"({"do": "wait_for", "pointer": "/video/active", "equals": true})", key("Escape"), kIdle,
                         dump("state.json")}}),
                coarse_sensor(studio));
    EXPECT_FALSE(studio.state("state.json")["video"]["active"]);
    for (const fs::directory_entry& entry : fs::directory_iterator(studio.folder()))
      EXPECT_FALSE(entry.path().filename().string().starts_with(name)) << entry.path();
  }
}

}  // namespace
}  // namespace taxel::test
