#version 450 core

in vec2 p;
uniform vec2 center;
uniform float radius;
uniform float cell;           // finer spacing of the grid [m]; every tenth line is a major one
uniform vec4 fill;            // sRGB, straight alpha
uniform vec4 line;
uniform vec3 axis_x, axis_y;
uniform sampler2D shadow;
uniform vec4 shadow_box;      // low corner and 1 / size of what the shadow covers, ground frame
uniform float shadow_strength;
out vec4 color;               // premultiplied

// Coverage of lines `width` pixels wide at the whole numbers of u, whose change per pixel is `du`; gone where they crowd.
vec2 grid_lines(vec2 u, vec2 du, float width) {
  vec2 pixels = abs(fract(u - 0.5) - 0.5) / du;
  return clamp(0.5 * width + 0.5 - pixels, 0.0, 1.0) * clamp(1.4 - 6.0 * du, 0.0, 1.0);
}

vec4 over(vec4 below, vec3 rgb, float alpha) { return vec4(rgb * alpha, alpha) + below * (1.0 - alpha); }

void main() {
  float far = length(p - center) / radius;
  float fade = 1.0 - smoothstep(0.25, 1.0, far);
  vec2 u = p / cell;
  vec2 du = max(fwidth(u), 1e-6);
  vec2 minor = grid_lines(u, du, 1.0);
  vec2 major = grid_lines(0.1 * u, 0.1 * du, 1.2);
  vec2 axis = clamp(1.2 - abs(u.yx) / du.yx, 0.0, 1.0);

  color = vec4(fill.rgb * fill.a, fill.a);
  vec2 s = (p - shadow_box.xy) * shadow_box.zw;
  color = over(color, vec3(0.0), shadow_strength * textureLod(shadow, s, 0.0).r);
  color = over(color, line.rgb, line.a * max(0.45 * max(minor.x, minor.y), max(major.x, major.y)));
  color = over(color, axis_x, 0.8 * axis.x);
  color = over(color, axis_y, 0.8 * axis.y);
  color *= fade;
}
