#version 330 core

flat in vec3 pointColour;
out vec4 colour;

uniform float pointSize;

void main() {
  vec2 fromCentre = gl_PointCoord - 0.5;
  if (pointSize >= 3.0 && dot(fromCentre, fromCentre) > 0.25) discard;
  colour = vec4(pointColour, 1.0);
}
