// One `taxel.contact` instance of one mjData: the soft geoms that it declares, with their contacts but without taxels.
#pragma once

#include <mujoco/mujoco.h>

#include <vector>

#include "core/sim/plugin/pairs/body_contacts.h"

namespace taxel {

class ContactInstance {
 public:
  /// Reads the configuration and builds the bodies. Throws Error if a key is not valid.
  ContactInstance(const mjModel& m, int instance);

  [[nodiscard]] const ContactConfig& config() const { return config_; }
  [[nodiscard]] std::vector<BodyContacts>& bodies() { return bodies_; }  ///< one per entry of config().bodies

  /// Retains the present state of all bodies and fills sensordata.
  void sense(const mjModel& m, mjData& d);

 private:
  int instance_ = -1;
  ContactConfig config_;
  std::vector<BodyContacts> bodies_;
};

}  // namespace taxel
