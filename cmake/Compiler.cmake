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
# Rule G1 of docs/design.md. GCC 12 drops roundings in the vectors that this makes: two doubles side by side that go to floats and back are copied, and
# x - double(float(x)) of two is 0. tests/base/rounding_test.cpp has both.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fno-tree-slp-vectorize)
endif()
if(DSPHERE_SANITIZE)
    add_compile_options(-fsanitize=${DSPHERE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${DSPHERE_SANITIZE})
endif()
option(DSPHERE_FUZZ "Build the fuzz targets of tests/fuzz, with Clang" OFF)
if(DSPHERE_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link)
endif()

# dsphere_precompiled_headers(name header...): headers that many files include, parsed once for all targets that
# dsphere_precompile(target name), which have to be compiled with the same options: GCC 12 crashed over headers of another -O.
# Each file still includes all that it needs: the preset `fuzz` builds without.
option(DSPHERE_PRECOMPILE "Parse common headers once for all files" ON)
function(dsphere_precompiled_headers name)
    file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp CONTENT "")
    add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
    target_precompile_headers(${name} PRIVATE ${ARGN})
endfunction()

function(dsphere_precompile target name)
    if(DSPHERE_PRECOMPILE)
        target_precompile_headers(${target} REUSE_FROM ${name})
    endif()
endfunction()

# dsphere_optimize_less(target): a quarter to a third less to compile, for code that takes no time itself.
function(dsphere_optimize_less target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    dsphere_precompile(${target} dsphere_headers_less)
endfunction()

# dsphere_library(name sources... LINK targets...): one library a folder of src/.
function(dsphere_library name)
    cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
    add_library(dsphere_${name} STATIC ${ARG_UNPARSED_ARGUMENTS})
    target_include_directories(dsphere_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
    target_link_libraries(dsphere_${name} PUBLIC ${ARG_LINK})
    set_target_properties(dsphere_${name} PROPERTIES EXPORT_NAME ${name})
    dsphere_precompile(dsphere_${name} dsphere_headers)
endfunction()

# dsphere_unity(target [files]): so many files, 12 by default, are compiled as one where their common headers, of GoogleTest,
# JSON or CLI11, are most of what there is to compile.
option(DSPHERE_UNITY "Compile several files at once: builds are faster, rebuilds after a small change slower" ON)
function(dsphere_unity target)
    set(files ${ARGN})
    if(NOT files)
        set(files 12)
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${DSPHERE_UNITY} UNITY_BUILD_BATCH_SIZE ${files})
    # GCC takes the one file for a header, whose anonymous namespaces would differ from one includer to the next.
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
    endif()
endfunction()

# dsphere_test_options(target): how tests, and the headers that they share, are compiled.
function(dsphere_test_options target)
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    if(DSPHERE_SANITIZE)  # GCC then follows variables for minutes, and takes some of std::regex's for uninitialized
        target_compile_options(${target} PRIVATE -O1 -g1 -Wno-maybe-uninitialized)
    endif()
endfunction()

# dsphere_test(name sources... LINK targets... [LABEL label] [SHARDS n]): one GoogleTest program, its cases named in ctest
# and labelled (default: fast). With SHARDS they are dealt out to n runs of it instead, where they share a device and the
# pipelines that it has made; ctest then knows them by their names where DSPHERE_CASES is set in the environment.
function(dsphere_test name)
    cmake_parse_arguments(ARG "" "SHARDS;LABEL" "LINK" ${ARGN})
    if(NOT ARG_LABEL)
        set(ARG_LABEL fast)
    endif()
    add_executable(${name}_test ${ARG_UNPARSED_ARGUMENTS})
    target_include_directories(${name}_test PRIVATE ${PROJECT_SOURCE_DIR})
    dsphere_unity(${name}_test)
    target_link_libraries(${name}_test PRIVATE ${ARG_LINK} GTest::gtest_main)
    dsphere_test_options(${name}_test)
    dsphere_precompile(${name}_test dsphere_test_headers)
    target_compile_definitions(${name}_test PRIVATE DSPHERE_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
    get_directory_property(found TEST_INCLUDE_FILES)
    gtest_discover_tests(${name}_test TEST_PREFIX "${name}." PROPERTIES TIMEOUT 300 LABELS ${ARG_LABEL}
                         DISCOVERY_TIMEOUT 60)
    if(NOT ARG_SHARDS)
        return()
    endif()
    get_directory_property(with_cases TEST_INCLUDE_FILES)
    list(GET with_cases -1 cases)
    set(asking ${CMAKE_CURRENT_BINARY_DIR}/${name}_cases.cmake)
    file(WRITE ${asking} "if(DEFINED ENV{DSPHERE_CASES})\n    include([==[${cases}]==])\nendif()\n")
    set_property(DIRECTORY PROPERTY TEST_INCLUDE_FILES ${found} ${asking})
    math(EXPR last "${ARG_SHARDS} - 1")
    foreach(shard RANGE ${last})
        add_test(NAME ${name}.shard${shard} COMMAND ${name}_test --gtest_brief=1)
        set_tests_properties(${name}.shard${shard} PROPERTIES TIMEOUT 900 COST 100 LABELS ${ARG_LABEL}
                             ENVIRONMENT "GTEST_TOTAL_SHARDS=${ARG_SHARDS};GTEST_SHARD_INDEX=${shard}")
    endforeach()
endfunction()
