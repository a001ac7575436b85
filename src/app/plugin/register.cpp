// The module's only entry: MuJoCo runs it when it loads the library.
#include "core/sim/plugin/plugin_table.h"

mjPLUGIN_LIB_INIT(taxel_sensor) {
  taxel::register_sensor_plugin();
}
