// Errors that are masked, and what the CPU does on demand. One struct for each block.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/library.hpp"
#include "ir/s7300/library/cpu_call.hpp"

namespace rungproof::s7300::library {

/// A call does nothing that the program could see.
inline constexpr std::string_view nothing = "SET; SAVE; BEU;";

struct Sfc36 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc,
      .number = 36,
      .name = "MSK_FLT",
      .parameters = "PRGFLT_SET_MASK:DWORD ACCFLT_SET_MASK:DWORD|RET_VAL:INT PRGFLT_MASKED:DWORD ACCFLT_MASKED:DWORD",
      .isContract = true,
      .masksErrors = true};

  template <class D>
  static void act(CpuCall<D>& call) {
    call.m.put(call.s.isMasking, call.d.constant(true));
    call.m.setBit(Reg::ErrorsMasked, 0, call.d.constant(true));
  }
};

struct Sfc37 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc,
      .number = 37,
      .name = "DMSK_FLT",
      .parameters =
          "PRGFLT_RESET_MASK:DWORD ACCFLT_RESET_MASK:DWORD|RET_VAL:INT PRGFLT_MASKED:DWORD ACCFLT_MASKED:DWORD",
      .isContract = true};

  template <class D>
  static void act(CpuCall<D>& call) {
    call.m.put(call.s.isMasking, call.d.constant(false));
  }
};

struct Sfc38 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc,
      .number = 38,
      .name = "READ_ERR",
      .parameters = "PRGFLT_QUERY:DWORD ACCFLT_QUERY:DWORD|RET_VAL:INT PRGFLT_CLR:DWORD ACCFLT_CLR:DWORD",
      .isContract = true};
};

struct Sfc43 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc, .number = 43, .name = "RE_TRIGR", .parameters = "", .statements = nothing};

  template <class D>
  static void act(CpuCall<D>& call) {
    call.m.signal(Signal::WatchdogRestarted);
  }
};

struct Sfc44 {
  static constexpr LibraryBlock block = {.type = BlockType::Sfc,
                                         .number = 44,
                                         .name = "REPL_VAL",
                                         .parameters = "VAL:DWORD|RET_VAL:INT",
                                         .isContract = true};

  template <class D>
  static void act(CpuCall<D>& call) {
    if (!call.gives(1)) return;
    call.m.put(call.s.replacement, call.value(0, Width::DWord), 32);
    call.m.put(call.s.isReplaced, call.d.constant(true));
  }
};

struct Sfc46 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc, .number = 46, .name = "STP", .parameters = "", .stopsCpu = true};
};

struct Sfc47 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfc, .number = 47, .name = "WAIT", .parameters = "WT:INT", .statements = nothing};
};

using ErrorsGroup = isa::Group<Sfc36, Sfc37, Sfc38, Sfc43, Sfc44, Sfc46, Sfc47>;

}  // namespace rungproof::s7300::library
