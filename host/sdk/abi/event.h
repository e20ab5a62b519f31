/* What happens to a scene (since 1.1). */
#ifndef PLINIAN_SDK_ABI_EVENT_H
#define PLINIAN_SDK_ABI_EVENT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* kind               what is filled in; else null, 0
 * nodeCreated        node
 * nodeDeleted        node
 * nodeRenamed        node, other: the name before
 * attributeChanged   plug
 * connected          plug: the driven one, other: the driving one
 * disconnected       plug
 * selectionChanged
 * timeChanged        time [frames]
 * beforeNew, afterNew, beforeOpen, afterOpen, beforeSave, afterSave   other: path of the file */
typedef struct PlinianEvent {
  size_t size;
  const char* kind;
  const char* node;
  const char* plug;
  const char* other;
  double time;
} PlinianEvent;

/* Called between commands: never in the middle of an edit nor of a computation. Returns 0 for a failure,
 * which is told once. */
typedef int (*PlinianEventCallback)(void* user, const PlinianEvent*);

#ifdef __cplusplus
}
#endif
#endif
