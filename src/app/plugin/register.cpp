// The only entry point of the plugin library. MuJoCo calls it when it loads the library.
#include "core/sim/plugin/plugin_table.h"

mjPLUGIN_LIB_INIT(taxel_sensor) {
  taxel::register_sensor_plugin();
}
