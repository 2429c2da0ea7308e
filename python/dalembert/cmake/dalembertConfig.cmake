# find_package(dalembert): item packages.
find_package(Python 3.11 REQUIRED COMPONENTS Interpreter)

# dalembert_add_items(TARGET): the extension module of the items in specs/ and kernels/ of this directory. It is built by
# `dalembert items build` and installed into the Python package with the name of the project.
function(dalembert_add_items target)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target})
  add_custom_target(${target} ALL
    COMMAND ${CMAKE_COMMAND} -E env CXX=${CMAKE_CXX_COMPILER} ${Python_EXECUTABLE} -m dalembert items build ${CMAKE_CURRENT_SOURCE_DIR} --output ${output}
    VERBATIM)
  install(DIRECTORY ${output}/ DESTINATION ${PROJECT_NAME})
endfunction()
