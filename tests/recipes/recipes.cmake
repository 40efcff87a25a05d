# Adds a rule, a command, a report, a trace format, a reader, an instruction, a CPU, an option and an engine to a copy of
# the sources by CONTRIBUTING's recipes and nothing else; the copy must be configured with them, and what names them compile.
file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${SOURCE}/CMakeLists.txt ${SOURCE}/LICENSE ${SOURCE}/ir ${SOURCE}/engine ${SOURCE}/analysis ${SOURCE}/frontend DESTINATION ${SCRATCH})

# Puts `text` behind the first `anchor` of a file.
function(insert path anchor text)
  file(READ ${SCRATCH}/${path} content)
  string(FIND "${content}" "${anchor}" at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${path} has no '${anchor}'")
  endif()
  string(LENGTH "${anchor}" length)
  math(EXPR at "${at} + ${length}")
  string(SUBSTRING "${content}" 0 ${at} head)
  string(SUBSTRING "${content}" ${at} -1 tail)
  file(WRITE ${SCRATCH}/${path} "${head}${text}${tail}")
endfunction()

function(compiles path)
  execute_process(COMMAND ${COMPILER} -std=c++20 -fsyntax-only -Wall -Werror -I ${SCRATCH} -I ${SCRATCH}/build/generated ${SCRATCH}/${path}
    RESULT_VARIABLE result ERROR_VARIABLE errors)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${path} does not compile:\n${errors}")
  endif()
endfunction()

function(lists path name)
  file(READ ${SCRATCH}/build/generated/${path} content)
  string(FIND "${content}" "&${name}," at)
  if(at EQUAL -1)
    message(FATAL_ERROR "${path} does not list ${name}")
  endif()
endfunction()

file(WRITE ${SCRATCH}/analysis/checks/zzz001_scratch.cpp [[
#include "analysis/flow/facts.hpp"
#include "analysis/rule.hpp"
namespace rungproof {
static void checkScratch(const Facts& facts, FindingSink& sink) { sink.report(facts.instruction(0).span, "here"); }
extern constexpr Rule zzz001_scratch = {.id = "ZZZ001", .title = "scratch", .check = checkScratch};
}
]])
file(WRITE ${SCRATCH}/frontend/command/scratch.cpp [[
#include "frontend/command.hpp"
namespace rungproof {
extern constexpr Command scratchCommand = {
    .name = "scratch", .usage = "", .summary = "", .details = "",
    .setup = [](ArgumentTable&) -> Action { return [](Context&) { return Exit::Clean; }; }};
}
]])
file(WRITE ${SCRATCH}/frontend/report/scratch.cpp [[
#include "frontend/report.hpp"
namespace rungproof {
extern constexpr Reporter scratchReport = {};
}
]])
file(WRITE ${SCRATCH}/frontend/trace/scratch.cpp [[
#include "frontend/trace_format.hpp"
namespace rungproof {
extern constexpr TraceFormat scratchTrace = {.ending = ".scratch", .summary = "", .write = nullptr};
}
]])
file(WRITE ${SCRATCH}/frontend/reader/scratch_file.cpp [[
#include "frontend/files/file_reader.hpp"
namespace rungproof {
extern const FileReader scratch_file{"scratch", nullptr, nullptr};
}
]])
file(WRITE ${SCRATCH}/analysis/bits/scratch_engine.cpp [[
#include "analysis/bits/engine_contract.hpp"
namespace rungproof {
namespace {
struct Scratch final : Engine {
  Verdict advance(const Budget&) override { return {}; }
};
}
std::unique_ptr<Engine> makeScratch(const BitSystem&, const EngineOptions&) { return std::make_unique<Scratch>(); }
}
]])
insert(analysis/bits/engine_contract.hpp "std::unique_ptr<Engine> makeBmc(const BitSystem& system, const EngineOptions& options);"
  "\nstd::unique_ptr<Engine> makeScratch(const BitSystem& system, const EngineOptions& options);")
insert(analysis/portfolio/race.cpp "EngineKind{Technique::Ic3, \"IC3\", makeIc3, schedule::ic3Weight},"
  "\n    EngineKind{Technique::Ic3, \"scratch\", makeScratch, schedule::ic3Weight},")
insert(ir/s7200/isa/control.hpp "namespace rungproof::isa {" [[

struct Scratch {
  static constexpr Desc desc{.stl = "SCRATCH", .meaning = "", .group = "program control", .stack = {1, 0, 0}};
  template <class D>
  static void run(Machine<D>& m, Args<D>&) {
    m.setTop(m.d.constant(true));
  }
};
]])
insert(ir/s7200/isa/control.hpp "using ControlGroup = Group<" "Scratch, ")
insert(ir/s7200/cpu.hpp "inline constexpr auto rows = std::to_array<CpuRow>({" "\n    {\"999\", Series::S7200, {8, 6}, both, {}, small},")
insert(frontend/settings/options.hpp "enum class Opt : std::uint8_t {" "\n  Scratch,")
insert(frontend/settings/options.cpp "constexpr std::array table = {"
  "\n    OptionInfo{Opt::Scratch, Reading, Arity::One, \"scratch\", \"TEXT\", \"\", \"nothing\"},")
file(WRITE ${SCRATCH}/seen.cpp [[
#include <algorithm>

#include "ir/s7200/cpu.hpp"
#include "ir/s7200/isa/list.hpp"
namespace rungproof {
static_assert(cpuRow(s7200Cpu("999")).onBoard.inputs == 8);
static_assert(std::ranges::any_of(isa::instructionTable, [](const Desc& desc) { return desc.stl == "SCRATCH"; }));
}
]])

execute_process(COMMAND ${CMAKE_COMMAND} -S ${SCRATCH} -B ${SCRATCH}/build -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${COMPILER}
  -D RUNGPROOF_TESTS=OFF RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "the copy cannot be configured:\n${errors}")
endif()
lists(analysis_checks_list.cpp zzz001_scratch)
lists(frontend_command_list.cpp scratchCommand)
lists(frontend_report_list.cpp scratchReport)
lists(frontend_trace_list.cpp scratchTrace)
lists(frontend_reader_list.cpp scratch_file)
foreach(path analysis/checks/zzz001_scratch.cpp frontend/command/scratch.cpp frontend/report/scratch.cpp frontend/trace/scratch.cpp
        frontend/reader/scratch_file.cpp analysis/bits/scratch_engine.cpp analysis/portfolio/race.cpp seen.cpp ir/s7200/dialect.cpp
        frontend/settings/options.cpp)
  compiles(${path})
endforeach()
file(REMOVE_RECURSE ${SCRATCH})
