// Presses a fingertip onto a box and prints the largest reading of each tactile sensor.
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <string.h>

static void print_sensors(const mjModel* model, const mjData* data) {
  for (int i = 0; i < model->nsensor; ++i) {
    if (model->sensor_type[i] != mjSENS_PLUGIN) continue;
    const int instance = model->sensor_plugin[i];
    if (instance < 0) continue;
    const mjpPlugin* plugin = mjp_getPluginAtSlot(model->plugin[instance]);
    if (strcmp(plugin->name, "taxel.sensor") != 0) continue;
    // The readings in the order of the taxels come first, then wrench and area if `output` has them.
    const char* output = mj_getPluginConfig(model, instance, "output");
    const int other = (strstr(output, "wrench") ? 6 : 0) + (strstr(output, "area") ? 1 : 0);
    const mjtNum* values = data->sensordata + model->sensor_adr[i];
    mjtNum largest = 0;
    for (int k = 0; k < model->sensor_dim[i] - other; ++k) largest = mju_max(largest, values[k]);
    printf("%s: %.10g Pa\n", mj_id2name(model, mjOBJ_SENSOR, i), largest);
  }
}

int main(int argc, char** argv) {
  const char* scene = argc > 1 ? argv[1] : SCENE;
  mj_loadPluginLibrary(PLUGIN);
  char error[1000] = "";
  mjModel* model = mj_loadXML(scene, NULL, error, sizeof error);
  if (model == NULL) {
    fprintf(stderr, "%s\n", error);
    return 1;
  }
  mjData* data = mj_makeData(model);
  for (int step = 0; step < 200; ++step) mj_step(model, data);
  print_sensors(model, data);
  mj_deleteData(data);
  mj_deleteModel(model);
  return 0;
}
