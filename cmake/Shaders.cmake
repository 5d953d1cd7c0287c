# dsphere_shaders(target shader.comp...): compiles each shader to SPIR-V and embeds it as a C array
# `kSpirv_<name>` in `shaders/<name>.spv.h` on the target's include path. Relative paths are under shaders/; included files are tracked.
find_program(GLSLANG glslangValidator REQUIRED)
find_program(SPIRV_OPT spirv-opt REQUIRED)

# dsphere_shader_variant(target name shader.comp [folder...]): the same of one shader, whose includes are looked for in those
# folders of shaders/ as well. Optimized here, once, and not by every driver at every start (rule L6): lavapipe then takes a
# fifth of the time.
function(dsphere_shader_variant target name shader)
    list(TRANSFORM ARGN PREPEND -I${PROJECT_SOURCE_DIR}/shaders/ OUTPUT_VARIABLE folders)
    cmake_path(ABSOLUTE_PATH shader BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/shaders OUTPUT_VARIABLE source)
    set(folder ${CMAKE_BINARY_DIR}/generated/shaders)
    set(spirv ${folder}/${name}.spv)
    set(flags ${PROJECT_SOURCE_DIR}/cmake/SpirvOptimization.flags)
    add_custom_command(
        OUTPUT ${spirv}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
        COMMAND ${GLSLANG} --quiet --target-env vulkan1.1 -I${PROJECT_SOURCE_DIR}/shaders ${folders}
                --depfile ${spirv}.d -o ${spirv} ${source}
        DEPENDS ${source}
        DEPFILE ${spirv}.d
        COMMENT "Compiling shader ${name}"
        VERBATIM)
    add_custom_command(
        OUTPUT ${spirv}.h
        COMMAND ${SPIRV_OPT} --target-env=vulkan1.1 -Oconfig=${flags} ${spirv} -o ${folder}/${name}.opt.spv
        COMMAND ${CMAKE_COMMAND} -D INPUT=${folder}/${name}.opt.spv -D OUTPUT=${spirv}.h -D NAME=kSpirv_${name}
                -P ${PROJECT_SOURCE_DIR}/cmake/EmbedSpirv.cmake
        DEPENDS ${spirv} ${flags} ${PROJECT_SOURCE_DIR}/cmake/EmbedSpirv.cmake
        COMMENT "Optimizing shader ${name}"
        VERBATIM)
    target_sources(${target} PRIVATE ${spirv}.h)
    target_include_directories(${target} PRIVATE ${CMAKE_BINARY_DIR}/generated)
endfunction()

function(dsphere_shaders target)
    foreach(shader ${ARGN})
        get_filename_component(name ${shader} NAME_WE)
        dsphere_shader_variant(${target} ${name} ${shader})
    endforeach()
endfunction()

# What scenes hold has three variants of the kernel, from the leanest on: bilinear surfaces pay nothing for splines, ripples
# and smooth normals, nor do Lambert's materials under distant and point lights for other ones, paths and meshes. On the
# device (src/render) and on the host (src/host) alike.
set(DSPHERE_VARIANTS lean curved paths)
set(DSPHERE_VARIANT_lean patch_bilinear shade_lambert)
set(DSPHERE_VARIANT_curved patch_curved shade_lambert)
set(DSPHERE_VARIANT_paths patch_curved shade_paths)

# dsphere_shader_variants(target name shader.comp folder... [WITHOUT variant...]): all three, and the header
# shaders/<name>.variants.h with them as `kVariants_<name>`. `paths`, which knows all, stands in for those left out.
function(dsphere_shader_variants target name shader)
    cmake_parse_arguments(PARSE_ARGV 3 ARG "" "" "WITHOUT")
    set(includes "")
    set(arrays "")
    foreach(variant ${DSPHERE_VARIANTS})
        if(variant IN_LIST ARG_WITHOUT)
            list(APPEND arrays kSpirv_${name}_paths)
            continue()
        endif()
        dsphere_shader_variant(${target} ${name}_${variant} ${shader} ${ARG_UNPARSED_ARGUMENTS} ${DSPHERE_VARIANT_${variant}})
        string(APPEND includes "#include \"shaders/${name}_${variant}.spv.h\"\n")
        list(APPEND arrays kSpirv_${name}_${variant})
    endforeach()
    list(JOIN arrays ", " arrays)
    file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/generated/shaders/${name}.variants.h
         CONTENT "#pragma once\n#include \"render/variants.h\"\n${includes}namespace dsphere {\nconst Variants kVariants_${name} = {${arrays}};\n}\n")
endfunction()
