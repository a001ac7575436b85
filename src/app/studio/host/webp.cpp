#include "app/studio/host/webp.h"

#include <webp/encode.h>
#include <webp/mux.h>

#include <algorithm>

#include "core/base/error.h"

namespace taxel::studio {
namespace {

// At this quality 5 s of 1000 x 600 pixels of a pressed finger take less than 5 MB. Without the slower conversion of
// colours, the worst edges of coloured lines are off by a third more. Every image depends on the images since the last
// key image, so that a player that jumps decodes at most these.
constexpr float kQuality = 80;
constexpr int kEffort = 4, kKeyImageEvery = 25;

struct FreePicture {
  void operator()(WebPPicture* picture) const { WebPPictureFree(picture); }
};

}  // namespace

struct WebpFilm::Impl {
  WebPAnimEncoder* encoder = nullptr;
  WebPConfig config{};

  Impl(int width, int height) {
    WebPAnimEncoderOptions options{};
    if (WebPAnimEncoderOptionsInit(&options) == 0 || WebPConfigInit(&config) == 0)
      throw Error("libwebp has another version than this program was built with: install the libwebp of the system");
    options.kmax = kKeyImageEvery;
    options.kmin = kKeyImageEvery - 1;
    config.quality = kQuality;
    config.method = kEffort;
    config.use_sharp_yuv = 1;
    if (std::max(width, height) <= WEBP_MAX_DIMENSION) encoder = WebPAnimEncoderNew(width, height, &options);
    if (encoder == nullptr) throw Error("libwebp makes no film of this size: choose a smaller size");
  }
  ~Impl() { WebPAnimEncoderDelete(encoder); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  [[noreturn]] void fail() const { throw Error(std::string("libwebp failed: ") + WebPAnimEncoderGetError(encoder)); }
};

WebpFilm::WebpFilm(int width, int height) : impl_(std::make_unique<Impl>(width, height)) {}

WebpFilm::~WebpFilm() = default;

void WebpFilm::add(const gl::RgbImage& image, int begin_ms) {
  WebPPicture picture;
  if (WebPPictureInit(&picture) == 0) impl_->fail();
  const std::unique_ptr<WebPPicture, FreePicture> freed(&picture);
  picture.use_argb = 1;
  picture.width = image.width;
  picture.height = image.height;
  if (WebPPictureImportRGB(&picture, image.rgb.data(), 3 * image.width) == 0)
    throw Error("there is not enough memory for an image of the film: choose a smaller size");
  if (WebPAnimEncoderAdd(impl_->encoder, &picture, begin_ms, &impl_->config) == 0) impl_->fail();
}

std::string WebpFilm::finish(int end_ms) {
  if (WebPAnimEncoderAdd(impl_->encoder, nullptr, end_ms, nullptr) == 0) impl_->fail();
  WebPData data;
  WebPDataInit(&data);
  if (WebPAnimEncoderAssemble(impl_->encoder, &data) == 0) impl_->fail();
  std::string bytes(reinterpret_cast<const char*>(data.bytes), data.size);
  WebPDataClear(&data);
  return bytes;
}

}  // namespace taxel::studio
