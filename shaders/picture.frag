#version 330 core
// The display pass: linear radiance to the screen's sRGB, by the formulas of render/film/tonemap.cpp.

in vec2 place;
out vec4 colour;

uniform sampler2D left, right;
uniform float leftScale, rightScale;  // screen pixels a texel
uniform vec2 leftSize, rightSize;     // texels; asking the samplers costs as much as a sample
uniform vec2 size;                    // of the picture on the screen, pixels
uniform int layout_;                  // 0: left alone, 1: right alone, 2: split, 3: difference
uniform float split, lineWidth, gain;

uniform int curve;  // 0 linear, 1 Reinhard, 2 ACES, 3 false colour
uniform float exposure;
uniform bool markNonFinite;
uniform float brightness;
uniform float falseLow, falseScale;  // (value - low) * scale, of the logarithms where falseLogarithmic
uniform bool falseLogarithmic;
uniform vec3 ramp[8];

const vec3 luminanceWeights = vec3(0.2126, 0.7152, 0.0722);

// By the bits: compilers may take a comparison with itself for true.
bool isNonFinite(vec3 c) {
  return any(equal(floatBitsToUint(c) & 0x7F800000u, uvec3(0x7F800000u)));
}

// The samplers are nearest where a texel is a screen pixel or more, else linear: a branch here costs as much as a sample.
vec3 sampleLeft() { return textureLod(left, place, 0.0).rgb; }
vec3 sampleRight() { return textureLod(right, place, 0.0).rgb; }

// Solid where texels are small, checks of two by two a texel where they are large.
vec3 nonFiniteMark(vec2 edge, float scale) {
  if (!markNonFinite) return vec3(0.0);
  ivec2 cell = ivec2(place * edge * 2.0);
  return scale >= 2.0 && ((cell.x + cell.y) & 1) == 1 ? vec3(0.0) : vec3(1.0, 0.0, 1.0);
}

vec3 encodeSrgb(vec3 c) {
  vec3 curved = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
  return mix(curved, 12.92 * c, lessThanEqual(c, vec3(0.0031308)));
}

// Divided by its largest channel first, so that a bright pixel at high exposure stays finite; the reciprocal of what is
// brighter than the limit would be denormal, which a GPU takes for 0.
vec3 reinhard(vec3 radiance) {
  vec3 c = min(radiance, 1e36);
  float largest = max(c.r, max(c.g, c.b));
  if (largest <= 0.0) return vec3(0.0);
  vec3 hue = c / largest;
  return hue / (1.0 / (largest * exposure) + dot(hue, luminanceWeights));
}

vec3 acesFit(vec3 c) {
  vec3 x = min(c, 1e6);
  return x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14);
}

vec3 falseColour(vec3 c) {
  float value = dot(c, vec3(1.0 / 3.0));
  if (falseLogarithmic) value = log2(max(value, 1e-37));
  float t = clamp((value - falseLow) * falseScale, 0.0, 1.0) * 7.0;
  int low = min(int(t), 6);
  return mix(ramp[low], ramp[low + 1], t - float(low));
}

vec3 toScreen(vec3 radiance) {
  if (curve == 3) return falseColour(radiance);
  vec3 c = max(radiance, 0.0);
  if (curve == 1) return encodeSrgb(clamp(reinhard(c), 0.0, 1.0));
  c *= exposure;
  if (curve == 2) c = acesFit(c);
  return encodeSrgb(clamp(c, 0.0, 1.0));
}

vec3 showLeft() {
  vec3 c = sampleLeft();
  return isNonFinite(c) ? nonFiniteMark(leftSize, leftScale) : toScreen(c);
}

vec3 showRight() {
  vec3 c = sampleRight();
  return isNonFinite(c) ? nonFiniteMark(rightSize, rightScale) : toScreen(c);
}

// Red by the channels in which the left is brighter, blue by those in which it is darker.
vec3 showDifference() {
  vec3 a = sampleLeft(), b = sampleRight();
  if (isNonFinite(a)) return nonFiniteMark(leftSize, leftScale);
  if (isNonFinite(b)) return nonFiniteMark(rightSize, rightScale);
  vec3 d = (a - b) * exposure * gain;
  float more = min(dot(max(d, 0.0), vec3(1.0 / 3.0)), 1.0), less = min(dot(max(-d, 0.0), vec3(1.0 / 3.0)), 1.0);
  return encodeSrgb(min(more * vec3(1.0, 0.02, 0.01) + less * vec3(0.01, 0.1, 1.0), 1.0));
}

vec3 showSplit() {
  float beyond = place.x * size.x - split * size.x;
  if (abs(beyond) < 0.5 * lineWidth) return vec3(1.0);
  return beyond < 0.0 ? showLeft() : showRight();
}

void main() {
  vec3 shown = layout_ == 0 ? showLeft() : layout_ == 1 ? showRight() : layout_ == 2 ? showSplit() : showDifference();
  colour = vec4(shown * brightness, 1.0);
}
