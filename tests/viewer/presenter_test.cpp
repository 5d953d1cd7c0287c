// What the presenter does when the window has changed or the device is lost, in an X server of the test's own. The
// chain's own calls are made; their results are replaced.

#include "viewer/presenter.h"

#include "base/error.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"
#include "tests/support/testdevice.h"
#include "tests/viewer/desktop.h"
#include "viewer/window.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <memory>

namespace dsphere::viewer {
namespace {

/// What the next calls say they met; success once it is empty.
std::deque<VkResult> acquired, presented;
PFN_vkAcquireNextImageKHR real_acquire;
PFN_vkQueuePresentKHR real_present;

VkResult next(std::deque<VkResult>& results) {
    if (results.empty()) return VK_SUCCESS;
    VkResult result = results.front();
    results.pop_front();
    return result;
}

// A failure acquires nothing; the real call would leave a picture that nobody presents.
VkResult acquire(VkDevice device, VkSwapchainKHR chain, std::uint64_t timeout, VkSemaphore semaphore, VkFence fence,
                 std::uint32_t* index) {
    VkResult result = next(acquired);
    return result < 0 ? result : std::max(result, real_acquire(device, chain, timeout, semaphore, fence, index));
}

VkResult present(VkQueue queue, const VkPresentInfoKHR* info) {
    VkResult result = next(presented), real = real_present(queue, info);
    return result == VK_SUCCESS ? real : result;
}

class PresenterTest : public testing::Test {
  protected:
    void SetUp() override {
        if (!test::desktopAvailable()) GTEST_SKIP() << "Xvfb or xdotool is missing";
        setenv("XDG_CACHE_HOME", folder_.path().c_str(), 1);
        desktop_ = std::make_unique<test::Desktop>(folder_.path());
        setenv("DISPLAY", desktop_->display().c_str(), 1);
        unsetenv("WAYLAND_DISPLAY");
        window_ = std::make_unique<Window>(64, 48, "presenter");
        const gpu::Presentation presentation = window_->presentation(true);
        device_ = std::make_unique<gpu::Device>(gpu::DeviceOptions{test::testDevice(), true, &presentation});
        const ChainCalls own = ChainCalls::of(*device_);
        real_acquire = own.acquire;
        real_present = own.present;
        acquired.clear();
        presented.clear();
        presenter_ = std::make_unique<Presenter>(*device_, *device_, ChainCalls{acquire, present});
        const unsigned char white[4] = {255, 255, 255, 255};
        presenter_->setFont(white, 1, 1);
        presenter_->resize(64, 48);
    }
    void TearDown() override {
        presenter_.reset();
        if (!device_) return;
        for (const std::string& message : device_->validationMessages()) ADD_FAILURE() << message;
    }

    bool draw() {
        ImDrawData nothing;
        nothing.DisplaySize = ImVec2(64.0f, 48.0f);
        nothing.FramebufferScale = ImVec2(1.0f, 1.0f);
        return presenter_->draw(nothing);
    }

    test::TempFolder folder_;
    std::unique_ptr<test::Desktop> desktop_;
    std::unique_ptr<Window> window_;
    std::unique_ptr<gpu::Device> device_;
    std::unique_ptr<Presenter> presenter_;
};

TEST_F(PresenterTest, DrawsFrameAfterFrame) {
    for (int k = 0; k < 5; ++k) EXPECT_TRUE(draw());
    presenter_->resize(80, 20);
    for (int k = 0; k < 5; ++k) EXPECT_TRUE(draw());
}

TEST_F(PresenterTest, AChainOutOfDateIsMadeAnew) {
    EXPECT_TRUE(draw());
    acquired = {VK_ERROR_OUT_OF_DATE_KHR};
    EXPECT_FALSE(draw()) << "nothing was acquired";
    EXPECT_TRUE(draw());
    presented = {VK_ERROR_OUT_OF_DATE_KHR};
    EXPECT_FALSE(draw()) << "it was not shown";
    EXPECT_TRUE(draw());
}

TEST_F(PresenterTest, AChainNoLongerTheBestIsMadeAnewOnceItsPictureIsPresented) {
    acquired = {VK_SUBOPTIMAL_KHR};
    EXPECT_TRUE(draw()) << "the picture is as good as any";
    presented = {VK_SUBOPTIMAL_KHR};
    EXPECT_FALSE(draw());
    EXPECT_TRUE(draw());
}

TEST_F(PresenterTest, ChangesInARowAreBorne) {
    for (int k = 0; k < 4; ++k) {
        acquired.push_back(k % 2 ? VK_SUCCESS : VK_ERROR_OUT_OF_DATE_KHR);
        presented.push_back(k % 2 ? VK_ERROR_OUT_OF_DATE_KHR : VK_SUBOPTIMAL_KHR);
    }
    int shown = 0;
    for (int k = 0; k < 12; ++k) shown += draw() ? 1 : 0;
    EXPECT_GE(shown, 6);
    EXPECT_TRUE(draw());
}

TEST_F(PresenterTest, ALostDeviceIsAnErrorThatNamesTheCall) {
    acquired = {VK_ERROR_DEVICE_LOST};
    std::string message = test::messageOf(ExitCode::Failure, [&] { draw(); });
    EXPECT_TRUE(test::holds(message, "vkAcquireNextImageKHR")) << message;
    EXPECT_TRUE(test::holds(message, "VK_ERROR_DEVICE_LOST")) << message;
    presented = {VK_ERROR_DEVICE_LOST};
    message = test::messageOf(ExitCode::Failure, [&] { draw(); });
    EXPECT_TRUE(test::holds(message, "vkQueuePresentKHR")) << message;
}

TEST_F(PresenterTest, AWindowThatIsGoneIsAnError) {
    acquired = {VK_ERROR_SURFACE_LOST_KHR};
    EXPECT_TRUE(test::holds(test::messageOf(ExitCode::Failure, [&] { draw(); }), "VK_ERROR_SURFACE_LOST_KHR"));
}

}  // namespace
}  // namespace dsphere::viewer
