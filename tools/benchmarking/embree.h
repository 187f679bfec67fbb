#pragma once

// Embree as the distribution has it: 3 in Debian 12, 4 in Debian 13. Of what is used here they differ in how a ray is asked for:
// find_closest_hit replaces hit.ray.tfar and hit.hit by the first hit of hit.ray, is_occluded tells whether `ray` meets anything,
// `order` whether the rays asked for one after the other are near each other (kCoherentRays) or not (kAnyRays).
#if __has_include(<embree4/rtcore.h>)

#include <embree4/rtcore.h>

inline constexpr RTCRayQueryFlags kAnyRays = RTC_RAY_QUERY_FLAG_INCOHERENT;
inline constexpr RTCRayQueryFlags kCoherentRays = RTC_RAY_QUERY_FLAG_COHERENT;

inline void find_closest_hit(RTCScene scene, RTCRayHit& hit, RTCRayQueryFlags order) {
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.flags = order;
  rtcIntersect1(scene, &hit, &arguments);
}

inline bool is_occluded(RTCScene scene, RTCRay ray, RTCRayQueryFlags order) {
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.flags = order;
  rtcOccluded1(scene, &ray, &arguments);
  return ray.tfar < 0.0f;
}

#else

#include <embree3/rtcore.h>

inline constexpr RTCIntersectContextFlags kAnyRays = RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
inline constexpr RTCIntersectContextFlags kCoherentRays = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;

inline RTCIntersectContext context_of(RTCIntersectContextFlags order) {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = order;
  return context;
}

inline void find_closest_hit(RTCScene scene, RTCRayHit& hit, RTCIntersectContextFlags order) {
  RTCIntersectContext context = context_of(order);
  rtcIntersect1(scene, &context, &hit);
}

inline bool is_occluded(RTCScene scene, RTCRay ray, RTCIntersectContextFlags order) {
  RTCIntersectContext context = context_of(order);
  rtcOccluded1(scene, &context, &ray);
  return ray.tfar < 0.0f;
}

#endif
