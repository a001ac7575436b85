// The fields of the calibration, which models how a device reports the readings.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/studio/frame/window_ui.h"
#include "app/studio/nouns/history/edit_commands.h"
#include "app/studio/nouns/inspector/inspector_state.h"
#include "core/layout/words.h"
#include "ui/widgets/controls.h"
#include "ui/widgets/fields.h"

namespace taxel::ui {

namespace {

constexpr std::uint64_t kLargestNoiseSeed = std::uint64_t{1} << 53U;
/// Upper limit of the field for a number of bits. The core's limit is lower.
constexpr double kMostBits = 1000;
constexpr const char* kRaw = "unit of the raw readings";
constexpr const char* kReported = "unit of the reported value";

/// Rows of one calibration. `changed` is true if the user changed any of the fields.
struct Rows {
  WindowUi& ui;
  Calibration& calibration;
  bool changed = false;

  void number(const char* name, const std::string& tip, double& value, const FieldUnit& unit = kExactNumber) {
    begin_property(name, tip);
    if (const auto typed = number_field(ui, name, {value}, unit)) {
      value = *typed;
      changed = true;
    }
    show_refusal(ui, name);
  }
  /// Draws the field of an optional number. An empty field means no number.
  std::optional<std::optional<double>> optional(const char* name, const std::string& tip,
                                                const std::optional<double>& value) {
    begin_property(name, tip);
    const auto typed = optional_field(ui, name, value, kExactNumber);
    changed = changed || typed.has_value();
    show_refusal(ui, name);
    return typed;
  }
  /// Draws the switch of an optional part of the calibration.
  template <class Part>
  void part(const char* name, const std::string& tip, std::optional<Part>& part, const Part& usual) {
    begin_property(name, tip);
    const auto on = switch_field(ui, name, part.has_value());
    show_refusal(ui, name);
    if (!on) return;
    part = *on ? std::optional<Part>(usual) : std::nullopt;
    changed = true;
  }
};

void draw_gain(Rows& rows, const Layout& layout) {
  Calibration& c = rows.calibration;
  begin_property("Reported unit", "Name of the unit that the device reports; empty: that of the readings");
  if (const auto unit = text_field(rows.ui, "Reported unit", {c.unit})) {
    c.unit = *unit;
    rows.changed = true;
  }
  if (const auto gain = rows.optional(
          "Gain", fmt::format("Reported units per {}; empty: 1", reading_unit(layout.readout.aggregate)), c.gain))
    c.gain = *gain;
  if (!c.curve.empty()) property("Curve", fmt::format("{} points, from the file", c.curve.size()));
  rows.number("Gain deviation", "Standard deviation between taxels, relative to the gain", c.gain_deviation);
  rows.part("Tare", "Value that the device subtracts from every reading", c.tare, Tare{});
  if (c.tare) {
    begin_property("First reading", "Each taxel's reading at the start is its tare");
    if (const auto first = switch_field(rows.ui, "First reading", c.tare->first_reading)) {
      c.tare->first_reading = *first;
      rows.changed = true;
    }
    if (!c.tare->first_reading) rows.number("Tare value", kRaw, c.tare->value);
  }
  rows.number("Tare deviation", fmt::format("Standard deviation between taxels, {}", kRaw), c.tare_deviation);
}

/// Draws the stages that depend on time.
void draw_dynamics(Rows& rows) {
  Calibration& c = rows.calibration;
  if (c.response) {
    const std::size_t points = c.response->points.size(), powers = c.response->polynomial.size();
    property("Response", points > 0 ? fmt::format("{} points, from the file", points)
                                    : fmt::format("polynomial of {} factors, from the file", powers));
  }
  begin_property("Relaxation", "Readings of a constant load decay by exponentials; forces do not change");
  if (const auto on = switch_field(rows.ui, "Relaxation", !c.relaxation.empty())) {
    c.relaxation = *on ? std::vector<RelaxationArm>{{0.1, 1}, {0.1, 5}} : std::vector<RelaxationArm>{};
    rows.changed = true;
  }
  for (std::size_t i = 0; i < c.relaxation.size(); ++i) {
    const std::string arm = fmt::format("Arm {} ", i + 1);
    rows.number((arm + "amplitude").c_str(), "Fraction of the reading that is lost in the end, 0 to 1",
                c.relaxation[i].amplitude);
    rows.number((arm + "time (s)").c_str(), "Time constant", c.relaxation[i].time);
  }
  rows.part("Low pass", "Filter of first order", c.low_pass, LowPass{0.01, {}});
  if (c.low_pass && c.low_pass->time) rows.number("Time constant (s)", "Of the low pass", *c.low_pass->time);
  if (c.low_pass && c.low_pass->cutoff)
    rows.number("Cut-off (Hz)", "Frequency at which the amplitude falls to 0.707", *c.low_pass->cutoff);
  rows.number("Latency (s)", "Delay of the reported values, to the nearest step", c.latency);
}

void draw_errors(Rows& rows) {
  Calibration& c = rows.calibration;
  rows.number("Noise", fmt::format("Standard deviation between values, {}", kReported), c.noise);
  rows.part("Hysteresis", "Loading and unloading report different values", c.hysteresis, Hysteresis{});
  if (c.hysteresis) {
    rows.number("Loop width", kRaw, c.hysteresis->width);
    rows.number("Loop fraction", "Of the reading that goes through the loop, 0 to 1", c.hysteresis->fraction);
    if (const std::size_t more = c.hysteresis->plays.size(); more > 0)
      property("Further loops", fmt::format("{}, from the file", more));
  }
  rows.part("Crosstalk", "Neighbours' readings are added", c.crosstalk, Crosstalk{0.1, Taxel{}.radius});
  if (c.crosstalk) {
    rows.number("Crosstalk fraction", "Of a neighbour's reading at distance 0, 0 to 1", c.crosstalk->fraction);
    rows.number("Crosstalk reach (mm)", "Distance of centres from which nothing is added", c.crosstalk->reach,
                kExactMillimetres);
  }
  if (!c.crosstalk_matrix.empty())
    property("Crosstalk matrix", fmt::format("{} rows, from the file", c.crosstalk_matrix.size()));
  rows.part("Dead taxels", "Some taxels report one value always", c.dead, DeadTaxels{});
  if (c.dead) {
    rows.number("Dead fraction", "Chance of each taxel, 0 to 1", c.dead->fraction);
    rows.number("Dead value", kReported, c.dead->value);
  }
}

void draw_output(Rows& rows) {
  Calibration& c = rows.calibration;
  rows.part("Range", "Reported values are clamped to this range", c.range, ValueRange{0, 1});
  if (c.range) {
    rows.number("Range low", kReported, c.range->low);
    rows.number("Range high", kReported, c.range->high);
  }
  const Quantisation q = c.quantisation.value_or(Quantisation{});  // a copy, because a field below may replace it
  if (const auto step =
          rows.optional("Step", fmt::format("Values are whole multiples of it, {}; empty: none", kReported), q.step)) {
    c.quantisation = *step ? std::optional(Quantisation{*step, std::nullopt}) : std::nullopt;
  }
  const std::optional<double> bits = q.bits ? std::optional<double>(*q.bits) : std::nullopt;
  if (const auto typed = rows.optional("Bits", "2^bits levels over the range; empty: none", bits)) {
    const bool whole = !*typed || (**typed == std::floor(**typed) && std::abs(**typed) < kMostBits);
    if (!whole) refuse(rows.ui, "must be a whole number");
    rows.changed = rows.changed && whole;
    c.quantisation.reset();
    if (*typed && whole) c.quantisation = Quantisation{std::nullopt, static_cast<int>(**typed)};
  }
  if (const auto rate = rows.optional("Rate (Hz)", "Values per second; empty: every step", c.rate)) c.rate = *rate;
  begin_property("Calibration seed", "The same seed gives the same noise and the same dead taxels");
  if (const auto seed = whole_field(rows.ui, "Calibration seed", c.seed, kLargestNoiseSeed)) {
    c.seed = *seed;
    rows.changed = true;
  }
  show_refusal(rows.ui, "Calibration seed");
  if (!c.taxels.empty()) property("Of their own", fmt::format("{} taxels, from the file", c.taxels.size()));
}

}  // namespace

void draw_calibration_settings(WindowUi& ui, const Layout& layout) {
  if (!header(ui, "Calibration") || !begin_properties("calibration")) return;
  begin_property("Calibrated", "Also record values as a device would report them");
  if (const auto on = switch_field(ui, "Calibrated", layout.calibration.has_value())) {
    SetCalibration edit;
    if (*on) edit.calibration.emplace();
    post_edit(ui, edit);
  }
  if (layout.calibration) {
    Calibration calibration = *layout.calibration;
    Rows rows{ui, calibration};
    draw_gain(rows, layout);
    draw_dynamics(rows);
    draw_errors(rows);
    draw_output(rows);
    if (rows.changed) post_edit(ui, SetCalibration{calibration});
  }
  end_properties();
}

}  // namespace taxel::ui
