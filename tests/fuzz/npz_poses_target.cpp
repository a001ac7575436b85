// NumPy poses of taxels, in the archives that members.h describes.
#include "core/layout/formats/layout_format.h"
#include "fuzz/layout_reading.h"
#include "fuzz/members.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  const auto layout = read_or_refuse([&] { return layout_of_poses(NpzReader(archive_of(input))); });
  if (layout) check_layouts_read(*find_layout_format("npz"), {*layout});
}

const Registered kTarget("npz_poses", run);

}  // namespace
}  // namespace taxel::fuzz
