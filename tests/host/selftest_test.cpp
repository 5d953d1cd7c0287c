// The test scenes hold on the host, and a fault is laid to the first step that has it.

#include "verify/selftest.h"
#include "host/hostrenderer.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dsphere::test {
namespace {

using host::HostRenderer;
using host::Precision;
using verify::Candidate;
using verify::Step;

/// A renderer whose pictures have one normal in ten turned round.
class Spoilt final : public SceneRenderer {
  public:
    explicit Spoilt(std::unique_ptr<SceneRenderer> renderer) : renderer_(std::move(renderer)) {}

    void setCamera(const Scene& scene) override { renderer_->setCamera(scene); }
    void setCrop(const Box& crop) override { renderer_->setCrop(crop); }
    void setLook(const Scene& scene, const SceneMaps& maps) override { renderer_->setLook(scene, maps); }
    void setPacking(const PackedScene& packed) override { renderer_->setPacking(packed); }
    SampleSums renderSums(SampleSums start, int from, int to, std::uint32_t seed, const Progress& progress,
                          std::uint32_t planes) override {
        return renderer_->renderSums(std::move(start), from, to, seed, progress, planes);
    }
    Image renderPlanes(std::uint32_t mask, const Progress& progress) override {
        Image image = renderer_->renderPlanes(mask, progress);
        for (Channel& channel : image.channels)
            if (channel.name.starts_with("N."))
                for (std::size_t i = 0; i < channel.floats().size(); i += 10)
                    channel.floats()[i] = -channel.floats()[i];
        return image;
    }
    const RenderStats& stats() const override { return renderer_->stats(); }
    std::uint64_t mapBytes() const override { return renderer_->mapBytes(); }
    std::uint64_t imageBytes() const override { return renderer_->imageBytes(); }

  private:
    std::unique_ptr<SceneRenderer> renderer_;
};

Candidate candidate(const char* name, Precision precision, bool spoilt) {
    return {name, [=](const PackedScene& packed, const Scene& scene) -> std::unique_ptr<SceneRenderer> {
                auto renderer = std::make_unique<HostRenderer>(packed, scene, Marcher::Exact, precision);
                if (spoilt) return std::make_unique<Spoilt>(std::move(renderer));
                return renderer;
            }};
}

verify::SelftestRow rowOf(int scene, bool spoil_double, bool spoil_float, bool spoil_device) {
    const Candidate device = candidate("device", Precision::Float, spoil_device);
    return verify::selftestScene(scene, candidate("double", Precision::Double, spoil_double),
                                 candidate("float", Precision::Float, spoil_float), &device);
}

TEST(SelftestTest, EveryTestSceneHolds) {
    for (int i = 0; i < verify::testSceneCount(); ++i) {
        const verify::SelftestRow row = rowOf(i, false, false, false);
        EXPECT_EQ(row.step, Step::None) << row.scene;
        ASSERT_EQ(row.results.size(), 3u);
        for (const verify::SceneResult& result : row.results) {
            EXPECT_GT(result.report.hits, 1000u) << row.scene;
            EXPECT_TRUE(result.faults.empty()) << row.scene << ", " << result.device << ": " << result.faults.front();
        }
    }
}

TEST(SelftestTest, NamesTheFirstStepThatFails) {
    EXPECT_EQ(rowOf(0, true, true, true).step, Step::Algorithm);
    EXPECT_EQ(rowOf(0, false, true, true).step, Step::Precision);
    const verify::SelftestRow row = rowOf(0, false, false, true);
    EXPECT_EQ(row.step, Step::Driver);
    EXPECT_TRUE(row.results[1].faults.empty());
    const std::vector<std::string>& faults = row.results[2].faults;
    EXPECT_TRUE(std::ranges::any_of(faults, [](const std::string& fault) {
        return fault.starts_with("normal N differs from float in ");
    })) << faults.size();
}

}  // namespace
}  // namespace dsphere::test
