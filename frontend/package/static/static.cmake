# The target rungproof_static: the object files of the ordinary program, which the tests have tried, linked without
# shared libraries. RUNGPROOF_STATIC is the folder of those libraries that frontend/package/static/build has built.
set(RUNGPROOF_STATIC "" CACHE PATH "folder of static libraries, made by frontend/package/static/build")
if(RUNGPROOF_STATIC)
  find_library(PUGIXML_STATIC libpugixml.a REQUIRED)
  find_library(ICU_STATIC libicuuc.a REQUIRED)
  find_library(ZLIB_STATIC libz.a REQUIRED)
  # libmimalloc.a brings new and delete.
  add_executable(rungproof_static EXCLUDE_FROM_ALL $<FILTER:$<TARGET_OBJECTS:rungproof>,EXCLUDE,allocation[.]cpp>)
  set_target_properties(rungproof_static PROPERTIES LINKER_LANGUAGE CXX LINK_DEPENDS "${RUNGPROOF_STATIC}/lib/libz3.a")
  add_dependencies(rungproof_static rungproof)
  target_link_options(rungproof_static PRIVATE -static -Wl,--gc-sections)
  # What is found by a path, not by a target, brings none of the shared libraries along.
  target_link_libraries(rungproof_static PRIVATE
    $<TARGET_FILE:rungproof_frontend> $<TARGET_FILE:rungproof_analysis> $<TARGET_FILE:rungproof_engine>
    $<TARGET_FILE:rungproof_ir> ${RUNGPROOF_STATIC}/lib/libfmt.a ${RUNGPROOF_STATIC}/lib/libmimalloc.a asmjit::asmjit
    ${RUNGPROOF_STATIC}/lib/libz3.a ${CADICAL_LIBRARY} ${PUGIXML_STATIC} ${ICU_STATIC}
    ${RUNGPROOF_STATIC}/lib/libicudata.a ${ZLIB_STATIC})
endif()
