#version 330 core
// What is printed: fills, letters and pictures, in the plane of the net.
layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 colour;

uniform mat4 clip_from_world;

out vec2 place;
flat out vec4 ink;

void main() {
  place = uv;
  ink = colour;
  gl_Position = clip_from_world * vec4(position, 0.0, 1.0);
}
