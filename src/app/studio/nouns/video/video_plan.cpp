#include "app/studio/nouns/video/video_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/base/error.h"
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

}  // namespace taxel::studio
