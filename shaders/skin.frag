#version 410 core
in vec3 shade;
in float facing;
uniform vec2 front_alpha;  // opacity where the skin faces the eye, and at its rim
uniform float back_alpha;
out vec4 color;            // premultiplied

void main() {
  float rim = 1.0 - min(abs(facing), 1.0);
  rim *= rim * rim;  // Schlick's curve, softened: the skin thickens towards its outline
  float alpha = gl_FrontFacing ? mix(front_alpha.x, front_alpha.y, rim) : back_alpha;
  color = vec4(shade * alpha, alpha);
}
