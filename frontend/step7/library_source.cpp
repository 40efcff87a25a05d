// IEC timers keep the time from their start to the start of the scan in ATIME, which grows by the length of each scan
// while STATE is 1 (ir/s7300/timer_pass.hpp); in the scan that starts them it is below 0.
// Behaviour of the IEC blocks beyond 002:2516-2532: general knowledge.
#include "frontend/step7/library_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "ir/s7300/library_contract.hpp"

namespace rungproof::step7 {

namespace {

struct SourceRow {
  BlockType type;
  std::uint16_t number;
  std::string_view text;
  std::string_view head{};  ///< before it
};

constexpr std::string_view nothing = "SET; SAVE; BEU;";

// A rising CU adds 1 unless CV = 32767; R sets it to 0.
constexpr std::string_view countUp = R"(
      A #R; JC res;
      A #CU; AN #CUO; JCN out;
      L #CV; L 32767; <I; JCN out;
      L #CV; + 1; T #CV; JU out;
res:  L 0; T #CV;
out:  A #CU; = #CUO;
      L #CV; L #PV; >=I; = #Q;
      SET; SAVE; BEU;)";

constexpr std::string_view countDown = R"(
      A #LOAD; JC load;
      A #CD; AN #CDO; JCN out;
      L #CV; L -32768; >I; JCN out;
      L #CV; + -1; T #CV; JU out;
load: L #PV; T #CV;
out:  A #CD; = #CDO;
      L #CV; L 0; <=I; = #Q;
      SET; SAVE; BEU;)";

// R before LOAD before counting; both inputs rising at once cancel.
constexpr std::string_view countUpDown = R"(
      A #R; JC res;
      A #LOAD; JC load;
      A #CU; AN #CUO; A #CD; AN #CDO; JC out;
      A #CU; AN #CUO; JCN down;
      L #CV; L 32767; <I; JCN out;
      L #CV; + 1; T #CV; JU out;
down: A #CD; AN #CDO; JCN out;
      L #CV; L -32768; >I; JCN out;
      L #CV; + -1; T #CV; JU out;
res:  L 0; T #CV; JU out;
load: L #PV; T #CV;
out:  A #CU; = #CUO;
      A #CD; = #CDO;
      L #CV; L #PV; >=I; = #QU;
      L #CV; L 0; <=I; = #QD;
      SET; SAVE; BEU;)";

// PT = 0 resets the block and its IN; PT < 0 does the same and is an error. STATE: 1 the time runs, 2 it is up, 3 of an
// on-delay, whose bit 0 says that IN was 1. The machine gives `passed`, the ms of the scan until the call
// (ir/s7300/control.hpp); the time is up where ATIME is `due`.
constexpr std::string_view iecHead = R"(
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

constexpr std::string_view onDelay = R"(
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

constexpr std::string_view pulse = R"(
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
constexpr std::string_view offDelay = R"(
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

// ((IN - k1) / (27648 - k1)) * (HI_LIM - LO_LIM) + LO_LIM, each step a REAL, with k1 = -27648 or 0 (002:2625-2647).
// General knowledge: beyond the range OUT is the limit, RET_VAL W#16#8 and ENO 0.
constexpr std::string_view scale = R"(
VAR_TEMP
  k1 : REAL;
  span : REAL;
  x : REAL;
END_VAR
BEGIN
NETWORK
      A #BIPOLAR; JC both;
      L 0.0; T #k1; JU go;
both: L -2.7648e+004; T #k1;
go:   L 2.7648e+004; L #k1; -R; T #span;
      L #IN; ITD; DTR; T #x;
      L 2.7648e+004; >R; JC high;
      L #x; L #k1; <R; JC low;
      L #x; L #k1; -R; L #span; /R; T #x;
      L #HI_LIM; L #LO_LIM; -R; L #x; *R; L #LO_LIM; +R; T #OUT;
      L 0; T #RET_VAL;
      SET; SAVE; BEU;
high: L #HI_LIM; T #OUT; JU out;
low:  L #LO_LIM; T #OUT;
out:  L 8; T #RET_VAL;
      CLR; SAVE; BEU;)";

// ((IN - LO_LIM) / (HI_LIM - LO_LIM)) * (27648 - k1) + k1, each step a REAL (002:2649-2651). How it rounds is not
// stated: to the nearest number, or to the other one beside it. General knowledge: beyond the limits as FC 105.
constexpr std::string_view unscale = R"(
VAR_TEMP
  k1 : REAL;
  span : REAL;
  x : REAL;
  near : DINT;
  down : DINT;
  other : BOOL;
END_VAR
BEGIN
NETWORK
      A #BIPOLAR; JC both;
      L 0.0; T #k1; JU go;
both: L -2.7648e+004; T #k1;
go:   L #IN; L #HI_LIM; >R; JC high;
      L #IN; L #LO_LIM; <R; JC low;
      L #HI_LIM; L #LO_LIM; -R; T #span;
      L #IN; L #LO_LIM; -R; L #span; /R; T #x;
      L 2.7648e+004; L #k1; -R; L #x; *R; L #k1; +R; T #x;
      RND; T #near;
      AN #other; JC give;
      L #x; RND-; T #down; L #x; RND+; L #down; +D; L #near; -D; T #near;
give: L #near; T #OUT;
      L 0; T #RET_VAL;
      SET; SAVE; BEU;
high: L 27648; T #OUT; JU out;
low:  L #k1; RND; T #OUT;
out:  L 8; T #RET_VAL;
      CLR; SAVE; BEU;)";

// N bits from SA on, of the outputs, get the result in front of it (002:2355).
constexpr std::string_view bitArray = R"(
      L P##SA; LAR1; L D[AR1,P#2.0];
      L DW#16#7FFFF; AD; L DW#16#82000000; OD; LAR1;
      L #N; L 0; <=I; JC none;
      L #N;
next: T #left; {0}; = [AR1,P#0.0]; +AR1 P#0.1; L #left; LOOP next;
none: NOP 0;)";

using enum BlockType;

/// The inputs of the image get what the modules have at that moment (002:2355).
std::string updateOfInputs(std::uint32_t imageBytes) {
  std::string text;
  for (std::uint32_t byte = 0; byte < imageBytes; byte += 4) text += fmt::format("L PID {0}; T ID {0};\n", byte);
  return text;
}

/// Statements that give every output, ENO and the registers a value of temporary data that nobody has written. Where
/// that is 0, as in `sim`, the block has met no error: RET_VAL is 0 and BR 1 (002:2387).
std::string anyOutputs(const s7300::LibraryBlock& block, std::string_view before = {}) {
  std::string data = "VAR_TEMP\n  left : INT;\n  eno : BOOL;\n  accu1 : DWORD;\n  accu2 : DWORD;\n  ar1 : DWORD;\n",
              statements;
  const auto parameters = s7300::interfaceOf(block);
  for (const s7300::Field& field : parameters->fields) {
    if (field.section != s7300::Section::Output) continue;
    const bool isBit = field.type.kind == s7300::TypeKind::Bool;
    data += fmt::format("  any_{} : {};\n", field.name, s7300::toString(field.type));
    statements += fmt::format("{0} #any_{1}; {2} #{1};\n", isBit ? "A" : "L", field.name, isBit ? "=" : "T");
  }
  return data + "END_VAR\nBEGIN\nNETWORK\n" + std::string(before) + statements +
         "L #ar1; LAR1; L #accu2; L #accu1; AN #eno; SAVE; BEU;";
}

constexpr auto sourceRows = std::to_array<SourceRow>({
    {Sfb, 0, countUp},
    {Sfb, 1, countDown},
    {Sfb, 2, countUpDown},
    {Sfb, 3, pulse, iecHead},
    {Sfb, 4, onDelay, iecHead},
    {Sfb, 5, offDelay, iecHead},
    {Sfc, 43, nothing},
    {Sfc, 47, nothing},
    {Fc, 105, scale},
    {Fc, 106, unscale},
});

}  // namespace

std::string librarySource(const s7300::LibraryBlock& block, std::uint32_t imageBytes) {
  if (isBuiltIn(block)) return std::string(emptyBody);
  if (block.type == Sfc && block.number == 26) return anyOutputs(block, updateOfInputs(imageBytes));
  if (block.type == Sfc && (block.number == 79 || block.number == 80))
    return anyOutputs(block, fmt::format(bitArray, block.number == 79 ? "SET" : "CLR"));
  const auto row = std::ranges::find_if(
      sourceRows, [&](const SourceRow& r) { return r.type == block.type && r.number == block.number; });
  if (row == sourceRows.end()) return s7300::isContractOnly(block) ? anyOutputs(block) : std::string();
  const std::string text = std::string(row->head).append(row->text);
  return text.find("BEGIN") != std::string::npos ? text : "BEGIN\nNETWORK\n" + text;
}

bool isModelled(const s7300::LibraryBlock& block) {
  constexpr int stop = 46;
  return (block.type == Sfc && block.number == stop) || !librarySource(block, 0).empty();
}

}  // namespace rungproof::step7
