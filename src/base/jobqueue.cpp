#include "base/jobqueue.h"

#include <utility>

namespace dsphere {

JobQueue::JobQueue(std::size_t most_waiting) : most_waiting_(most_waiting), thread_([this] { work(); }) {}

JobQueue::~JobQueue() {
    {
        std::lock_guard lock(mutex_);
        closed_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void JobQueue::add(std::function<void()> job) {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return jobs_.size() < most_waiting_ || failure_; });
    if (failure_) std::rethrow_exception(failure_);
    jobs_.push_back(std::move(job));
    changed_.notify_all();
}

void JobQueue::finish() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return (jobs_.empty() && !running_) || failure_; });
    if (failure_) std::rethrow_exception(failure_);
}

void JobQueue::work() {
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return !jobs_.empty() || closed_; });
        if (jobs_.empty()) return;
        std::function<void()> job = std::move(jobs_.front());
        jobs_.pop_front();
        running_ = !failure_;
        changed_.notify_all();
        if (failure_) continue;
        lock.unlock();
        std::exception_ptr thrown;
        try {
            job();
        } catch (...) {
            thrown = std::current_exception();
        }
        job = nullptr;  // what it holds goes before the next one starts
        lock.lock();
        failure_ = thrown;
        running_ = false;
        changed_.notify_all();
    }
}

}  // namespace dsphere
