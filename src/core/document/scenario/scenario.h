// A scenario: how the finger moves against an object in a built scene. Plain values, stored in the project file.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/document/scenario/kinds.h"

namespace taxel {

/// How the finger moves. In all kinds except Drop, a weld holds the finger to a mocap body. To add a kind, add its
/// struct to kinds.h, its alternative here, and its overload of lead_finger() (core/run/motion/motion.h).
using ScenarioMotion =
    std::variant<scenarios::Sweep, scenarios::Press, scenarios::Roll, scenarios::Twist, scenarios::Slide,
                 scenarios::Drop, scenarios::Path, scenarios::Replay, scenarios::Paper>;

/// A kind of scenario: the index of an alternative of ScenarioMotion.
enum class ScenarioKind : std::size_t {};

namespace scenarios {

template <std::size_t... I>
constexpr auto kind_words(std::index_sequence<I...>) {
  return std::array{Word<ScenarioKind>{ScenarioKind{I}, std::variant_alternative_t<I, ScenarioMotion>::kWord}...};
}
inline constexpr auto kWords = kind_words(std::make_index_sequence<std::variant_size_v<ScenarioMotion>>());

}  // namespace scenarios

constexpr std::span<const Word<ScenarioKind>> words_of(ScenarioKind) {
  return scenarios::kWords;
}

/// The kind of a type: kKind<scenarios::Press>.
template <class Kind>
inline constexpr ScenarioKind kKind =
    std::ranges::find(scenarios::kWords, Kind::kWord, &Word<ScenarioKind>::text)->value;

/// One scenario of a project. Lengths are in metres, poses in the world frame.
struct Scenario {
  double timestep = 0.001;                ///< [s]; not used by a replay
  double finger_mass = 0.020;             ///< [kg]
  double box_size = 0.050;                ///< size of the object, see ObjectShape [m]
  double edge_radius = 0.001;             ///< radius of the rounded edge of an `edge` [m]
  std::string object = {};                ///< mesh file of the object; empty if the object is `shape`
  ObjectShape shape = ObjectShape::edge;  ///< shape of the object without a mesh file
  ScenarioMotion motion = {};             ///< the kind and its values

  [[nodiscard]] ScenarioKind kind() const { return ScenarioKind{motion.index()}; }
  template <class Kind>
  [[nodiscard]] bool is() const {
    return std::holds_alternative<Kind>(motion);
  }
  /// The values of the kind. Throws std::bad_variant_access if the scenario is of another kind.
  template <class Kind>
  [[nodiscard]] Kind& as() {
    return std::get<Kind>(motion);
  }
  template <class Kind>
  [[nodiscard]] const Kind& as() const {
    return std::get<Kind>(motion);
  }
  bool operator==(const Scenario&) const = default;
};

/// Calls v(FieldSpec, value&) for each field that the scenario uses, in the order of the inspector. Values are numbers,
/// texts and lists of waypoints. `shape` and `object` are not fields.
template <class S, class V>
void visit_fields(S& scenario, const V& v) {
  const auto visit = [&](auto& motion) {
    using Kind = std::remove_cvref_t<decltype(motion)>;
    Kind::visit(motion, v);
    if constexpr (Kind::kHasObject) {
      v(FieldSpec{"box_size", "Object size",
                  "Edges of a box, sides of a plate (a tenth as thick), diameter of a sphere", FieldQuantity::length,
                  FieldRange::positive},
        scenario.box_size);
      if (scenario.shape == ObjectShape::edge)
        v(FieldSpec{"edge_radius", "Edge radius", "Of the round on the edge that points up", FieldQuantity::length,
                    FieldRange::positive},
          scenario.edge_radius);
    }
    v(FieldSpec{"finger_mass", "Finger mass", "Of the whole finger", FieldQuantity::mass, FieldRange::positive},
      scenario.finger_mass);
    Kind::visit_rows(motion, v);
    if constexpr (Kind::kHasTimestep)
      v(FieldSpec{"timestep", "Time step", "Of the simulation", FieldQuantity::interval, FieldRange::positive},
        scenario.timestep);
  };
  std::visit(visit, scenario.motion);
}

/// A number of a scenario. Pointers are valid until the scenario is assigned to.
struct ScenarioNumber {
  FieldSpec field;
  double* value = nullptr;
};

/// Returns the numbers that the scenario uses, in the order of files.
std::vector<ScenarioNumber> numbers_of(Scenario& scenario);

/// Returns the number with this key, or null if the scenario does not use the key.
double* find_number(Scenario& scenario, std::string_view key);
inline const double* find_number(const Scenario& scenario, std::string_view key) {
  return find_number(const_cast<Scenario&>(scenario), key);  // the reference is not written to
}

/// Returns the keys of the files that a scenario names, and their paths. A path is empty if there is no file.
std::vector<std::pair<std::string, std::string*>> files_of(Scenario& scenario);

/// Returns true if the user chooses the object.
bool has_object(const Scenario& scenario);

/// Returns the shape of the default object: `edge` for a sweep, `box` for all other kinds.
ObjectShape default_shape(ScenarioKind kind);

/// Returns the default scenario of a kind, with its default object.
Scenario default_scenario(ScenarioKind kind);

/// Returns `scenario` with another shape as its object. `before` and `past` of a sweep change with the shape if they
/// have the default values of the former shape.
Scenario with_shape(Scenario scenario, ObjectShape shape);

/// Returns `scenario` with a mesh file as its object, or with `box` if `file` is empty.
Scenario with_object(Scenario scenario, const std::string& file);

/// The last scenario of each kind. A change of the kind starts from these values.
using LastScenarios = std::map<ScenarioKind, Scenario>;

/// Returns `scenario` as another kind. Numbers that both kinds use are copied, except a default that differs between
/// the kinds. The object changes if it is the default object of the former kind, unless the poses of the new kind
/// belong to it. Other values are those of `last`, which is updated, or the defaults of the kind.
Scenario with_kind(const Scenario& scenario, ScenarioKind kind, LastScenarios& last);
Scenario with_kind(const Scenario& scenario, ScenarioKind kind);

// Reads and writes scenarios as JSON: in project files, scenario files, and the sweep.json of recordings.

/// Returns one JSON object with the values that the scenario uses, in SI units, with shortest round-trip numbers and no
/// newline at the end. A sweep on a box names neither kind nor shape, because older files do not have these keys.
std::string scenario_to_json(const Scenario& scenario);

/// Returns the text of a scenario file: {"format": "taxel-scenario", "version": 1, "scenario": {...}}.
std::string scenario_file_json(const Scenario& scenario);

/// Reads a scenario object, or a document with a scenario under "scenario" (a scenario file, a sweep.json). Missing
/// values have the defaults of a box: without `shape`, the object is a box, also in a sweep. Throws
/// Error(file, JSON pointer, message) for keys that the kind does not use, wrong types, values out of range, and an
/// unknown version of "taxel-scenario".
Scenario parse_scenario(const std::string& text, const std::string& file = "");
/// Reads a file by parse_scenario, without changing its paths.
Scenario read_scenario(const std::filesystem::path& path);
/// Reads a file by parse_scenario and makes its paths absolute.
Scenario read_scenario_with_files(const std::filesystem::path& path);
/// Returns the scenario with absolute paths (object, source). Its paths are relative to the folder of `file`.
Scenario with_absolute_files(Scenario scenario, const std::filesystem::path& file);

/// Throws Error("", "/key", ...) for the first value that is not valid.
void check_scenario(const Scenario& scenario);

}  // namespace taxel
