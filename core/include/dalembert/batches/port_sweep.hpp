// Kernels between markers: frames in and out of the ports, and the loop that differentiates them by the coordinates of
// all their markers, a fixed number of directions at a time.
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "dalembert/math/dual.hpp"
#include "dalembert/model/errors.hpp"
#include "dalembert/system/term.hpp"

namespace dalembert {

inline constexpr int sweep_width = 8;
using SweepDual = Dual<sweep_width>;
// Calls f(first, count) for the directions of each sweep over n of them.
template <class F>
void each_sweep(std::size_t n, const F& f) {
  for (int first = 0, all = static_cast<int>(n); first < all; first += sweep_width)
    f(first, std::min(sweep_width, all - first));
}

// Refuses markers that give less than the frame of `Port`, or several coordinates instead of one. The frame of a rigid body
// begins with that of a point.
template <class Port>
void check_markers(const Placement& placement, const Ports& ports, const ItemLabel& item) {
  for (const int marker : placement.markers) {
    const PortLayout& port = ports.ports[marker];
    const bool one_coordinate = Port::forces == ScalarPort::forces;
    if (one_coordinate ? port.forces == 1 : port.values >= Port::values && port.forces >= Port::forces) continue;
    refuse(ErrorKind::value,
           {item, "markerNumbers",
            "marker " + std::to_string(marker) + " gives " + std::to_string(port.forces) + " coordinates", "",
            one_coordinate ? "markers of a single coordinate" : "markers of a point or a rigid body", ""});
  }
}

// Ports keep frames as they are laid out.
template <class Port, class S>
const typename Port::template Frame<S>& read_frame(const S* from) {
  return *reinterpret_cast<const typename Port::template Frame<S>*>(from);
}
template <class Port, class S>
const typename Port::template Frame<S>& read_frame(const PortsOf<S>& ports, int marker) {
  return read_frame<Port>(ports.frame(marker));
}

// The frame with the derivatives along columns [first, first + sweep_width) of the concatenated coordinates;
// `offset` is the marker's first column there.
template <class Port>
typename Port::template Frame<SweepDual> read_moving_frame(const Ports& ports, int marker, int offset, int first) {
  typename Port::template Frame<SweepDual> frame;
  if constexpr (Port::values > 0) {
    const int n = ports.ports[marker].n;
    const int begin = std::max(0, first - offset), end = std::min(n, first - offset + sweep_width);
    const double* from = ports.frame(marker);
    const double* derivative = ports.derivative(marker);
    SweepDual* to = reinterpret_cast<SweepDual*>(&frame);
    for (int i = 0; i < Port::values; ++i) {
      to[i].value = from[i];
      for (int c = begin; c < end; ++c) to[i].d[c + offset - first] = derivative[i * n + c];
    }
  }
  return frame;
}

// The parameters of a record, without the list of markers: entries keep that themselves, where it takes no memory of its own.
template <class Parameters, class Record>
Parameters parameters_between_markers(const void* record) {
  Parameters parameters = static_cast<const Record*>(record)->parameters;
  if constexpr (requires { parameters.markerNumbers; }) parameters.markerNumbers = {};
  return parameters;
}

// Coordinates that move the markers of one item, one marker after the other.
template <int M>
struct Columns {
  std::array<int, M> offset{};
  int total = 0;

  Columns(const PortTable& ports, const std::array<int, M>& markers) {
    for (int m = 0; m < M; ++m) {
      offset[m] = total;
      total += ports.ports[markers[m]].n;
    }
  }
};

template <int M>
std::vector<int> all_dofs(const Ports& ports, const std::array<int, M>& markers) {
  std::vector<int> dofs;
  dofs.reserve(static_cast<std::size_t>(Columns<M>(ports, markers).total));
  for (const int marker : markers) {
    const auto own = ports.marker_dofs(marker);
    dofs.insert(dofs.end(), own.begin(), own.end());
  }
  return dofs;
}

// values[slot] += sign * J^T force.d for all markers' rows and the columns of one sweep; entries that are always zero have no slot.
template <class Port, int M>
void scatter_forces(const Ports& ports, const std::array<int, M>& markers, const Columns<M>& columns, int first,
                    double sign, const std::array<typename Port::template Force<SweepDual>, M>& forces,
                    const int* slots, double* values) {
  const int count = std::min(sweep_width, columns.total - first);
  for (int m = 0; m < M; ++m) {
    const int n = ports.ports[markers[m]].n;
    const double* jacobian = ports.jacobian(markers[m]);
    const auto* force = reinterpret_cast<const SweepDual*>(&forces[m]);
    for (int i = 0; i < n; ++i) {
      std::array<double, sweep_width> row{};
      for (int f = 0; f < Port::forces; ++f) {
        const double j = sign * jacobian[f * n + i];
        for (int k = 0; k < sweep_width; ++k) row[k] += j * force[f].d[k];
      }
      const int* slot = slots + (columns.offset[m] + i) * columns.total + first;
      for (int k = 0; k < count; ++k)
        if (slot[k] >= 0) values[slot[k]] += row[k];
    }
  }
}

// Component by component: a loop would keep the vector out of registers.
template <class S>
void add_vector(S* to, double sign, const Vec3<S>& v) {
  to[0] += sign * v[0];
  to[1] += sign * v[1];
  to[2] += sign * v[2];
}
template <class S>
void add_force(S* to, double sign, const ScalarForce<S>& f) {
  to[0] += sign * f.force;
}
template <class S>
void add_force(S* to, double sign, const Force<S>& f) {
  add_vector(to, sign, f.force);
}
template <class S>
void add_force(S* to, double sign, const Wrench<S>& w) {
  add_vector(to, sign, w.force);
  add_vector(to + 3, sign, w.moment);
}
template <class Port, int M, class S>
void add_forces(PortsOf<S>& ports, const std::array<int, M>& markers, double sign,
                const std::array<typename Port::template Force<S>, M>& forces) {
  for (int m = 0; m < M; ++m) add_force(ports.force(markers[m]), sign, forces[m]);
}

}  // namespace dalembert
