#include "core/run/batch/streamed_file.h"

#include <fmt/format.h>

#include "core/base/error.h"
#include "core/base/files.h"

namespace taxel {

StreamedFile::StreamedFile(std::filesystem::path path) : path_(std::move(path)) {
  make_folder(path_.parent_path());
  file_ = os::File(path_, os::Open::create);
  if (!file_.is_open()) fail(file_.error());
}

void StreamedFile::fail(int why) const {
  throw Error(path_.string(), fmt::format("writing failed: {}", os::error_text(why)));
}

void StreamedFile::write(std::string_view bytes) {
  if (const int why = file_.write(bytes); why != 0) fail(why);
}

void StreamedFile::finish() {
  if (const int why = file_.sync(); why != 0) fail(why);
  file_.close();
}

}  // namespace taxel
