#pragma once

// The four steps to a failure's cause, on the test scenes.

#include "render/method.h"
#include "render/pack.h"
#include "render/scenerenderer.h"
#include "verify/report.h"
#include "verify/testscenes.h"

#include <functional>
#include <memory>

namespace dsphere::verify {

/// Where a fault lies: the first step of these that fails. None: all is well.
enum class Step { None, Reference, Algorithm, Precision, Driver };
const char* stepName(Step step);

/// A device as selftest asks it, by its name.
struct Candidate {
    std::string name;
    std::function<std::unique_ptr<SceneRenderer>(const PackedScene&, const Scene&)> makeRenderer;
};

/// What one device made of one scene.
struct SceneResult {
    std::string device;
    Report report;
    double paths_off = 0.0;           ///< of the pixels of a traced picture, the share that is off; 0 without paths
    std::vector<std::string> faults;  ///< what breaks the contract, and what differs from the step before
};

struct SelftestRow {
    std::string scene;
    std::vector<std::string> reference_faults;
    std::vector<SceneResult> results;  ///< the kernel in double, in float, then the device unless it is one of them
    Step step = Step::None;
};

/// Renders and verifies scene i on the kernel in double, in float, and on a device (null: on none), each held against
/// the reference, and against the one before.
SelftestRow selftestScene(int i, const Candidate& in_double, const Candidate& in_float, const Candidate* device);

}  // namespace dsphere::verify
