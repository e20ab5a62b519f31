// What hands do again and again before the window, and how what they made is looked at.
#pragma once

#include <filesystem>

#include "tests/host/window/sitting.h"

namespace plinian {

/// Waits for a picture at rest that is on the screen, with nothing left to be drawn; returns the number of
/// its line. since: of the trace.
std::size_t wait_for_rest(Sitting& sitting, std::size_t since);

/// Types a line into the console and waits until it ran. The keys stay there.
void command(Sitting& sitting, const std::string& line);

/// Clicks there, where nothing is, and waits until no field has the keys. nowhere: [pixels]
void leave_fields(Sitting& sitting, ivec2 nowhere);

/// "psnr" of a picture's line [dB]; -1 where it was not compared.
double psnr_in(const std::string& line);

std::string text_of(const std::filesystem::path& path);

/// Of 8-bit values, as a share of their range. [dB]
double psnr(const Pixels& a, const std::vector<std::uint8_t>& b);

}  // namespace plinian
