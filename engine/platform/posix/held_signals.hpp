// The signals that InterruptWatch holds back, for a child that is to get them.
#pragma once

namespace rungproof {

/// As they were before the watch began; nothing if there is none.
void releaseHeldSignals();

}  // namespace rungproof
