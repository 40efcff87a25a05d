// One instruction with random operands on a random machine: operands come from the signature of the mnemonic, values
// from the borders of its types, pointers lead everywhere, legal or not, buffers end with their areas.
#pragma once

#include <memory>
#include <random>
#include <string>

#include "naive.hpp"
#include "tests/manual/plant.hpp"

namespace rungproof::reference {

/// LDB= to ORS<>.
bool isCompare(const std::string& mnemonic);

class SingleCase {
 public:
  SingleCase(const std::string& mnemonic, std::uint64_t seed);

  manual::Plant& plant() { return *plant_; }
  const std::string& statements() const { return statements_; }
  const Instruction& instruction() const;

 private:
  /// A value to be put somewhere before the scan.
  struct Setting {
    Operand place;
    int bytes;
    std::uint32_t value;
  };
  /// A direct operand with its spelling.
  struct Spot {
    std::string text;
    Area area;
    std::uint32_t offset;
  };

  std::uint32_t pick(std::uint32_t n) { return static_cast<std::uint32_t>(random_() % n); }
  bool oneIn(std::uint32_t n) { return pick(n) == 0; }
  template <class T>
  T any(std::initializer_list<T> list) {
    return *(list.begin() + pick(static_cast<std::uint32_t>(list.size())));
  }

  std::string operandsOf(const std::string& mnemonic, std::string_view signature);
  std::string operand(const std::string& mnemonic, char letter, std::size_t at);
  std::string bit(const std::string& mnemonic, bool written);
  std::string value(char letter);
  std::string buffer(const std::string& mnemonic, char letter);
  std::string table(char letter);
  std::string stringOperand(const std::string& mnemonic, bool constant);
  std::string number(const std::string& mnemonic, std::size_t at);
  Spot spot(int bytes, int room, bool written);
  std::string reach(int bytes, int room, bool written, std::uint32_t firstValue, bool setFirst);
  std::uint32_t special(char letter);
  std::string characters(const std::string& mnemonic);
  void put(const Spot& at, int bytes, std::uint32_t value, std::uint32_t element = 0);
  void fillMemory(const std::string& mnemonic);

  std::mt19937_64 random_;
  std::string statements_;
  std::vector<Setting> settings_, pointers_;
  std::unique_ptr<manual::Plant> plant_;
  std::uint32_t odds_ = 5;  ///< one in so many operands is a pointer or an accumulator
  std::uint32_t nextSlot_ = 300;
  std::optional<std::uint32_t> neighbour_;  ///< value of the first operand, or of an entry of the table
  std::optional<std::string> neighbourText_;
};

}  // namespace rungproof::reference
