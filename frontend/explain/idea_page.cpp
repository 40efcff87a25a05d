// The table.
#include "frontend/explain/idea_page.hpp"

#include <array>

#include "frontend/stl/stl_lexer.hpp"

namespace rungproof {

namespace {

constexpr std::array ideaTable = {
    Idea{"PROVED",
         "The property holds at the end of every scan that any run can reach, for all inputs, scan lengths and "
         "interrupts that the assumptions allow. The report names the method; --certificate writes the proof for "
         "another solver."},
    Idea{"VIOLATED",
         "There is a run that breaks the property, and the reference engine has made the same run. The table shows its "
         "scans; --traces writes it as a stimulus."},
    Idea{"REACHABLE", "There is a run that comes to such a scan end; the reference engine has made it too."},
    Idea{"UNREACHABLE", "No run comes to such a scan end: a proof of the opposite, with a certificate like any other."},
    Idea{"HOLDS TO BOUND",
         "No run of at most that many scans breaks the property. Longer ones were not looked at: this is no proof."},
    Idea{"VACUOUS",
         "The property holds for no reason of the program's: its premise can never be met, the assumptions contradict "
         "each other, or nothing writes what it speaks of."},
    Idea{"UNKNOWN",
         "The limits of time, memory or --bound ended the search. The notes say what was tried and how far."},
    Idea{"NOT COVERED",
         "The property depends on code that was not read or is not modelled. Nothing is said about it, because a proof "
         "of the rest would be a proof of another program."},
    Idea{"one scan",
         "The property follows from what one scan computes, whatever memory it starts with: no history is needed. The "
         "strongest kind of proof, and the quickest."},
    Idea{"simulation", "Many random runs side by side came to a scan that breaks the property or reaches the goal."},
    Idea{"BMC",
         "Bounded model checking: a solver looked for a run of 1, 2, 3, ... scans and found one. The shortest comes "
         "first."},
    Idea{"k-induction",
         "The property holds in the first k scans, and whenever it holds in k scans in a row it holds in the next one: "
         "so it holds for ever."},
    Idea{"IC3",
         "The solver finds statements about memory that every scan keeps (an inductive invariant) and that exclude "
         "every state which breaks the property. Works without unrolling time."},
    Idea{"IC3 on words",
         "IC3 that speaks of comparisons between words, such as VW2 <= 100, in place of single bits: for counters and "
         "sums."},
    Idea{"invariant",
         "A statement about memory that holds at the start and that every scan keeps. If it excludes all bad states, "
         "the property is proved."},
    Idea{"explicit search", "The program has so few states that all of them were visited."},
    Idea{"held inputs",
         "Runs whose inputs stay as they are for many scans: what timers and counters need to come to their ends."},
    Idea{"accelerated search",
         "A search in which time passes in long scans, so that a preset of an hour is one step; what it finds is made "
         "again with real scans by the reference engine."},
    Idea{"exploration",
         "Runs of the reference engine that go on from states which are new: deep sequences step by step."},
    Idea{"engine runs",
         "Runs of the reference engine from power-up, with inputs that are held for a while and inputs that change at "
         "random: what happens without a special order of events is found so."},
    Idea{"run of another question",
         "A long run that was looked for to answer another question of the program: the reference engine repeated it "
         "and came by this one as well."},
    Idea{"both programs side by side",
         "equiv: a solver looked for inputs on which two programs that run side by side drive different outputs, or "
         "proved that there are none."},
    Idea{
        "one scan from memory that corresponds",
        "equiv: memory that stands for each other is equal at the start, and one scan from equal memory leads to equal "
        "memory and equal outputs: so both programs do the same for ever."},
    Idea{"runs of both programs",
         "equiv: the reference engine ran both programs with the same inputs, and an observed output differed."},
    Idea{"certificate",
         "The proof of one PROVED as SMT-LIB 2 files: that the invariant holds at the start, that each scan keeps it, "
         "and that it excludes what is bad. Another solver must answer unsat to each."},
    Idea{"cone of influence",
         "The part of the program that a property can depend on. The rest is not encoded; the report names the "
         "networks that a verdict rests on."},
    Idea{"assumption",
         "What a verdict takes for granted: CPU, scan times, memory at the start, who else writes memory, and every "
         "reading of a point that the manual leaves open."},
    Idea{"process image",
         "The copy of the inputs that is taken before a scan and the copy of the outputs that is written after it "
         "(001:1719-1750). Contacts and coils work on the copies; LDI, =I and the like work on the terminals."},
    Idea{"scan",
         "Inputs are read, the program runs once, outputs are written. Properties speak of scan ends, where the "
         "outputs are written, unless they begin with 'at every instruction'."},
    Idea{"logic stack",
         "Nine bits (S7-200 SMART: 32) on which contacts work (001:2753). Loads push, ALD and OLD join the two on top; "
         "what is pushed beyond the last level is lost."},
};

}  // namespace

std::span<const Idea> ideas() { return ideaTable; }

const Idea* ideaNamed(std::string_view word) {
  if (word.size() > 10 && equalsIgnoringCase(word.substr(word.size() - 10), "-induction")) word = "k-induction";
  if (word.size() > 15 && equalsIgnoringCase(word.substr(0, 15), "HOLDS TO BOUND ")) word = "HOLDS TO BOUND";
  for (const Idea& idea : ideaTable) {
    if (equalsIgnoringCase(idea.name, word)) return &idea;
  }
  return nullptr;
}

}  // namespace rungproof
