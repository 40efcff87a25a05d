# One program without shared libraries: RUNGPROOF_STATIC is the folder of the libraries that frontend/package/static/build
# has built. They come before those of the system, of which only static ones are taken.
set(RUNGPROOF_STATIC "" CACHE PATH "folder of static libraries, made by frontend/package/static/build; empty: shared ones")
if(RUNGPROOF_STATIC)
  list(PREPEND CMAKE_PREFIX_PATH ${RUNGPROOF_STATIC})
  set(CMAKE_FIND_LIBRARY_SUFFIXES .a)
  set(CMAKE_LINK_SEARCH_START_STATIC ON)
  add_link_options(-static -Wl,--gc-sections)
endif()

# What packages describe as shared although they have both, and the data of ICU, which its static library wants.
macro(take_static_libraries)
  if(RUNGPROOF_STATIC)
    set_target_properties(pugixml::pugixml PROPERTIES INTERFACE_LINK_LIBRARIES pugixml::static)
    set_property(TARGET ICU::uc APPEND PROPERTY INTERFACE_LINK_LIBRARIES ${RUNGPROOF_STATIC}/lib/libicudata.a)
  endif()
endmacro()
