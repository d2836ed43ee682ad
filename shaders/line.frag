#version 330 core
flat in vec4 colour;
flat in vec4 dash;
flat in vec3 extent;
noperspective in vec2 place;
out vec4 fragment;

void main() {
  // How far outside the segment, along it; round ends.
  float beyond = max(abs(place.x) - extent.y, 0.0);
  if (dash.x > 0.0) {
    // The pattern is symmetric about the middle of its first dash, which sits on the middle of the segment.
    float period = dash.x + dash.y + dash.z + dash.w;
    float t = mod(place.x * extent.z + 0.5 * dash.x, period);
    float second = dash.x + dash.y;
    float gap = t <= dash.x ? 0.0 : min(t - dash.x, period - t);
    if (dash.z > 0.0 && t > dash.x) {
      float out_of_second = t < second ? second - t : max(t - second - dash.z, 0.0);
      gap = min(gap, out_of_second);
    }
    float gap_px = gap / extent.z + extent.x;  // flat ends, as a pen would draw them
    beyond = gap > 0.0 ? max(beyond, gap_px) : beyond;
  }
  float distance_px = length(vec2(beyond, place.y));
  float cover = clamp(extent.x + 0.5 - distance_px, 0.0, 1.0) * min(1.0, 2.0 * extent.x);
  if (cover <= 0.0) discard;
  fragment = vec4(colour.rgb, colour.a * cover);
}
