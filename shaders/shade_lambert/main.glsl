// An invocation's pixel, by direct light. Expects what kernel.glsl has before.

void main() {
    readUniforms();
    Task task = findTask(0);
    if (!task.exists) return;
    const int sample_index = sampleOf(task);
    ivec2 raster = rasterOf(task);
    vec2 jitter = vec2(real(0));
    if (kWantsColour && sample_index >= 0) jitter = samplePosition(raster.x, raster.y, sample_index, params.seed);
    Gathered result = gatherDirect(cameraSegment(vec2(raster), jitter, task.safe_s));
    finish(task, result, sample_index);
}
