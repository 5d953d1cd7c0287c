# dsphere_shaders(target shader.comp...): compiles each shader to SPIR-V and embeds it as a C array
# `kSpirv_<name>` in `shaders/<name>.spv.h` on the target's include path. Relative paths are under shaders/; included files are tracked.
find_program(GLSLANG glslangValidator REQUIRED)
find_program(SPIRV_OPT spirv-opt REQUIRED)

# dsphere_shader_variant(target name shader.comp [MACRO=VALUE...]): the same of one shader, compiled with macros. Optimized
# here, once, and not by every driver at every start: lavapipe then takes a fifth of the time.
function(dsphere_shader_variant target name shader)
    list(TRANSFORM ARGN PREPEND -D OUTPUT_VARIABLE macros)
    cmake_path(ABSOLUTE_PATH shader BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/shaders OUTPUT_VARIABLE source)
    set(folder ${CMAKE_BINARY_DIR}/generated/shaders)
    set(spirv ${folder}/${name}.spv)
    set(flags ${PROJECT_SOURCE_DIR}/cmake/SpirvOptimization.flags)
    add_custom_command(
        OUTPUT ${spirv}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}
        COMMAND ${GLSLANG} --quiet --target-env vulkan1.1 -I${PROJECT_SOURCE_DIR}/shaders ${macros}
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
