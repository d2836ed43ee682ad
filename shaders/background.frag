#version 330 core
in vec3 tone;
out vec4 fragment;

void main() { fragment = vec4(tone, 1.0); }
