#include "app/studio/nouns/video/video_maker.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "app/studio/host/png.h"
#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/os/find_program.h"
#include "core/base/output.h"
#include "ui/widgets/format.h"

namespace taxel::studio {
namespace {

constexpr int kMinSide = 16, kMaxSide = 8192;  // [pixels]; OpenGL 4.1 has at least 16384
constexpr std::size_t kMaxFrames = 100'000;
// Bytes per pixel at most; measured: 0.6, 0.1 and 0.02.
constexpr double kImageBytesPerPixel = 1.0, kVideoBytesPerPixel = 0.2, kFilmBytesPerPixel = 0.1;
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

/// A format, with the extension that names it.
struct FormatRow {
  ui::VideoFormat format;
  const char* extension;
};
constexpr std::array kNamedFormats{FormatRow{ui::VideoFormat::webp, ".webp"}, FormatRow{ui::VideoFormat::mp4, ".mp4"},
                                   FormatRow{ui::VideoFormat::gif, ".gif"}};

/// Returns the extension of a format; empty for images.
const char* video_extension(ui::VideoFormat format) {
  for (const FormatRow& row : kNamedFormats)
    if (row.format == format) return row.extension;
  return "";
}

}  // namespace

ui::VideoFormat format_of(const std::string& path) {
  for (const FormatRow& row : kNamedFormats)
    if (path.ends_with(row.extension)) return row.format;
  return ui::VideoFormat::png;
}

bool needs_encoder(ui::VideoFormat format) {
  return format == ui::VideoFormat::mp4 || format == ui::VideoFormat::gif;
}

std::string with_format(const std::string& path, ui::VideoFormat format) {
  std::string name = path.substr(0, path.size() - std::string_view(video_extension(format_of(path))).size());
  if (name.empty() || name.back() == '/') name += "video";
  return name + video_extension(format);
}

StepRange chosen_steps(const ui::VideoState& settings) {
  const ui::VideoSource& source = settings.source;
  switch (settings.steps) {
    case ui::VideoSteps::contact:
      return source.contact.value_or(source.steps);
    case ui::VideoSteps::period:
      return source.period.value_or(source.steps);
    case ui::VideoSteps::all:
      break;
  }
  return source.steps;
}

VideoPlan plan_video(const std::string& path, const StepRange& steps, const ui::VideoState& settings) {
  const Size size = size_of(settings);
  VideoPlan plan{path,
                 {},
                 size.width,
                 size.height,
                 settings.rate,
                 settings.window,
                 settings.source.timestep,
                 !settings.window && settings.annotated,
                 !settings.window && settings.bars,
                 !settings.window && settings.orbit};
  for (std::uint64_t step = steps.first; step <= steps.last; step += static_cast<std::uint64_t>(settings.every))
    plan.steps.push_back(step);
  return plan;
}

VideoPlan plan_film(const std::string& path, const StepRange& steps, const ui::VideoState& settings) {
  const Size size = settings.size == ui::VideoSize::view ? Size{1920, 1080} : size_of(settings);
  VideoPlan plan{path, {}, size.width, size.height, kFilmRate, false, 0, true, true, true};
  for (std::uint64_t i = 0; i < kFilmFrames; ++i)
    plan.steps.push_back(steps.first + (steps.last - steps.first) * i / (kFilmFrames - 1));
  return plan;
}

double estimated_bytes(const VideoPlan& plan) {
  const double pixels = static_cast<double>(plan.width) * plan.height * static_cast<double>(plan.steps.size());
  if (format_of(plan.path) == ui::VideoFormat::webp) return pixels * kFilmBytesPerPixel;
  return pixels * (kImageBytesPerPixel + (format_of(plan.path) == ui::VideoFormat::png ? 0 : kVideoBytesPerPixel));
}

namespace {

/// Returns how fast a plan shows the run: " in real time" or " at 0.5 x real time"; empty if unknown.
std::string speed_text(const VideoPlan& plan) {
  if (!(plan.timestep > 0) || plan.steps.size() < 2) return "";
  const double speed = static_cast<double>(plan.steps[1] - plan.steps[0]) * plan.timestep * plan.rate;
  if (std::abs(speed - 1) < 0.005) return " in real time";
  return fmt::format(" at {:.2g} x real time", speed);
}

}  // namespace

std::string plan_text(const VideoPlan& plan) {
  const auto count = static_cast<long long>(plan.steps.size());
  const std::string size = plan.window ? "size of the window" : fmt::format("{} x {} pixels", plan.width, plan.height);
  return fmt::format("{} {}, {:.1f} s{}, {}, at most {}", ui::grouped(count), count == 1 ? "frame" : "frames",
                     static_cast<double>(count) / plan.rate, speed_text(plan), size,
                     ui::bytes_text(estimated_bytes(plan)));
}

std::string why_no_video(const VideoPlan& plan, bool has_encoder) {
  const ui::VideoFormat format = format_of(plan.path);
  if (needs_encoder(format) && !has_encoder)
    return fmt::format("{} needs ffmpeg, which is not installed: install ffmpeg, or choose WebP or PNG frames",
                       format == ui::VideoFormat::mp4 ? "MP4" : "GIF");
  if (plan.steps.empty()) return "there is no recorded step: run the scene first (Space)";
  if (plan.steps.size() > kMaxFrames)
    return fmt::format("a video has at most {} frames, these are {}: raise \"Frame every N steps\"", kMaxFrames,
                       plan.steps.size());
  if (std::min(plan.width, plan.height) < kMinSide || std::max(plan.width, plan.height) > kMaxSide)
    return fmt::format("width and height must be {} to {} pixels, are {} x {}: choose another size", kMinSide, kMaxSide,
                       plan.width, plan.height);
  if (format == ui::VideoFormat::webp && plan.rate > kMaxWebpRate)
    return fmt::format(
        "a WebP film has at most {} frames per second for browsers, these are {}: lower \"Frame rate "
        "(fps)\"",
        kMaxWebpRate, plan.rate);
  return "";
}

std::string why_no_video(const ui::VideoState& settings, const std::string& path) {
  const ui::VideoSource& source = settings.source;
  VideoPlan plan = plan_video(path, chosen_steps(settings), settings);
  if (plan.window) plan.width = plan.height = kMaxSide;  // that of the window is good
  const std::string why = why_no_video(plan, source.has_encoder);
  if (!why.empty() || settings.steps != ui::VideoSteps::period || source.period) return why;
  return fmt::format("no step is recorded from {:.6g} s to {:.6g} s: type times from {:.6g} s to {:.6g} s",
                     settings.from, settings.to, source.begin, source.end);
}

void check_plan(const VideoPlan& plan, double free_bytes) {
  constexpr bool kHasEncoder = true;  // VideoMaker looks for it later
  if (const std::string why = why_no_video(plan, kHasEncoder); !why.empty()) throw Error(plan.path, why);
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

/// Returns whether a path names a file that ffmpeg makes.
bool is_encoded(const std::string& path) {
  return needs_encoder(format_of(path));
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

namespace {

/// Throws Error if a file cannot be written: a temporary file in its folder is made and removed.
void check_folder_of(const fs::path& file) {
  const TargetFile target(file);
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  const TemporaryPath probe(folder, file.filename().string() + ".", os::Open::create);
  if (!probe.file().is_open()) throw Error(file.string(), "cannot be written: " + os::error_text(probe.file().error()));
}

}  // namespace

VideoMaker::VideoMaker(VideoPlan plan, std::uint64_t shown, JobExecutor& executor)
    : plan_(std::move(plan)), shown_(shown) {
  queue_ = std::make_unique<ImageQueue>(executor, [this](const gl::RgbImage& image) { write_image(image); });
  const bool is_encoded_later = is_encoded(plan_.path);
  folder_name_ = is_encoded_later ? fs::path(plan_.path).replace_extension("").string() + "_frames"
                                  : fs::path(plan_.path).string();
  check_plan(plan_, free_bytes(folder_name_));
  if (const std::string why = why_no_video(plan_, os::has_program("ffmpeg")); !why.empty())
    throw Error(plan_.path, why);
  const bool is_film = format_of(plan_.path) == ui::VideoFormat::webp;
  try {
    if (is_film)
      check_folder_of(plan_.path);
    else
      folder_ = std::make_unique<OutputFolder>(folder_name_);
  } catch (const Error& error) {
    throw Error(error.file(), error.where(), error.message() + ": choose another folder");
  }
  if (is_film) film_ = std::make_unique<WebpFilm>(plan_.width, plan_.height);
  is_tried_ = !is_encoded_later;
}

std::string VideoMaker::sample_file() const {
  return is_encoded(plan_.path) ? (folder_->staging() / kSampleName).string() : "";
}

bool VideoMaker::is_ready() {
  if (is_tried_) return true;
  const std::string video = std::string("sample") + video_extension(format_of(plan_.path));
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

int VideoMaker::begin_ms(std::size_t image) const {
  return static_cast<int>(std::lround(1000.0 * static_cast<double>(image) / plan_.rate));
}

/// Encodes the next image, on a worker.
void VideoMaker::write_image(const gl::RgbImage& image) {
  if (film_)
    film_->add(image, begin_ms(written_));
  else
    write_png(folder_->staging() / fmt::format(fmt::runtime(kPictureName), written_ + 1), image);
  ++written_;
}

void VideoMaker::add(gl::RgbImage image) {
  queue_->check();
  queue_->add(std::move(image));
  ++taken_;
}

ui::VideoProgress VideoMaker::progress() const {
  return {true, !is_tried_, is_tried_ && (encoder_.runs() || !wanted()), taken_, plan_.steps.size()};
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

VideoMade VideoMaker::write_film() {
  const std::string bytes = film_->finish(begin_ms(taken_));
  TargetFile(plan_.path).write(bytes);
  return {fmt::format("Wrote {} with {} frames, {}", fs::absolute(plan_.path).string(), taken_,
                      ui::bytes_text(static_cast<double>(bytes.size()))),
          true};
}

/// Starts ffmpeg on the images, or polls it.
std::optional<VideoMade> VideoMaker::run_encoder() {
  const std::string video = std::string("video") + video_extension(format_of(plan_.path));
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

std::optional<VideoMade> VideoMaker::finish() {
  queue_->check();
  if (!queue_->is_empty()) return std::nullopt;
  if (film_) return write_film();
  if (is_encoded(plan_.path)) return run_encoder();
  return keep_pictures("");
}

}  // namespace taxel::studio
