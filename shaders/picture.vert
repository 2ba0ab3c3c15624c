#version 330 core
// One triangle over the viewport; `place` is (0,0) at its top left and (1,1) at its bottom right corner.

out vec2 place;

void main() {
  vec2 corner = vec2(float((gl_VertexID & 1) << 2), float((gl_VertexID & 2) << 1)) - 1.0;
  place = vec2(0.5 + 0.5 * corner.x, 0.5 - 0.5 * corner.y);
  gl_Position = vec4(corner, 0.0, 1.0);
}
