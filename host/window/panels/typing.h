// What Dear ImGui remembers of what was typed in a field.
//
// As of 1.86 it keeps the steps of undo of a field that is left and entered again, and of one whose text
// others change. To take one back in a text that it was not made in writes outside of that text.
#pragma once

namespace plinian::window {

/// Forgets the steps of a field that was left. To be called in every frame, before any field.
void forget_left_typing();

/// Forgets those of the field that is being typed in: others have changed its text.
void forget_typing();

/// Whether keys are a field's. At once, where Dear ImGui's own word (WantTextInput) follows only after
/// another frame, which may be long in coming where nothing moves.
bool is_typing();

/// Says that a field will take the keys with the next picture: those that are pressed until then are its own.
void expect_typing();
/// Whether a field is about to take them.
bool is_typing_expected();

}  // namespace plinian::window
