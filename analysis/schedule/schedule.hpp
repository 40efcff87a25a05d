// The schedule of the prover: every share of time, limit and patience is a row of this table, with its unit and the
// reason for it. Who changes one reads here what else there is, and tests/prover/technique_test.cpp says what each
// technique earns. Layout: no file of the rooms that prove has a share, limit or patience of its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

// clang-format off
/// type, name, value, unit, reason
#define RUNGPROOF_SCHEDULE(ROW) \
  /* A question and its time */ \
  ROW(double, questionSeconds, 60, "s", "for each question, where the caller says nothing") \
  ROW(double, ruleSeconds, 2, "s", "for a question of a rule in lint: there are hundreds of them") \
  ROW(double, ruleProcessorSeconds, 0.12, "s", "of the processor for each search for such an answer, after all have been looked at together") \
  ROW(double, ruleHeldSeconds, 0.12, "s", "of these for runs with held inputs, which find what waits for long counts") \
  ROW(double, withoutEstimatesSeconds, 0.02, "s", "for bounded search for a run that rests on no estimate, where random runs show none") \
  ROW(double, rulesShare, 0.75, "of lint --prove", "for all rules but those about power-up, which need a run of their own") \
  ROW(double, premiseSeconds, 5, "s", "for a question that a verdict is checked with, such as its premise") \
  ROW(double, premiseShare, 3, "of the proof", "for a run that meets the premise of what is proved: the search only decides between two words") \
  ROW(double, leastPremiseSeconds, 0.5, "s", "of these, however quick the proof was") \
  ROW(double, quickSeconds, 0.5, "s", "for each question while all are looked at together") \
  ROW(double, mostWait, 5, "s", "on the clock for each second of the processor, where others have it") \
  ROW(double, quickRaceSeconds, 0.12, "s", "of these for the race of the engines, which goes on where the question has its own time") \
  ROW(double, ruleRaceShare, 0.85, "of that race", "for a question of a rule, without the engines that settle none in it") \
  ROW(double, freeRealShare, 0.25, "of a question", "before REAL operations are written out: many proofs hold whatever they give") \
  ROW(std::size_t, writtenReals, 200, "operations", "of a goal that are written out as bits; more do not come to an end") \
  ROW(std::size_t, writtenForChecks, 12, "operations", "of a rule's question: there is one at each REAL operation") \
  ROW(double, asWrittenSeconds, 1, "s", "for a proof on the surface of the program as it is written") \
  ROW(double, toldSearch, 3, "s", "for the search for a proof of such facts where their own invariant is not enough") \
  ROW(double, toldSeconds, 10, "s", "for each of the facts that the program as it is written was told, once for all questions") \
  /* Runs of the reference engine */ \
  ROW(int, earlyPatience, 50, "ms", "most programs are encoded by then; longer ones are run meanwhile") \
  ROW(double, engineSeconds, 2, "s", "for runs of the engine, which count their scans, on a busy machine") \
  ROW(double, engineShare, 0.1, "of a question", "for runs of the engine before each question has its own time") \
  ROW(std::uint64_t, fewInstructions, 20'000, "instructions", "of such runs before questions are looked at one by one") \
  ROW(std::size_t, manyPremises, 8, "questions", "that are not declared: one run serves them all, bits answer each") \
  ROW(std::uint64_t, premiseInstructions, 200'000, "instructions", "of runs for so many, before any proof is tried") \
  ROW(std::uint64_t, someInstructions, 400'000, "instructions", "of runs for what is to be reached, before engines are asked whether it can be") \
  ROW(std::uint64_t, guidedInstructions, 4'000'000, "instructions", "40,000 scans of 100 instructions, hours of the machine's time") \
  ROW(int, guidedPhases, 400, "phases", "of a random run") \
  ROW(std::uint64_t, guidedScansBetweenLooks, 64, "scans", "between two looks at the clock") \
  ROW(double, plainShare, 0.25, "of these runs", "for each plain one") \
  ROW(int, plainRuns, 2, "runs", "all inputs on, all off") \
  ROW(std::size_t, steadyInputs, 12, "inputs", "of which each is on alone for long, and on in every other scan") \
  ROW(std::uint64_t, scansUntilRest, 128, "scans", "after which a run whose memory is as it was is at its end") \
  ROW(std::uint64_t, leastInstructions, 50, "instructions", "that a scan counts for, so that empty programs come to an end") \
  ROW(double, ownRunsShare, 0.05, "of a question", "for own runs when the solvers' run was not confirmed") \
  ROW(double, lastOwnRunsShare, 0.3, "of a question", "the same when nothing else is left to be tried") \
  ROW(double, firstExploring, 0.02, "s", "for all questions before they are looked at one by one: what waits for timers and is wrong is often found there") \
  ROW(double, exploringPause, 0.25, "s", "after these, before a question's own race is joined: the engines settle most until then") \
  ROW(double, exploringPauseShare, 0.2, "of what is left", "the same, at most") \
  ROW(double, exploringSeconds, 0.15, "s", "for all questions that are open after the quick looks") \
  ROW(std::size_t, explorationConstants, 200, "constants", "of the program that inputs are set to") \
  ROW(std::size_t, exploredStates, 3000, "states", "kept with their memory") \
  ROW(int, shortRuns, 32, "runs", "of one or two scans, for each one that may be long") \
  ROW(int, longestStretch, 14, "doublings", "a long run keeps its inputs for up to 2^13 scans") \
  ROW(int, longerStretch, 16, "runs", "of which one is 16 times as long") \
  ROW(std::uint64_t, exactBelow, 64, "", "words below tell states apart by value, above by size") \
  ROW(double, otherReadingsShare, 0.25, "of an exploration", "for all readings of open points but those that are chosen") \
  ROW(std::uint32_t, exploredScansBetweenLooks, 64, "scans", "between two looks at the clock") \
  ROW(std::size_t, newestStates, 8, "states", "that are chosen more often") \
  ROW(int, barrenRuns, 50000, "runs", "without a new state, after which the exploration is at its end") \
  /* Witnesses */ \
  ROW(int, fillings, 16, "tries", "of inputs that a question does not mention, to confirm a run") \
  ROW(double, minimiseSeconds, 0.25, "s", "for making a witness smaller") \
  ROW(double, leastMinimising, 0.05, "s", "for the same when the time is over: people read it") \
  ROW(std::uint64_t, minimisedScans, 200, "scans", "longer witnesses wait for a timer; they stay as they were found") \
  ROW(std::size_t, leastJoined, 8, "scans", "of a witness in which alike ones are looked for") \
  ROW(int, minimisingTrials, 48, "tries", "random values of all idle inputs together") \
  ROW(int, replayTrials, 24, "tries", "the same for rules' questions") \
  ROW(std::uint64_t, triedScans, 20000, "scans", "longer runs are not repeated under other readings") \
  ROW(double, completionSeconds, 3600, "s", "for inputs outside a cone: they are there, constraints are total") \
  /* Long scans instead of many */ \
  ROW(int, shallowDepth, 12, "scans", "of a short accelerated run") \
  ROW(double, shallowSeconds, 0.25, "s", "for all of them") \
  ROW(double, shallowShare, 0.18, "of that time", "of the processor for each: most proofs are found sooner, and longer runs have the race") \
  /* Before the engines */ \
  ROW(std::size_t, surfaceNodes, 400, "nodes", "of the surface that a proof in one scan looks at") \
  ROW(double, surfaceQuerySeconds, 0.05, "s", "for each look") \
  ROW(double, mergeShare, 0.3, "of a question", "for merging states, or for finding words to cap") \
  ROW(double, mostMerging, 10, "s", "the same for all questions together") \
  ROW(int, mergingScans, 96, "scans", "sampled on 64 runs") \
  ROW(std::size_t, narrowWord, 4, "bits", "of words that are looked at bit by bit") \
  ROW(int, mergingBatches, 4, "batches", "of 64 states near a counterexample") \
  ROW(double, uncappedShare, 0.7, "of a question", "for the system with whole words") \
  ROW(double, leastForBoth, 5, "s", "of a question, below which words are not capped") \
  ROW(int, cappedWidth, 8, "bits", "of words that are worth it, at least") \
  ROW(std::size_t, cappingConstants, 8, "constants", "the largest ones that a scan has for the word") \
  ROW(double, cappingQuerySeconds, 0.1, "s", "for each query") \
  /* Absorption */ \
  ROW(double, absorptionSeconds, 0.05, "s", "to see that a scan that sets a latch is not bad") \
  /* All questions of a stage together */ \
  ROW(int, simulatedScans, 256, "scans", "of 64 random runs") \
  ROW(double, simulationShare, 0.1, "of a stage", "for them") \
  ROW(int, shortInduction, 3, "steps", "of k-induction under mined invariants") \
  ROW(double, inductionShare, 0.3, "of a stage", "for it") \
  ROW(double, inductionQuerySeconds, 0.25, "s", "for each query: short proofs are wanted, long ones are IC3's") \
  ROW(std::size_t, mostShared, 2, "times", "that a gate may be encoded on average, for solvers of their own") \
  ROW(double, searchShare, 0.9, "of what is left", "for searches; the rest is for checking what they find") \
  ROW(std::size_t, manyClauses, 100, "clauses", "of a certificate, to be joined") \
  /* Invariants */ \
  ROW(double, pairsShare, 0.3, "of a stage", "for pairs of truth values of the state") \
  ROW(double, mostMining, 10, "s", "for each kind of invariant") \
  ROW(std::size_t, truthLimit, 600, "truths", "of the state that invariants speak of") \
  ROW(std::size_t, pairedTruths, 400, "truths", "whose pairs are looked at together") \
  ROW(std::size_t, groupedTruths, 1000, "truths", "whose groups are looked for") \
  ROW(std::size_t, leastGroup, 24, "truths", "of a group; the pairs of fewer are as good") \
  ROW(std::size_t, mostGroups, 64, "groups", "looked at together") \
  ROW(int, groupScans, 48, "scans", "sampled on 64 runs") \
  ROW(int, groupRounds, 4, "rounds", "of 64 states that keep all groups, before the solver is asked") \
  ROW(std::size_t, pairLimit, 12000, "pairs", "that are candidates") \
  ROW(std::size_t, implicationLimit, 3000, "pairs", "the same of one group of questions") \
  ROW(double, invariantShare, 0.3, "of a question", "for the invariants of a group of questions") \
  ROW(std::size_t, ofOneClass, 6, "truths", "of one class that pairs are made of") \
  ROW(std::size_t, unseenLimit, 32, "truths", "that are 0 in all samples") \
  ROW(std::size_t, ofReadings, 64, "latches", "that pairs under one reading of an open point are made of") \
  ROW(std::size_t, invariantBlock, 32, "clauses", "that one assumption switches on") \
  ROW(int, neighbourBatches, 6, "batches", "of 64 states near a counterexample") \
  ROW(int, walkPatience, 24, "scans", "of a walk that drop nothing, then the solver is asked again") \
  ROW(std::size_t, leastCovers, 3, "candidates", "fewer are pairs") \
  ROW(std::size_t, mostCovers, 400, "candidates", "more are too slow to sample") \
  ROW(int, coverScans, 96, "scans", "sampled on 64 runs") \
  ROW(int, coverTrials, 5000, "members", "tried, in all groups") \
  ROW(int, coverGroups, 12, "groups", "that are asked for by induction") \
  ROW(double, unguidedSeconds, 0.02, "s", "for candidates after a scan, before the guide is asked") \
  ROW(double, guideSeconds, 0.05, "s", "for each gate of a guide through what a scan makes of invariants") \
  ROW(double, sumSeconds, 4, "s", "for what is kept of sums that questions ask for") \
  ROW(int, sumAdditions, 10'000, "additions", "that the form of a sum is looked into, all ways to one counted") \
  ROW(std::size_t, changeParts, 64, "parts", "of what a scan adds to a word; one that is counted in more places is no account") \
  ROW(int, changeDepth, 1000, "nodes", "below each other, in which it is looked for") \
  ROW(std::size_t, sumTerms, 24, "words", "of a sum") \
  ROW(int, limitsOfSums, 3, "constants", "of these that whole sums are bounded by") \
  ROW(std::size_t, sumLimits, 8, "constants", "that the words of sums may end at") \
  ROW(std::size_t, correspondingGates, 8000, "gates", "over latches, with these, of which equal ones are looked for") \
  ROW(int, correspondenceScans, 128, "scans", "sampled on 64 runs") \
  ROW(std::size_t, askedTogether, 8, "gates", "that one query asks for: few follow from what is equal to begin with") \
  ROW(int, correspondenceWalk, 4, "scans", "that split nothing, after which a walk from a counterexample ends") \
  ROW(double, correspondenceShare, 0.5, "of a stage", "for equal gates") \
  ROW(double, mostCorrespondence, 0.25, "s", "for them: those that prove something are found sooner") \
  ROW(std::size_t, lastingLimit, 4, "bits", "that stay on, such as the cell of once(I0.3)") \
  ROW(std::size_t, timerPairs, 3000, "pairs", "of bits") \
  ROW(int, wordScans, 384, "scans", "sampled") \
  ROW(int, wordLaneStep, 4, "runs", "of which one is sampled") \
  ROW(std::size_t, wordLanes, 16, "runs", "that are sampled, four of each pace of input changes") \
  ROW(std::size_t, countingWords, 160, "words", "that count and are looked at") \
  ROW(std::size_t, capLimit, 6, "constants", "for each word") \
  ROW(std::int64_t, widestDifference, 1 << 20, "", "bounds further apart tell nothing") \
  ROW(std::size_t, valueLimit, 256, "values", "of a word that are listed") \
  ROW(std::size_t, fewValues, 16, "values", "that random runs show of a word, however often each comes") \
  ROW(int, valueScans, 96, "scans", "of random runs that tell which words have more") \
  ROW(std::uint64_t, valueLanes, 0x1111'1111'1111'1111, "", "the runs of 64 that are looked at, as bits") \
  ROW(int, valuePasses, 3, "times", "that words are tried again, with what is known of others") \
  ROW(double, valueSeconds, 0.3, "s", "for the values of all words of a group of questions") \
  ROW(double, runsBeforeBounds, 0.01, "s", "of random runs for each question that bounds would be looked for") \
  ROW(double, raceBeforeBounds, 0.03, "s", "of the race for each question, before bounds under many conditions are looked for") \
  ROW(double, chainBounds, 4, "s", "for bounds of timers that start each other: nothing else proves what waits for their sum") \
  ROW(double, firstBounds, 0.5, "s", "for few bounds before runs are searched with long scans: most of what waits for timers is true, and what is cut off begins anew later") \
  ROW(double, quickBounds, 0.3, "s", "for bounds under many conditions while all are looked at together: those that prove something are found sooner") \
  ROW(double, boundShare, 2, "of a question", "for bounds on differences, which whole groups wait for") \
  ROW(double, miningShare, 0.3, "of what is left", "the same, at most") \
  ROW(int, templateScans, 24, "scans", "of random runs on which increments are compared") \
  ROW(std::size_t, comparedBits, 24, "bits", "of increments") \
  ROW(std::size_t, incrementGroup, 10, "words", "of one increment") \
  ROW(std::size_t, chainedTimers, 64, "words", "the same of timers that start each other, with one condition each") \
  ROW(std::size_t, leastChain, 6, "words", "of which one is a clock; shorter ones are proved by other bounds") \
  ROW(std::size_t, linkGuards, 3, "conditions", "of a timer of them") \
  ROW(std::size_t, guardLimit, 14, "conditions", "for one pair of words, each also negated") \
  ROW(std::size_t, nearGuards, 6, "conditions", "the same while few bounds are looked for") \
  ROW(std::size_t, fewGuards, 4, "conditions", "the same for words that tell less about each other") \
  ROW(int, smallWidth, 10, "bits", "of words whose range is looked for without condition") \
  ROW(std::size_t, stepsOfWord, 4, "constants", "that scans add to a word; more are no steady pace") \
  ROW(std::size_t, stopLimit, 3, "constants", "at which a word stops counting") \
  ROW(std::size_t, followedChoices, 64, "choices", "between a word and the sum that counts it on") \
  ROW(std::size_t, templateLimit, 1600, "bounds", "that are looked for") \
  ROW(std::int64_t, hopelessBound, 32000, "", "a bound that the words' own ranges give") \
  ROW(int, hopelessBits, 4, "bits", "the same for wider words: fewer than they have") \
  ROW(int, boundScans, 160, "scans", "sampled on 64 runs") \
  ROW(int, raisesAllowed, 6, "times", "that a bound may be raised to its largest value") \
  ROW(int, growthPatience, 1, "times", "the same for a difference that can grow on and on") \
  ROW(std::size_t, closureLimit, 300, "invariants", "that are needed; where so many rest on each other, most rest on all") \
  ROW(int, coreRounds, 4, "rounds", "of making a core smaller") \
  /* The race: slices double from short to long, so that short proofs do not wait for long searches */ \
  ROW(double, firstSlice, 0.005, "s", "of an engine's first turn") \
  ROW(double, longestSlice, 1, "s", "of a turn") \
  ROW(double, leastSlice, 0.001, "s", "of a turn at the end of a question's time") \
  ROW(double, ic3Weight, 4, "parts of the time", "finds most proofs") \
  ROW(double, wordsWeight, 3, "parts of the time", "finds those about numbers") \
  ROW(double, bmcWeight, 2, "parts of the time", "finds most runs") \
  ROW(double, simulationWeight, 1, "parts of the time", "finds what waits for timers") \
  ROW(double, exhaustiveWeight, 1, "parts of the time", "settles small systems, and says so when they are too large") \
  ROW(double, heldInputsWeight, 1, "parts of the time", "finds what waits for long counts") \
  ROW(double, kInductionWeight, 1, "parts of the time", "finds what follows from the last scans") \
  ROW(double, bmcWait, 0.003, "s", "that count as used by it when the race begins") \
  ROW(double, seekerWait, 0.004, "s", "the same, of engines that seldom settle what is left for the race") \
  ROW(double, runPatience, 0.1, "s", "of engines that find soon what they find: their share halves when they have worked so long") \
  ROW(double, tirelessSeconds, 1e6, "s", "the same for those that get on as long as they work") \
  ROW(int, ctgLimit, 3, "states", "counterexamples to generalisation looked at for one literal") \
  ROW(double, activityGrowth, 1.05, "times", "that a cube counts more than the one before it, on bits and on words") \
  ROW(int, longestEpisode, 1 << 16, "scans", "of a random run") \
  ROW(std::size_t, episodeWords, 16U << 20U, "words", "of inputs recorded of one") \
  ROW(int, redraws, 3, "tries", "of inputs that meet the constraints") \
  ROW(int, wordRunBits, 8, "bits", "of a product or quotient whose circuit is long") \
  ROW(std::size_t, wordRunNodes, 60'000, "nodes", "of a system that is run on numbers before circuits are made") \
  ROW(std::size_t, wordRunHints, 400, "hints", "of inputs from its comparisons") \
  ROW(int, wordRunRounds, 3, "rounds", "of 64 such runs") \
  ROW(int, wordRunScans, 3, "scans", "of each of them") \
  ROW(int, wordRunRedraws, 12, "tries", "of inputs that meet the constraints, in each of their scans") \
  ROW(int, inputSamples, 8, "inputs", "that meet the constraints, from a solver") \
  ROW(double, inputSampleSeconds, 0.5, "s", "for them") \
  ROW(int, longestHeldRun, 1 << 17, "scans", "of a run with held inputs") \
  ROW(std::size_t, gatesOfHeldRuns, 300'000'000, "gates", "evaluated at most: about half a second") \
  ROW(std::size_t, largestUnrolled, 200'000, "gates", "of one scan; larger systems are left to others") \
  ROW(std::size_t, lanesOfOneKind, 32, "runs", "whose inputs stay; as many take turns") \
  ROW(std::size_t, latchesTried, 256, "latches", "that inputs are held for") \
  ROW(std::size_t, explicitStates, 4U << 20U, "states", "of an explicit search") \
  ROW(std::size_t, explicitInputs, 12, "inputs", "whose values are all tried") \
  ROW(std::size_t, explicitFree, 16, "latches", "of unknown initial value") \
  ROW(std::size_t, explicitLatches, 64, "latches", "a state is one word") \
  ROW(std::size_t, explicitGates, 3000, "gates", "of a certificate that another solver can still check") \
  ROW(std::size_t, gatesBetweenLooks, 10000, "gates", "made between two looks at the clock") \
  /* The engine on words */ \
  ROW(std::size_t, wordEngineScans, 160, "scans", "of random runs that predicates are tried on") \
  ROW(std::size_t, wordEngineGates, 200'000'000, "gates", "evaluated for them at most") \
  ROW(std::size_t, wordEngineSamples, 1024, "states", "kept of them") \
  ROW(std::size_t, firstRestart, 2000, "queries", "before a search begins anew, twice as many each time: a good one needs a thousand, one with the wrong predicates goes on") \
  ROW(double, wordEngineCone, 400'000, "gates", "of a scan for each second of a question, in which the engine gets ready; larger ones are left to others") \
  ROW(double, firstTermSlice, 0.05, "s", "that Z3 works before it looks at the budget, at first") \
  ROW(std::size_t, predicateStore, 1500, "predicates", "that are at hand") \
  ROW(std::size_t, mostTelling, 3, "predicates", "that tell two states apart, added by one refinement") \
  ROW(std::size_t, mostCarried, 3, "predicates", "that are carried through a scan, added by one refinement") \
  ROW(std::size_t, leafLimit, 12, "alternatives", "of one term") \
  ROW(std::size_t, eliminationLimit, 48, "words", "looked at together for equations") \
  ROW(std::size_t, leastSamples, 32, "samples", "that an equation is read from") \
  ROW(std::int64_t, coefficientLimit, 1'000'000, "", "larger coefficients are chance") \
  ROW(std::uint64_t, denominatorLimit, 4000, "", "larger denominators are chance") \
  ROW(std::size_t, termLimit, 5, "words", "of an equation") \
  ROW(int, choiceLimit, 128, "equations", "that one becomes") \
  /* Faults planted by the self-check: runs side by side */ \
  ROW(std::size_t, sideBySideTraces, 256, "traces", "of random runs: as many as one vector of bits holds") \
  ROW(std::uint32_t, sideBySideScans, 1000, "scans", "of each") \
  ROW(unsigned, sideBySideStretch, 7, "doublings", "inputs stay for up to 2^6 scans") \
  ROW(double, sideBySideSeconds, 0.05, "s", "for those of the program itself; its copies take as long") \
  ROW(std::size_t, sideBySideSuspects, 8, "traces", "in which outputs differ that are followed one by one") \
  /* Checking */ \
  ROW(double, judgeShare, 0.6, "of checking", "for the judge, who has the program as it is written") \
  ROW(double, leastCheck, 0.5, "s", "for checking certificates, whatever the deadline says") \
  ROW(double, leastForCertificate, 10, "s", "that a certificate may take, however short the question was") \
  ROW(double, guidedSeconds, 10, "s", "for one with a guide, which Z3 does not have") \
  ROW(double, stepByStepSeconds, 1, "s", "for an obligation whose refutation is followed step by step, before Z3") \
  ROW(std::size_t, stepsBetweenLooks, 64, "steps", "of a refutation between two looks at the clock") \
  ROW(std::size_t, nodesBetweenLooks, 1024, "nodes", "read for bounds between two looks at the clock") \
  ROW(double, plainCheckSeconds, 3, "s", "for a plain strategy that starts fast, before Z3's own for QF_BV") \
  ROW(double, jointSeconds, 0.3, "s", "for several formulas at once") \
  ROW(std::size_t, smallFormula, 1000, "numbers", "in the form of a formula that is checked with others") \
  ROW(std::size_t, jointFormulas, 2000, "numbers", "of all formulas that are checked at once")
// clang-format on

namespace rungproof {

/// The rows as constants: schedule::searchShare.
namespace schedule {
#define RUNGPROOF_ROW(type, name, value, unit, reason) inline constexpr type name = value;
RUNGPROOF_SCHEDULE(RUNGPROOF_ROW)
#undef RUNGPROOF_ROW
}  // namespace schedule

struct ScheduleRow {
  std::string_view name;
  double value;
  std::string_view unit;  ///< empty: a number of the program
  std::string_view reason;
};
inline constexpr std::array scheduleRows = {
#define RUNGPROOF_ROW(type, name, value, unit, reason) ScheduleRow{#name, static_cast<double>(value), unit, reason},
    RUNGPROOF_SCHEDULE(RUNGPROOF_ROW)
#undef RUNGPROOF_ROW
};

}  // namespace rungproof
