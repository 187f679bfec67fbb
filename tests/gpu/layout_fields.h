// Every field of the structs that host and device share, for struct_layout.comp and struct_layout_test.cpp alike:
// VEC(f) and NUMBER(f) and WORD(f) write a vector of three floats, a float and a uint.
// No include guard: it stands inside a function, once each.
// clang-format off

VEC(render.camera_origin) WORD(render.image_width)
VEC(render.camera_right) WORD(render.image_height)
VEC(render.camera_up) WORD(render.seed)
VEC(render.camera_forward) NUMBER(render.cutoff)
VEC(render.sky) NUMBER(render.metres_per_unit)
VEC(render.ground) WORD(render.max_bounces)
VEC(render.environment_scale)
VEC(render.world_center)
VEC(render.ambient_harmonics[0]) VEC(render.ambient_harmonics[1]) VEC(render.ambient_harmonics[2])
VEC(render.ambient_harmonics[3]) VEC(render.ambient_harmonics[4]) VEC(render.ambient_harmonics[5])
VEC(render.ambient_harmonics[6]) VEC(render.ambient_harmonics[7]) VEC(render.ambient_harmonics[8])

WORD(dispatch.tile_x) WORD(dispatch.tile_y) WORD(dispatch.tile_width) WORD(dispatch.tile_height)
WORD(dispatch.band_x) WORD(dispatch.band_y) WORD(dispatch.band_width)
WORD(dispatch.sample_begin) WORD(dispatch.sample_end) WORD(dispatch.job_end) WORD(dispatch.search_budget) WORD(dispatch.search_limit) WORD(dispatch.resume)
WORD(dispatch.pixel_count)
WORD(dispatch.steering.spp) WORD(dispatch.steering.orthographic) WORD(dispatch.steering.environment_texture)
WORD(dispatch.steering.light_count) WORD(dispatch.steering.triangle_count) WORD(dispatch.steering.vertex_texels)
WORD(dispatch.steering.normal_texel) WORD(dispatch.steering.uv01_texel) WORD(dispatch.steering.uv23_texel)
WORD(dispatch.steering.color_texel) WORD(dispatch.steering.tangent_texel)
WORD(dispatch.steering.pixel_filter) WORD(dispatch.steering.object_count) WORD(dispatch.steering.one)

NUMBER(material.base_color.x) NUMBER(material.base_color.y) NUMBER(material.base_color.z) NUMBER(material.base_color.w)
VEC(material.specular) NUMBER(material.roughness)
VEC(material.reflection) NUMBER(material.metallic)
VEC(material.emission) NUMBER(material.ior)
VEC(material.transmission) NUMBER(material.alpha_cutoff)
VEC(material.absorption) NUMBER(material.normal_scale)
VEC(material.ambient) NUMBER(material.occlusion_strength)
WORD(material.flags) NUMBER(material.specular_strength) WORD(material.textured_slots) WORD(material.free_word)

WORD(use.texture) WORD(use.uv_set)
NUMBER(use.m00) NUMBER(use.m10) NUMBER(use.m01) NUMBER(use.m11) NUMBER(use.m02) NUMBER(use.m12)

VEC(light.position) WORD(light.kind)
VEC(light.direction) NUMBER(light.range)
VEC(light.intensity) NUMBER(light.cos_outer)
NUMBER(light.cone_scale) WORD(light.free_word_0) WORD(light.free_word_1) WORD(light.free_word_2)

NUMBER(instance.object_from_traced_x.x) NUMBER(instance.object_from_traced_x.y) NUMBER(instance.object_from_traced_x.z) NUMBER(instance.object_from_traced_x.w)
NUMBER(instance.object_from_traced_y.x) NUMBER(instance.object_from_traced_y.y) NUMBER(instance.object_from_traced_y.z) NUMBER(instance.object_from_traced_y.w)
NUMBER(instance.object_from_traced_z.x) NUMBER(instance.object_from_traced_z.y) NUMBER(instance.object_from_traced_z.z) NUMBER(instance.object_from_traced_z.w)
NUMBER(instance.traced_from_object_x.x) NUMBER(instance.traced_from_object_x.y) NUMBER(instance.traced_from_object_x.z) NUMBER(instance.traced_from_object_x.w)
NUMBER(instance.traced_from_object_y.x) NUMBER(instance.traced_from_object_y.y) NUMBER(instance.traced_from_object_y.z) NUMBER(instance.traced_from_object_y.w)
NUMBER(instance.traced_from_object_z.x) NUMBER(instance.traced_from_object_z.y) NUMBER(instance.traced_from_object_z.z) NUMBER(instance.traced_from_object_z.w)
WORD(instance.first_triangle) NUMBER(instance.handedness) NUMBER(instance.roundings) WORD(instance.free_word)
