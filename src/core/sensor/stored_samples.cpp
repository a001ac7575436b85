// Samples on disk. A value is the number of samples, then their positions, areas, shares and faces, as numbers of this
// machine's order of bytes, which the key names. Normals are those of the faces.
#include "core/sensor/stored_samples.h"

#include <fmt/format.h>

#include <bit>
#include <charconv>
#include <cstring>
#include <span>

#include "core/base/error.h"
#include "core/base/files.h"
#include "core/base/os/file.h"
#include "core/base/os/process.h"

namespace taxel {
namespace {

constexpr std::uint64_t kMegabyte = 1'000'000, kDefaultMegabytes = 1000;
constexpr std::size_t kBytesOfSample = 5 * sizeof(double) + sizeof(std::int32_t);

/// The samples on disk of this process. Never destroyed, because Python compiles and frees models at its very end.
std::optional<DiskCache>& cache_of_process() {
  static auto* const cache = new std::optional<DiskCache>;
  return *cache;
}

template <class Number>
std::string hash_of(std::span<const Number> numbers) {
  const auto bytes = std::as_bytes(numbers);
  return sha256_hex({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

std::string key_of_mesh(const TriMesh& mesh) {
  return fmt::format("samples {} {} {} {}", kSamplesVersion,
                     std::endian::native == std::endian::little ? "little" : "big",
                     hash_of(std::span<const dvec3>(mesh.vertices())), hash_of(std::span<const ivec3>(mesh.faces())));
}

void append(std::string& bytes, const void* data, std::size_t size) {
  bytes.append(static_cast<const char*>(data), size);
}

std::string packed(const std::vector<SurfaceSample>& samples) {
  std::string bytes;
  bytes.reserve(samples.size() * kBytesOfSample);
  for (const SurfaceSample& s : samples) {
    append(bytes, &s.position, sizeof(s.position));
    append(bytes, &s.area, sizeof(s.area));
    append(bytes, &s.share, sizeof(s.share));
    const std::int32_t face = s.face;
    append(bytes, &face, sizeof(face));
  }
  return bytes;
}

/// Returns the samples of a value; nothing if it has a face that the mesh has not.
std::optional<std::vector<SurfaceSample>> unpacked(const std::string& bytes, const TriMesh& mesh) {
  if (bytes.size() % kBytesOfSample != 0) return std::nullopt;
  std::vector<SurfaceSample> samples(bytes.size() / kBytesOfSample);
  const char* from = bytes.data();
  const auto take = [&](void* to, std::size_t size) {
    std::memcpy(to, from, size);
    from += size;
  };
  for (SurfaceSample& s : samples) {
    std::int32_t face = -1;
    take(&s.position, sizeof(s.position));
    take(&s.area, sizeof(s.area));
    take(&s.share, sizeof(s.share));
    take(&face, sizeof(face));
    if (face < 0 || face >= mesh.face_count()) return std::nullopt;
    s.face = face;
    s.normal = mesh.face_normals()[at(face)];
  }
  return samples;
}

std::vector<SurfaceSample> found_or_made(const DiskCache& cache, const std::string& key, const TriMesh& mesh,
                                         const std::function<std::vector<SurfaceSample>()>& make) {
  if (const std::optional<std::string> found = cache.find(key))
    if (std::optional<std::vector<SurfaceSample>> samples = unpacked(*found, mesh)) return *std::move(samples);
  std::vector<SurfaceSample> made = make();
  if (made.size() >= kLeastStored) cache.keep(key, packed(made));
  return made;
}

}  // namespace

std::optional<DiskCache> sample_cache() {
  std::uint64_t megabytes = kDefaultMegabytes;
  const std::string text = os::variable(kSampleCacheVariable);
  if (text == "off") return std::nullopt;
  if (!text.empty()) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), megabytes);
    if (error != std::errc{} || end != text.data() + text.size() || megabytes > kDefaultMegabytes * kMegabyte)
      throw Error("", kSampleCacheVariable,
                  fmt::format("must be \"off\" or the most megabytes of samples to keep on disk, is \"{}\"", text));
  }
  return DiskCache(os::cache_folder() / "taxelstudio" / "samples", megabytes * kMegabyte);
}

void keep_samples_on_disk() {
  cache_of_process() = sample_cache();
}

std::vector<SurfaceSample> stored_samples(const TriMesh& mesh, int count, std::uint64_t seed, SampleQuality quality,
                                          const std::function<std::vector<SurfaceSample>()>& make) {
  const std::optional<DiskCache>& cache = cache_of_process();
  if (!cache || quality != SampleQuality::polished || count < kLeastStored) return make();
  return found_or_made(*cache, fmt::format("{} {} {}", key_of_mesh(mesh), count, seed), mesh, make);
}

std::vector<SurfaceSample> stored_dense_samples(const TriMesh& mesh, const std::vector<SurfaceSample>& samples,
                                                const DenseSampling& how,
                                                const std::function<std::vector<SurfaceSample>()>& make) {
  const std::optional<DiskCache>& cache = cache_of_process();
  if (!cache || how.quality != SampleQuality::polished || how.discs.empty()) return make();
  const std::string key = fmt::format("{} dense {} {} {:a} {}", key_of_mesh(mesh), sha256_hex(packed(samples)),
                                      hash_of(std::span<const DenseDisc>(how.discs)), how.density, how.seed);
  return found_or_made(*cache, key, mesh, make);
}

}  // namespace taxel
