// What the heading of a column means: a signal of the program, an output of a library block, or a device.
// Tested by tests/trace/stimulus_test.cpp.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/stimulus.hpp"
#include "frontend/files/failure.hpp"

namespace rungproof {

/// The signal that an address, a symbol, or one of them with ".value" means; failure text otherwise.
std::optional<TraceSignal> signalNamed(const Program& program, std::string_view name, Failure& failure);

/// The same where no program is known, with a symbol table or none: what is neither address nor symbol keeps its name
/// and is a number.
TraceSignal signalWithoutProgram(std::string_view name, std::span<const Symbol> symbols);

/// Whether the operand is an input: its column sets it also in a stimulus that is whole.
bool isInputColumn(const Operand& operand);

/// Whether the operand is an output, which the program drives and no stimulus may.
bool isOutputColumn(const Operand& operand);

/// The column of a stimulus with that heading. In a recorded trace, what the program computes is passed over.
std::optional<StimulusColumn> stimulusColumn(const Program& program, const std::string& name, bool isRecorded,
                                             Failure& failure);

/// The column of these that sets memory which `column` sets too, or nullptr; "columns 'A' and 'B' name the same place".
const StimulusColumn* sharedWith(std::span<const StimulusColumn> columns, const StimulusColumn& column);
std::string samePlaceText(std::string_view first, std::string_view second);

}  // namespace rungproof
