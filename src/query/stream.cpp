#include "query/stream.h"

#include "base/error.h"

#include <atomic>
#include <chrono>
#include <future>

namespace dsphere::query {

namespace {

constexpr std::size_t kBlockRays = 1u << 19;
constexpr std::size_t kCertifiedRays = 1u << 14;  // the reference takes long over each: progress, and Ctrl-C

// Counts of a block; answers come from many threads.
struct BlockCounts {
    std::atomic<std::uint64_t> of[256] = {};

    void addTo(StreamCounts& counts) const {
        counts.hits += of[std::size_t(QueryStatus::Hit)];
        counts.inside += of[std::size_t(QueryStatus::Inside)];
        counts.invalid += of[std::size_t(QueryStatus::Invalid)];
    }
};

}  // namespace

StreamCounts streamRays(RayReader& reader, Engine& engine, const Record& record, HitWriter& writer,
                        Certifier* certifier, const Progress& progress) {
    const auto start = std::chrono::steady_clock::now();
    const std::size_t most = certifier ? kCertifiedRays : kBlockRays;
    StreamCounts counts;
    std::vector<double> rooms[2];
    std::vector<std::byte> records[2];
    const auto readInto = [&](int side) {
        return std::async(std::launch::async, [&, side] { return reader.read(rooms[side], most); });
    };
    std::future<RayRows> reading = readInto(0);
    std::future<void> writing;
    for (int side = 0;; side = 1 - side) {
        const RayRows rays = reading.get();
        const double share = reader.share().value_or(0.0);
        if (progress && !progress(share)) throw Error(ExitCode::Interrupted, "interrupted");
        if (rays.count == 0) break;
        reading = readInto(1 - side);
        records[side].resize(rays.count * record.bytes());
        BlockCounts block;
        engine.trace(rays, [&](std::size_t i, const Answer& answer) {
            block.of[std::size_t(answer.hit.status)].fetch_add(1, std::memory_order_relaxed);
            const Truth truth = certifier ? certifier->check(counts.rays + i, rays.at(i), answer) : Truth();
            record.put(records[side].data() + i * record.bytes(), answer.hit, truth);
        });
        block.addTo(counts);
        counts.rays += rays.count;
        if (writing.valid()) writing.get();
        writing = std::async(std::launch::async, [&, side] { writer.write(records[side]); });
    }
    if (writing.valid()) writing.get();
    counts.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return counts;
}

}  // namespace dsphere::query
