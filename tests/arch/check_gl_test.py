#!/usr/bin/env python3
"""Shows that check_gl.py detects functions, constants and shaders above the program's version of OpenGL."""
import pathlib
import tempfile

import check_gl

HEADER = """\
#ifndef GL_VERSION_1_5
#define GL_ARRAY_BUFFER 0x8892
GLAPI void APIENTRY glBindBuffer (GLenum target, GLuint buffer);
#ifndef GL_VERSION_4_1
#define GL_PROGRAM_SEPARABLE 0x8258
GLAPI void APIENTRY glProgramUniform1i (GLuint program, GLint location, GLint v0);
#ifndef GL_VERSION_4_3
#define GL_SHADER_STORAGE_BUFFER 0x90D2
#ifndef GL_VERSION_4_5
GLAPI void APIENTRY glCreateBuffers (GLsizei n, GLuint *buffers);
#ifndef GL_ARB_bindless_texture
GLAPI GLuint64 APIENTRY glGetTextureHandleARB (GLuint texture);
"""
VERSION = {"src/ui/gl/offscreen_context.h": "inline constexpr int kMajor = 4, kMinor = 1;\n"}
BROKEN = {
    "src/ui/gl/objects.h": "void f() { glCreateBuffers(1, &id); }\n",
    "src/ui/scene/a.cpp": "glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, id);\n",
    "src/app/studio/b.cpp": "auto h = glGetTextureHandleARB(t);\n",
    "shaders/a.vert": "#version 450 core\n",
    "shaders/b.glsl": "layout(std140, binding = 0) uniform Frame {\n",
    "shaders/c.glsl": "layout(std430) readonly buffer Segments { vec4 s[]; };\n",
    "shaders/d.frag": "#version 410 core\nlayout(location = 1) uniform vec4 tint;\n",
}
FINE = {
    "src/ui/gl/objects.h": "void f() { glBindBuffer(GL_ARRAY_BUFFER, id); }  // not glCreateBuffers(\n",
    "src/ui/gl/program.cpp": "glProgramUniform1i(id, location, 1);\n",
    "shaders/a.vert": "#version 410 core\nlayout(location = 0) in vec3 position;\nuniform usamplerBuffer segments;\n",
    "shaders/b.glsl": "layout(std140) uniform Frame {\n",
}


def broken_files(files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**VERSION, "shaders/z.glsl": "", **files}.items():
            path = pathlib.Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text)
        return sorted({line.split(":")[0] for line in check_gl.complaints(folder, HEADER)})


found = broken_files(BROKEN)
assert found == sorted(BROKEN), f"not seen: {sorted(set(BROKEN) - set(found))}"
found = broken_files(FINE)
assert not found, f"wrongly blamed: {found}"
print("every newer use of OpenGL is seen")
