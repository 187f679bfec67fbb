#pragma once

namespace vernier {

/// From now on the first SIGINT (Ctrl-C), SIGTERM or SIGHUP only sets what interrupted() tells; a second one ends the
/// program as usual. SIGHUP stays ignored where it was (nohup).
void catch_interrupt();

/// Whether one came since catch_interrupt(). May be called from any thread.
bool interrupted();

}  // namespace vernier
