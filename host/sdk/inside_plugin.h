// Where each thread is inside plug-ins, so that the program's last line can say in which one it crashed.
#pragma once

#include <string>

namespace plinian::sdk {

/// While it lives, this thread runs code of a plug-in. Costs a few stores; the texts are not copied.
class InsidePlugin {
 public:
  /// Read as "OWNER while DOING SUBJECT.PART": "the plug-in 'puff'", "computing", "puff1", "out". Whatever is
  /// not needed is empty. All of it must stay where it is for as long.
  InsidePlugin(const std::string& owner, const char* doing, const char* subject = "", const char* part = "");
  /// Where another thread is, on whose behalf this one works.
  explicit InsidePlugin(const InsidePlugin* other);
  InsidePlugin(const InsidePlugin&) = delete;
  InsidePlugin& operator=(const InsidePlugin&) = delete;
  ~InsidePlugin();

  /// Of this thread, innermost; null where it is in none. Good until that one has gone.
  static const InsidePlugin* current();
  /// Writes " in the plug-in 'puff' while computing puff1.out" or what stands for it, to a descriptor. Safe
  /// in a signal handler.
  void write_to(int descriptor) const;

 private:
  const char *owner_, *doing_, *subject_, *part_;
  const InsidePlugin* outer_;
};

/// From now on a crash says in one line on standard error where it was, and ends the program as it would have
/// ended. Once, for the whole process.
void tell_of_crashes();

}  // namespace plinian::sdk
