#include "gpu/instance.h"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <mutex>

#include "base/error.h"
#include "gpu/result.h"

namespace dsphere::gpu {
namespace {

constexpr char kValidationLayer[] = "VK_LAYER_KHRONOS_validation";

void loadLoader() {
    if (volkGetInstanceVersion() == 0 && volkInitialize() != VK_SUCCESS) {
        throw Error(ExitCode::NoDevice, "no Vulkan device: the Vulkan loader (libvulkan.so.1) is not installed");
    }
    if (volkGetInstanceVersion() < VK_API_VERSION_1_1) {
        throw Error(ExitCode::NoDevice, "no Vulkan device: the Vulkan loader is older than Vulkan 1.1");
    }
}

bool layerInstalled(const char* name) {
    std::uint32_t count = 0;
    check(vkEnumerateInstanceLayerProperties(&count, nullptr), "vkEnumerateInstanceLayerProperties");
    std::vector<VkLayerProperties> layers(count);
    check(vkEnumerateInstanceLayerProperties(&count, layers.data()), "vkEnumerateInstanceLayerProperties");
    return std::ranges::any_of(layers, [&](const auto& layer) { return std::strcmp(layer.layerName, name) == 0; });
}

/// `layer` null: what the loader and the drivers offer.
bool extensionOffered(const char* layer, const char* name) {
    std::uint32_t count = 0;
    constexpr char kCall[] = "vkEnumerateInstanceExtensionProperties";
    check(vkEnumerateInstanceExtensionProperties(layer, &count, nullptr), kCall);
    std::vector<VkExtensionProperties> all(count);
    check(vkEnumerateInstanceExtensionProperties(layer, &count, all.data()), kCall);
    return std::ranges::any_of(all, [&](const auto& one) { return std::strcmp(one.extensionName, name) == 0; });
}

/// Keeps what validation says; of the loader's and drivers' general talk only errors.
VkBool32 VKAPI_PTR collect(VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT types,
                           const VkDebugUtilsMessengerCallbackDataEXT* data, void* user) {
    const bool error = severity >= VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    if (error || (types & VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT)) {
        // Pipelines are made on threads of their own.
        static std::mutex mutex;
        std::lock_guard lock(mutex);
        static_cast<std::vector<std::string>*>(user)->push_back(
            fmt::format("{}: {}", error ? "error" : "warning", data->pMessage));
    }
    return VK_FALSE;
}

VkDebugUtilsMessengerCreateInfoEXT messengerInfo(std::vector<std::string>* messages) {
    VkDebugUtilsMessengerCreateInfoEXT info = {VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
    info.messageSeverity =
        VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
    info.messageType = VK_DEBUG_UTILS_MESSAGE_TYPE_GENERAL_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT;
    info.pfnUserCallback = collect;
    info.pUserData = messages;
    return info;
}

/// The functions are the program's, not the instance's: one without a window's extensions that came later would take
/// those of an instance that has them.
void loadFunctions(VkInstance instance, bool extended) {
    static std::mutex mutex;
    static bool loaded_extended = false;
    const std::lock_guard lock(mutex);
    if (loaded_extended) return;
    volkLoadInstanceOnly(instance);
    loaded_extended = extended;
}

}  // namespace

Instance::Instance(bool validation, const std::vector<const char*>& more_extensions) {
    loadLoader();
    std::vector<const char*> layers;
    std::vector<const char*> extensions = more_extensions;
    for (const char* name : extensions)
        if (!extensionOffered(nullptr, name))
            throw Error(ExitCode::NoDevice, fmt::format("no Vulkan driver offers {}", name));
    if (validation) {
        if (!layerInstalled(kValidationLayer)) {
            throwFailure("validation was asked for, but the layer {} is not installed", kValidationLayer);
        }
        layers.push_back(kValidationLayer);
        extensions.push_back(VK_EXT_VALIDATION_FEATURES_EXTENSION_NAME);
    }
    debug_utils_ = extensionOffered(nullptr, VK_EXT_DEBUG_UTILS_EXTENSION_NAME) ||
                   (validation && extensionOffered(kValidationLayer, VK_EXT_DEBUG_UTILS_EXTENSION_NAME));
    if (debug_utils_) extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);

    VkApplicationInfo application = {VK_STRUCTURE_TYPE_APPLICATION_INFO};
    application.pApplicationName = "dsphere";
    application.apiVersion = VK_API_VERSION_1_1;

    // In pNext the messenger also hears what vkCreateInstance and vkDestroyInstance have to say.
    VkDebugUtilsMessengerCreateInfoEXT messenger = messengerInfo(&messages_);
    const VkValidationFeatureEnableEXT enabled[] = {VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT};
    VkValidationFeaturesEXT features = {VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
    features.pNext = debug_utils_ ? &messenger : nullptr;
    features.enabledValidationFeatureCount = std::size(enabled);
    features.pEnabledValidationFeatures = enabled;

    VkInstanceCreateInfo create = {VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
    create.pNext = validation ? &features : nullptr;
    create.pApplicationInfo = &application;
    create.enabledLayerCount = std::uint32_t(layers.size());
    create.ppEnabledLayerNames = layers.data();
    create.enabledExtensionCount = std::uint32_t(extensions.size());
    create.ppEnabledExtensionNames = extensions.data();
    const VkResult result = vkCreateInstance(&create, nullptr, &instance_);
    if (result == VK_ERROR_INCOMPATIBLE_DRIVER) {
        throw Error(ExitCode::NoDevice, "no Vulkan device: the Vulkan loader found no driver");
    }
    check(result, "vkCreateInstance");
    loadFunctions(instance_, !more_extensions.empty());
    if (validation && debug_utils_) createMessenger(messenger);
}

Instance::~Instance() {
    if (messenger_ != VK_NULL_HANDLE) vkDestroyDebugUtilsMessengerEXT(instance_, messenger_, nullptr);
    if (instance_ != VK_NULL_HANDLE) vkDestroyInstance(instance_, nullptr);
    for (const std::string& message : messages_) std::fprintf(stderr, "%s\n", message.c_str());
}

void Instance::createMessenger(const VkDebugUtilsMessengerCreateInfoEXT& create) {
    const VkResult result = vkCreateDebugUtilsMessengerEXT(instance_, &create, nullptr, &messenger_);
    if (result == VK_SUCCESS) return;
    vkDestroyInstance(instance_, nullptr);  // the destructor does not run after a throw in the constructor
    check(result, "vkCreateDebugUtilsMessengerEXT");
}

std::vector<VkPhysicalDevice> Instance::physicalDevices() const {
    std::uint32_t count = 0;
    VkResult result = vkEnumeratePhysicalDevices(instance_, &count, nullptr);
    // Older loaders answer VK_ERROR_INITIALIZATION_FAILED where a driver is installed but finds no device.
    if (result == VK_ERROR_INITIALIZATION_FAILED || (result == VK_SUCCESS && count == 0)) {
        throw Error(ExitCode::NoDevice, "no Vulkan device: a driver is installed, but it found no device");
    }
    check(result, "vkEnumeratePhysicalDevices");
    std::vector<VkPhysicalDevice> devices(count);
    check(vkEnumeratePhysicalDevices(instance_, &count, devices.data()), "vkEnumeratePhysicalDevices");
    return devices;
}

}  // namespace dsphere::gpu
