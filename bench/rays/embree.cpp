// Embree 3 as a peer. Compiled where the library is there.
#include <embree3/rtcore.h>

#include <cstring>
#include <stdexcept>

#include "rays/peers.h"

namespace taxel::bench {
namespace {

constexpr std::size_t kWidest = 16;

/// Rays in packets of 16 or one by one; triangles fanned from each polygon's first vertex, in single precision.
class Embree final : public RayCaster {
 public:
  Embree(const SensorModel& sensor, std::size_t width, RTCBuildQuality quality, std::string name)
      : width_(width), name_(std::move(name)), ray_count_(sensor.rays.size()) {
    device_ = rtcNewDevice("threads=1,set_affinity=0");
    if (device_ == nullptr) throw std::runtime_error("Embree gives no device");
    scene_ = rtcNewScene(device_);
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene_, quality);
    geometry_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetGeometryBuildQuality(geometry_, quality);
    rtcAttachGeometry(scene_, geometry_);
    rtcInitIntersectContext(&context_);
    context_.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    packets_.resize((ray_count_ + kWidest - 1) / kWidest);
    std::memset(packets_.data(), 0, packets_.size() * sizeof(RTCRayHit16));
    reach_.assign(packets_.size() * kWidest, -1.0f);
    for (std::size_t r = 0; r < ray_count_; ++r) {
      const SensorRay& ray = sensor.rays[r];
      RTCRay16& to = packets_[r / kWidest].ray;
      const std::size_t i = r % kWidest;
      to.org_x[i] = static_cast<float>(ray.origin.x);
      to.org_y[i] = static_cast<float>(ray.origin.y);
      to.org_z[i] = static_cast<float>(ray.origin.z);
      to.dir_x[i] = static_cast<float>(ray.direction.x);
      to.dir_y[i] = static_cast<float>(ray.direction.y);
      to.dir_z[i] = static_cast<float>(ray.direction.z);
      to.mask[i] = ~0u;
      reach_[r] = static_cast<float>(ray.max_depth);
    }
  }
  ~Embree() override {
    rtcReleaseGeometry(geometry_);
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  [[nodiscard]] std::string name() const override { return name_; }

  void cast(const std::vector<const ContactSurface*>& surfaces) override {
    convert(surfaces);
    rtcSetSharedGeometryBuffer(geometry_, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, vertices_.data(), 0,
                               3 * sizeof(float), vertices_.size() / 3 - 1);
    rtcSetSharedGeometryBuffer(geometry_, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices_.data(), 0,
                               3 * sizeof(unsigned), indices_.size() / 3);
    rtcCommitGeometry(geometry_);
    rtcCommitScene(scene_);
    alignas(64) int valid[kWidest];
    for (std::size_t p = 0; p < packets_.size(); ++p) {
      RTCRayHit16& packet = packets_[p];
      std::memcpy(packet.ray.tfar, &reach_[p * kWidest], sizeof(packet.ray.tfar));
      std::memset(packet.hit.geomID, 0xFF, sizeof(packet.hit.geomID));
      for (std::size_t i = 0; i < kWidest; ++i) valid[i] = p * kWidest + i < ray_count_ ? -1 : 0;
      if (width_ == kWidest) rtcIntersect16(valid, scene_, &context_, &packet);
      if (width_ == 1) cast_one_by_one(packet, p);
    }
    collect(surfaces);
  }
  [[nodiscard]] std::vector<RayHit> hits() const override { return hits_; }

 private:
  struct Source {
    int surface = 0, polygon = 0;
  };

  void convert(const std::vector<const ContactSurface*>& surfaces) {
    vertices_.clear();
    indices_.clear();
    sources_.clear();
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      const auto base = static_cast<unsigned>(vertices_.size() / 3);
      for (const dvec3& v : surfaces[s]->vertices)
        for (int i = 0; i < 3; ++i) vertices_.push_back(static_cast<float>(v[i]));
      for (std::size_t i = 0; i < surfaces[s]->polygons.size(); ++i) {
        const ContactPolygon& polygon = surfaces[s]->polygons[i];
        const unsigned first = base + static_cast<unsigned>(polygon.first);
        for (unsigned k = 1; k + 1 < static_cast<unsigned>(polygon.count); ++k) {
          indices_.insert(indices_.end(), {first, first + k, first + k + 1});
          sources_.push_back({static_cast<int>(s), static_cast<int>(i)});
        }
      }
    }
    vertices_.insert(vertices_.end(), 3, 0.0f);  // Embree reads 16 bytes at the last vertex
  }

  void cast_one_by_one(RTCRayHit16& packet, std::size_t p) {
    for (std::size_t i = 0; i < kWidest && p * kWidest + i < ray_count_; ++i) {
      RTCRayHit one =
          rtcGetRayHitFromRayHitN(reinterpret_cast<RTCRayHitN*>(&packet), kWidest, static_cast<unsigned>(i));
      rtcIntersect1(scene_, &context_, &one);
      packet.ray.tfar[i] = one.ray.tfar;
      packet.hit.geomID[i] = one.hit.geomID;
      packet.hit.primID[i] = one.hit.primID;
    }
  }

  void collect(const std::vector<const ContactSurface*>& surfaces) {
    hits_.resize(ray_count_);
    for (std::size_t r = 0; r < ray_count_; ++r) {
      const RTCRayHit16& packet = packets_[r / kWidest];
      const std::size_t i = r % kWidest;
      hits_[r] = RayHit{};
      if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
      const Source source = sources_[packet.hit.primID[i]];
      const ContactPolygon& polygon =
          surfaces[static_cast<std::size_t>(source.surface)]->polygons[static_cast<std::size_t>(source.polygon)];
      const double t = packet.ray.tfar[i];
      const dvec3 x(packet.ray.org_x[i] + t * packet.ray.dir_x[i], packet.ray.org_y[i] + t * packet.ray.dir_y[i],
                    packet.ray.org_z[i] + t * packet.ray.dir_z[i]);
      hits_[r] = {source.surface, source.polygon, t,
                  polygon.pressure + glm::dot(polygon.gradient, x - polygon.centroid)};
    }
  }

  std::size_t width_;
  std::string name_;
  std::size_t ray_count_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
  RTCGeometry geometry_ = nullptr;
  RTCIntersectContext context_{};
  std::vector<RTCRayHit16> packets_;
  std::vector<float> reach_, vertices_;
  std::vector<unsigned> indices_;
  std::vector<Source> sources_;
  std::vector<RayHit> hits_;
};

}  // namespace

std::vector<std::unique_ptr<RayCaster>> make_embree(const SensorModel& sensor) {
  std::vector<std::unique_ptr<RayCaster>> all;
  all.push_back(std::make_unique<Embree>(sensor, 16, RTC_BUILD_QUALITY_LOW, "Embree low, 16 wide"));
  all.push_back(std::make_unique<Embree>(sensor, 16, RTC_BUILD_QUALITY_MEDIUM, "Embree medium, 16 wide"));
  all.push_back(std::make_unique<Embree>(sensor, 1, RTC_BUILD_QUALITY_LOW, "Embree low, single"));
  return all;
}

}  // namespace taxel::bench
