#include "bench/devicecontender.h"

#include "gpu/device.h"
#include "gpu/pipelinestore.h"
#include "render/filmtracer.h"

#include <chrono>
#include <future>

namespace dsphere::bench {

namespace {

std::uint32_t planesOf(std::initializer_list<int> planes) {
    std::uint32_t mask = 0;
    for (int plane : planes) mask |= planeBit(plane);
    return mask;
}

const std::uint32_t kPrimary = planesOf({PLANE_T});
const std::uint32_t kShadow = planesOf({PLANE_T, PLANE_LIT});
const std::uint32_t kAnswer =
    planesOf({PLANE_T, PLANE_NX, PLANE_NY, PLANE_NZ, PLANE_ID, PLANE_LIT, PLANE_STEPS, PLANE_OBJECT_PX, PLANE_OBJECT_PY,
              PLANE_OBJECT_PZ, PLANE_START_X, PLANE_START_Y, PLANE_START_Z, PLANE_FLAGS});

/// What a picture of kAnswer says of its pixels.
class AnswerPicture {
  public:
    AnswerPicture(Renderer& renderer, double unit) : image_(renderer.renderPlanes(kAnswer, {})), unit_(unit) {
        t_ = &image_.at("t").floats();
        id_ = &image_.at("id").uints();
        lit_ = &image_.at("lit").uints();
        steps_ = &image_.at("steps").uints();
        flags_ = &image_.at("flags").uints();
        for (int c = 0; c < 3; ++c) {
            const std::string axis(1, "XYZ"[c]);
            normal_[c] = &image_.at("N." + axis).floats();
            object_[c] = &image_.at("object." + axis).floats();
            start_[c] = &image_.at("start." + axis).floats();
        }
    }
    AnswerPicture(const AnswerPicture&) = delete;
    AnswerPicture& operator=(const AnswerPicture&) = delete;

    std::size_t size() const { return image_.pixelCount(); }
    bool hit(std::size_t i) const { return (*id_)[i] != 0; }
    std::uint32_t steps(std::size_t i) const { return (*steps_)[i]; }

    bool facesSun(std::size_t i, const dvec3& sun) const {
        return hit(i) && !((*flags_)[i] & 1u) && glm::dot(triple(normal_, i), sun) > 0.0;
    }

    verify::Answer answer(std::size_t i) const {
        verify::Answer answer;
        answer.hit = hit(i);
        if (!answer.hit) return answer;
        answer.shape = int((*id_)[i]) - 1;
        answer.inside = ((*flags_)[i] & 1u) != 0;
        answer.t = (*t_)[i];
        answer.object_position = triple(object_, i) * unit_;
        answer.normal = triple(normal_, i);
        return answer;
    }

    PixelAnswer pixelAnswer(std::size_t i) const {
        PixelAnswer result;
        result.pixel = i;
        result.answer = answer(i);
        result.start = triple(start_, i) * unit_;
        result.lit = (*lit_)[i] != 0;
        result.runaway = ((*flags_)[i] & 2u) != 0;
        return result;
    }

  private:
    using Floats = const std::vector<float>*;
    using Uints = const std::vector<std::uint32_t>*;

    static dvec3 triple(const Floats (&planes)[3], std::size_t i) {
        return {(*planes[0])[i], (*planes[1])[i], (*planes[2])[i]};
    }

    Image image_;
    double unit_;
    Floats t_, normal_[3], object_[3], start_[3];
    Uints id_, lit_, steps_, flags_;
};

dvec3 sunOf(const Scene& scene) {
    return std::get<DistantLight>(scene.lights[0]).direction;
}

class DeviceContender : public Contender {
  public:
    DeviceContender(DeviceView& view, const Method& method, double unit, Alive alive)
        : view_(view), march_(method.march), unit_(unit), alive_(std::move(alive)) {
        AnswerPicture picture = answerPicture();
        for (std::size_t i = 0; i < picture.size(); ++i) shadow_rays_ += picture.facesSun(i, sunOf(view.scene()));
    }

    Timing tracePrimary() override { return last_primary_ = timed(kPrimary); }
    Timing traceShadows() override {
        Timing both = timed(kShadow);
        return {both.device - last_primary_.device, both.wall - last_primary_.wall};
    }
    std::uint64_t shadowRays() const override { return shadow_rays_; }

    Answers answer(std::span<const std::size_t> pixels) override {
        AnswerPicture picture = answerPicture();
        Answers answers;
        for (std::size_t i : pixels) answers.pixels.push_back(picture.pixelAnswer(i));
        double steps = 0.0;
        for (std::size_t i = 0; i < picture.size(); ++i) {
            answers.hits += picture.hit(i);
            steps += picture.steps(i);
        }
        answers.fetches_per_hit = answers.hits > 0 ? steps / double(answers.hits) : 0.0;  // steps of a miss are 0
        return answers;
    }

  private:
    AnswerPicture answerPicture() {
        view_.renderer().setMethod(march_);
        return AnswerPicture(view_.renderer(), unit_);
    }

    Timing timed(std::uint32_t planes) {
        Renderer& renderer = view_.renderer();
        renderer.setMethod(march_);
        RenderStats before = renderer.stats();
        renderer.renderPlanes(planes, [this](double) { return alive_(); });
        return {renderer.stats().device_seconds - before.device_seconds,
                renderer.stats().wall_seconds - before.wall_seconds};
    }

    DeviceView& view_;
    MarchMethod march_;
    double unit_;
    Alive alive_;
    std::uint64_t shadow_rays_ = 0;
    Timing last_primary_;
};

Scene seenFrom(Scene scene, const View& view) {
    scene.camera = view.camera;
    scene.film = view.film;
    return scene;
}

}  // namespace

DeviceView::DeviceView(gpu::Device& device, Scene scene, PackedScene packed)
    : scene_(std::move(scene)), packed_(std::move(packed)), renderer_(device, packed_, scene_, {}) {}

DeviceView::DeviceView(gpu::Device& device, const Scene& scene, const SceneMaps& maps, const View& view, Levels levels)
    : scene_(seenFrom(scene, view)), packed_(packScene(scene_, maps, levels)), renderer_(device, packed_, scene_, {}) {}

void DeviceView::look(const View& view) {
    scene_.camera = view.camera;
    scene_.film = view.film;
    renderer_.setCamera(scene_);
}

std::unique_ptr<Contender> makeDeviceContender(DeviceView& view, const Method& method, double unit, Alive alive) {
    return std::make_unique<DeviceContender>(view, method, unit, std::move(alive));
}

SceneMaps noMaps() {
    SceneMaps maps;
    maps.map_of_shape = {-1};
    maps.reliefs.resize(1);
    return maps;
}

double timeDeviceSetup(gpu::Device& device, const Workload& workload, const View& view, const Method& method) {
    bool smooth = method.engine == Engine::SmoothSphere;
    device.pipelineStore().clear();
    double start = wallSeconds();
    Scene scene = seenFrom(smooth ? smoothScene(workload) : workload.scene, view);
    std::future<void> compiling = warmAhead(device, traitsOf(scene), method.march, kPrimary);
    const SceneMaps none = noMaps();
    PackedScene packed = packScene(scene, smooth ? none : workload.maps, method.levels());
    if (compiling.valid()) compiling.get();
    DeviceView made(device, std::move(scene), std::move(packed));
    made.renderer().setMethod(method.march);
    made.renderer().renderPlanes(kPrimary, {});
    return wallSeconds() - start;
}

double wallSeconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace dsphere::bench
