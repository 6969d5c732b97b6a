// Replays rays from a file by Embree 3: those that look for the nearest surface, then those that look for any before a light.
//
//     embree KIND SHAPES RAYS WIDTH ANSWERS
//
// SHAPES holds, as KIND says, `spheres` of four numbers or `triangles` of nine; RAYS eight numbers a ray: origin, direction,
// distance of a light (infinite for none) and one that is not used. Rays go one by one, or as neighbours in packets of WIDTH 8
// or 16. Prints nanoseconds of processor time to build, for all that look for the nearest surface, and for all others. Writes
// for each ray the distance to the nearest surface, infinite for none; or 1 where there is any, and else 0.
#include <embree3/rtcore.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <string>
#include <type_traits>
#include <vector>

// The floor of the flake is at this height; here, a square of this many units to each side of the middle.
static const float FLOOR = -0.5f, REACH = 64;
// Embree leaves it to its users to keep rays from meeting the surface that they leave.
static const float NEAR = 1e-4f;
// Of the way to a light, as far as a surface is in its way.
static const float FAR = 1 - 1.0f / 8192;

struct Ray {
    float origin[3], direction[3], distance, unused;
};

static void fail(const char *what) { std::perror(what), std::exit(1); }

template <class T> static std::vector<T> read(const char *path) {
    std::FILE *file = std::fopen(path, "rb");
    if (!file) fail(path);
    std::vector<T> items;
    for (T item; std::fread(&item, sizeof item, 1, file) == 1;) items.push_back(item);
    std::fclose(file);
    return items;
}

static double now() {
    timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return time.tv_sec * 1e9 + time.tv_nsec;
}

static void add(RTCDevice device, RTCScene scene, bool are_spheres, const std::vector<float> &numbers) {
    const auto type = are_spheres ? RTC_GEOMETRY_TYPE_SPHERE_POINT : RTC_GEOMETRY_TYPE_TRIANGLE;
    const auto format = are_spheres ? RTC_FORMAT_FLOAT4 : RTC_FORMAT_FLOAT3;
    const size_t width = are_spheres ? 4 : 3, places = numbers.size() / width;
    RTCGeometry geometry = rtcNewGeometry(device, type);
    void *memory = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, format, 4 * width, places);
    std::memcpy(memory, numbers.data(), 4 * numbers.size());
    if (!are_spheres) {
        memory = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, places / 3);
        for (unsigned i = 0; i < places; i++) static_cast<unsigned *>(memory)[i] = i;
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

// What Embree does with rays for the nearest surface and for any, one by one or in packets of N.
template <int N> struct Packet;
#define PACKET(N, WIDTH, VALID)                                                                                \
    template <> struct Packet<N> {                                                                             \
        using Hit = RTCRayHit##WIDTH;                                                                          \
        using Any = RTCRay##WIDTH;                                                                             \
        alignas(64) int valid[N];                                                                              \
        void find(RTCScene scene, RTCIntersectContext *to, Hit *rays) { rtcIntersect##N(VALID scene, to, rays); } \
        void find(RTCScene scene, RTCIntersectContext *to, Any *rays) { rtcOccluded##N(VALID scene, to, rays); } \
    };
#define IN_PACKETS valid,
PACKET(1, , )
PACKET(8, 8, IN_PACKETS)
PACKET(16, 16, IN_PACKETS)

// A field's lane; a single ray has a number where a packet has an array.
template <class T> static auto &lane(T &field, int i) {
    return reinterpret_cast<std::remove_all_extents_t<T> *>(&field)[i];
}

template <class R> static void put(R &rays, int i, const Ray &ray) {
    lane(rays.org_x, i) = ray.origin[0], lane(rays.dir_x, i) = ray.direction[0];
    lane(rays.org_y, i) = ray.origin[1], lane(rays.dir_y, i) = ray.direction[1];
    lane(rays.org_z, i) = ray.origin[2], lane(rays.dir_z, i) = ray.direction[2];
    lane(rays.tnear, i) = NEAR, lane(rays.tfar, i) = ray.distance * FAR, lane(rays.time, i) = 0;
    lane(rays.mask, i) = -1, lane(rays.id, i) = 0, lane(rays.flags, i) = 0;
}

// Looks for what the rays from `first` to before `end` meet; T is what a packet of them is.
template <int N, class T> static void replay(RTCScene scene, const Ray *first, const Ray *end, float *answers) {
    constexpr bool is_any = std::is_same_v<T, typename Packet<N>::Any>;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    for (; first < end; first += N, answers += N) {
        alignas(64) T packet;
        Packet<N> embree;
        auto &rays = [&packet]() -> auto & {
            if constexpr (is_any) return packet; else return packet.ray;
        }();
        for (int i = 0; i < N; i++) {
            embree.valid[i] = first + i < end ? -1 : 0;
            put(rays, i, embree.valid[i] ? first[i] : *first);
            if constexpr (!is_any) lane(packet.hit.geomID, i) = lane(packet.hit.instID[0], i) = RTC_INVALID_GEOMETRY_ID;
        }
        embree.find(scene, &context, &packet);
        for (int i = 0; i < N && embree.valid[i]; i++) answers[i] = is_any ? lane(rays.tfar, i) < 0 : lane(rays.tfar, i);
    }
}

template <int N> static void measure(RTCScene scene, const std::vector<Ray> &rays, float *answers, double *times) {
    const Ray *middle = rays.data(), *end = middle + rays.size();
    while (middle < end && std::isinf(middle->distance)) middle++;
    for (int time = 0; time < 2; time++) { // The first time is for the caches.
        const double start = now();
        replay<N, typename Packet<N>::Hit>(scene, rays.data(), middle, answers);
        const double half = now();
        replay<N, typename Packet<N>::Any>(scene, middle, end, answers + (middle - rays.data()));
        times[0] = half - start, times[1] = now() - half;
    }
}

int main(int count, char **arguments) {
    if (count != 6) return std::puts(RTC_VERSION_STRING), 0;
#ifdef __SSE__
    __builtin_ia32_ldmxcsr(__builtin_ia32_stmxcsr() | 0x8040); // Subnormal numbers are zero, as Embree's manual recommends.
#endif
    const auto shapes = read<float>(arguments[2]);
    const auto rays = read<Ray>(arguments[3]);
    RTCDevice device = rtcNewDevice("threads=1");
    const double start = now();
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    add(device, scene, std::string(arguments[1]) == "spheres", shapes);
    const float a = REACH, z = FLOOR;
    add(device, scene, false, {-a, -a, z, a, -a, z, a, a, z, -a, -a, z, a, a, z, -a, a, z});
    rtcCommitScene(scene);
    const double built = now() - start;
    const std::string width = arguments[4];
    std::vector<float> answers(rays.size());
    double times[2];
    (width == "16" ? measure<16> : width == "8" ? measure<8> : measure<1>)(scene, rays, answers.data(), times);
    std::FILE *file = std::fopen(arguments[5], "wb");
    if (!file || std::fwrite(answers.data(), 4, answers.size(), file) != answers.size()) fail(arguments[5]);
    std::fclose(file);
    std::printf("%.0f %.0f %.0f\n", built, times[0], times[1]);
}
