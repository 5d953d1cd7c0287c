#pragma once

namespace dsphere {

/// The calling thread, until it ends, steps back where others want the same cores: it gets a third of what each of them
/// gets (Linux; nothing elsewhere, or where it is refused). Threads that it starts inherit that.
void stepBack();

}  // namespace dsphere
