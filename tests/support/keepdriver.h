#pragma once

// For test programs that open devices, under the leak sanitizer. Include in exactly one source file of the program.

#include <dlfcn.h>

/// True if the library is installed; nothing depends on it.
inline bool keepLibrary(const char* name) {
    return dlopen(name, RTLD_NOW | RTLD_NODELETE) != nullptr;
}

// The Vulkan loader unloads driver and layer with the last instance. Kept in memory, what their globals hold (LLVM's
// 128 bytes an instance) stays in reach, and the rest carries the library's name.
inline const bool kDriverKept = keepLibrary("libvulkan_lvp.so");
// NVIDIA's cannot be loaded again a few times over (580.159): the loader then finds no driver.
inline const bool kNvidiaKept = keepLibrary("libGLX_nvidia.so.0");
inline const bool kValidationKept = keepLibrary("libVkLayer_khronos_validation.so");

// Leaks of their own: lavapipe 22.3 the names of descriptor sets that go with their pool, the validation layer 1.3.239
// its record of each command buffer. Objects that we forget are still found: the layer names them at vkDestroyDevice.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libvulkan_lvp.so\nleak:libVkLayer_khronos_validation.so\n";
}
