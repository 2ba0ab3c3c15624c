#version 330 core
// Photons as points: those of the wanted bounces and kinds, in the hue of their flux.

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 flux;
layout(location = 2) in uint bounce;
layout(location = 3) in uint caustic;

flat out vec3 pointColour;

uniform vec3 cameraHigh, cameraLow, cameraRight, cameraUp, cameraForward;
uniform float near;
uniform float pointSize;  // pixels
uniform float fluxScale;  // brings the mean of the largest channel to 1 at 0 stops
uniform int fewestBounces, mostBounces;
uniform bool showGlobal, showCaustic;

vec3 encodeSrgb(vec3 c) {
  return mix(1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}

void main() {
  // The difference of near numbers is exact: only then is it safe to multiply.
  vec3 d = (position - cameraHigh) - cameraLow;
  float w = dot(d, cameraForward);
  bool wanted = int(bounce) >= fewestBounces && int(bounce) <= mostBounces && (caustic != 0u ? showCaustic : showGlobal);
  gl_Position = wanted ? vec4(dot(d, cameraRight), dot(d, cameraUp), w - 2.0 * near, w) : vec4(2.0, 2.0, 2.0, 1.0);
  gl_PointSize = pointSize;
  vec3 c = max(flux, 0.0) * fluxScale;
  pointColour = encodeSrgb(c / max(max(c.r, max(c.g, c.b)), 1.0));
}
