# The engine of the desk (web/README.md): theory, cases, routes and the catalogue as WebAssembly, without simulations. What it
# takes of io/ is what needs no simulation; the libraries are those that scripts/wasm.sh has built below build/wasm.
set(DESK_LIBRARIES ${PROJECT_SOURCE_DIR}/build/wasm)
file(GLOB_RECURSE sources CONFIGURE_DEPENDS core/*.c def/*.c theory/*.c survey/*.c contact/*.c io/yaml/*.c io/schema/*.c io/case/*.c io/library/*.c
     io/chains/*.c io/place/*.c io/alignment/*.c io/job/*.c)
list(APPEND sources io/api/api_answer.c io/api/api_case.c io/api/api_library.c io/api/api_plausible.c io/api/api_remedy.c io/api/api_route.c
     io/api/api_theory.c io/api/api_equipment.c io/api/theory_tables.c io/report/calculation.c io/report/crew.c io/report/route_page.c io/report/svg.c
     io/report/text.c io/results/document.c io/results/page.c io/results/results_file.c io/results/shown.c io/results/summary_json.c
     io/results/tables.c io/results/words.c io/results/words_table.c io/results/workbook.c web/engine/along.c web/engine/desk.c)
add_executable(hawser_desk ${sources})
target_include_directories(hawser_desk PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/include ${DESK_LIBRARIES}/include)
target_compile_definitions(hawser_desk PRIVATE HAWSER_ISA=generic HAWSER_VERSION="${PROJECT_VERSION}")
target_compile_options(hawser_desk PRIVATE -O2 -Wno-unused-command-line-argument -Wno-psabi -fno-math-errno -fno-trapping-math
                       -fmacro-prefix-map=${PROJECT_SOURCE_DIR}=.)
set(functions malloc free)
foreach(name theory answer page schema route section along library words)
    list(APPEND functions desk_${name})
endforeach()
list(TRANSFORM functions PREPEND _)
list(JOIN functions , functions)
target_link_options(hawser_desk PRIVATE -O2 -sMODULARIZE=1 -sEXPORT_NAME=hawserEngine -sENVIRONMENT=web,worker,node -sALLOW_MEMORY_GROWTH=1
                    -sTOTAL_STACK=4194304 -sINITIAL_MEMORY=33554432 -sDYNAMIC_EXECUTION=0 -sEXPORTED_FUNCTIONS=${functions}
                    -sEXPORTED_RUNTIME_METHODS=FS,UTF8ToString,stringToUTF8,lengthBytesUTF8,ENV -sFORCE_FILESYSTEM=1
                    --embed-file ${PROJECT_SOURCE_DIR}/library@/library)
foreach(name yaml expat jansson zip z)
    target_link_libraries(hawser_desk PRIVATE ${DESK_LIBRARIES}/lib/lib${name}.a)
endforeach()
set_target_properties(hawser_desk PROPERTIES OUTPUT_NAME hawser RUNTIME_OUTPUT_DIRECTORY ${DESK_LIBRARIES}/desk)
