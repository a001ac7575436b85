// Open files that other programs change, and the remedies.
#pragma once

#include <optional>
#include <string>

#include "app/studio/frame/command.h"
#include "app/studio/nouns/files/files_state.h"
#include "core/document/project.h"

namespace taxel::ui {

struct AnswerNotice {
  std::string file;
  std::optional<FileOffer> taken;  ///< empty if all stays as it is
};

}  // namespace taxel::ui

namespace taxel::studio {

void carry_out(const ui::AnswerNotice& command, Host& host);

/// Looks for changes of the open files at a time [s], and reports them.
void watch_files(Host& host, double now);
/// Reports if the opened document was made on a different mesh than the one in its mesh file.
void tell_other_mesh(Host& host);
/// Says which layout asks for a missing mesh, and offers to look for the mesh. The next mesh that is opened is taken.
void offer_to_locate(Host& host, const std::string& layout, const std::string& mesh);
/// Registers a file that this program wrote, so that no change is reported for it. Adds a message if its mesh was
/// written too.
void wrote(Host& host, const std::string& file, const Project& written);
[[nodiscard]] bool has_notice(const Host& host, const std::string& file);

}  // namespace taxel::studio
