// Paths as texts of Python.
#pragma once

#include <nanobind/nanobind.h>

#include <string>

namespace taxel::python {

/// Returns a path, which need not be UTF-8, as os.fsdecode() does.
inline nanobind::str path_text(const std::string& path) {
  return nanobind::steal<nanobind::str>(
      PyUnicode_DecodeFSDefaultAndSize(path.data(), static_cast<Py_ssize_t>(path.size())));
}

}  // namespace taxel::python
