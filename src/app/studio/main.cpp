// taxelstudio: the window.
#include "app/studio/shell/program.h"
#include "core/base/os/process.h"
#include "core/sensor/sensor_cache.h"

int main(int argc, char** argv) {
  taxel::os::prepare_process();
  taxel::SensorCache cache;
  return taxel::studio::run_program(argc, argv, cache);
}
