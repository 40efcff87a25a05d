// Random small programs that use devices, interrupts, the time base and system bits in ways that touch each other, and
// random properties over what they write.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "random.hpp"

namespace rungproof::referee {

using Network = std::vector<std::string>;  ///< its lines
struct Block {
  std::string head, tail;  ///< "INTERRUPT_BLOCK INT_0:INT0", "END_INTERRUPT_BLOCK"
  std::vector<Network> networks;
};
/// One program with its properties, in pieces that can be taken away.
struct Case {
  std::vector<Block> blocks;            ///< MAIN first
  std::vector<std::string> properties;  ///< without //@
  std::string text() const;
};

/// What a program may use. Those named by a campaign are drawn; a program has one to three of them.
enum class Topic {
  Edges,
  Timed,
  Receive,
  Transmit,
  Network,
  HighSpeed,
  Pulses,
  Clock,
  SystemBits,
  Timers,
  Counters,
  Ends,
  Save,
  Masking
};
constexpr int topicCount = 14;

class CaseDraw {
 public:
  CaseDraw(std::uint64_t seed, const std::vector<Topic>& topics);
  /// The program, without properties.
  Case program();
  /// A statement about one cell of that program.
  std::string atom();
  /// What properties are made of from now on.
  void setAtoms(std::vector<std::string> atoms) { atoms_ = std::move(atoms); }
  /// One more property line.
  std::string property(int number);

 private:
  struct Cell {
    char width;
    std::string address;
    std::vector<int> values;
  };
  void edges();
  void timed();
  void reception();
  void transmission();
  void netRequest();
  void highSpeed();
  void pulses();
  void clock();
  void systemBits();
  void timers();
  void counters();
  void ends();
  void save();
  void masking();
  void use(Topic topic);

  std::string attach(int event);
  std::string input() { return "I0." + std::to_string(inputs_[static_cast<std::size_t>(random_.below(2))]); }
  std::string bit();
  std::string comparison(const std::string& joint);
  Network condition(bool inMain);
  std::string action(bool inMain);
  Network rung(bool inMain);
  void networkOf(Network lines) { main_.push_back(std::move(lines)); }
  std::string propertyTerm();

  Random random_;
  std::vector<Topic> topics_;
  std::vector<int> inputs_ = {0, 1};
  std::vector<std::string> setup_, bits_, actions_, routineBits_, routineActions_;
  std::vector<Cell> cells_;
  std::vector<Network> main_;
  std::vector<std::vector<Network>> routines_;
  std::vector<std::string> atoms_;
  bool hasHighSpeed_ = false;
  bool interrupts_ = false;
  std::string text_;
};

}  // namespace rungproof::referee
