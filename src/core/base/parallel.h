// A parallel loop whose result cannot depend on the number of threads: chunks are fixed by the caller, each chunk
// writes its own output, and any reduction is done afterwards in chunk order.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

namespace taxel {

/// Calls body(begin, end) for consecutive chunks of [0, count), at most `chunk` long each.
template <class Body>
void parallel_chunks(int count, int chunk, const Body& body) {
  const int chunks = (count + chunk - 1) / chunk;
  tbb::parallel_for(tbb::blocked_range<int>(0, chunks, 1), [&](const tbb::blocked_range<int>& range) {
    for (int c = range.begin(); c != range.end(); ++c) body(c * chunk, std::min(count, (c + 1) * chunk));
  });
}

}  // namespace taxel
