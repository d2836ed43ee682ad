#version 330 core
flat in vec3 tone;
flat in float hatched;

uniform vec4 hatch;
uniform vec2 hatch_origin;
uniform float hatch_scale;

out vec4 fragment;

void main() {
  vec3 colour = tone;
  if (hatched > 0.5) {
    vec2 p = (gl_FragCoord.xy - hatch_origin) * hatch_scale;
    float wave = abs(fract((p.x + p.y) * 0.117) - 0.5) * 8.5;
    colour = mix(colour, hatch.rgb, hatch.a * clamp(1.6 - wave, 0.0, 1.0));
  }
  fragment = vec4(colour, 1.0);
}
