// Loops that are written out before a shader is compiled.
#pragma once

#include <string>

#include "viewport/gl/shader.h"

namespace plinian::gl {

/// Carries out each line `#unroll WORD INDEX COUNT` of a shader: every later `WORD STATEMENT`, where the
/// statement is a block or ends with its first semicolon, becomes COUNT copies of the statement, in copy i of
/// which `const int INDEX = i`. COUNT is one of `defines` or a number in [0, 64]. They may be nested. Text
/// without comments is expected; lines of the preprocessor are left alone. Throws std::runtime_error for a
/// count that is none and for a statement that does not end.
///
/// GLSL leaves it to the compiler whether a loop is unrolled. Where it is not, arrays live in memory instead
/// of registers, and what is chosen by the index (a sampler) is fetched for every index each time around: two
/// equal media took 4.5 times as long as twice one.
std::string unroll(std::string text, const Defines& defines);

}  // namespace plinian::gl
