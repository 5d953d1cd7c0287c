#pragma once

// Right first hits for rays of one's own, as a library: find_package(dsphere) and the target dsphere::query. This
// header needs no other. Everything that fails throws std::runtime_error, whose what() says what is wrong, and where.

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace dsphere {

/// The points origin + t direction with t_min <= t < t_max. The direction has any length but 0: t is in units of it.
struct QueryRay {
    std::array<double, 3> origin, direction;
    double t_min = 0.0, t_max = std::numeric_limits<double>::infinity();
};

enum class QueryStatus : std::uint8_t {
    Miss = 0,
    Hit = 1,
    Inside = 2,     ///< the ray starts in a shape's solid: the answer is its start, at t_min
    Invalid = 255,  ///< the ray is none: something of it is not finite (but t_max), or its direction is 0
};

struct QueryHit {
    static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();  ///< where a value means nothing
    static constexpr float kNoneFloat = std::numeric_limits<float>::quiet_NaN();

    QueryStatus status = QueryStatus::Miss;
    double t = kNone;                                                 ///< in units of |direction|
    std::array<double, 3> position{kNone, kNone, kNone};              ///< in the rays' frame
    std::array<float, 3> normal{kNoneFloat, kNoneFloat, kNoneFloat};  ///< unit, outward, in the rays' frame
    double u = kNone, v = kNone;                                      ///< the shape's own, 0 to 1
    double latitude = kNone, longitude = kNone;  ///< degrees, of a displaced sphere: -180 to 180, east positive
    double height = kNone;                       ///< in the map's stored unit
    double metres = kNone;  ///< the same in metres above its datum, where the map says what they mean
    std::uint32_t id = 0;   ///< 1 + the shape's place in the scene; 0: a miss
    std::uint32_t lit = 0;  ///< bit i: light i of the scene is visible from there; none inside
};

/// An answer with what the certified reference, which shares no code with the device's marcher, says of it.
struct CertifiedHit {
    QueryHit hit;
    double t_low = QueryHit::kNone, t_high = QueryHit::kNone;  ///< enclose the first root; NaN: proven to meet nothing
    bool wrong = false;  ///< the answer breaks the contract: a defect of the program or of the device
};

struct QueryOptions {
    /// Body: the object space of the scene's first displaced sphere, whose poles are on the y axis and longitude 0 on
    /// +z.
    enum class Frame { World, Body };

    Frame frame = Frame::World;
    bool lit = false;         ///< whether QueryHit::lit is wanted: it takes a shadow ray for each light
    std::string device = "";  ///< a Vulkan device by its index or a part of its name, or "cpu"; empty: the best one
};

/// A scene, or a heightmap, made ready on a device. Use from one thread at a time.
class Query {
  public:
    /// Reads a scene file or a heightmap.
    explicit Query(const std::string& scene_or_map, const QueryOptions& options = {});
    ~Query();
    Query(Query&&) noexcept;
    Query& operator=(Query&&) noexcept;

    /// One answer a ray, in their order. Any number of rays; many at once take less time for each.
    std::vector<QueryHit> trace(std::span<const QueryRay> rays);
    QueryHit trace(const QueryRay& ray);

    /// Only whether something lies between t_min and t_max (lines of sight), which is faster.
    std::vector<QueryStatus> statuses(std::span<const QueryRay> rays);

    /// trace(), and the reference's word on each answer, on all cores; some ten times as slow.
    std::vector<CertifiedHit> traceCertified(std::span<const QueryRay> rays);

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace dsphere
