// Checks of the values of a layout file. Broken rules are listed, not thrown.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "core/base/error.h"
#include "core/base/limits.h"
#include "core/layout/layout.h"

namespace taxel {

/// Collects problems of one file.
class Check {
 public:
  explicit Check(std::string file) : file_(std::move(file)) {}
  void error(const std::string& pointer, const char* code, const std::string& message, const std::string& fix = "") {
    problems.push_back({file_, pointer, Severity::error, code, message, fix});
  }
  void warning(const std::string& pointer, const char* code, const std::string& message, const std::string& fix = "") {
    problems.push_back({file_, pointer, Severity::warning, code, message, fix});
  }
  void note(const std::string& pointer, const char* code, const std::string& message) {
    problems.push_back({file_, pointer, Severity::note, code, message, ""});
  }
  bool positive(const std::string& pointer, double v, const char* code, const std::string& fix = "") {
    if (v > 0.0 && std::isfinite(v)) return true;
    error(pointer, code, fmt::format("must be {}, is {}", std::isfinite(v) ? "greater than 0" : "finite", v), fix);
    return false;
  }
  bool not_negative(const std::string& pointer, double v, const char* code) {
    if (v >= 0.0 && std::isfinite(v)) return true;
    error(pointer, code, fmt::format("must be {}, is {}", std::isfinite(v) ? "0 or more" : "finite", v));
    return false;
  }
  /// Checks a length, which is at most as large as the largest coordinate.
  bool length(const std::string& pointer, double v) {
    if (!(v > kFarthest)) return true;
    error(pointer, "too_far", fmt::format("must be at most {:g} m, is {}", kFarthest, v), "in metres: 6 mm is 0.006");
    return false;
  }
  bool finite(const std::string& pointer, const dvec3& v) {
    if (is_finite(v)) return true;
    error(pointer, "not_finite", fmt::format("must be finite, is [{}, {}, {}]", v.x, v.y, v.z));
    return false;
  }
  bool direction(const std::string& pointer, const dvec3& v) {
    if (!finite(pointer, v)) return false;
    const double length = glm::length(v);
    if (length > 0.0 && std::isfinite(length)) return true;
    error(pointer, "zero_normal", fmt::format("must be a direction, is [{}, {}, {}]", v.x, v.y, v.z));
    return false;
  }
  Problems problems;

 private:
  std::string file_;
};

/// Checks the rules of layout.calibration, which must be set.
void check_calibration(const Layout& layout, Check& check);

}  // namespace taxel
