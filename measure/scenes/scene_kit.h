#pragma once
// Scenes made in code: a material, shapes one by one, a camera, and closed rooms whose radiance is known everywhere.

#include "render/scene/scene.h"

namespace ropelight {

/// A scene of one material, diffuse with this albedo; shapes are added by the functions below.
Scene emptyScene(float albedo);
int addMaterial(Scene& scene, const MaterialDesc& desc);
ShapeDesc& addQuad(Scene& scene, Vec3d corner, Vec3d edge1, Vec3d edge2, int material = 0);
ShapeDesc& addSphere(Scene& scene, Vec3d center, double radius, int material = 0);
ShapeDesc& addBox(Scene& scene, Vec3d min, Vec3d max, int material = 0);
ShapeDesc& addMesh(Scene& scene, Mesh mesh, int material = 0);
void lookAt(Scene& scene, Vec3d position, Vec3d target, Vec3d up, double verticalFov);

/// The inside of a sphere around the origin: albedo and emission are the same everywhere, so that every ray inside
/// brings emitted/(1 − albedo) in every channel. The camera is inside, off the centre.
Scene sphereFurnace(Rgb albedo, double radius, float emitted = 1);

/// How much more irradiance a gather disc of radius r finds on the inside of a unit sphere of uniform flux than there
/// is: the sphere's area within the disc's cylinder, whose height is ±0.2 r and whose normals lie within acos 0.1, over
/// πr².
double discGain(double r);

/// The same in the box [−1, 1]³.
Scene boxFurnace(Rgb albedo, float emitted = 1);

/// The same box without a camera of its own, black and emitting 1 inwards: around anything that absorbs nothing, every
/// ray brings 1.
Scene whiteSurroundings(double halfSize = 4);

/// A small room with everything in it: diffuse walls, a lamp, glass, a mirror, a mesh.
Scene mixedRoom();

/// A floor of this albedo under a black lamp of radiance 1, two units apart in a cell of perfect mirrors: endless
/// planes.
Scene mirrorCell(float albedo);

/// A mesh of the unit sphere: `rings` from pole to pole, twice as many around; counter-clockwise from outside.
Mesh sphereMesh(int rings);

}  // namespace ropelight
