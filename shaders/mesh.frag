#version 330 core
in vec2 texture_place;
flat in vec3 front;
flat in vec3 back;
flat in vec2 hatch_and_texture;
flat in float cover;

uniform vec4 hatch;
uniform vec2 hatch_origin;
uniform float hatch_scale;
uniform int has_texture;
uniform sampler2D picture;

out vec4 fragment;

void main() {
  vec3 colour = gl_FrontFacing ? front : back;
  if (has_texture != 0 && hatch_and_texture.y > 0.5 && gl_FrontFacing)
    colour *= texture(picture, texture_place).rgb;
  if (hatch_and_texture.x > 0.5) {
    vec2 p = (gl_FragCoord.xy - hatch_origin) * hatch_scale;
    float wave = abs(fract((p.x + p.y) * 0.117) - 0.5) * 8.5;
    colour = mix(colour, hatch.rgb, hatch.a * clamp(1.6 - wave, 0.0, 1.0));
  }
  fragment = vec4(colour, cover);
}
