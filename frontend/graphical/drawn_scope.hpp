// Names of a drawn block: variables with their places, instances of function blocks with their pins. Names are
// compared without regard to case, as IEC 61131-3 does. Tested by tests/graphical/plcopen_test.cpp.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/graphical/iec_type.hpp"

namespace rungproof {

/// Capitals.
std::string foldedName(std::string_view name);

struct DrawnCopy;

/// Where a variable lives, or what it is.
struct VariablePlace {
  IecType type = IecType::None;
  Operand operand;
  std::optional<IecLiteral> constant;  ///< a constant, or an input variable that nobody can write
  DrawnCopy* copy = nullptr;           ///< instance of a function block
};

enum class StandardBlock : std::uint8_t { None, Ton, Tof, Tp, Ctu, Ctd, Ctud, Sr, Rs, RTrig, FTrig };
/// "TON", "R_TRIG", "CTU_DINT" is none.
StandardBlock standardBlockNamed(std::string_view name);

/// One copy of a block with memory of its own: an instance of a function block, a program, or the only copy of a
/// function. Copies of the project's own blocks are subroutines; `places` holds their variables, of a standard block
/// the outputs that live in memory.
struct DrawnCopy {
  std::string path;                   ///< "MAIN.Pump1"
  const DrawnBlock* block = nullptr;  ///< of the project
  StandardBlock standard = StandardBlock::None;
  int number = -1;     ///< of the subroutine, timer or counter
  int resolution = 0;  ///< of the timer, ms
  std::map<std::string, VariablePlace> places;
  bool isBroken = false;  ///< no number was left; reported
  bool isRead = false;    ///< its outputs are named somewhere ("T1.ET")
};

}  // namespace rungproof
