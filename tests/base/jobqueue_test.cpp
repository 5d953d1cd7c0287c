#include "base/jobqueue.h"

#include "base/error.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

namespace dsphere {
namespace {

TEST(JobQueue, RunsJobsInTheirOrder) {
    std::vector<int> done;
    JobQueue queue(2);
    for (int i = 0; i < 100; ++i) queue.add([&done, i] { done.push_back(i); });
    queue.finish();
    ASSERT_EQ(done.size(), 100u);
    for (int i = 0; i < 100; ++i) EXPECT_EQ(done[std::size_t(i)], i);
}

TEST(JobQueue, LetsNoMoreThanThatManyWait) {
    std::atomic<int> begun = 0;
    std::atomic<bool> go = false;
    std::atomic<int> added = 0;
    JobQueue queue(2);
    std::thread adder([&] {
        for (int i = 0; i < 10; ++i) {
            queue.add([&] {
                ++begun;
                go.wait(false);
            });
            ++added;
        }
    });
    while (begun < 1) std::this_thread::yield();
    while (added < 3) std::this_thread::yield();
    EXPECT_EQ(begun, 1);
    EXPECT_EQ(added, 3) << "one runs, two wait";
    go = true;
    go.notify_all();
    adder.join();
    queue.finish();
    EXPECT_EQ(begun, 10);
}

TEST(JobQueue, StopsAtAFailureAndTellsIt) {
    std::atomic<int> run = 0;
    JobQueue queue(4);
    queue.add([&] { ++run; });
    queue.add([] { throwFailure("the disk is full"); });
    const auto addTillItThrows = [&] {
        for (;;) queue.add([&] { ++run; });
    };
    EXPECT_THROW(addTillItThrows(), Error);
    EXPECT_THROW(queue.finish(), Error);
    EXPECT_EQ(run, 1);
}

TEST(JobQueue, ItsEndFinishesWhatWasAdded) {
    int run = 0;
    {
        JobQueue queue(8);
        for (int i = 0; i < 5; ++i) queue.add([&] { ++run; });
    }
    EXPECT_EQ(run, 5);
}

}  // namespace
}  // namespace dsphere
