/* Draw overrides: what only a viewport shows of a node (since 1.1).
 *
 * `prepare` makes immutable draw data of the node's values, on any thread; `upload` turns them into GL
 * objects, in slices; `draw` draws them and cannot look at the graph; `release` lets go of the objects. The
 * last three run on the GL thread with the context current, OpenGL 4.5 core, and the state of GL is put back
 * after each. */
#ifndef PLINIAN_SDK_ABI_DRAW_H
#define PLINIAN_SDK_ABI_DRAW_H

#include <stddef.h>
#include <stdint.h>

#include "host/sdk/abi/data_type.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct PlinianCompute PlinianCompute;
typedef struct PlinianContext PlinianContext;

/* The GL of the host. */
typedef struct PlinianGl {
  size_t size;
  void* self;
  void* (*function)(void* self, const char* name); /* "glDrawArrays"; null where there is none */
  void (*fail)(void* self, const char* message);   /* says why a function of the override fails */
} PlinianGl;

/* A light of the picture, in world space; fields as in PlinianLight. */
typedef struct PlinianDrawLight {
  size_t size;
  const char* name;
  uint32_t type;
  float toward[3], position[3];
  float power[3]; /* colour * intensity * 2^exposure */
  uint32_t falloff;
  float radius, cone_angle, penumbra;
  /* Held nothing in 1.1, and do not now: see PlinianLightMap. */
  uint32_t reserved_map;
  int32_t reserved_layer;
  const char* reserved_encoding;
  double reserved_matrix[16];
} PlinianDrawLight;

/* How a shader looks up how much of a light arrives at a place, through the media of the picture (since 1.2).
 * `glsl` goes behind the version line (450) of the shader, in front of what is its own; it declares
 *
 *   vec3 plinian_light(int light, vec3 place);   share [-] per channel, at a place [world]
 *   uniform usamplerBuffer plinian_map_texels;   for `texels`: glBindTextureUnit, glUniform1i
 *   uniform PlinianLights { ... };               for `block`: glBindBufferBase, glUniformBlockBinding
 *
 * and the names of Plinian's core/shared/light_lookup.h with what that includes; names of your own that begin
 * with the name of the plug-in stay out of their way. The text is the same object as long as the same program
 * will do: make another where it is not. */
typedef struct PlinianLightMap {
  size_t size;
  const char* glsl;
  uint32_t texels; /* GL name of a buffer texture (GL_RGBA32UI): layer, row, column, then 1 to 3 words */
  uint32_t block;  /* GL name of a uniform buffer */
  int32_t light;   /* its number for plinian_light() */
} PlinianLightMap;

typedef struct PlinianDrawContext {
  size_t size;
  const PlinianGl* gl;
  double world_from_object[16], view_from_world[16], clip_from_view[16]; /* column by column */
  int32_t viewport[4];                                                   /* x, y, width, height [pixels] */
  int32_t gate[4];      /* what the camera's picture covers of it */
  uint32_t framebuffer; /* is bound, with colour and depth to draw to */
  uint32_t colour;      /* texture of the picture beneath, linear radiance; 0: none */
  uint32_t depth;       /* texture of its distances [world]; 0: none */
  const PlinianDrawLight* lights;
  size_t light_count;
  uint32_t selection; /* 0 no, 1 selected, 2 selected last */
  float pixel_ratio;  /* pixels of the framebuffer per point of the screen */
  double frame;       /* current time [frames] */
  /* Since 1.2. One for each light; null where it has no map. */
  const PlinianLightMap* const* light_maps;
} PlinianDrawContext;

typedef struct PlinianDraw {
  size_t size;
  const char* affected_by; /* attributes that drawing depends on, separated by spaces; null: all inputs */
  void* user;
  /* Fills in *data, whose type is known. Fails through the compute table. */
  void (*prepare)(void* user, const PlinianCompute*, PlinianContext*, PlinianData* data);
  /* 1 when done, 0 to be called again soon, -1 for a failure. *resources is null at first. What was drawn
   * before goes on being drawn until it is done. May be null. */
  int (*upload)(void* user, const PlinianGl*, const void* data, void** resources);
  /* 0 for a failure: then it is not called again before there are other data. */
  int (*draw)(void* user, const PlinianDrawContext*, const void* data, void* resources);
  /* Also of what failed to upload. May be null. */
  void (*release)(void* user, const PlinianGl*, void* resources);
  /* Whether the pixel x, y (from the lower left of the framebuffer) is on what it draws, and how far along
   * the view ray [world] that is. Without GL. May be null. */
  int (*hit)(void* user, const PlinianDrawContext*, const void* data, float x, float y, double* distance);
} PlinianDraw;

#ifdef __cplusplus
}
#endif
#endif
