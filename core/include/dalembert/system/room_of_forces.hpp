// How forces of markers lie in the ports (system/ports.hpp).
#pragma once

namespace dalembert {

// From the forces of one marker to those of the next: a register is added to three.
constexpr int room_of_forces(int forces) { return forces == 3 ? 4 : forces; }

}  // namespace dalembert
