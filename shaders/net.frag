#version 330 core
flat in vec3 tone;
flat in float hatched;
flat in float marked;

uniform vec4 hatch;
uniform vec2 hatch_origin;
uniform float hatch_scale;
uniform int is_glass;  // the face itself is drawn by somebody else

out vec4 fragment;

void main() {
  vec3 colour = tone;
  if (hatched > 0.5) {
    vec2 p = (gl_FragCoord.xy - hatch_origin) * hatch_scale;
    float wave = abs(fract((p.x + p.y) * 0.117) - 0.5) * 8.5;
    colour = mix(colour, hatch.rgb, hatch.a * clamp(1.6 - wave, 0.0, 1.0));
  }
  if (is_glass != 0 && marked < 0.5) discard;
  fragment = vec4(colour, is_glass != 0 ? 0.45 : 1.0);
}
