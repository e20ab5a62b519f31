// Where the program's own data files are.
#pragma once

#include <filesystem>
#include <vector>

namespace plinian {

/// share/plinian beside the folder of the running executable (PREFIX/bin/plinian -> PREFIX/share/plinian;
/// the build tree has the same layout). Empty where the executable is not known.
std::filesystem::path resource_folder();

/// $XDG_CONFIG_HOME/plinian, or ~/.config/plinian; empty where there is neither.
std::filesystem::path user_config_folder();
/// $XDG_STATE_HOME/plinian, or ~/.local/state/plinian, likewise: for what the program keeps for itself.
std::filesystem::path user_state_folder();

/// Folders that hold presets/, plugins/ and the like, the first that has a thing counting: those of
/// $PLINIAN_PATH (a show's; absolute ones only, between colons), the user's, the installation's.
std::vector<std::filesystem::path> search_folders();

}  // namespace plinian
