// Generated from specs/ by codegen/templates/item_transformations.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/reflection/item_transformations.hpp"

#include <array>

namespace dalembert {
namespace {

constexpr auto transformations = std::to_array<ItemTransformation>({
    {"ObjectGround", "referenceHT", "referencePosition", "referenceRotation"},
    {"ObjectKinematicTree", "jointHTs", "jointOffsets", "jointTransformations"},
    {"MarkerBodyRigid", "localHT", "localPosition", "localRotation"},
    {"MarkerKinematicTreeRigid", "localHT", "localPosition", "localRotation"},
    {"MarkerNodeRigid", "localHT", "", "localRotation"},
    {"MarkerSuperElementRigid", "localHT", "offset", "localRotation"},
});

}  // namespace

std::span<const ItemTransformation> item_transformations() { return transformations; }

}  // namespace dalembert
