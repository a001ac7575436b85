// Spheres around the contacts of the frame. Next to a contact, surfaces get less light of the sky, and the object, which
// would hide the contact, is partly transparent.
const int kMaxContacts = 8;
uniform vec4 contacts[kMaxContacts];  // centre and radius, world [m]
uniform int contact_count;
const float kNearAlpha = 0.4;
const float kInside = 0.7;  // brightness of the inside of an object, which is seen through its transparent part

// Returns the distance from the nearest contact, in radii of its sphere.
float contact_distance(vec3 p) {
  float least = 1e6;
  for (int i = 0; i < contact_count; ++i) least = min(least, distance(p, contacts[i].xyz) / contacts[i].w);
  return least;
}

// The following functions take a distance from the nearest contact.
float light_at_distance(float d) { return 1.0 - 0.35 * (1.0 - smoothstep(0.7, 1.5, d)); }

// Returns the opacity of an object: 0.4 where it touches, 1 from two radii of the contact on.
float alpha_at_distance(float d) { return mix(kNearAlpha, 1.0, smoothstep(1.15, 2.0, d)); }

float light_near_contact(vec3 p) { return contact_count > 0 ? light_at_distance(contact_distance(p)) : 1.0; }
float alpha_near_contact(vec3 p) { return alpha_at_distance(contact_distance(p)); }
