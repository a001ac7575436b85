#include "app/studio/nouns/video/video_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/output.h"
#include "ui/widgets/format.h"

namespace taxel::studio {
namespace {

constexpr int kMinSide = 16, kMaxSide = 8192;  // [pixels]; OpenGL 4.1 has at least 16384
constexpr std::size_t kMaxFrames = 100'000;
constexpr double kImageBytesPerPixel = 1.0, kVideoBytesPerPixel = 0.2;  // at most, measured: 0.6 and 0.1
constexpr int kFilmRate = 30, kFilmFrames = 240;

struct Size {
  int width, height;
};

Size size_of(const ui::VideoState& settings) {
  switch (settings.size) {
    case ui::VideoSize::hd:
      return {1280, 720};
    case ui::VideoSize::full_hd:
      return {1920, 1080};
    case ui::VideoSize::custom:
      return {settings.width, settings.height};
    case ui::VideoSize::view:
      break;
  }
  return {settings.source.width, settings.source.height};
}

}  // namespace

ui::VideoFormat format_of(const std::string& path) {
  return path.ends_with(".mp4")   ? ui::VideoFormat::mp4
         : path.ends_with(".gif") ? ui::VideoFormat::gif
                                  : ui::VideoFormat::png;
}

std::string with_format(const std::string& path, ui::VideoFormat format) {
  std::string name = path;
  if (format_of(path) != ui::VideoFormat::png) name.resize(name.size() - 4);  // ".mp4", ".gif"
  if (name.empty() || name.back() == '/') name += "video";
  return name + (format == ui::VideoFormat::mp4 ? ".mp4" : format == ui::VideoFormat::gif ? ".gif" : "");
}

VideoPlan plan_video(const std::string& path, const StepRange& steps, const ui::VideoState& settings) {
  const Size size = size_of(settings);
  VideoPlan plan{path,
                 {},
                 size.width,
                 size.height,
                 settings.rate,
                 settings.window,
                 !settings.window && settings.annotated,
                 !settings.window && settings.orbit};
  for (std::uint64_t step = steps.first; step <= steps.last; step += static_cast<std::uint64_t>(settings.every))
    plan.steps.push_back(step);
  return plan;
}

VideoPlan plan_film(const std::string& path, const StepRange& steps, const ui::VideoState& settings) {
  const Size size = settings.size == ui::VideoSize::view ? Size{1920, 1080} : size_of(settings);
  VideoPlan plan{path, {}, size.width, size.height, kFilmRate, false, true, true};
  for (std::uint64_t i = 0; i < kFilmFrames; ++i)
    plan.steps.push_back(steps.first + (steps.last - steps.first) * i / (kFilmFrames - 1));
  return plan;
}

double estimated_bytes(const VideoPlan& plan) {
  const double pixels = static_cast<double>(plan.width) * plan.height * static_cast<double>(plan.steps.size());
  return pixels * (kImageBytesPerPixel + (format_of(plan.path) == ui::VideoFormat::png ? 0 : kVideoBytesPerPixel));
}

std::string plan_text(const VideoPlan& plan) {
  const auto count = static_cast<long long>(plan.steps.size());
  const std::string size = plan.window ? "size of the window" : fmt::format("{} x {} pixels", plan.width, plan.height);
  return fmt::format("{} {}, {:.1f} s, {}, at most {}", ui::grouped(count), count == 1 ? "frame" : "frames",
                     static_cast<double>(count) / plan.rate, size, ui::bytes_text(estimated_bytes(plan)));
}

void check_plan(const VideoPlan& plan, double free_bytes) {
  if (plan.steps.empty()) throw Error(plan.path, "there is no recorded step: run the scene first (Space)");
  if (plan.steps.size() > kMaxFrames)
    throw Error(plan.path, fmt::format("a video has at most {} frames, these are {}: raise \"Frame every N steps\"",
                                       kMaxFrames, plan.steps.size()));
  if (std::min(plan.width, plan.height) < kMinSide || std::max(plan.width, plan.height) > kMaxSide)
    throw Error(plan.path, fmt::format("width and height must be {} to {} pixels, are {} x {}: choose another size",
                                       kMinSide, kMaxSide, plan.width, plan.height));
  if (std::error_code ignored;
      format_of(plan.path) != ui::VideoFormat::png && std::filesystem::is_directory(plan.path, ignored))
    throw Error(plan.path, "is a folder: choose another name for the video");
  if (estimated_bytes(plan) > free_bytes)
    throw Error(plan.path,
                fmt::format("{} frames need up to {}, and the disk has {} left: choose fewer frames, a "
                            "smaller size or a folder on another disk",
                            plan.steps.size(), ui::bytes_text(estimated_bytes(plan)), ui::bytes_text(free_bytes)));
}

namespace fs = std::filesystem;
namespace {

constexpr const char *kPictureName = "frame_{:06}.png", *kPicturePattern = "frame_%06d.png";
constexpr const char *kSampleName = "sample_000001.png", *kSamplePattern = "sample_%06d.png";
constexpr const char* kLogName = "encoder.log";

bool is_video(const std::string& path) {
  return format_of(path) != ui::VideoFormat::png;
}

const char* video_extension(const std::string& path) {
  return format_of(path) == ui::VideoFormat::gif ? ".gif" : ".mp4";
}

/// Returns the arguments with which ffmpeg makes a video from images. Both paths are absolute.
std::vector<std::string> encoder_arguments(const std::string& images, const std::string& video, int rate) {
  const bool gif = format_of(video) == ui::VideoFormat::gif;
  // A GIF gets its own palette. An MP4 gets even side lengths, as required by the pixel format that every player
  // supports.
  const std::string filter = gif ? "split[a][b];[a]palettegen[p];[b][p]paletteuse" : "pad=ceil(iw/2)*2:ceil(ih/2)*2";
  std::vector<std::string> arguments{"ffmpeg",     "-nostdin",           "-y", "-loglevel", "error",
                                     "-framerate", std::to_string(rate), "-i", images,      "-vf",
                                     filter};
  if (!gif) arguments.insert(arguments.end(), {"-pix_fmt", "yuv420p"});
  arguments.push_back(video);
  return arguments;
}

/// Returns the room on the disk of a folder that may not exist yet [bytes].
double free_bytes(fs::path folder) {
  std::error_code failed;
  folder = fs::absolute(folder, failed);
  while (!fs::exists(folder, failed) && folder.has_relative_path()) folder = folder.parent_path();
  const fs::space_info space = fs::space(folder, failed);
  return failed ? 1e300 : static_cast<double>(space.available);  // unknown: writing will say
}

}  // namespace

VideoMaker::VideoMaker(VideoPlan plan, std::uint64_t shown) : plan_(std::move(plan)), shown_(shown) {
  folder_name_ = is_video(plan_.path) ? fs::path(plan_.path).replace_extension("").string() + "_frames" : plan_.path;
  check_plan(plan_, free_bytes(folder_name_));
  try {
    folder_ = std::make_unique<OutputFolder>(folder_name_);
  } catch (const Error& error) {
    throw Error(error.file(), error.where(), error.message() + ": choose another folder");
  }
  is_tried_ = !is_video(plan_.path);
}

std::string VideoMaker::sample_file() const {
  return is_video(plan_.path) ? (folder_->staging() / kSampleName).string() : "";
}

bool VideoMaker::is_ready() {
  if (is_tried_) return true;
  const std::string video = std::string("sample") + video_extension(plan_.path);
  if (!encoder_.runs()) {
    if (start_encoder(kSamplePattern, video)) return false;
    throw Error(plan_.path, "ffmpeg is not installed: install ffmpeg, or choose PNG frames");
  }
  const std::optional<int> status = encoder_.ended();
  if (!status) return false;
  std::error_code failed;
  if (*status != 0 || !fs::exists(folder_->staging() / video, failed))
    throw Error(plan_.path, fmt::format("ffmpeg cannot encode it ({}): choose another format or PNG frames, or install "
                                        "an ffmpeg with this encoder",
                                        encoder_words()));
  for (const std::string& name : {video, std::string(kSampleName), std::string(kLogName)})
    fs::remove(folder_->staging() / name, failed);
  is_tried_ = true;
  return true;
}

std::optional<std::uint64_t> VideoMaker::wanted() const {
  return taken_ < plan_.steps.size() ? std::optional(plan_.steps[taken_]) : std::nullopt;
}

double VideoMaker::fraction() const {
  return static_cast<double>(taken_) / static_cast<double>(plan_.steps.size());
}

std::string VideoMaker::next_file() const {
  return (folder_->staging() / fmt::format(fmt::runtime(kPictureName), taken_ + 1)).string();
}

ui::VideoProgress VideoMaker::progress() const {
  return {true, !is_tried_, is_tried_ && encoder_.runs(), taken_, plan_.steps.size()};
}

/// Starts ffmpeg in the folder of the images. Returns false if ffmpeg is not installed.
bool VideoMaker::start_encoder(const std::string& images, const std::string& video) {
  const fs::path& folder = folder_->staging();
  return encoder_.start(encoder_arguments((folder / images).string(), (folder / video).string(), plan_.rate),
                        folder / kLogName);
}

/// Returns the last message of the encoder.
std::string VideoMaker::encoder_words() const {
  std::string text;
  try {
    text = read_file(folder_->staging() / kLogName);
  } catch (const Error&) {  // the encoder wrote no message
  }
  while (!text.empty() && text.back() == '\n') text.pop_back();
  const std::size_t last = text.find_last_of('\n');
  text = text.substr(last == std::string::npos ? 0 : last + 1);
  return text.empty() ? "it gives no reason" : text;
}

VideoMade VideoMaker::keep_pictures(const std::string& why) {
  std::error_code ignored;
  for (const char* other : {kLogName, "video.mp4", "video.gif"}) fs::remove(folder_->staging() / other, ignored);
  // Images of a longer video in the folder would be mistaken for images of this video.
  for (std::size_t i = taken_ + 1;; ++i) {
    const std::string name = fmt::format(fmt::runtime(kPictureName), i);
    if (!fs::exists(fs::path(folder_name_) / name, ignored)) break;
    folder_->leave_out(name);
  }
  folder_->commit();
  const std::string where = fs::absolute(folder_name_).string();
  return {fmt::format("{}{} PNG frames are in {}", why, taken_, where), why.empty()};
}

std::optional<VideoMade> VideoMaker::finish() {
  if (!is_video(plan_.path)) return keep_pictures("");
  const std::string video = std::string("video") + video_extension(plan_.path);
  if (!encoder_.runs()) {
    if (start_encoder(kPicturePattern, video)) return std::nullopt;
    return keep_pictures("ffmpeg not found: saved PNG frames instead of " + plan_.path + ". ");
  }
  const std::optional<int> status = encoder_.ended();
  if (!status) return std::nullopt;
  const fs::path made = folder_->staging() / video;
  std::error_code failed;
  if (*status != 0 || !fs::exists(made, failed))
    return keep_pictures(
        fmt::format("ffmpeg failed ({}): saved PNG frames instead of {}. ", encoder_words(), plan_.path));
  TargetFile(plan_.path).take(made);
  return VideoMade{fmt::format("Wrote {} with {} frames", fs::absolute(plan_.path).string(), taken_), true};
}

}  // namespace taxel::studio
