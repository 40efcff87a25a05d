# The chapters of the guide as texts in the program: frontend/guide/20_tutorial.md becomes {"tutorial", "..."}.
file(GLOB chapter_files CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/frontend/guide/*.md)
list(SORT chapter_files)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${chapter_files})
set(chapter_entries "")
foreach(chapter IN LISTS chapter_files)
  get_filename_component(name ${chapter} NAME_WE)
  string(REGEX REPLACE "^[0-9]+_" "" name ${name})
  file(READ ${chapter} text)
  string(APPEND chapter_entries "    {\"${name}\", R\"chapter(${text})chapter\"},\n")
endforeach()
set(chapter_source
"// Generated from the Markdown files of frontend/guide.
#include \"frontend/guide/chapter.hpp\"
#include <array>
namespace rungproof {
namespace {
const Chapter all[] = {
${chapter_entries}};
}
std::span<const Chapter> chapters() { return all; }
}  // namespace rungproof
")
set(chapter_target ${CMAKE_BINARY_DIR}/generated/chapters.cpp)
set(chapter_old "")
if(EXISTS ${chapter_target})
  file(READ ${chapter_target} chapter_old)
endif()
if(NOT chapter_old STREQUAL chapter_source)
  file(WRITE ${chapter_target} "${chapter_source}")
endif()
set_source_files_properties(${chapter_target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
