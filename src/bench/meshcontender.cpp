// Embree's meshes as contenders.

#include "bench/contender.h"
#include "bench/devicecontender.h"
#include "bench/meshrays.h"
#include "bench/pixelorder.h"

#include <cmath>

namespace dsphere::bench {

namespace {

class MeshContender : public Contender {
  public:
    MeshContender(const EmbreeScene& scene, const Workload& workload, const View& view)
        : scene_(scene),
          workload_(workload),
          order_(packetOrder(cropBox(view.film).width(), cropBox(view.film).height())),
          camera_(cameraRays(workload, view, order_)),
          t_(camera_.size()) {
        makeShadowRays();
    }

    Timing tracePrimary() override {
        return timed([&] { scene_.intersect(camera_, t_, nullptr); });
    }
    Timing traceShadows() override {
        return timed([&] { scene_.occluded(shadow_, shadow_t_); });
    }
    std::uint64_t shadowRays() const override { return shadow_rays_; }

    Answers answer(std::span<const std::size_t> pixels) override {
        tracePrimary();
        traceShadows();
        Answers answers;
        std::vector<std::uint32_t> ray_of(order_.size());
        for (std::uint32_t k = 0; k < order_.size(); ++k) {
            ray_of[order_[k]] = k;
            answers.hits += std::isfinite(t_[k]);
        }
        for (std::size_t pixel : pixels) answers.pixels.push_back(answerOf(pixel, ray_of[pixel]));
        return answers;
    }

  private:
    static constexpr std::uint32_t kNoRay = ~0u;

    template <typename Trace>
    static Timing timed(Trace trace) {
        const double start = wallSeconds();
        trace();
        const double seconds = wallSeconds() - start;
        return {seconds, seconds};
    }

    double unit() const { return workload_.maps.reliefs[0].greatest_radius; }
    dvec3 hitPoint(std::size_t k) const {
        return dvec3(camera_.x[k], camera_.y[k], camera_.z[k]) +
               double(t_[k]) * dvec3(camera_.dx[k], camera_.dy[k], camera_.dz[k]);
    }

    void makeShadowRays() {
        const dmat4 object_from_world = glm::inverse(workload_.scene.shapes[0].world_from_object);
        const dvec3 world_sun = std::get<DistantLight>(workload_.scene.lights[0]).direction;
        const dvec3 sun = glm::normalize(transformVector(object_from_world, world_sun));
        std::vector<glm::vec3> normals(camera_.size());
        scene_.intersect(camera_, t_, normals.data());
        shadow_of_.assign(order_.size(), kNoRay);
        for (std::size_t k = 0; k < order_.size(); ++k) {
            if (!std::isfinite(t_[k])) continue;
            const dvec3 p = hitPoint(k);
            dvec3 n = glm::normalize(dvec3(normals[k]));
            if (glm::dot(n, p) < 0.0) n = -n;
            if (!(glm::dot(n, sun) > 0.0)) continue;
            shadow_of_[k] = std::uint32_t(shadow_rays_++);
            shadow_.add(p + kMeshOffset * n, sun);
        }
        shadow_.fillPackets();
        shadow_t_.resize(shadow_.size());
    }

    PixelAnswer answerOf(std::size_t pixel, std::uint32_t k) const {
        PixelAnswer result;
        result.pixel = pixel;
        result.answer.hit = std::isfinite(t_[k]);
        if (!result.answer.hit) return result;
        result.answer.shape = 0;
        result.answer.t = t_[k];
        result.answer.object_position = unit() * hitPoint(k);
        result.answer.normal = glm::normalize(result.answer.object_position);
        result.lit = shadow_of_[k] != kNoRay && shadow_t_[shadow_of_[k]] > 0.0f;
        return result;
    }

    const EmbreeScene& scene_;
    const Workload& workload_;
    std::vector<std::uint32_t> order_;  ///< pixel of each camera ray
    RaySet camera_, shadow_;
    std::vector<float> t_, shadow_t_;
    std::vector<std::uint32_t> shadow_of_;  ///< of each camera ray, kNoRay if none
    std::uint64_t shadow_rays_ = 0;
};

class OwnMeshScene : public MeshScene {
  public:
    OwnMeshScene(const Workload& workload, const Method& method)
        : scene_(NodeGrid(*workload.maps.maps[0]),
                 workload.maps.reliefs[0].base / workload.maps.reliefs[0].greatest_radius,
                 workload.maps.reliefs[0].scale / workload.maps.reliefs[0].greatest_radius, method.spacing,
                 method.engine == Engine::GridMesh ? MeshKind::Grid : MeshKind::Triangles) {}

    std::uint64_t memoryBytes() const override { return scene_.peakBytes(); }
    std::unique_ptr<Contender> contender(const Workload& workload, const View& view) const override {
        return std::make_unique<MeshContender>(scene_, workload, view);
    }

  private:
    EmbreeScene scene_;
};

}  // namespace

std::unique_ptr<MeshScene> makeMeshScene(const Workload& workload, const Method& method) {
    requireNodes(workload);
    return std::make_unique<OwnMeshScene>(workload, method);
}

}  // namespace dsphere::bench
