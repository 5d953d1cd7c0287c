# Compile settings of every target: C++20, warnings as errors, optional sanitizers.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(DSPHERE_SANITIZE "" CACHE STRING "Sanitizers to build with, as -fsanitize= takes them (address,undefined)")

# Assertions stay on in release: a broken invariant must stop the program, not a picture be wrong.
set(CMAKE_CXX_FLAGS_RELEASE "-O2")
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g")
# Contraction would make the shader functions compiled as C++ differ from lavapipe's in the last bit.
add_compile_options(-Wall -Wextra -Wpedantic -Werror -ffp-contract=off)
if(DSPHERE_SANITIZE)
    add_compile_options(-fsanitize=${DSPHERE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${DSPHERE_SANITIZE})
endif()

# dsphere_library(name sources... LINK targets...): one library a folder of src/.
function(dsphere_library name)
    cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
    add_library(dsphere_${name} STATIC ${ARG_UNPARSED_ARGUMENTS})
    target_include_directories(dsphere_${name} PUBLIC ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(dsphere_${name} PUBLIC ${ARG_LINK})
endfunction()

# dsphere_test(name sources... LINK targets...): one GoogleTest program, its cases named in ctest.
function(dsphere_test name)
    cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
    add_executable(${name}_test ${ARG_UNPARSED_ARGUMENTS})
    target_include_directories(${name}_test PRIVATE ${PROJECT_SOURCE_DIR})
    target_link_libraries(${name}_test PRIVATE ${ARG_LINK} GTest::gtest_main)
    target_compile_definitions(${name}_test PRIVATE DSPHERE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    gtest_discover_tests(${name}_test TEST_PREFIX "${name}." PROPERTIES TIMEOUT 300 DISCOVERY_TIMEOUT 60)
endfunction()
