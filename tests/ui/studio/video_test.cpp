// Videos: an image of each requested step, and an encoder if one is installed.
#include <gtest/gtest.h>

#include "script_lines.h"

namespace taxel::test {
namespace {
namespace fs = std::filesystem;

/// Returns lines that choose File > Export video, every ten steps, and press Enter.
Lines video_of(const std::string& file) {
  const std::string all = key("a", kCtrl);
  return {press("File"),
          kIdle,
          press("Export video..."),
          kIdle,
          R"({"event": "double_click", "at": {"widget": "Frame every N steps"}})",
          all,
          type("10"),
          kIdle,
          press("Path"),
          all,
          type(file),
          kIdle,
          key("Enter"),
          kIdle,
          kIdle};
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

TEST(Video, GivesImagesToTheEncoderAndTheNameToItsFile) {
  const StudioProgram studio;
  const EncoderInPath encoder(studio.folder() / "bin", "for last; do :; done\nprintf '%s\\n' \"$@\" > \"" +
                                                           (studio.folder() / "arguments").string() +
                                                           "\"\necho video > \"$last\"\n");
  studio.play(joined({kSomeSteps, video_of((studio.folder() / "my film.mp4").string()), {dump("state.json")}}),
              coarse_sensor(studio));
  EXPECT_EQ(file_text(studio.folder() / "my film.mp4"), "video\n");
  EXPECT_FALSE(fs::exists(studio.folder() / "my film_frames")) << "its pictures go with it";
  const std::string arguments = file_text(studio.folder() / "arguments");
  EXPECT_NE(arguments.find("-framerate\n50\n-i\n"), std::string::npos) << arguments;
  EXPECT_NE(arguments.find("frame_%06d.png"), std::string::npos);
}

TEST(Video, KeepsTheImagesAndReportsAMissingEncoder) {
  const StudioProgram studio;
  const EncoderInPath none(studio.folder() / "empty", "");
  studio.play(joined({kSomeSteps, video_of((studio.folder() / "film.gif").string()), {dump("none.json")}}),
              coarse_sensor(studio));
  EXPECT_FALSE(fs::exists(studio.folder() / "film.gif"));
  EXPECT_GE(pictures_in(studio.folder() / "film_frames"), 4U);
  EXPECT_NE(studio.state("none.json")["messages"].dump().find("ffmpeg not found: saved PNG frames instead of "),
            std::string::npos);
}

TEST(Video, KeepsTheImagesAndQuotesAFailedEncoder) {
  const StudioProgram studio;
  const EncoderInPath failing(studio.folder() / "bin", "echo 'no such codec' >&2\nexit 3\n");
  studio.play(joined({kSomeSteps, video_of((studio.folder() / "bad.mp4").string()), {dump("bad.json")}}),
              coarse_sensor(studio));
  EXPECT_FALSE(fs::exists(studio.folder() / "bad.mp4"));
  EXPECT_GE(pictures_in(studio.folder() / "bad_frames"), 4U);
  EXPECT_NE(studio.state("bad.json")["messages"].dump().find("ffmpeg failed (no such codec)"), std::string::npos);
}

TEST(Video, LeavesNothingIfCancelled) {
  const StudioProgram studio;
  Lines video = video_of((studio.folder() / "series").string());
  video.resize(video.size() - 2);  // without waiting for the video
  studio.play(joined({kSomeSteps,
                      video,
                      {R"({"do": "wait_for", "pointer": "/video/active", "equals": true})", key("Escape"), kIdle,
                       dump("state.json")}}),
              coarse_sensor(studio));
  EXPECT_FALSE(studio.state("state.json")["video"]["active"]);
  EXPECT_FALSE(fs::exists(studio.folder() / "series"));
}

}  // namespace
}  // namespace taxel::test
