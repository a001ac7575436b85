// A body of one colour. Needs body.glsl.
vec3 body_color() { return color_in_light(base.rgb, light_key, light_rest); }
