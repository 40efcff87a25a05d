// Timers of IEC 61131-3. They keep the time from their start to the start of the scan in ATIME, which grows by the
// length of each scan while STATE is 1 (ir/s7300/timer_pass.hpp); in the scan that starts them it is below 0. Beyond
// 002:2516-2532: general knowledge. One struct for each block.
#pragma once

#include "ir/machine/instruction_group.hpp"
#include "ir/s7300/library.hpp"

namespace rungproof::s7300::library {

// PT = 0 resets the block and its IN; PT < 0 does the same and is an error. STATE: 1 the time runs, 2 it is up, 3 of an
// on-delay, whose bit 0 says that IN was 1. The machine gives `passed`, the ms of the scan until the call
// (ir/s7300/control.hpp); the time is up where ATIME is `due`.
inline constexpr std::string_view iecHead = R"(
VAR_TEMP
  passed : DINT;
  due : DINT;
END_VAR
BEGIN
NETWORK
      L #PT; L #passed; -D; T #due;
      L #PT; L L#0; >D; JC go;
      CLR; = #Q; = #IN;
      L L#0; T #ET; T #ATIME;
      L 0; T #STATE;
      L #PT; L L#0; ==D; SAVE; BEU;
)";

inline constexpr std::string_view onDelay = R"(
go:   A #IN; JC on;
      CLR; = #Q;
      L L#0; T #ET; T #ATIME;
      L 0; T #STATE; JU end;
on:   L #STATE; L 0; ==I; JCN run;
      L 1; T #STATE; L L#0; L #passed; -D; T #ATIME;
run:  L #STATE; L 3; ==I; JC done;
      L #ATIME; L #due; >=D; JC over;
      L #ATIME; L #passed; +D; T #ET; CLR; = #Q; JU end;
over: L 3; T #STATE; L #PT; T #ET;
done: SET; = #Q;
end:  SET; SAVE; BEU;)";

inline constexpr std::string_view pulse = R"(
go:   L #STATE; L 0; ==I; JCN act;
      A #IN; JCN idle;
      L 1; T #STATE; L L#0; L #passed; -D; T #ATIME;
act:  L #STATE; L 1; ==I; JCN post;
      L #ATIME; L #due; >=D; JC over;
      L #ATIME; L #passed; +D; T #ET; SET; = #Q; JU end;
over: L 2; T #STATE; L #PT; T #ET;
post: CLR; = #Q;
      A #IN; JC end;
idle: CLR; = #Q;
      L L#0; T #ET; T #ATIME;
      L 0; T #STATE;
end:  SET; SAVE; BEU;)";

// STATE: 3 while IN is 1.
inline constexpr std::string_view offDelay = R"(
go:   A #IN; JCN off;
      L 3; T #STATE;
      L L#0; T #ET; T #ATIME;
      SET; = #Q; JU end;
off:  L #STATE; L 3; ==I; JCN run;
      L 1; T #STATE; L L#0; L #passed; -D; T #ATIME;
run:  L #STATE; L 1; ==I; JCN idle;
      L #ATIME; L #due; >=D; JC over;
      L #ATIME; L #passed; +D; T #ET; SET; = #Q; JU end;
over: L 0; T #STATE; L #PT; T #ET;
idle: CLR; = #Q;
end:  SET; SAVE; BEU;)";

struct Sfb3 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfb,
      .number = 3,
      .name = "TP",
      .parameters = "IN:BOOL PT:TIME|Q:BOOL ET:TIME||STATE:BYTE STIME:TIME ATIME:TIME",
      .head = iecHead,
      .statements = pulse};
};

struct Sfb4 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfb,
      .number = 4,
      .name = "TON",
      .parameters = "IN:BOOL PT:TIME|Q:BOOL ET:TIME||STATE:BYTE STIME:TIME ATIME:TIME",
      .head = iecHead,
      .statements = onDelay};
};

struct Sfb5 {
  static constexpr LibraryBlock block = {
      .type = BlockType::Sfb,
      .number = 5,
      .name = "TOF",
      .parameters = "IN:BOOL PT:TIME|Q:BOOL ET:TIME||STATE:BYTE STIME:TIME ATIME:TIME",
      .head = iecHead,
      .statements = offDelay};
};

using TimersGroup = isa::Group<Sfb3, Sfb4, Sfb5>;

}  // namespace rungproof::s7300::library
