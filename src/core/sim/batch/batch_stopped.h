// The end of a batch before its last group.
#pragma once

namespace taxel {

/// Exception that leaves a group because the batch is to end.
struct BatchStopped {};

}  // namespace taxel
