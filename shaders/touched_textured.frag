#version 410 core
#include "frame.glsl"
#include "key_shadow.glsl"
#include "light.glsl"
#include "near_contact.glsl"
#include "body.glsl"
#include "textured.glsl"
#include "touched.glsl"
