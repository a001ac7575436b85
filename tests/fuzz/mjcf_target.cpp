// MJCF as far as the project handles its text: attributes that MuJoCo has dropped, and attribute values that are
// changed.
#include <algorithm>

#include "core/sim/scene/current_mjcf.h"
#include "core/sim/scene/mjcf_text.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  std::vector<std::string> notes;
  const std::string current = without_dropped_attributes(input, "input.xml", notes);
  require(!notes.empty() || current == input, "text without dropped attributes stays as it is");
  const std::size_t count = notes.size();
  require(without_dropped_attributes(current, "input.xml", notes) == current && notes.size() == count,
          "no attribute is dropped twice");
  change_attributes(input, [](const XmlAttribute&) { return std::string("a<b"); });
  require(xml_unescaped(xml_escaped(input)) == input, "escaped text is read back");
  xml_unescaped(input);
}

const Registered kTarget("mjcf", run);

}  // namespace
}  // namespace taxel::fuzz
