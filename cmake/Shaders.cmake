# dsphere_shaders(target shader.comp...): compiles each shader to SPIR-V and embeds it as a C array
# `kSpirv_<name>` in `shaders/<name>.spv.h` on the target's include path. Relative paths are under shaders/; included files are tracked.
find_program(GLSLANG glslangValidator REQUIRED)

# dsphere_shader_variant(target name shader.comp [MACRO=VALUE...]): the same of one shader, compiled with macros.
function(dsphere_shader_variant target name shader)
    list(TRANSFORM ARGN PREPEND -D OUTPUT_VARIABLE macros)
    cmake_path(ABSOLUTE_PATH shader BASE_DIRECTORY ${PROJECT_SOURCE_DIR}/shaders OUTPUT_VARIABLE source)
    set(header ${CMAKE_BINARY_DIR}/generated/shaders/${name}.spv.h)
    add_custom_command(
        OUTPUT ${header}
        COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/generated/shaders
        COMMAND ${GLSLANG} --quiet --target-env vulkan1.1 -I${PROJECT_SOURCE_DIR}/shaders ${macros}
                --vn kSpirv_${name} --depfile ${header}.d -o ${header} ${source}
        DEPENDS ${source}
        DEPFILE ${header}.d
        COMMENT "Compiling shader ${name}"
        VERBATIM)
    target_sources(${target} PRIVATE ${header})
    target_include_directories(${target} PRIVATE ${CMAKE_BINARY_DIR}/generated)
endfunction()

function(dsphere_shaders target)
    foreach(shader ${ARGN})
        get_filename_component(name ${shader} NAME_WE)
        dsphere_shader_variant(${target} ${name} ${shader})
    endforeach()
endfunction()
