// scenario_text(): scenarios are checked in the caller's process before a program plays them.
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include "app/python/nouns.h"
#include "core/document/scenario/scenario.h"

namespace taxel::python {

void add_scenario(nanobind::module_& m) {
  namespace nb = nanobind;
  m.def(
      "scenario_text",
      [](const std::string& text, const std::filesystem::path& file) {
        return scenario_file_json(with_absolute_files(parse_scenario(text, file.string()), file));
      },
      nb::arg("text"), nb::arg("file"),
      "Checks the JSON text of a scenario. Returns the text of a scenario file with absolute paths, which are relative "
      "to the folder of `file` before. Raises Error.");
}

}  // namespace taxel::python
