/* What crosses the boundary between Plinian and a plug-in: tables of plain C.
 *
 * A plug-in need not be rebuilt for a newer minor version, nor for another C++ library: structures only grow
 * at their end and say how large they are, functions are only added, and no C++ object crosses. Write
 * plug-ins with plugin.h, which lays C++ over this. What is newer than 1.0 says since when it is there; all
 * of it is there where a plug-in that was built with it is loaded.
 *
 * Texts are UTF-8 and end with a zero byte; those given to a function are read before it returns. A function
 * that returns int returns 1 for success. Attributes are numbered as they are declared, from 0, a compound
 * before its children. */
#ifndef PLINIAN_SDK_ABI_H
#define PLINIAN_SDK_ABI_H

#include "host/sdk/abi/command.h"
#include "host/sdk/abi/data_type.h"
#include "host/sdk/abi/draw.h"
#include "host/sdk/abi/event.h"
#include "host/sdk/abi/handle.h"
#include "host/sdk/abi/node.h"
#include "host/sdk/abi/scene.h"

#ifdef __cplusplus
extern "C" {
#endif

#define PLINIAN_ABI_MAJOR 1
#define PLINIAN_ABI_MINOR 3

/* What a plug-in is given when it is initialised. */
typedef struct PlinianHost {
  size_t size;
  uint32_t abi_major, abi_minor; /* of the program */
  void* self;                    /* given back to the functions */
  int (*register_node_type)(void* self, const PlinianNodeType*);
  int (*register_command)(void* self, const PlinianCommand*);
  void (*fail)(void* self, const char* message);
  /* Since 1.1. */
  int (*register_data_type)(void* self, const PlinianDataType*);
  int (*register_file_type)(void* self, const PlinianFileType*);
  int (*register_menu_entry)(void* self, const PlinianMenuEntry*);
  /* Calls the callback on every event of a kind until it is unsubscribed. Returns a number for that; 0 where
   * there is no such kind. On the thread that initialises. */
  uint64_t (*subscribe)(void* self, const char* kind, void* user, PlinianEventCallback);
  void (*unsubscribe)(void* self, uint64_t subscription);
  /* Runs a command line from an event callback, and from there alone. answers: lines, or null. */
  int (*execute)(void* self, const char* line, const char** answers);
  const char* (*error)(void* self); /* of the last one of these that failed */
} PlinianHost;

/* What a plug-in exports. The host's table is good until uninitialise returns. */
#define PLINIAN_EXPORT __attribute__((visibility("default")))
#define PLINIAN_HIDDEN [[gnu::visibility("hidden")]]
PLINIAN_EXPORT int plinian_initialise(const PlinianHost* host);
PLINIAN_EXPORT void plinian_uninitialise(const PlinianHost* host);

/* Since 1.1: a plug-in that is compiled into the program exports nothing, and is handed over as this. */
typedef struct PlinianLinkedPlugin {
  size_t size;
  const char* description; /* lines, as in the note of a shared library */
  int (*initialise)(const PlinianHost* host);
  void (*uninitialise)(const PlinianHost* host);
} PlinianLinkedPlugin;

#ifdef __cplusplus
}
#endif
#endif
