// The instructions of every family with their meanings, and those of their system blocks. Only the one source per
// domain that instantiates the dispatch tables includes this.
#pragma once

#include "ir/iec/isa/list.hpp"
#include "ir/s7200/isa/list.hpp"
#include "ir/s7300/isa/list.hpp"
#include "ir/s7300/library/system_block.hpp"
