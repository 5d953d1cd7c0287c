#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace dsphere {

/// Runs jobs in their order on a thread of its own, beside the work of the caller. Few may wait: what they hold, a
/// picture each, must not pile up.
class JobQueue {
  public:
    explicit JobQueue(std::size_t most_waiting);
    /// Finishes the jobs that were added; their failures are lost unless finish() was called.
    ~JobQueue();
    JobQueue(const JobQueue&) = delete;
    JobQueue& operator=(const JobQueue&) = delete;

    /// Waits while as many jobs as may be are waiting. Throws what a job before has thrown, after which none is run.
    void add(std::function<void()> job);
    /// Waits until all jobs are done. Throws what one of them has thrown.
    void finish();

  private:
    void work();

    std::size_t most_waiting_;
    std::deque<std::function<void()>> jobs_;
    bool running_ = false;  ///< a job that is no longer in jobs_
    bool closed_ = false;
    std::exception_ptr failure_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::thread thread_;
};

}  // namespace dsphere
