#version 330 core
in vec2 place;
flat in vec4 ink;

uniform int kind;          // 0 fill, 1 letter, 2 picture
uniform sampler2D pixels;
uniform vec4 paper;        // ink is transparent: on grey paper white is grey

out vec4 fragment;

void main() {
  vec4 colour = ink;
  if (kind == 1) {
    // Four samples: the strokes of small letters are thinner than a pixel.
    vec2 dx = dFdx(place);
    vec2 dy = dFdy(place);
    // How much of the stored range half a pixel of the screen covers: 1024 texels, 14.4 of them the range.
    float per_sample = max(0.25 * (length(dx) + length(dy)) * 1024.0 / 14.4, 1e-4);
    float cover = 0.0;
    for (int i = 0; i < 4; ++i) {
      vec2 aside = vec2(i % 2 == 0 ? -0.25 : 0.25, i < 2 ? -0.25 : 0.25);
      float away = texture(pixels, place + aside.x * dx + aside.y * dy).r - 0.5;
      cover += clamp(away / per_sample + 0.5, 0.0, 1.0);
    }
    colour.a *= 0.25 * cover;
  } else if (kind == 2) {
    colour = texture(pixels, place);
  }
  if (colour.a <= 0.0) discard;
  fragment = vec4(colour.rgb * paper.rgb, colour.a);
}
