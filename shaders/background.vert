#version 330 core
// One triangle over the whole view, without any buffer.
uniform vec4 top;
uniform vec4 bottom;
out vec3 tone;

void main() {
  vec2 corner = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
  tone = mix(bottom.rgb, top.rgb, corner.y * 0.5 + 0.5);
  gl_Position = vec4(corner, 1.0, 1.0);
}
