// Stimulus: what the surroundings do in a run, scan by scan or at given times. An empty
// cell keeps the last value. A row keyed by time counts from the first scan that begins at that time or later.
// Covered by tests/trace/stimulus_test.cpp.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/replay.hpp"
#include "engine/simulator.hpp"
#include "engine/trace.hpp"
#include "ir/s7300/start_information.hpp"

namespace rungproof {

/// What a column acts on.
enum class StimulusTarget : std::uint8_t {
  Memory,         ///< a direct operand: I and AI the physical value, other areas written like by a panel
  LibraryOutput,  ///< output of a library block: "USS_CTRL.Speed", or "USS_CTRL.12" for the twelfth operand of its
                  ///< calls
  Pulses,         ///< "HSC0.pulses": pulses at the clock or up-clock input of a counter in every scan
  DownPulses,     ///< "HSC0.down": at the down-clock input
  Characters,     ///< "PORT0.receive": characters that another station sends
  NetworkError,   ///< "NET.error": error code of NETR and NETW requests that end
  NetworkHold,    ///< "NET.hold": 1 keeps requests from ending
  TickPhase,      ///< "CLOCK.tick": ms since the last tick of the 100 ms time base
  SecondPhase,    ///< "CLOCK.second": ms that SM0.5 is into its second, first off, then on
  MinutePhase,    ///< "CLOCK.minute": the same for SM0.4 and its minute
  ClockBitPhase,  ///< "CLOCK.bit5": the same for a bit of the clock memory of an S7-300/400 and its period
  StartField,     ///< "OB40_POINT_ADDR": of the start information of an organization block of an S7-300/400
  None            ///< read and passed over: a column of a recorded trace that the program itself computes
};

struct StimulusColumn {
  StimulusTarget target = StimulusTarget::None;
  TraceSignal signal;
  std::string block{};         ///< LibraryOutput: name in the call
  s7300::StartField field{};   ///< StartField
  std::uint32_t position = 0;  ///< LibraryOutput: operand, from 1; Pulses, Characters: number of the counter or port
};

struct StimulusRow {
  std::uint64_t scan = 0;                   ///< from 1, if keyed by scan
  std::uint64_t timeUs = 0;                 ///< if keyed by time
  std::optional<std::uint32_t> scanUs{};    ///< length of the scans from here on
  std::vector<int> events{};                ///< at the start of the scan
  std::vector<ScanScript::Event> placed{};  ///< within it, in the order of execution
  std::vector<ScanScript::Write> writes{};  ///< of devices
  std::vector<ScanScript::Tick> ticks{};    ///< Stimulus::isWhole: 1 ms ticks within the scan
  std::optional<std::uint32_t> ticks10{};   ///< Stimulus::isWhole: as ScanScript has them
  std::optional<std::uint32_t> ticks100{};
  std::vector<ExternalValue> externals{};  ///< Stimulus::isWhole: what the engine asks for, in that order
  std::vector<PresetValue> presets{};      ///< Stimulus::isWhole: inputs and memory without a column of their own
  std::vector<std::optional<TraceNumber>> values{};  ///< by column
  /// Port and character (SerialPorts::breakSignal: a break), in the order in which they are sent.
  std::vector<std::pair<std::uint32_t, int>> characters{};
};

/// What a byte of an area or a register holds when the run begins.
struct StartValue {
  std::optional<Reg> reg{};  ///< nothing: a byte of the area
  Area area = Area::V;
  std::uint32_t index = 0;
  std::uint64_t value = 0;
};

struct Stimulus {
  std::vector<StimulusColumn> columns;
  std::vector<StimulusRow> rows;  ///< in ascending order of their key
  bool isByTime = false;
  /// Some interrupt stands at its place in a scan, or writes of devices are given: nothing comes but that of the rows.
  bool isScripted = false;
  /// Everything that the surroundings do is in the rows, as a witness has it; what they do not give is 0.
  bool isWhole = false;
  std::vector<StartValue> start{};  ///< isWhole: beside what power-up leaves
};

/// How many of a register a state has.
std::uint32_t registerSize(const Concrete::Store& store, Reg reg);
/// Options of a simulator that plays a stimulus which is whole: those of replays.
SimulatorOptions wholeOptions(const Choices& choices);
/// Puts a simulator, which has just been made, where a stimulus that is whole begins.
void beginWhole(Simulator& simulator, const Stimulus& stimulus, const Choices& choices);

/// What a value of a column does before the next scan; columns of characters and those that are passed over do nothing.
void actOn(Simulator& simulator, const StimulusColumn& column, std::uint64_t value);

/// Plays a stimulus into a simulator.
class StimulusPlayer {
 public:
  /// `given`: the simulator's outside, for a stimulus that is whole; nullptr otherwise.
  StimulusPlayer(Simulator& simulator, const Stimulus& stimulus, GivenValues* given = nullptr)
      : simulator_(simulator), stimulus_(stimulus), given_(given) {}

  /// Sets the environment for the next scan and says what that scan is to be. Call once in front of every scan.
  ScanRequest next();
  /// All rows have been played.
  bool isDone() const { return row_ >= stimulus_.rows.size(); }

 private:
  void apply(const StimulusRow& row, ScanRequest& request);

  Simulator& simulator_;
  const Stimulus& stimulus_;
  GivenValues* given_;
  std::size_t row_ = 0;
  std::uint32_t scanUs_ = 0;
  ScanScript script_;  ///< of the next scan, if the stimulus is scripted
};

}  // namespace rungproof
