/* Manipulator handles: what an artist takes hold of in a viewport (since 1.1). */
#ifndef PLINIAN_SDK_ABI_HANDLE_H
#define PLINIAN_SDK_ABI_HANDLE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A handle on one attribute of the node. Attributes are named; null where one is not needed. All of it is in
 * the handle's space, which `transform` takes to the object space of the node. */
typedef struct PlinianHandle {
  size_t size;
  const char* name;
  uint32_t kind;
  const char* attribute; /* that dragging sets */
  const char* origin;    /* float3: where it begins; null: 0 0 0 */
  const char* along;     /* float3: its direction; null: axis */
  float axis[3];
  const char* length;    /* number: how far from the origin it is shown; null: 1 */
  const char* transform; /* matrix: from the handle's space to the object's; null: the same */
  float colour[3];       /* linear Rec.709 */
} PlinianHandle;

#define PLINIAN_HANDLE_POINT 0u     /* attribute: float3, a place */
#define PLINIAN_HANDLE_DIRECTION 1u /* attribute: float3, a direction whose length is kept */
#define PLINIAN_HANDLE_DISTANCE 2u  /* attribute: a number >= 0, along the axis from the origin */
#define PLINIAN_HANDLE_CONE 3u      /* attribute: an angle [degrees], the full angle around the axis */

#ifdef __cplusplus
}
#endif
#endif
