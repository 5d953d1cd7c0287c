// How far is the ground straight below a satellite, and does the satellite see a station on it?
// Usage: example SCENE|MAP

#include <dsphere/query.h>

#include <cstdio>
#include <exception>
#include <vector>

int main(int count, char** words) try {
    if (count != 2) return std::fputs("usage: example SCENE|MAP\n", stderr), 2;
    dsphere::Query query(words[1], {.frame = dsphere::QueryOptions::Frame::Body});

    // Along the equator, 4 units from the centre; longitude 0 is on +z, 90 on +x.
    const std::vector<dsphere::QueryRay> down = {{{0, 0, 4}, {0, 0, -1}}, {{4, 0, 0}, {-1, 0, 0}}};
    for (const dsphere::CertifiedHit& shot : query.traceCertified(down)) {
        if (shot.wrong) return std::fputs("the device is wrong\n", stderr), 1;
        std::printf("range %.6f at latitude %.3f, longitude %.3f\n", shot.hit.t, shot.hit.latitude, shot.hit.longitude);
    }

    // From each satellite to a point 2 units above the north pole: t counts in the direction, so that t_max = 1 is
    // there.
    std::vector<dsphere::QueryRay> sight = {{{0, 0, 4}, {0, 2, -4}}, {{0, -4, 0}, {0, 6, 0}}};
    for (dsphere::QueryRay& ray : sight) ray.t_max = 1.0;
    for (const dsphere::QueryStatus status : query.statuses(sight))
        std::printf("%s\n", status == dsphere::QueryStatus::Miss ? "in sight" : "hidden");
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
