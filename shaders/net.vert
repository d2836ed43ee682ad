#version 330 core
layout(location = 0) in vec2 position;
layout(location = 1) in uint face;

uniform mat4 clip_from_world;
uniform vec4 paper;
uniform vec4 root;
uniform vec4 overlap;
uniform vec4 hover;
uniform vec4 chosen;
uniform vec4 climbed;
uniform vec4 seldom;  // in collision
uniform vec4 often;
uniform vec4 most;
uniform usampler2D states;

flat out vec3 tone;
flat out float hatched;
flat out float marked;  // 0 where nothing is said of the face

void main() {
  uint state = texelFetch(states, ivec2(int(face) % 1024, int(face) / 1024), 0).r;
  vec3 colour = paper.rgb;
  if ((state & 32u) != 0u) colour = mix(colour, climbed.rgb, climbed.a);
  uint heat = state >> 6;
  if (heat != 0u) {
    vec4 tint = heat == 1u ? seldom : heat == 2u ? often : most;
    colour = mix(colour, tint.rgb, tint.a);
  }
  // The face a move starts from overlaps nearly always; red under its own colour would hide which it is.
  if ((state & 20u) == 4u) colour = mix(colour, overlap.rgb, overlap.a);
  if ((state & 16u) != 0u) colour = mix(colour, chosen.rgb, chosen.a);
  if ((state & 2u) != 0u) colour = mix(colour, root.rgb, root.a);
  // Blue over a strong fill turns it brown; there the hover lightens.
  if ((state & 1u) != 0u) colour = mix(colour, (state & 214u) != 0u ? vec3(1.0) : hover.rgb, hover.a);
  tone = colour;
  marked = (state & 247u) != 0u ? 1.0 : 0.0;
  hatched = (state & 4u) != 0u ? 1.0 : 0.0;
  gl_Position = clip_from_world * vec4(position, 0.0, 1.0);
}
