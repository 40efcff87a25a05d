// IEC timers keep the time since their start in ATIME, which runs while STATE is 1 (ir/s7200/timer_refresh.hpp).
// Behaviour of the IEC blocks beyond 002:2516-2532: general knowledge.
#include "frontend/step7/library_source.hpp"

#include <algorithm>
#include <array>

namespace rungproof::step7 {

namespace {

struct SourceRow {
  BlockType type;
  std::uint16_t number;
  std::string_view text;
  std::string_view head{};  ///< before it
};

constexpr std::string_view returnsZero = "L 0; T #RET_VAL; SET; SAVE; BEU;";
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

// PT = 0 resets the block and its IN; PT < 0 does the same and is an error. STATE: 1 the time runs, 2 it is up.
constexpr std::string_view iecHead = R"(
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
      L 1; T #STATE; L L#0; T #ATIME;
run:  L #STATE; L 2; ==I; JC done;
      L #ATIME; L #PT; >=D; JC over;
      L #ATIME; T #ET; CLR; = #Q; JU end;
over: L 2; T #STATE; L #PT; T #ET;
done: SET; = #Q;
end:  SET; SAVE; BEU;)";

constexpr std::string_view pulse = R"(
go:   L #STATE; L 0; ==I; JCN act;
      A #IN; JCN idle;
      L 1; T #STATE; L L#0; T #ATIME;
act:  L #STATE; L 1; ==I; JCN post;
      L #ATIME; L #PT; >=D; JC over;
      L #ATIME; T #ET; SET; = #Q; JU end;
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
      L 1; T #STATE; L L#0; T #ATIME;
run:  L #STATE; L 1; ==I; JCN idle;
      L #ATIME; L #PT; >=D; JC over;
      L #ATIME; T #ET; SET; = #Q; JU end;
over: L 0; T #STATE; L #PT; T #ET;
idle: CLR; = #Q;
end:  SET; SAVE; BEU;)";

using enum BlockType;

constexpr auto sourceRows = std::to_array<SourceRow>({
    {Sfb, 0, countUp},
    {Sfb, 1, countDown},
    {Sfb, 2, countUpDown},
    {Sfb, 3, pulse, iecHead},
    {Sfb, 4, onDelay, iecHead},
    {Sfb, 5, offDelay, iecHead},
    {Sfc, 41, returnsZero},
    {Sfc, 42, returnsZero},
    {Sfc, 43, nothing},
    {Sfc, 47, nothing},
});

}  // namespace

std::string librarySource(const s7300::LibraryBlock& block) {
  const auto row = std::ranges::find_if(
      sourceRows, [&](const SourceRow& r) { return r.type == block.type && r.number == block.number; });
  if (row == sourceRows.end()) return {};
  const bool hasSection = row->text.find("BEGIN") != std::string_view::npos;
  return std::string(hasSection ? "" : "BEGIN\nNETWORK\n").append(row->head).append(row->text);
}

bool isModelled(const s7300::LibraryBlock& block) {
  constexpr int stop = 46;
  return (block.type == Sfc && block.number == stop) || !librarySource(block).empty();
}

}  // namespace rungproof::step7
