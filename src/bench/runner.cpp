#include "bench/runner.h"

#include "base/error.h"
#include "bench/accuracy.h"
#include "bench/devicecontender.h"
#include "bench/iterated.h"

#include <unistd.h>

#include <algorithm>
#include <optional>
#include <random>

namespace dsphere::bench {

namespace {

/// The share of the work that is done, over sources, views, methods and repeats.
class Meter {
  public:
    Meter(const std::vector<Source>& sources, const Plan& plan, const Progress& progress)
        : progress_(progress), per_view_(double(plan.methods.size()) * (plan.repeats + 2)) {
        double views = 0.0;
        for (const Source& source : sources) views += source.views;
        total_ = views * per_view_;
    }

    void step() {
        done_ += 1.0;
        alive();
    }
    void endView() { done_ = ++views_ * per_view_; }
    void alive() const {
        if (!update()) throw Error(ExitCode::Interrupted, "interrupted; nothing was written");
    }
    bool update() const { return !progress_ || progress_(std::min(done_ / total_, 1.0)); }

  private:
    const Progress& progress_;
    double per_view_, total_ = 0.0, done_ = 0.0;
    int views_ = 0;
};

/// A method in the race on one view.
struct Entry {
    const Method* method;
    report::MethodResult result;
    std::unique_ptr<Contender> contender;  ///< empty if skipped
    std::vector<Timing> primary, shadow;
    double spent = 0.0;
};

std::vector<double> pick(const std::vector<Timing>& timings, double Timing::*clock) {
    std::vector<double> seconds;
    for (const Timing& timing : timings) seconds.push_back(timing.*clock);
    return seconds;
}

report::Speed speedOf(double rays, const std::vector<Timing>& timings) {
    return {report::ratesOf(rays, pick(timings, &Timing::device)), report::ratesOf(rays, pick(timings, &Timing::wall))};
}

// What Embree holds of a mesh at its peak, for a cell of the map: measured, rounded up.
double meshBytes(const Workload& workload, const Method& method) {
    double cells = double(workload.width) * workload.height / (method.spacing * method.spacing);
    return cells * (method.engine == Engine::GridMesh ? 32.0 : 230.0);
}

// A mesh that does not fit beside the others would measure the swap, or end the run.
std::string whySkipped(const Workload& workload, const Method& method) {
    double free = double(sysconf(_SC_AVPHYS_PAGES)) * double(sysconf(_SC_PAGESIZE)), need = meshBytes(workload, method);
    if (need < 0.3 * free) return "";
    return fmt::format("needs some {:.1f} GB of memory", need * 1e-9);
}

class WorkloadRun {
  public:
    WorkloadRun(gpu::Device& device, const Workload& workload, const Plan& plan, Meter& meter)
        : device_(device),
          workload_(workload),
          plan_(plan),
          meter_(meter),
          planet_(device, workload.scene, workload.maps, workload.views.at(0)),
          smooth_(device, smoothScene(workload), noMaps(), workload.views[0]),
          comparison_(workload.scene, workload.maps, verify::Comparison::Tolerance::Approximate) {}

    void buildMeshes();
    report::ViewResult runView(std::size_t index);

  private:
    std::vector<Entry> enter(const View& view);
    void race(std::vector<Entry>& entries);
    void runOnce(Entry& entry, bool timed);
    void finish(Entry& entry, const View& view, const std::vector<std::size_t>& pixels, const Answers& exact,
                report::ViewResult& result);
    report::Spread setup(const Method& method, const View& view);
    DeviceView& viewFor(const Method& method);
    double unit() const { return workload_.maps.reliefs[0].greatest_radius; }

    struct BuiltMesh {
        std::unique_ptr<MeshScene> scene;  ///< empty if skipped
        std::string skipped;
        std::vector<double> build_seconds;
    };

    gpu::Device& device_;
    const Workload& workload_;
    const Plan& plan_;
    Meter& meter_;
    DeviceView planet_, smooth_;
    std::optional<DeviceView> detailed_;  ///< the planet with its levels of detail, once a method wants them
    verify::Comparison comparison_;
    std::vector<BuiltMesh> meshes_;  ///< one a method; unused for the device's
};

void WorkloadRun::buildMeshes() {
    meshes_.resize(plan_.methods.size());
    for (std::size_t k = 0; k < plan_.methods.size(); ++k) {
        const Method& method = plan_.methods[k];
        if (!method.isMesh()) continue;
        BuiltMesh& mesh = meshes_[k];
        mesh.skipped = whySkipped(workload_, method);
        for (int repeat = 0; mesh.skipped.empty() && repeat < plan_.setups; ++repeat) {
            mesh.scene.reset();
            double start = wallSeconds();
            mesh.scene = makeMeshScene(workload_, method);
            mesh.build_seconds.push_back(wallSeconds() - start);
            meter_.alive();
        }
    }
}

report::Spread WorkloadRun::setup(const Method& method, const View& view) {
    std::vector<double> seconds;
    for (int repeat = 0; repeat < plan_.setups; ++repeat) {
        seconds.push_back(timeDeviceSetup(device_, workload_, view, method));
        meter_.alive();
    }
    return report::spreadOf(seconds);
}

DeviceView& WorkloadRun::viewFor(const Method& method) {
    if (method.engine == Engine::SmoothSphere) return smooth_;
    if (method.levels() == Levels::Finest) return planet_;
    if (!detailed_) detailed_.emplace(device_, workload_.scene, workload_.maps, workload_.views.at(0), Levels::All);
    return *detailed_;
}

std::vector<Entry> WorkloadRun::enter(const View& view) {
    std::vector<Entry> entries;
    std::uint64_t film = std::uint64_t(cropBox(view.film).width()) * std::uint64_t(cropBox(view.film).height()) * 4;
    for (std::size_t k = 0; k < plan_.methods.size(); ++k) {
        const Method& method = plan_.methods[k];
        Entry entry{&method, {}, {}, {}, {}, 0.0};
        entry.result.method = method.name;
        entry.result.family = method.family;
        if (method.isMesh()) {
            const BuiltMesh& mesh = meshes_[k];
            entry.result.skipped = mesh.skipped;
            if (mesh.scene) {
                entry.contender = mesh.scene->contender(workload_, view);
                entry.result.memory_bytes = mesh.scene->memoryBytes() + film;
            }
        } else if (method.isIterated()) {
            entry.contender = makeIteratedContender(workload_, view, method.engine == Engine::Secant);
            entry.result.memory_bytes = std::uint64_t(workload_.width) * std::uint64_t(workload_.height) * 4 + film;
        } else {
            DeviceView& on = viewFor(method);
            entry.contender = makeDeviceContender(on, method, unit(), [this] { return meter_.update(); });
            entry.result.memory_bytes = on.renderer().mapBytes() + film;
        }
        if (entry.contender) entry.result.shadow_rays = entry.contender->shadowRays();
        entries.push_back(std::move(entry));
    }
    return entries;
}

void WorkloadRun::runOnce(Entry& entry, bool timed) {
    double start = wallSeconds();
    Timing primary = entry.contender->tracePrimary();
    Timing shadow;
    if (entry.result.shadow_rays > 0) shadow = entry.contender->traceShadows();
    meter_.step();
    if (!timed) return;
    entry.spent += wallSeconds() - start;
    entry.primary.push_back(primary);
    entry.shadow.push_back(shadow);
}

// In another order each round, the same in every run: who comes after a method that has the caches and has let others'
// threads fall asleep is late, and none is to be so always.
void WorkloadRun::race(std::vector<Entry>& entries) {
    constexpr int kLeastRepeats = 3;
    std::vector<Entry*> order;
    for (Entry& entry : entries)
        if (entry.contender) order.push_back(&entry);
    std::mt19937 random;
    for (int round = -1; round < plan_.repeats; ++round) {
        std::shuffle(order.begin(), order.end(), random);
        for (Entry* next : order) {
            Entry& entry = *next;
            // A run that alone takes all the time is measured once: noise hides little of what it costs.
            bool enough = round >= kLeastRepeats ? entry.spent > plan_.seconds
                                                 : round >= 1 && entry.spent > kLeastRepeats * plan_.seconds;
            if (!enough) runOnce(entry, round >= 0);
        }
    }
}

void WorkloadRun::finish(Entry& entry, const View& view, const std::vector<std::size_t>& pixels, const Answers& exact,
                         report::ViewResult& result) {
    report::MethodResult& of = entry.result;
    of.primary = speedOf(double(result.width) * result.height, entry.primary);
    of.shadow = speedOf(double(of.shadow_rays), entry.shadow);
    Answers answers = entry.contender->answer(pixels);
    of.fetches_per_hit = answers.fetches_per_hit;
    if (entry.method->hasError())
        of.accuracy =
            judge(comparison_, view, answers.pixels, exact.pixels, [this](double) { return meter_.update(); });
    meter_.step();
}

report::ViewResult WorkloadRun::runView(std::size_t index) {
    const View& view = workload_.views[index];
    Box box = cropBox(view.film);
    report::ViewResult result{workload_.map,
                              workload_.width,
                              workload_.height,
                              workload_.percent,
                              view.name,
                              box.width(),
                              box.height(),
                              0.0,
                              {}};
    if (std::ranges::any_of(plan_.methods, [](const Method& method) { return method.levels() == Levels::All; }))
        viewFor(*std::ranges::find(plan_.methods, Levels::All, &Method::levels)).look(view);
    planet_.look(view);
    smooth_.look(view);
    std::vector<std::size_t> pixels =
        samplePixels(std::size_t(result.width) * std::size_t(result.height), plan_.samples);
    std::vector<Entry> entries = enter(view);
    Answers exact = makeDeviceContender(planet_, {}, unit(), [this] { return meter_.update(); })->answer(pixels);
    race(entries);
    for (std::size_t k = 0; k < entries.size(); ++k) {
        Entry& entry = entries[k];
        if (entry.contender) finish(entry, view, pixels, exact, result);
        if (entry.contender && index == 0) {
            const report::Spread first_frame = report::spreadOf(pick(entry.primary, &Timing::wall));
            for (double& seconds : meshes_[k].build_seconds) seconds += first_frame.median;
            entry.result.setup_seconds = entry.method->isIterated() ? first_frame  // it takes the map as it is
                                         : entry.method->isMesh()   ? report::spreadOf(meshes_[k].build_seconds)
                                                                    : setup(*entry.method, view);
        }
        result.methods.push_back(std::move(entry.result));
    }
    result.hit_share = double(exact.hits) / (double(result.width) * result.height);
    meter_.endView();
    return result;
}

}  // namespace

std::vector<report::ViewResult> measure(gpu::Device& device, const std::vector<Source>& sources, const Plan& plan,
                                        const Progress& progress) {
    Meter meter(sources, plan, progress);
    std::vector<report::ViewResult> results;
    for (const Source& source : sources) {
        Workload workload = source.make();
        meter.alive();
        WorkloadRun run(device, workload, plan, meter);
        run.buildMeshes();
        for (std::size_t k = 0; k < workload.views.size(); ++k) results.push_back(run.runView(k));
    }
    return results;
}

}  // namespace dsphere::bench
