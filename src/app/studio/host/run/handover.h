// Makes the simulation read by the newest model of the document.
#pragma once

#include <optional>

#include "app/studio/host/document/document.h"
#include "app/studio/host/run/run.h"

namespace taxel::studio {

class Handover {
 public:
  Handover(Document& document, Run& run) : document_(document), run_(run) {}

  /// Requests that the simulation reads by the newest model as soon as it is built.
  void request() { is_wanted_ = true; }
  /// Forgets the request, because another document is open.
  void forget_request() { is_wanted_ = false; }
  /// Forgets everything, because the document is closed.
  void clear() { replacement_.reset(); }
  /// Hands over polished samples of the displayed layout.
  void begin(Polished models) { replacement_ = Replacement{std::move(models)}; }
  /// Sends the newest model to the simulation, if it is requested and built.
  void update(HostEvents& events);
  /// Handles the reply to the command that replaces a model.
  void accept(const SimEvent& event, HostEvents& events);

  [[nodiscard]] bool is_replacing() const { return replacement_.has_value(); }
  /// Whether the simulation reads by a preview's samples that will be replaced. When they are replaced depends on the
  /// load of the machine, so that a step before would read differently from one start to the next.
  [[nodiscard]] bool will_change_samples() const;

 private:
  /// Samples on their way to the view: the simulation reads by them first.
  struct Replacement {
    Polished models;
    CommandId command = 0;  // command that replaces the model, or 0 before it is sent
  };
  void send_newest();
  void send_replacement(HostEvents& events);

  Document& document_;
  Run& run_;
  bool is_wanted_ = false;
  std::optional<Replacement> replacement_;
};

}  // namespace taxel::studio
