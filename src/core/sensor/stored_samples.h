// Samples that a program keeps on disk from one start to the next, because placing them takes most of the time in which
// a layout is compiled.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/base/disk_cache.h"
#include "core/layout/sampling/poisson_disk.h"

namespace taxel {

/// Raised when the same arguments of sample_surface() or add_dense_samples() give other samples than before, so that
/// stored samples of earlier versions are not used.
inline constexpr int kSamplesVersion = 1;

/// Samples below this number are not stored: they are placed within milliseconds.
inline constexpr int kLeastStored = 1000;

/// The variable of the environment that bounds the samples on disk [MB], or turns them off with the word "off".
inline constexpr const char* kSampleCacheVariable = "TAXEL_SAMPLE_CACHE";

/// Returns the samples on disk by the environment; nothing if they are turned off. Throws Error if the variable is
/// neither a number nor "off".
std::optional<DiskCache> sample_cache();

/// Makes this process keep samples on disk, by sample_cache(), which may throw. Meant for the beginning of programs;
/// without it nothing is read or written.
void keep_samples_on_disk();

/// Returns the samples of sample_surface() for these arguments from the disk, or those of make(), which are then kept
/// there. Samples of a preview are never stored.
std::vector<SurfaceSample> stored_samples(const TriMesh& mesh, int count, std::uint64_t seed, SampleQuality quality,
                                          const std::function<std::vector<SurfaceSample>()>& make);
/// Returns the samples of add_dense_samples() in the same way.
std::vector<SurfaceSample> stored_dense_samples(const TriMesh& mesh, const std::vector<SurfaceSample>& samples,
                                                const DenseSampling& how,
                                                const std::function<std::vector<SurfaceSample>()>& make);

}  // namespace taxel
