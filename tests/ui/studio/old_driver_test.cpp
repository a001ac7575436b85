// Drivers with an older OpenGL, as Mesa pretends to be one: the same images at 4.1, and a clear message below it.
#include <gtest/gtest.h>

#include "fixtures/surroundings.h"
#include "script_lines.h"

namespace taxel::test {
namespace {

/// Mesa with OpenGL 4.1, and without the extensions that later versions made part of the core. Without them, epoxy ends
/// the program at the first function that 4.1 does not have.
std::vector<std::pair<std::string, std::string>> mesa_4_1() {
  std::string without;
  for (const char* name : {"buffer_storage", "clip_control", "shader_storage_buffer_object", "texture_buffer_range",
                           "texture_storage_multisample", "shading_language_420pack", "base_instance",
                           "explicit_uniform_location", "shader_image_load_store", "compute_shader"})
    without += std::string(" -GL_ARB_") + name;
  return {
      {"MESA_GL_VERSION_OVERRIDE", "4.1"}, {"MESA_GLSL_VERSION_OVERRIDE", "410"}, {"MESA_EXTENSION_OVERRIDE", without}};
}

/// Returns lines that show a contact, a cut by the clip plane, the labels and all fields, in a light window too.
Lines pictures_of(const std::string& name) {
  const auto shot = [&](const std::string& what) {
    return R"({"do": "screenshot", "file": ")" + what + "_" + name + R"(.png"})";
  };
  return {R"({"do": "wait_time", "time": 0.05})",
          key("Space"),
          kIdle,
          shot("contact"),
          key("t"),
          R"({"event": "wheel", "at": {"taxel": 3}, "y": 2, "mods": ["shift"]})",
          kIdle,
          shot("cut"),
          kLayoutMode,
          key("a"),
          key("n"),
          kIdle,
          shot("layout")};
}

TEST(OldDriver, DrawsTheSamePicture) {
  const StudioProgram studio;
  studio.play(pictures_of("new"));
  {
    const Surroundings old(mesa_4_1());
    studio.play(pictures_of("old"));
  }
  for (const std::string name : {"contact", "cut", "layout"}) {
    const Picture now = studio.picture(name + "_new.png"), then = studio.picture(name + "_old.png");
    ASSERT_EQ(now.rgb.size(), then.rgb.size());
    int largest = 0;
    for (std::size_t i = 0; i < now.rgb.size(); ++i) largest = std::max(largest, std::abs(now.rgb[i] - then.rgb[i]));
    EXPECT_LE(largest, 1) << name << ": of 255 levels";
  }
  EXPECT_NE(studio.picture("contact_new.png").rgb, studio.picture("cut_new.png").rgb);
}

TEST(OldDriver, IsRefusedBelowTheNeededVersion) {
  const StudioProgram studio;
  const Surroundings old({{"MESA_GL_VERSION_OVERRIDE", "3.3"}, {"MESA_GLSL_VERSION_OVERRIDE", "330"}});
  const Outcome outcome = studio.run({R"({"do": "quit"})"});
  if (outcome.status == 0) GTEST_SKIP() << "the driver is not Mesa, and does not pretend to be an older one";
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("needs OpenGL 4.1, but this machine offers 3.3 from "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("; install "), std::string::npos) << "the remedy";
}

}  // namespace
}  // namespace taxel::test
