// One level of the logic stack while a network is followed symbolically: which element's output it holds, and what a
// ladder must know about the circuit that ends there. Used by analysis/drawing/raise.cpp; tested by
// tests/drawing/raise_test.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "ir/drawing.hpp"

namespace rungproof {

struct DrawnLevel {
  std::uint32_t element = 0;
  bool isOpen = true;      ///< nothing but the next element uses the value: no coil, no copy, no box beside it
  bool isContacts = true;  ///< made of contacts and ORs only, so that it can stand in series behind anything
  bool mayExtend = false;  ///< the gate `element` was made last and takes a further input
  std::vector<std::uint32_t> heads;  ///< contacts at the rail with which the circuit begins
};

/// What the instructions around a CALL do for its flow inputs (001:6809, 001:10223-10238).
enum class CallRole : std::uint8_t { None, StoreEnable, StoreFlow, Recall, Call };

struct CallIdiom {
  std::vector<CallRole> roles;        ///< by instruction
  std::vector<std::uint32_t> callOf;  ///< by instruction with a role: the position of its CALL
};

/// Finds `= L60.0 ... = L63.7 ... = L63.6 ... LD L60.0, CALL x, L63.7, L63.6` in a network.
CallIdiom callIdiomOf(const Network& network);

/// Coils, boxes and contacts: how an instruction is drawn. Stack operations count as Or.
Shape shapeOf(const Desc& desc);

}  // namespace rungproof
