# The project's own targets: warnings, sanitizers and include paths in one place.

set(OSSUARY_COMPILE_OPTIONS -Wall -Wextra -Wshadow -Wconversion
    # The same bits on every machine: no fused multiply-add behind our back.
    -ffp-contract=off)
# GCC 12 warns of overlapping copies inside std::string's own operator+ (GCC bug 105651).
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    list(APPEND OSSUARY_COMPILE_OPTIONS -Wno-restrict)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # What mutexes guard, see engine/core/mutex.h.
    list(APPEND OSSUARY_COMPILE_OPTIONS -Wthread-safety)
endif()
if(OSSUARY_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    # Compiled together, a file's own types look as if they came from a header.
    list(APPEND OSSUARY_COMPILE_OPTIONS -Wno-subobject-linkage)
endif()
if(OSSUARY_WERROR)
    list(APPEND OSSUARY_COMPILE_OPTIONS -Werror)
endif()
set(OSSUARY_LINK_OPTIONS "")
if(OSSUARY_SANITIZE)
    list(APPEND OSSUARY_COMPILE_OPTIONS -fsanitize=${OSSUARY_SANITIZE} -fno-omit-frame-pointer
         -fno-sanitize-recover=undefined)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # Instrumented, g++ 12 loses track of what OpenMesh's containers and std::regex have set.
        list(APPEND OSSUARY_COMPILE_OPTIONS -Wno-maybe-uninitialized)
    endif()
    list(APPEND OSSUARY_LINK_OPTIONS -fsanitize=${OSSUARY_SANITIZE})
endif()
if(OSSUARY_ONE_DEFINITION)
    # For scripts/one-definition, which has all types of all libraries compared.
    list(APPEND OSSUARY_COMPILE_OPTIONS -flto)
endif()
if(OSSUARY_COVERAGE)
    list(APPEND OSSUARY_COMPILE_OPTIONS --coverage)
    list(APPEND OSSUARY_LINK_OPTIONS --coverage)
endif()

function(ossuary_configure_target target)
    target_compile_options(${target} PRIVATE ${OSSUARY_COMPILE_OPTIONS})
    target_link_options(${target} PRIVATE ${OSSUARY_LINK_OPTIONS})
    target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR})
endfunction()

# All libraries, for scripts/one-definition.
add_custom_target(ossuary_libraries)

# ossuary_add_library(name SOURCES … [PUBLIC libs…] [PRIVATE libs…])
# A library without .cpp files becomes an INTERFACE library.
function(ossuary_add_library name)
    cmake_parse_arguments(arg "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
    set(compiled ${arg_SOURCES})
    list(FILTER compiled INCLUDE REGEX "\\.cpp$")
    if(compiled)
        add_library(${name} STATIC ${arg_SOURCES})
        add_dependencies(ossuary_libraries ${name})
        ossuary_configure_target(${name})
        target_link_libraries(${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
    else()
        add_library(${name} INTERFACE)
        target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR})
        target_link_libraries(${name} INTERFACE ${arg_PUBLIC} ${arg_PRIVATE})
    endif()
endfunction()

# Compiles a target with the machine's instruction for counting bits, where OSSUARY_POPCNT allows.
function(ossuary_use_popcnt target)
    if(OSSUARY_POPCNT AND CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
        target_compile_options(${target} PRIVATE -mpopcnt)
    endif()
endfunction()

# ossuary_add_program(name OUTPUT binary SOURCES … LIBRARIES …)
function(ossuary_add_program name)
    cmake_parse_arguments(arg "" "OUTPUT" "SOURCES;LIBRARIES" ${ARGN})
    add_executable(${name} ${arg_SOURCES})
    ossuary_configure_target(${name})
    target_link_libraries(${name} PRIVATE ${arg_LIBRARIES})
    if(arg_OUTPUT)
        set_target_properties(${name} PROPERTIES OUTPUT_NAME ${arg_OUTPUT})
    endif()
endfunction()

# ossuary_add_test(name SOURCES … LIBRARIES … [LABELS …] [TIMEOUT seconds])
function(ossuary_add_test name)
    cmake_parse_arguments(arg "" "TIMEOUT" "SOURCES;LIBRARIES;LABELS" ${ARGN})
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 300)
    endif()
    add_executable(${name} ${arg_SOURCES})
    ossuary_configure_target(${name})
    target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} GTest::gmock GTest::gtest_main)
    gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60
        PROPERTIES TIMEOUT ${arg_TIMEOUT} LABELS "${arg_LABELS}")
endfunction()

# Adds each folder that has a CMakeLists.txt, in the order given.
function(ossuary_add_folders)
    foreach(folder IN LISTS ARGN)
        if(EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/CMakeLists.txt)
            add_subdirectory(${folder})
        endif()
    endforeach()
endfunction()
