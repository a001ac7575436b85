// Reads the files from which the Generate panel makes patterns.
#include "app/studio/nouns/files/file_listing.h"
#include "app/studio/nouns/generate/generate.h"
#include "app/studio/nouns/generate/generate_state.h"
#include "app/studio/shell/studio.h"
#include "core/base/files.h"
#include "core/base/text/shown_message.h"

namespace taxel::studio {

void Studio::carry_out(const ui::ReadPoints& command) {
  ui::GenerateState& g = app_.get<ui::GenerateState>();
  const std::string file = std::filesystem::absolute(command.path).string();
  g.file_problem.clear();
  try {
    if (is_picture(file)) {
      g.image = std::make_shared<const GreyImage>(read_grey_image(file));
      g.image_path = file;
      ui::change_kind<patterns::Image>(g);
    } else {
      g.table = std::make_shared<const std::string>(read_file(file));
      g.table_path = file;
      g.table_file = std::filesystem::path(file).filename().string();
      ui::change_kind<patterns::Table>(g);
    }
  } catch (const Error& error) {
    g.file_problem = shown_message(error);
  }
}

}  // namespace taxel::studio
