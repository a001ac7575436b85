// Saved steps (.taxelframe): the input is a list of members (members.h), so that checksums never stop a fuzzer.
#include "core/layout/file/layout_json.h"
#include "core/run/bundle/frame_bundle.h"
#include "fuzz/members.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

/// Returns whether the layout has few samples. A layout with many samples takes seconds to compile, which is correct
/// but slow.
bool is_quick(const NpzReader& in) {
  const std::string name = "sensor0/layout";
  if (!in.has(name)) return true;
  const Layout layout = parse_layout(in.text(name), in.file());
  return layout.sampling.density <= 1e6 && layout.taxels.size() <= 16;
}

void run(const std::string& input) {
  const auto frame = read_or_refuse([&] {
    const NpzReader in(archive_of(input));
    return is_quick(in) ? read_frame_bundle(in) : nullptr;
  });
  if (!frame || *frame == nullptr) return;
  const std::string written = frame_to_bundle(**frame);
  const SimFramePtr again = read_frame_bundle(NpzReader(ZipArchive("again.taxelframe", written)));
  require(frame_to_bundle(*again) == written, "a step that is read can be written and read again");
}

const Registered kTarget("frame", run);

}  // namespace
}  // namespace taxel::fuzz
