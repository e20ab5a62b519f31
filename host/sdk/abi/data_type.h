/* Data that scene files can hold (since 1.1). */
#ifndef PLINIAN_SDK_ABI_DATA_TYPE_H
#define PLINIAN_SDK_ABI_DATA_TYPE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Opaque data that a node hands on. `release` is called once nobody holds it, on any thread. */
typedef struct PlinianData {
  size_t size;
  const char* type;
  const void* object;
  size_t bytes;     /* held in memory */
  uint64_t content; /* equal for equal content; 0: not known */
  void (*release)(const void* object);
} PlinianData;

/* Where bytes go to, or an object made of them. */
typedef struct PlinianSink PlinianSink;
typedef struct PlinianSerial {
  size_t size;
  void (*write)(PlinianSink*, const void* bytes, size_t count); /* any number of times */
  void (*give)(PlinianSink*, const PlinianData*); /* taken over; its type and content are known */
  void (*fail)(PlinianSink*, const char* message);
} PlinianSerial;

/* Attributes of this data type can be set, and are stored in scenes: as they are where the bytes are text, in
 * base64 where they are not. */
typedef struct PlinianDataType {
  size_t size;
  const char* name;
  void* user;
  void (*serialise)(void* user, const void* object, const PlinianSerial*, PlinianSink*);
  void (*deserialise)(void* user, const void* bytes, size_t count, const PlinianSerial*, PlinianSink*);
} PlinianDataType;

#ifdef __cplusplus
}
#endif
#endif
