// Programs of every family can run: the list of what each adds to the machine (ir/machine/scan.hpp,
// ir/machine/timers.hpp). Includes of a further family stand here, and its dialect in ir/families/dialect.cpp.
#pragma once

#include "ir/iec/control.hpp"
#include "ir/s7200/control.hpp"
#include "ir/s7200/scan_cycle.hpp"
#include "ir/s7300/control.hpp"
#include "ir/s7300/timer_pass.hpp"
