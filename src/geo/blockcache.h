#pragma once

// Decoded blocks of a file, kept for the windows that share them.

#include <cstddef>
#include <cstdint>
#include <future>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>
#include <vector>

namespace dsphere::geo {

/// May be used by several threads at once. The blocks that were asked for longest ago leave first.
class BlockCache {
  public:
    using Samples = std::shared_ptr<const std::vector<std::byte>>;

    static constexpr std::size_t kBytes = std::size_t(32) << 20;  ///< of all blocks, but for those in use

    /// The block of that number: as kept, or of `bytes` that `read(to)` writes. A thread that asks for one that another
    /// is reading waits for it, and throws what that has thrown.
    template <typename Read>
    Samples get(std::int64_t number, std::size_t bytes, const Read& read) {
        std::promise<Samples> made;
        if (const std::shared_future<Samples> known = findOrPromise(number, made); known.valid()) return known.get();
        try {
            std::vector<std::byte> buffer = spare_->take();
            buffer.resize(bytes);
            read(buffer.data());
            Samples samples(new std::vector(std::move(buffer)), [spare = spare_](std::vector<std::byte>* left) {
                spare->put(std::move(*left));
                delete left;
            });
            made.set_value(samples);
            dropOldest(bytes);
            return samples;
        } catch (...) {
            made.set_exception(std::current_exception());
            forget(number);
            throw;
        }
    }

  private:
    /// The memory of a block that has left, for the next one: threads that allocate and free a block each would leave
    /// holes in the heaps of all.
    class Spare {
      public:
        std::vector<std::byte> take() {
            const std::lock_guard lock(mutex_);
            return std::exchange(buffer_, {});
        }
        void put(std::vector<std::byte> buffer) {
            const std::lock_guard lock(mutex_);
            buffer_.swap(buffer);
        }

      private:
        std::mutex mutex_;
        std::vector<std::byte> buffer_;
    };

    struct Block {
        std::int64_t number;
        std::shared_future<Samples> samples;
    };

    /// Without a state: the block is new, and others will wait for `made`.
    std::shared_future<Samples> findOrPromise(std::int64_t number, std::promise<Samples>& made) {
        const std::lock_guard lock(mutex_);
        if (const auto found = places_.find(number); found != places_.end()) {
            blocks_.splice(blocks_.begin(), blocks_, found->second);
            return found->second->samples;
        }
        blocks_.push_front({number, made.get_future().share()});
        places_[number] = blocks_.begin();
        return {};
    }

    // All blocks but those at the file's edges are of one size.
    void dropOldest(std::size_t bytes) {
        const std::lock_guard lock(mutex_);
        while (blocks_.size() > 1 && blocks_.size() * bytes > kBytes) {
            places_.erase(blocks_.back().number);
            blocks_.pop_back();
        }
    }

    void forget(std::int64_t number) {
        const std::lock_guard lock(mutex_);
        const auto found = places_.find(number);
        if (found == places_.end()) return;
        blocks_.erase(found->second);
        places_.erase(found);
    }

    std::mutex mutex_;
    std::list<Block> blocks_;  ///< the last asked for first
    std::shared_ptr<Spare> spare_ = std::make_shared<Spare>();
    std::unordered_map<std::int64_t, std::list<Block>::iterator> places_;
};

}  // namespace dsphere::geo
