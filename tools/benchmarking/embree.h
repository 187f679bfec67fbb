#pragma once

// Embree as the distribution has it: 3 in Debian 12, 4 in Debian 13. Of what is used here they differ in how a ray is asked for.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

/// Whether rays are near those that are asked for before and after.
enum class RayOrder { any, coherent };

/// Replaces hit.ray.tfar and hit.hit by the first hit of hit.ray.
inline void find_closest_hit(RTCScene scene, RTCRayHit& hit, RayOrder order) {
#if RTC_VERSION_MAJOR >= 4
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  if (order == RayOrder::coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcIntersect1(scene, &hit, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (order == RayOrder::coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect1(scene, &context, &hit);
#endif
}

/// Whether `ray` meets anything.
inline bool is_occluded(RTCScene scene, RTCRay ray, RayOrder order) {
#if RTC_VERSION_MAJOR >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  if (order == RayOrder::coherent) arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
  rtcOccluded1(scene, &ray, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  if (order == RayOrder::coherent) context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcOccluded1(scene, &context, &ray);
#endif
  return ray.tfar < 0.0f;
}
