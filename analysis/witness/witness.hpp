// Witnesses: a run that the solver found, as scans for the reference engine, and what the engine and the property's
// monitor say about it. Only a run that the engine repeats with the same outcome counts.
// Covered by tests/prover.
#pragma once

#include <optional>
#include <random>
#include <unordered_set>
#include <vector>

#include "analysis/bits/bit_blast.hpp"
#include "analysis/encoding/asked_properties.hpp"
#include "engine/replay.hpp"

namespace rungproof {

/// A run of the engine that shows what was asked.
struct Witness {
  std::vector<ReplayScan> scans;  ///< up to and including the scan that shows it
  /// By scan and input of it: whether the value matters (witness_minimal.hpp). Empty: not known.
  std::vector<std::vector<bool>> matters{};
  std::optional<Concrete::Store> initial;  ///< where retentive memory starts with other values than power-up
  std::uint64_t scanCount = 0;             ///< scans of the engine, repeats included
  std::uint64_t milliseconds = 0;          ///< from the start to the end of the last scan
  /// In front of which instruction of the last scan a property of every instruction showed it; nullptr: at the end.
  const Instruction* place = nullptr;
};

/// Cells of V, M, T and C whose value at the start is not that of a power-up with lost memory, as the bytes of V and M
/// and the current values of T and C: what a witness needs beside its inputs.
struct StartCell {
  Area area;
  std::uint32_t index;  ///< byte or number
};
std::vector<StartCell> startCells(const Program& program, const Choices& choices, const Concrete::Store& initial);

/// Judges engine runs by the monitors of assumptions and of one goal.
class Judge {
 public:
  Judge(const Program& program, const Choices& choices, const std::vector<Property>& assumptions, const Property& goal);

  struct Outcome {
    bool shown = false;  ///< the goal's monitor answered true in some scan, with all assumptions kept until then
    const Instruction* place = nullptr;  ///< as Witness::place
    std::uint64_t scan = 0;              ///< engine scans made until then, from 1
    std::size_t step = 0;                ///< index of its ReplayScan
    std::uint32_t round = 0;             ///< repeat of that ReplayScan, from 0
    std::uint64_t milliseconds = 0;
    bool assumptionBroken = false;
  };
  Outcome run(const std::vector<ReplayScan>& scans, const Concrete::Store* initial) const;
  /// The same run, cut behind the scan that shows the goal; nothing if it is not shown.
  std::optional<Witness> witness(std::vector<ReplayScan> scans, std::optional<Concrete::Store> initial) const;
  const Program& program() const { return program_; }
  const Choices& choices() const { return choices_; }

 private:
  const Program& program_;
  const Choices& choices_;
  const std::vector<Property>& assumptions_;
  const Property& goal_;
};

/// Of each goal the same as Judge::witness gives, in one run for all of them.
std::vector<std::optional<Witness>> witnessesOf(const Program& program, const Choices& choices,
                                                const std::vector<Property>& assumptions,
                                                const std::vector<const Property*>& goals,
                                                const std::vector<ReplayScan>& scans,
                                                const std::optional<Concrete::Store>& initial);

/// Turns a word-level run of an encoding into scans of the engine. Scans longer than the range become several.
std::vector<ReplayScan> scansOf(EncodedScan& encoding, const TransitionSystem& system, const WordTrace& trace,
                                const TimeRange& range);
/// Gives every input but the `fixed` ones (node indices) any value, in all scans of the run.
void fillOtherInputs(const TransitionSystem& system, const std::unordered_set<std::uint32_t>& fixed,
                     std::mt19937_64& random, WordTrace& trace);
/// The state that the run starts from, or nothing if it is that of power-up.
std::optional<Concrete::Store> initialOf(EncodedScan& encoding, const TransitionSystem& system, const WordTrace& trace);

/// Real scans that last `length` ms together: how many of which length, nearly equal ones, the longer first.
struct Stretch {
  std::uint32_t length;
  std::uint32_t count;
};
std::vector<Stretch> stretchOf(std::uint32_t length, const TimeRange& range);

/// Value of a direct operand in a state, in the width in which it is written; T and C: bit or current value by width.
std::uint64_t valueIn(const Concrete::Store& state, const Operand& operand);

}  // namespace rungproof
