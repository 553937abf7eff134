# hawser_folder(NAME LINKS...): the library of one folder, from every .c file in it.
# Files named *_lanes.c hold kernels written in vector types; each is compiled once for every instruction set
# (symbols end in HAWSER_ISA) and chosen at run time by core/machine.h.
set(HAWSER_ISA_FLAGS_generic "")
set(HAWSER_ISA_LIST generic)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT HAWSER_ONE_ISA)
    list(APPEND HAWSER_ISA_LIST avx2 avx512)
    set(HAWSER_ISA_FLAGS_avx2 -mavx2 -mfma)
    set(HAWSER_ISA_FLAGS_avx512 -mavx512f -mavx512dq -mavx512vl -mavx2 -mfma -mprefer-vector-width=512)
    add_compile_definitions(HAWSER_X86)
endif()

# Many programs share a folder's sanitized library, which is large, at run time.
set(HAWSER_FOLDER_KIND STATIC)
if(HAWSER_SANITIZED)
    set(HAWSER_FOLDER_KIND SHARED)
endif()

# The targets whose objects make up libhawser (cmake/Install.cmake) are collected in the property HAWSER_OBJECTS.
function(hawser_folder name)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS *.c *.h)
    file(GLOB_RECURSE kernels CONFIGURE_DEPENDS *_lanes.c)
    list(REMOVE_ITEM sources ${kernels} "" ${HAWSER_LEFT_OUT})
    set(objects "")
    if(kernels)
        foreach(isa ${HAWSER_ISA_LIST})
            add_library(${name}_${isa} OBJECT ${kernels})
            target_compile_options(${name}_${isa} PRIVATE ${HAWSER_ISA_FLAGS_${isa}} -ffp-contract=fast)
            target_compile_definitions(${name}_${isa} PRIVATE HAWSER_ISA=${isa})
            target_link_libraries(${name}_${isa} PRIVATE hawser_flags)
            list(APPEND objects $<TARGET_OBJECTS:${name}_${isa}>)
            set_property(GLOBAL APPEND PROPERTY HAWSER_OBJECTS ${name}_${isa})
        endforeach()
    endif()
    add_library(${name} ${HAWSER_FOLDER_KIND} ${sources} ${objects})
    target_link_libraries(${name} PUBLIC hawser_flags ${ARGN} m)
    set_property(GLOBAL APPEND PROPERTY HAWSER_OBJECTS ${name})
endfunction()
