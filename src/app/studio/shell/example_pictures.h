// Pictures of the examples as textures, for the card that invites to open something.
#pragma once

#include <memory>
#include <vector>

#include "app/studio/nouns/files/files_state.h"
#include "ui/gl/texture.h"

namespace taxel::studio {

class ExamplePictures {
 public:
  /// Decodes the embedded pictures. Needs the context of OpenGL, and must be destroyed before that.
  ExamplePictures();
  /// Returns a tile for each example that has a picture. The textures live as long as this object.
  [[nodiscard]] const std::vector<ui::ExampleTile>& tiles() const { return tiles_; }

 private:
  std::vector<std::unique_ptr<gl::Texture>> textures_;
  std::vector<ui::ExampleTile> tiles_;
};

}  // namespace taxel::studio
