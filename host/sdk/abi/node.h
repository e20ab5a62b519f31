/* Node types: attributes, what a compute function sees, migration of older scenes. */
#ifndef PLINIAN_SDK_ABI_NODE_H
#define PLINIAN_SDK_ABI_NODE_H

#include <stddef.h>
#include <stdint.h>

#include "host/sdk/abi/data_type.h"
#include "host/sdk/abi/draw.h"
#include "host/sdk/abi/handle.h"
#include "host/sdk/abi/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

/* One attribute. Types, defaults and choices are spelled as in scene files. */
typedef struct PlinianAttribute {
  size_t size; /* of this structure: sizeof(PlinianAttribute) */
  const char* name;
  const char* type;          /* "float", "colour", "enum", "compound", "data", ... */
  const char* default_value; /* null: the zero value of the type */
  const char* nice_name;     /* these may be null */
  const char* help;
  const char* unit;
  const char* group;
  const char* choices;                                           /* enum: "off,low:10,high" */
  const char* data_type;                                         /* data: what connects to it */
  const char* affects;                                           /* outputs, separated by spaces */
  const double *minimum, *maximum, *soft_minimum, *soft_maximum; /* null: none */
  uint32_t flags;
  const struct PlinianAttribute* children; /* compound */
  size_t child_count;
  /* Since 1.1. */
  const char* widget;     /* "slider", ...; null: what the type suggests */
  const char* shown_when; /* "mode" or "mode=low,high": shown while the attribute reads so; null: always */
  double step;            /* of the slider; 0: smooth */
} PlinianAttribute;

#define PLINIAN_ATTRIBUTE_ARRAY 1u
#define PLINIAN_ATTRIBUTE_OUTPUT 2u
#define PLINIAN_ATTRIBUTE_HIDDEN 4u
#define PLINIAN_ATTRIBUTE_READ_ONLY 8u
#define PLINIAN_ATTRIBUTE_NOT_KEYABLE 16u
#define PLINIAN_ATTRIBUTE_NOT_STORABLE 32u
#define PLINIAN_ATTRIBUTE_NOT_CONNECTABLE 64u
#define PLINIAN_ATTRIBUTE_NOT_OF_PICTURE 128u /* of a shape: does not affect its contribution (since 1.1) */

/* What a compute function sees of the world. element: -1 where the attribute is no array. time: the
 * frame at which the input is read; null for the present. A failure is remembered, and becomes the error of
 * the output. */
struct PlinianCompute {
  size_t size;
  int (*read_number)(PlinianContext*, int32_t attribute, int32_t element, const double* time, double* value);
  int (*read_vector)(PlinianContext*, int32_t attribute, int32_t element, const double* time, float value[4]);
  int (*read_matrix)(PlinianContext*, int32_t attribute, int32_t element, const double* time,
                     double value[16]);
  /* The text is good until the compute function returns. */
  int (*read_text)(PlinianContext*, int32_t attribute, int32_t element, const double* time,
                   const char** value);
  /* Null where there are no data yet; the object is good until the compute function returns. */
  int (*read_data)(PlinianContext*, int32_t attribute, int32_t element, const double* time,
                   const void** object);
  /* Elements that exist, ascending; good until the next call. */
  size_t (*elements)(PlinianContext*, int32_t array, const int32_t** elements);
  int (*write_number)(PlinianContext*, int32_t attribute, double value);
  int (*write_vector)(PlinianContext*, int32_t attribute, const float* value, int32_t count);
  int (*write_matrix)(PlinianContext*, int32_t attribute, const double value[16]);
  int (*write_text)(PlinianContext*, int32_t attribute, const char* value);
  /* Takes the data over, also where it fails. */
  int (*write_data)(PlinianContext*, int32_t attribute, const PlinianData* value);
  int (*cancelled)(PlinianContext*);
  void (*progress)(PlinianContext*, double fraction, const char* what);
  void (*fail)(PlinianContext*, const char* message);
  const char* (*error)(PlinianContext*); /* of the last call that failed */
  /* Since 1.1. The current frame, for time sources alone: others are driven by one. */
  int (*time)(PlinianContext*, double* frames);
  /* A ramp at a position. */
  int (*sample_ramp)(PlinianContext*, int32_t attribute, int32_t element, const double* time, float position,
                     float value[3]);
  /* Volumes; null where there is none yet. */
  int (*read_volume)(PlinianContext*, int32_t attribute, int32_t element, const double* time,
                     const PlinianVolume** volume);
  int (*make_volume)(PlinianContext*, const PlinianVolumeSource*, const PlinianVolume** volume);
  int (*write_volume)(PlinianContext*, int32_t attribute, const PlinianVolume* volume);
  int (*volume_info)(PlinianContext*, const PlinianVolume*, PlinianVolumeInfo*);
  /* The voxels of a box, x fastest; temperature may be null. */
  int (*read_voxels)(PlinianContext*, const PlinianVolume*, const int32_t first[3], const int32_t count[3],
                     float* density, float* temperature);
};

/* The attributes of one node in an older scene. Aliases hold here too: an attribute that the scene has under
 * an old name is read, and removed, by any of its names. What is set under a name counts over what another
 * name of the attribute holds. What is set and the type has not, or that is no value of it, is told with the
 * node's name and kept in the scene as a line. */
typedef struct PlinianMigration PlinianMigration;
typedef struct PlinianMigrate {
  size_t size;
  const char* (*text)(PlinianMigration*, const char* path); /* null: not there; good until the next call */
  void (*set)(PlinianMigration*, const char* path, const char* text);
  void (*remove)(PlinianMigration*, const char* path);
  /* Since 1.3. Says why the node cannot be migrated: it and the others of its type stay as they stand in the
   * scene, until a plug-in is loaded that can. */
  void (*fail)(PlinianMigration*, const char* message);
} PlinianMigrate;

typedef struct PlinianNodeType {
  size_t size;
  const char* name;
  const char* help;
  int32_t version; /* from 1; goes up where older scenes must be migrated */
  uint32_t flags;
  const PlinianAttribute* attributes;
  size_t attribute_count;
  const char* aliases; /* "old=new older=new"; may be null */
  void* user;          /* given to the functions */
  void (*compute)(void* user, const PlinianCompute*, PlinianContext*, int32_t output); /* null: no outputs */
  void (*migrate)(void* user, int32_t from, const PlinianMigrate*,
                  PlinianMigration*); /* null: nothing to migrate */
  /* Since 1.1. A shape: the host gives the type a hidden output `contribution`, computed by this function
   * when a picture is wanted and an input has changed that is of the picture. It implies
   * PLINIAN_NODE_HIERARCHICAL; null: no shape. */
  void (*contribute)(void* user, const PlinianCompute*, PlinianContext*, const PlinianContribute*,
                     PlinianContribution*);
  /* What only a viewport shows of the nodes; null: nothing. */
  const PlinianDraw* draw;
  const PlinianHandle* handles;
  size_t handle_count;
} PlinianNodeType;

#define PLINIAN_NODE_NOT_CONCURRENT 1u /* compute may not run on several threads at a time */
/* Has a place in the transform hierarchy, and an attribute `visibility`, which the host declares behind those
 * of a type that has none of that name. */
#define PLINIAN_NODE_HIERARCHICAL 2u
#define PLINIAN_NODE_HOLDS_CHILDREN 4u /* ... and may be a parent in it */
#define PLINIAN_NODE_FOLLOWS 8u        /* deleted with the last node that it drives */
#define PLINIAN_NODE_TIME_SOURCE 16u   /* tells the current time; what it drives depends on it (since 1.1) */
#define PLINIAN_NODE_UNIQUE 32u        /* a scene has one: what is imported shares it (since 1.1) */

#ifdef __cplusplus
}
#endif
#endif
