#version 410 core
// The skybox of a user's scene, with haze at the horizon.
#include "frame.glsl"
#include "color.glsl"

in vec2 uv;
uniform samplerCube sky;
uniform float level;  // of the image, whose texels are about as large as pixels
uniform vec4 haze;  // sRGB; alpha 0 without haze
uniform float tangent;  // of half the vertical field of view
out vec4 color;

void main() {
  vec2 ndc = 2.0 * uv - 1.0;
  vec3 d = vec3(ndc.x * tangent * viewport.x * viewport.w, ndc.y * tangent, -1.0);
  d = normalize(transpose(mat3(view_from_world)) * d);
  vec3 shown = textureLod(sky, vec3(d.x, d.z, -d.y), level).rgb;
  shown = mix(shown, haze.rgb, haze.a * (1.0 - smoothstep(0.0, 0.22, d.z)));
  color = vec4(shown + dither(gl_FragCoord.xy), 1.0);
}
