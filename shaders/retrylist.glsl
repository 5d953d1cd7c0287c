// The list of what the filter leaves to full precision.
layout(std430, binding = BINDING_RETRY) buffer Retry {
    RetryHead retry;
    RetryPixel retry_pixels[];
};
