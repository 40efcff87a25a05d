// The environment referee: a second, naive model of one CPU with its devices, interrupt queues, time base and system
// bits, written from the manual alone. It shares no code with the product and runs one random run at a time: whatever
// the manual lets the environment choose (inputs, lengths of scans, the moment of every event, data that arrives) is
// drawn. What it does is meant to be possible by the manual; it need not do everything that is possible.
// A run is one object: construct, then call scan() until it says that there is no further scan end.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "program_text.hpp"
#include "random.hpp"

namespace rungproof::referee {

/// Which points that the manual leaves open are drawn anew for each run; the others have their usual reading.
struct OpenPoints {
  bool detach = true;          ///< DTCH drops what is queued, or leaves it there (001:5357)
  bool stop = true;            ///< STOP in the main program ends the scan, or lets it finish (001:5693)
  bool scanClock = true;       ///< SM0.4, SM0.5, SM0.6 begin off or on (001:14054, 001:14681)
  bool counterEdge = true;     ///< a count input that is on in the first scan counts, or is stored (001:2763)
  bool portsInScan = true;     ///< characters arrive and leave while the program runs (001:5703), or between scans
  bool portsBeforeEnd = true;  ///< part 3 of the scan comes before the outputs are written (001:1205)
  bool countersInScan = true;  ///< pulses are counted, trains end while the program runs, or between scans
};

/// What the environment is like in one run; drawn at its start, so that runs differ as a whole.
struct Temper {
  int inputs = 30;   ///< percent: an input changes between two scans
  int events = 10;   ///< percent at each boundary between instructions: something happens
  int devices = 30;  ///< percent between scans: a device makes progress
  int ticks = 0;     ///< when the milliseconds of a scan pass: at its end, at its start, spread, single
  int lengths = 0;   ///< how long scans are: short, mixed, long, one length for all
  int fixedLength = 10;
};

class Machine {
 public:
  Machine(const Program& program, std::uint64_t seed, const OpenPoints& open);

  /// One scan. False if the run has ended before the end of this scan: STOP at once, a fatal error, no RUN any more.
  bool scan();

  /// Value at the last scan end, unsigned bytes, signed words and double words; bits 0 or 1.
  std::int64_t valueOf(const Operand& o) const;
  /// As valueOf, a timer or counter without `.value` is its bit.
  bool bitOf(const Operand& o) const;
  std::int64_t now() const { return now_; }  ///< ms since the start of RUN
  int scanNumber() const { return scanNumber_; }
  const std::vector<std::string>& told() const { return told_; }  ///< what happened, for people
  void tellAll() { telling_ = true; }

 private:
  static constexpr int watchdog = 500;
  static constexpr int busy = 300;  ///< boundaries of a scan after which the outside world is quiet until its end
  struct Entry {
    int event;
    int routine;
  };
  struct TimerState {
    int current = 0;
    int preset = 0;
    bool bit = false;
    bool timing = false;
    bool input = false;
    bool offDelay = false;
  };
  struct CounterState {
    int current = 0;
    bool bit = false;
    bool up = false;
    bool down = false;
    bool executed = false;
  };
  struct Port {
    bool receiving = false;
    bool transmitting = false;
    Operand buffer;
    std::vector<std::uint8_t> characters;
    std::size_t arrived = 0;
    std::uint8_t reason = 0;
    bool countEach = false;
    std::int64_t earliest = 0;  ///< when the reception may end
    std::int64_t sentFrom = 0, sentBy = 0;
  };
  struct Request {
    Operand table;
    bool reads;
  };
  struct HighSpeedCounter {
    bool defined = false;
    bool enabled = false;
    bool up = true;
    int mode = 0;
    std::int32_t current = 0;
    std::int32_t preset = 0;
  };
  struct PulseTrain {
    bool active = false;
    bool pending = false;
    int cycle = 2;
    std::int64_t count = 1;
    std::int64_t from = 0, by = 0;
    std::int64_t pendingMicroseconds = 0;
  };

  // machine.cpp: the scan, time and the boundaries between instructions.
  void startOfScan();
  void endOfScan();
  int lengthOfScan();
  void boundary();
  void pass(int milliseconds);
  void tick();
  void happen();
  void runBlock(const std::vector<Instruction>& block);
  void tell(const std::string& what);
  std::vector<std::uint8_t>& bytesOf(Area area);
  const std::vector<std::uint8_t>& bytesOf(Area area) const;
  std::uint32_t load(Area area, int offset, int bytes) const;
  void store(Area area, int offset, int bytes, std::uint32_t value);
  bool systemBit(int byte, int bit) const { return (load(Area::SM, byte, 1) >> bit & 1) != 0; }
  void setSystemBit(int byte, int bit, bool value);
  void runTimeError() { setSystemBit(4, 3, true); }

  // instructions.cpp
  void execute(const Instruction& i);
  std::int64_t read(const Operand& o, char width) const;
  void write(const Operand& o, char width, std::int64_t value);
  bool readBit(const Operand& o, bool immediate) const;
  void writeBits(const Operand& o, int count, bool value);
  void join(Joint joint, bool value);
  void compare(const Instruction& i);
  void edge(const Instruction& i);
  void step(const Instruction& i, int by);
  void callSubroutine(const Instruction& i);

  // timers.cpp
  void timer(const Instruction& i);
  void refresh(TimerState& t, int number, std::int64_t ticks);
  std::int64_t ticksBetween(int resolution, std::int64_t from, std::int64_t to) const;
  void resetTimer(int number);
  void counter(const Instruction& i);

  // interrupts.cpp
  void attach(const Instruction& i);
  void detach(int event);
  void raise(int event);
  void serve();
  void runRoutine(const Entry& entry);

  // ports.cpp
  void receive(const Instruction& i);
  void transmit(const Instruction& i);
  void network(const Instruction& i);
  void freeportProgress();
  void transmissionTime();
  void finishReception(Port& port, int number, std::uint8_t reason);
  void networkProgress();

  // pulses.cpp
  void defineCounter(const Instruction& i);
  void highSpeed(const Instruction& i);
  void count();
  void pulseOutput(const Instruction& i);
  void pulseTime();
  void startTrain(PulseTrain& train, std::int64_t microseconds);

  // system.cpp
  void startOfRun();
  void systemBits();
  void storeClock(const Operand& to);
  void changeInput(int number);

  const Program& program_;
  Random random_;
  OpenPoints open_;
  Temper temper_;

  std::vector<std::uint8_t> i_, q_, m_, v_, s_, sm_, ai_;
  std::array<std::uint32_t, 4> accumulators_{};
  std::array<bool, 9> stack_{};
  std::array<bool, 16> terminals_{};  ///< I0.0 to I1.7 as they are outside
  std::vector<int> usedInputs_;
  std::vector<bool> edgeMemory_;
  std::vector<TimerState> timers_;
  std::vector<CounterState> counters_;
  std::array<std::deque<Entry>, 3> queues_;
  std::array<int, 34> attached_{};  ///< routine + 1
  std::array<std::int64_t, 2> period_{}, elapsed_{};
  std::array<Port, 2> ports_;
  std::vector<Request> requests_;
  std::array<HighSpeedCounter, 6> highSpeed_;
  std::array<PulseTrain, 2> trains_;

  bool interruptsEnabled_ = false;
  bool inRoutine_ = false;
  bool routineEnds_ = false;  ///< CRETI or STOP
  bool subroutineEnds_ = false;
  bool scanEnds_ = false;   ///< END, or STOP where that ends the scan
  bool runEnds_ = false;    ///< no further scan
  bool noScanEnd_ = false;  ///< a fatal error, or STOP that ends the program at once
  bool detachDrops_ = false;
  bool stopAtOnce_ = true;
  bool clockOn_ = false;
  bool edgeCounts_ = false;
  bool dated_ = false;
  int scanNumber_ = 0;
  int left_ = 0;  ///< ms of this scan that have not passed
  int length_ = 0;
  int executed_ = 0;
  std::int64_t now_ = 0;
  std::int64_t scanStart_ = 0, lastScanStart_ = 0;
  std::int64_t clockSeconds_ = 0;
  int shortest_ = 0, longest_ = 0;
  std::array<int, 2> phase_{};  ///< of the 10 ms and the 100 ms base
  bool telling_ = false;
  std::vector<std::string> told_;
};

}  // namespace rungproof::referee
