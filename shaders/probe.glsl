// A ray from a list against object 0.

ProbeHit probeObject(const ObjectData object, const MapData map, const ProbeRay query) {
    Line line;
    line.x = makePair(real(query.point.x), real(query.point_lo.x));
    line.y = makePair(real(query.point.y), real(query.point_lo.y));
    line.z = makePair(real(query.point.z), real(query.point_lo.z));
    line.dx = makePair(real(query.direction.x), real(query.direction_lo.x));
    line.dy = makePair(real(query.direction.y), real(query.direction_lo.y));
    line.dz = makePair(real(query.direction.z), real(query.direction_lo.z));
    Ray ray = makeRay(line, real(query.point.w), real(query.direction.w), query.flags == 0u);
    ObjectHit hit = hitObject(object, map, ray, ~0);
    ProbeHit answer;
    answer.position = vec4(hit.p, hit.hit ? dot(hit.p, ray.d) - ray.s_point : real(0));
    answer.normal = vec4(hit.n, hit.residual);
    answer.flags = (hit.hit ? 1u : 0u) | (hit.inside ? 2u : 0u) | (hit.exhausted ? 4u : 0u);
    answer.steps = uint(hit.steps);
    answer.pad0 = 0u;
    answer.pad1 = 0u;
    return answer;
}
