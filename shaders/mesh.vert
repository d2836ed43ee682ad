#version 330 core
// Everything that is one value per face is worked out here, so that a fragment costs next to nothing.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 material;  // alpha 0: the paper's own colour
layout(location = 4) in uint face;

uniform mat4 clip_from_world;
uniform mat4 view_from_world;
uniform vec4 paper;
uniform vec4 paper_back;
uniform vec4 root;
uniform vec4 overlap;
uniform vec4 hover;
uniform vec4 chosen;
uniform vec4 climbed;
uniform vec4 seldom;  // in collision
uniform vec4 often;
uniform vec4 most;
uniform int shows_materials;
uniform float opacity;
uniform usampler2D states;

out vec2 texture_place;
flat out vec3 front;
flat out vec3 back;
flat out vec2 hatch_and_texture;
flat out float cover;

const vec3 kKeyLight = normalize(vec3(-0.35, 0.75, 0.65));
const vec3 kFillLight = normalize(vec3(0.8, -0.1, 0.45));

vec3 shade(vec3 colour, vec3 n) {
  float key = max(dot(n, kKeyLight), 0.0);
  float fill = max(dot(n, kFillLight), 0.0);
  vec3 light = vec3(0.50, 0.51, 0.54) + vec3(0.50, 0.49, 0.46) * key + vec3(0.12, 0.13, 0.15) * fill;
  return colour * min(light, vec3(1.06));
}

void main() {
  uint state = texelFetch(states, ivec2(int(face) % 1024, int(face) / 1024), 0).r;
  bool has_material = shows_materials != 0 && material.a > 0.0;
  vec3 colour = has_material ? material.rgb : paper.rgb;
  float mark = 0.0;
  if ((state & 32u) != 0u) { colour = mix(colour, climbed.rgb, climbed.a); mark = 1.0; }
  uint heat = state >> 6;
  if (heat != 0u) {
    vec4 tint = heat == 1u ? seldom : heat == 2u ? often : most;
    colour = mix(colour, tint.rgb, tint.a);
    mark = 1.0;
  }
  // The face a move starts from overlaps nearly always; red under its own colour would hide which it is.
  if ((state & 20u) == 4u) { colour = mix(colour, overlap.rgb, overlap.a); mark = 1.0; }
  if ((state & 16u) != 0u) { colour = mix(colour, chosen.rgb, chosen.a); mark = 1.0; }
  if ((state & 2u) != 0u) { colour = mix(colour, root.rgb, root.a); mark = 1.0; }
  // Blue over a strong fill turns it brown; there the hover lightens.
  if ((state & 1u) != 0u) colour = mix(colour, (state & 214u) != 0u ? vec3(1.0) : hover.rgb, hover.a);
  vec3 n = mat3(view_from_world) * normal;
  front = shade(colour, n);
  back = shade(mark > 0.0 ? colour : paper_back.rgb, -n);
  hatch_and_texture = vec2((state & 4u) != 0u ? 1.0 : 0.0, has_material && mark == 0.0 ? 1.0 : 0.0);
  // What is marked, selected or pointed at stands out of a model that is seen through.
  cover = mark > 0.0 || (state & 9u) != 0u ? min(1.0, opacity * 2.5) : opacity;
  texture_place = uv;
  gl_Position = clip_from_world * vec4(position, 1.0);
}
