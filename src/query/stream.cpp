#include "query/stream.h"

#include "base/error.h"

#include <atomic>
#include <chrono>
#include <future>

namespace dsphere::query {

namespace {

constexpr std::size_t kBlockRays = 1u << 18;
constexpr std::size_t kCertifiedRays = 1u << 14;  // the reference takes long over each: progress, and Ctrl-C

// Counts of answers; they come from many threads.
struct BlockCounts {
    std::atomic<std::uint64_t> hits = 0, inside = 0, invalid = 0;

    void add(std::span<const Answer> answers) {
        addThose(hits, answers, QueryStatus::Hit);
        addThose(inside, answers, QueryStatus::Inside);
        addThose(invalid, answers, QueryStatus::Invalid);
    }
    static void addThose(std::atomic<std::uint64_t>& count, std::span<const Answer> answers, QueryStatus status) {
        std::uint64_t some = 0;
        for (const Answer& answer : answers) some += answer.hit.status == status;
        if (some > 0) count += some;
    }
    void addTo(StreamCounts& counts) const {
        counts.hits += hits;
        counts.inside += inside;
        counts.invalid += invalid;
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
        engine.traceBatches(
            rays.count, [&](std::size_t first, std::span<QueryRay> some) { rays.copyTo(first, some); },
            [&](std::size_t first, std::span<const Answer> answers) {
                block.add(answers);
                std::vector<Truth> truths;
                for (std::size_t k = 0; certifier && k < answers.size(); ++k)
                    truths.push_back(certifier->check(counts.rays + first + k, rays.at(first + k), answers[k]));
                record.put(records[side].data() + first * record.bytes(), answers, truths);
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
