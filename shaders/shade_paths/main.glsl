// An invocation's pixels, by paths. Expects what kernel.glsl has before.

Rules rulesOf(const int sample_index) {
    Rules rules;
    rules.centre = sample_index < 0;
    rules.shadowed = kShadows != 0;
    rules.weighed = !rules.centre && kDiffusePaths != 0;
    return rules;
}

Path pathOf(const Task task, const int sample_index) {
    ivec2 raster = rasterOf(task);
    Numbers numbers;
    numbers.key = pixelKey(raster.x, raster.y, params.seed);
    numbers.index = max(sample_index, 0);
    vec2 jitter = sample_index < 0 ? vec2(real(0)) : filterPlace(numbersAt(numbers, 0, 0u));
    return startPath(cameraSegment(vec2(raster), jitter, task.safe_s), numbers, task.exists);
}

// All invocations of a SIMD group pay for the longest of their paths. So each takes its next pixel as soon as a path
// ends, and they come out even. What an invocation that has had long searches has not begun goes to the retry: the group's
// loops together have a limit of iterations, see layout.h.
void main() {
    readUniforms();
    Task task = findTask(0);
    const int sample_index = sampleOf(task);
    Rules rules = rulesOf(sample_index);
    Path path = pathOf(task, sample_index);
    int steps = 0;
    int done = 0;
    for (int n = 0; n < kTasks * (kMaxDepth + 1); ++n) {
        if (path.going) {
            extendPath(path, rules);
            if (!path.going) {
                steps += path.result.searches.steps;
                finish(task, resultOf(path, rules), sample_index);
            }
        }
        if (!path.going) ++done;
        if (kTasks > 1 && !path.going && done < kTasks) {
            task = findTask(done);
            path = pathOf(task, sample_index);
            if (path.going && steps > NEXT_PIXEL_STEPS) {
                leaveForRetry(task.pixel, task.safe_s);
                path.going = false;
            }
        }
        if (done == kTasks) break;
    }
}
