/* Commands. */
#ifndef PLINIAN_SDK_ABI_COMMAND_H
#define PLINIAN_SDK_ABI_COMMAND_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A word of a command: a parameter, or a flag with or without a word behind it. many: a parameter takes
 * several words, a flag may be given several times, with a word each. optional: of parameters; flags are. */
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

/* Files that the commands import and export take beside scenes, by their extension (since 1.1). The functions
 * are called as a part of those commands. An importer runs commands that make what the file holds and answers
 * with the names of the nodes; what it does not put into the namespace of the flag "namespace" itself is put
 * there behind it. An exporter finds as words of the parameter "nodes" the names of all that is to be
 * written: the nodes that were named or are selected, what is under them, the transforms above them and, with
 * the flag "inputs", what drives them (before 1.3 the words as they were typed). It writes to `path`, a
 * temporary file of the right extension that takes the place of the real one once the exporter has succeeded
 * and the file is not empty. Either may be null. */
typedef struct PlinianFileType {
  size_t size;
  const char* name;
  const char* help;
  const char* extensions; /* "chan" or "obj ply", in lower case */
  void* user;
  void (*import_file)(void* user, const PlinianCommandContext*, PlinianCall*, const char* path);
  void (*export_file)(void* user, const PlinianCommandContext*, PlinianCall*, const char* path);
} PlinianFileType;

/* An entry of a menu, which runs a command line (since 1.1). */
typedef struct PlinianMenuEntry {
  size_t size;
  const char* path; /* "Create/Clouds/Ash Column" */
  const char* command;
  const char* help; /* may be null */
} PlinianMenuEntry;

#ifdef __cplusplus
}
#endif
#endif
