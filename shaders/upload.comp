#version 430 core
// Pixels from a buffer into a texture, bit by bit: where drawing is slow and computing is not, as on a data centre's
// GPU, many times as fast as glTexSubImage2D.

layout(local_size_x = 16, local_size_y = 16) in;

layout(std430, binding = 0) readonly buffer Pixels { uvec4 pixels[]; };
layout(rgba32ui, binding = 0) writeonly uniform uimage2D texels;

uniform int width, height;

void main() {
  ivec2 p = ivec2(gl_GlobalInvocationID.xy);
  if (p.x < width && p.y < height) imageStore(texels, p, pixels[p.y * width + p.x]);
}
