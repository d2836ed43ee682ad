#version 330 core
// One segment becomes a quad that covers it on screen, with half a pixel more on every side for the soft rim.
layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in uint style;

uniform mat4 clip_from_world;
uniform vec2 size_px;
uniform float pull;
uniform vec4 style_colour[16];
uniform vec4 style_dash[16];
uniform vec4 style_shape[16];  // width in px, 1 when dashes are in world units, pixels per design pixel

flat out vec4 colour;
flat out vec4 dash;         // lengths along the segment: dash, gap, dash, gap
flat out vec3 extent;       // half width px, half length px, dash units per px
noperspective out vec2 place;           // px from the segment's middle: along, across

const float kNear = 1e-4;

void main() {
  vec4 a = clip_from_world * vec4(from, 1.0);
  vec4 b = clip_from_world * vec4(to, 1.0);
  colour = style_colour[style];
  dash = style_dash[style];
  gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
  if (colour.a == 0.0 || (a.w < kNear && b.w < kNear)) return;
  if (a.w < kNear) a = mix(b, a, (b.w - kNear) / (b.w - a.w));
  if (b.w < kNear) b = mix(a, b, (a.w - kNear) / (a.w - b.w));

  vec2 pixel_a = a.xy / a.w * size_px * 0.5;
  vec2 pixel_b = b.xy / b.w * size_px * 0.5;
  float length_px = length(pixel_b - pixel_a);
  vec2 along = length_px > 1e-6 ? (pixel_b - pixel_a) / length_px : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);

  float half_width = 0.5 * style_shape[style].x;
  float world_per_px = length(to - from) / max(length_px, 1e-6);
  extent = vec3(half_width, 0.5 * length_px,
                style_shape[style].y > 0.5 ? world_per_px : 1.0 / style_shape[style].z);

  bool is_end = gl_VertexID >= 2;
  float side = (gl_VertexID & 1) == 0 ? -1.0 : 1.0;
  float reach = half_width + 0.75;
  place = vec2((is_end ? 1.0 : -1.0) * (0.5 * length_px + reach), side * reach);
  vec2 pixel = (is_end ? pixel_b : pixel_a) + along * ((is_end ? 1.0 : -1.0) * reach) + across * (side * reach);
  vec4 base = is_end ? b : a;
  // Lines lie on surfaces: a little nearer to the eye in depth alone, they win against what they lie on.
  gl_Position = vec4(pixel / (size_px * 0.5) * base.w, base.z - pull, base.w);
}
