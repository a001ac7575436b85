// Framebuffers and shader sources of OpenGL.
#include <gtest/gtest.h>

#include "core/base/error.h"
#include "ui/gl/framebuffer.h"
#include "ui/gl/offscreen_context.h"
#include "ui/gl/program.h"
#include "ui/scene/paint/mark_pass.h"
#include "ui/scene/passes/passes.h"
#include "ui/scene/picture.h"

namespace taxel::gl {
namespace {

TEST(Framebuffer, ReadsTheTopRowFirst) {
  test::context();
  const Framebuffer target(5, 3);
  target.bind();
  glClearColor(0, 0, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glEnable(GL_SCISSOR_TEST);
  glScissor(1, 2, 2, 1);  // OpenGL counts rows from below
  glClearColor(1, 0.2f, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDisable(GL_SCISSOR_TEST);
  const RgbImage image = target.read();
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const bool marked = y == 0 && (x == 1 || x == 2);
      const std::array<int, 3> expected = marked ? std::array{255, 51, 0} : std::array{0, 0, 255};
      EXPECT_EQ(test::pixel_at(image, dvec2(x, y)), expected) << x << ", " << y;
    }
  }
}

TEST(Framebuffer, ResolvesMultisampling) {
  test::context();
  const Framebuffer target(4, 4, 4);
  target.bind();
  glClearColor(0, 1, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  target.resolve();
  EXPECT_EQ(test::pixel_at(target.read(), dvec2(2, 2)), (std::array{0, 255, 0}));
}

TEST(ShaderSource, IncludesOnceAndKeepsFilesAndLines) {
  const auto read = [](const std::string& name) -> std::string {
    if (name == "a") return "#version 410 core\n#include \"b\"\n#include \"c\"\nlast\n";
    if (name == "b") return "in b\n";
    if (name == "c") return "#include \"b\"\nin c\n";
    throw Error(name, "no such shader");
  };
  const ShaderSource source = assemble_shader(read, "a");
  EXPECT_EQ(source.files, (std::vector<std::string>{"a", "b", "c"}));
  EXPECT_EQ(source.text,
            "#version 410 core\n#line 2\n#line 10001\nin b\n#line 3\n#line 20001\n#line 20002\nin c\n#line 4\nlast\n");
  EXPECT_THROW(assemble_shader(read, "missing"), Error);
  EXPECT_THROW(read_embedded_shader("missing.vert"), Error);
}

TEST(ShaderSource, ParsesTheMessagesOfMesaAndNvidia) {
  const ShaderSource source{"", {"line.frag", "color.glsl"}};
  const ShaderMessage mesa = parse_shader_log("0:10012(5): error: `y' undeclared\n0:3(1): error: more\n", source);
  EXPECT_EQ(mesa.file, "color.glsl");
  EXPECT_EQ(mesa.where, "line 12");
  EXPECT_EQ(mesa.text, "error: `y' undeclared");
  const ShaderMessage nvidia = parse_shader_log("0(7) : error C1503: undefined variable \"y\"", source);
  EXPECT_EQ(nvidia.file, "line.frag");
  EXPECT_EQ(nvidia.where, "line 7");
  EXPECT_EQ(nvidia.text, "error C1503: undefined variable \"y\"");
  const ShaderMessage other = parse_shader_log("Link failed", source);
  EXPECT_EQ(other.file, "line.frag");
  EXPECT_EQ(other.where, "");
  EXPECT_EQ(other.text, "Link failed");
}

/// Returns the image of many lines in all directions and colours, read by shaders in pieces of at most `most`.
RgbImage picture_of_lines(GLsizei most) {
  const Framebuffer target(120, 90);
  target.bind();
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  Buffer frame;
  ui::bind_frame(frame, ui::pixel_frame(120, 90, 1));
  ui::Segments lines;
  for (int i = 0; i < 37; ++i) {
    const std::uint32_t color = 0xff000000U | static_cast<std::uint32_t>(i * 0x061325);
    lines.push_back(ui::segment(dvec3(3 * i, 5, 0), dvec3(110 - 2 * i, 85, 0), 1.5f, color));
  }
  ui::SegmentPass pass(read_embedded_shader, most);
  pass.draw_lines(lines, {.depth_test = false});
  return target.read();
}

TEST(Segments, LookTheSameInPiecesAsTheDriverAllows) {
  test::context();
  const RgbImage whole = picture_of_lines(BufferTexture::max_texels() / 2);
  EXPECT_GT(std::count_if(whole.rgb.begin(), whole.rgb.end(), [](unsigned char c) { return c > 0; }), 3000);
  EXPECT_EQ(picture_of_lines(37), whole);
  EXPECT_EQ(picture_of_lines(10), whole);
  EXPECT_EQ(picture_of_lines(1), whole);
}

TEST(Texture, LeavesTheTexturesAndFramebuffersThatAreBound) {
  test::context();
  const Texture first(GL_RGBA8, 4, 4);
  first.bind(0);
  const Texture second(GL_R8, 2, 2);
  const std::array<unsigned char, 4> pixels{1, 2, 3, 4};
  second.upload(GL_RED, GL_UNSIGNED_BYTE, pixels.data());
  GLint bound = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_2D, &bound);
  EXPECT_EQ(bound, static_cast<GLint>(first.id()));
  const Framebuffer one(4, 4), other(4, 4);
  one.bind();
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  GLint after = 0;
  other.copy_color(one);
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &after);
  EXPECT_EQ(after, bound);
  glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &after);
  EXPECT_EQ(after, bound);
}

TEST(Version, NamesTheOfferOfAnOldDriver) {
  EXPECT_EQ(offered_text("3.3 (Core Profile) Mesa 22.3.6", "llvmpipe"), "this machine offers 3.3 from llvmpipe");
  EXPECT_EQ(offered_text("2.1", nullptr), "this machine offers 2.1 from an unknown renderer");
  EXPECT_EQ(offered_text(nullptr, nullptr), "this machine offers no OpenGL at all");
}

}  // namespace
}  // namespace taxel::gl
