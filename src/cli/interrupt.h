#pragma once

namespace vernier {

/// From now on the first SIGINT (Ctrl-C) only sets what interrupted() tells; a second one ends the program as usual.
void catch_interrupt();

/// Whether SIGINT came since catch_interrupt(). May be called from any thread.
bool interrupted();

}  // namespace vernier
