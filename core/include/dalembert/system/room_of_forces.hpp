// How forces of markers lie in the ports (system/ports.hpp).
#pragma once

namespace dalembert {

// Stride between the forces of successive markers: three numbers are padded to a register.
constexpr int room_of_forces(int forces) { return forces == 3 ? 4 : forces; }

}  // namespace dalembert
