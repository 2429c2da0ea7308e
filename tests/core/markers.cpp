// Kernels of markers are refused when a member is missing, misspelt or has another type.
#include "dalembert/contracts/marker.hpp"

using namespace dalembert;

namespace {

struct Parameters {};

struct Local {
  using Parameters = ::Parameters;
  static Vec3<double> local(const Parameters&) { return {}; }
};
struct OfFrame : Local {
  static constexpr FrameShape shape = FrameShape::point;
};
struct MisspeltShape : Local {
  static constexpr FrameShape shpae = FrameShape::point;
};
static_assert(FrameMarkerKernel<OfFrame>);
static_assert(!FrameMarkerKernel<Local>);
static_assert(!FrameMarkerKernel<MisspeltShape>);

struct Chosen {
  using Parameters = ::Parameters;
  static std::vector<int> coordinates(const Parameters&, int) { return {}; }
};
struct OfCoordinates : Chosen {
  static constexpr bool totals = true;
};
struct MisspeltTotals : Chosen {
  static constexpr bool total = true;
};
static_assert(CoordinateMarkerKernel<OfCoordinates>);
static_assert(!CoordinateMarkerKernel<Chosen>);
static_assert(!CoordinateMarkerKernel<MisspeltTotals>);

}  // namespace

int main() { return 0; }
