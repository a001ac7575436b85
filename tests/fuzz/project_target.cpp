// Projects.
#include "core/document/project.h"
#include "fuzz/target.h"

namespace taxel::fuzz {
namespace {

void run(const std::string& input) {
  read_and_write_again(
      input, [](const std::string& text) { return parse_project(text, "input.taxelproj"); },
      [](const auto& value) { return project_to_json(value); });
}

const Registered kTarget("project", run);

}  // namespace
}  // namespace taxel::fuzz
