#version 330 core
// The edges of kd-tree cells, coloured by their depth in the tree.

layout(location = 0) in vec3 position;
layout(location = 1) in float depth;

flat out vec4 lineColour;

uniform vec3 cameraHigh, cameraLow, cameraRight, cameraUp, cameraForward;
uniform float near;
uniform float deepest;

void main() {
  vec3 d = (position - cameraHigh) - cameraLow;
  float w = dot(d, cameraForward);
  gl_Position = vec4(dot(d, cameraRight), dot(d, cameraUp), w - 2.0 * near, w);
  vec3 hue = 0.55 + 0.45 * cos(6.2831853 * (depth * 0.13 + vec3(0.0, 0.33, 0.67)));
  lineColour = vec4(hue, mix(1.0, 0.45, clamp(depth / deepest, 0.0, 1.0)));
}
