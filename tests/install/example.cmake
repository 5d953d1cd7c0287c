# Installs the library, builds the example against it, and runs it.
file(REMOVE_RECURSE ${FOLDER})
set(prefix ${FOLDER}/prefix)

function(run)
    execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT code EQUAL 0)
        message(FATAL_ERROR "${ARGN}: ${code}\n${output}")
    endif()
    set(output "${output}" PARENT_SCOPE)
endfunction()

function(expect what found wanted)
    if(NOT found STREQUAL wanted)
        message(FATAL_ERROR "${what}: found\n${found}\nexpected\n${wanted}")
    endif()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix} --component library)
run(${CMAKE_COMMAND} -S ${EXAMPLE} -B ${FOLDER}/build -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX} -D CMAKE_PREFIX_PATH=${prefix})
run(${CMAKE_COMMAND} --build ${FOLDER}/build)
file(WRITE ${FOLDER}/ball.pbrt "WorldBegin Shape \"displacedsphere\" \"float radius\" 1.5\n")
run(${FOLDER}/build/example ${FOLDER}/ball.pbrt)
expect("the example" "${output}" "range 2.500000 at latitude 0.000, longitude 0.000
range 2.500000 at latitude 0.000, longitude 90.000
in sight
hidden
")
execute_process(COMMAND ${FOLDER}/build/example ${FOLDER}/none.pbrt RESULT_VARIABLE code ERROR_VARIABLE output)
if(NOT code EQUAL 1 OR NOT output MATCHES "none.pbrt")
    message(FATAL_ERROR "a missing scene: ${code}, ${output}")
endif()
