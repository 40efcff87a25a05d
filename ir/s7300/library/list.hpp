// All blocks of the CPU and of the standard libraries. Only ir/s7300/library/table.cpp and the one source per domain
// that instantiates their meanings include it.
#pragma once

#include "ir/s7300/library/clock_blocks.hpp"
#include "ir/s7300/library/counters_blocks.hpp"
#include "ir/s7300/library/dates_blocks.hpp"
#include "ir/s7300/library/errors_blocks.hpp"
#include "ir/s7300/library/interrupts_blocks.hpp"
#include "ir/s7300/library/scaling_blocks.hpp"
#include "ir/s7300/library/selection_blocks.hpp"
#include "ir/s7300/library/strings_blocks.hpp"
#include "ir/s7300/library/timers_blocks.hpp"
#include "ir/s7300/library/transfer_blocks.hpp"

namespace rungproof::s7300::library {

using AllBlocks = isa::Join<CountersGroup, TimersGroup, ClockGroup, TransferGroup, InterruptsGroup, ErrorsGroup,
                            DatesGroup, StringsGroup, SelectionGroup, ScalingGroup>::type;

}  // namespace rungproof::s7300::library
