# find_package(dsphere): the target dsphere::query, whose header is dsphere/query.h.
include(CMakeFindDependencyMacro)
foreach(dependency Threads glm fmt nlohmann_json OpenEXR TIFF PNG JPEG)
    find_dependency(${dependency})
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/dsphere-targets.cmake)
