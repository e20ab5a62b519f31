/* What crosses the boundary between Plinian and a plug-in: tables of plain C.
 *
 * A plug-in need not be rebuilt for a newer minor version, nor for another C++ library: structures only grow
 * at their end and say how large they are, functions are only added, and no C++ object crosses. Write
 * plug-ins with plugin.h, which lays C++ over this.
 *
 * Texts are UTF-8 and end with a zero byte; those given to a function are read before it returns. A function
 * that returns int returns 1 for success. Attributes are numbered as they are declared, from 0, a compound
 * before its children. */
#ifndef PLINIAN_SDK_ABI_H
#define PLINIAN_SDK_ABI_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define PLINIAN_ABI_MAJOR 1
#define PLINIAN_ABI_MINOR 0

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
} PlinianAttribute;

#define PLINIAN_ATTRIBUTE_ARRAY 1u
#define PLINIAN_ATTRIBUTE_OUTPUT 2u
#define PLINIAN_ATTRIBUTE_HIDDEN 4u
#define PLINIAN_ATTRIBUTE_READ_ONLY 8u
#define PLINIAN_ATTRIBUTE_NOT_KEYABLE 16u
#define PLINIAN_ATTRIBUTE_NOT_STORABLE 32u
#define PLINIAN_ATTRIBUTE_NOT_CONNECTABLE 64u

/* Opaque data that a node hands on. `release` is called once nobody holds it, on any thread. */
typedef struct PlinianData {
  size_t size;
  const char* type;
  const void* object;
  size_t bytes;     /* held in memory */
  uint64_t content; /* equal for equal content; 0: not known */
  void (*release)(const void* object);
} PlinianData;

/* What a compute function sees of the world. element: -1 where the attribute is no array. time: null for now,
 * or the frame at which the input is read. A failure is remembered, and becomes the error of the output. */
typedef struct PlinianContext PlinianContext;
typedef struct PlinianCompute {
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
} PlinianCompute;

/* The attributes of one node in an older scene. */
typedef struct PlinianMigration PlinianMigration;
typedef struct PlinianMigrate {
  size_t size;
  const char* (*text)(PlinianMigration*, const char* path); /* null: not there; good until the next call */
  void (*set)(PlinianMigration*, const char* path, const char* text);
  void (*remove)(PlinianMigration*, const char* path);
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
} PlinianNodeType;

#define PLINIAN_NODE_NOT_CONCURRENT 1u /* compute may not run on several threads at a time */
#define PLINIAN_NODE_HIERARCHICAL 2u   /* has a place in the transform hierarchy */
#define PLINIAN_NODE_HOLDS_CHILDREN 4u /* ... and may be a parent in it */
#define PLINIAN_NODE_FOLLOWS 8u        /* deleted with the last node that it drives */

/* A word of a command: a parameter, or a flag with or without a word behind it. */
typedef struct PlinianArgument {
  size_t size;
  const char* name;
  const char* kind; /* "text", "number", "integer", "node", "plug", "path", or of a flag "" for none */
  const char* help;
  int32_t optional, many;
} PlinianArgument;

typedef struct PlinianCall PlinianCall;
typedef struct PlinianCommandContext {
  size_t size;
  size_t (*word_count)(PlinianCall*, const char* argument); /* 0 where it was not given */
  int (*given)(PlinianCall*, const char* argument);
  const char* (*word)(PlinianCall*, const char* argument, size_t index);
  /* Runs another command as a part of this one, so that undo takes both back. answers: lines, or null. */
  int (*execute)(PlinianCall*, const char* line, const char** answers);
  void (*answer)(PlinianCall*, const char* line);
  void (*fail)(PlinianCall*, const char* message);
  const char* (*error)(PlinianCall*);
} PlinianCommandContext;

typedef struct PlinianCommand {
  size_t size;
  const char* name;
  const char* help;
  const PlinianArgument* parameters;
  size_t parameter_count;
  const PlinianArgument* flags;
  size_t flag_count;
  void* user;
  void (*run)(void* user, const PlinianCommandContext*, PlinianCall*);
} PlinianCommand;

/* What a plug-in is given when it is initialised. */
typedef struct PlinianHost {
  size_t size;
  uint32_t abi_major, abi_minor; /* of the program */
  void* self;                    /* given back to the functions */
  int (*register_node_type)(void* self, const PlinianNodeType*);
  int (*register_command)(void* self, const PlinianCommand*);
  void (*fail)(void* self, const char* message);
} PlinianHost;

/* What a plug-in exports. The host's table is good until uninitialise returns. */
#define PLINIAN_EXPORT __attribute__((visibility("default")))
PLINIAN_EXPORT int plinian_initialise(const PlinianHost* host);
PLINIAN_EXPORT void plinian_uninitialise(const PlinianHost* host);

#ifdef __cplusplus
}
#endif
#endif
