# What a program for Windows needs of compiler and linker; included by CMakeLists.txt.
enable_language(RC)
add_compile_definitions(_WIN32_WINNT=0x0A00 UNICODE NOMINMAX WIN32_LEAN_AND_MEAN)
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-Wa,-mbig-obj>)  # several files compiled as one have many sections
# One file without libraries beside it; 8 MiB of stack for each thread, as elsewhere; an identity for the result cache.
add_link_options(-static -Wl,--stack,8388608 -Wl,--build-id)
# Names are UTF-8: engine/platform/windows/utf8_conversion.cpp. Only the runtime asks, and it is linked behind that file:
# --undefined takes it in.
foreach(question mbrtowc wcrtomb __imp____mb_cur_max_func)
  add_link_options(-Wl,--wrap=${question} -Wl,--undefined=__wrap_${question})
endforeach()
set(SYSTEM_LIBRARIES advapi32 bcrypt psapi shell32)
