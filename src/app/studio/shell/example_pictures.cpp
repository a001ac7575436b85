// The pictures of the examples, decoded by stb_image.
#include <memory>
#include <string_view>

#include "app/studio/host/examples.h"
#include "app/studio/shell/studio.h"
#include "core/base/error.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wcast-align"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#include <stb_image.h>
#pragma GCC diagnostic pop

namespace taxel::studio {

std::string_view embedded_file(std::string_view name);

namespace {

std::unique_ptr<gl::Texture> texture_of(const std::string& name) {
  const std::string_view bytes = embedded_file(name);
  int width = 0, height = 0, channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()), static_cast<int>(bytes.size()), &width,
                            &height, &channels, 4),
      stbi_image_free);
  if (!pixels) throw Error(name, "is no picture that this program can draw");
  auto texture = std::make_unique<gl::Texture>(GL_RGBA8, width, height);
  texture->upload(GL_RGBA, GL_UNSIGNED_BYTE, pixels.get());
  return texture;
}

}  // namespace

ExamplePictures::ExamplePictures() {
  for (const Example& example : examples()) {
    if (example.picture.empty()) continue;
    textures_.push_back(texture_of(example.picture));
    const gl::Texture& texture = *textures_.back();
    tiles_.push_back({example.label, example.tip, example.name, texture.id(),
                      static_cast<float>(texture.width()) / static_cast<float>(texture.height())});
  }
}

}  // namespace taxel::studio
