#pragma once

#include "surface/scenemaps.h"

#include <string>
#include <vector>

namespace dsphere::verify {

/// A small scene that takes no file: its maps and images are made in memory.
struct TestScene {
    Scene scene;  ///< its name says what is special about it
    SceneMaps maps;
};

/// How many there are: together they have all surfaces, shapes, materials, lights and filters, one object and several,
/// cameras far away and near the ground, every shader variant.
int testSceneCount();
/// The i-th; the same on every machine.
TestScene makeTestScene(int i);

}  // namespace dsphere::verify
