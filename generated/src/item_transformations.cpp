// Generated from specs/ by codegen/templates/item_transformations.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/reflection/own_items.hpp"

#include <array>

namespace dalembert {
namespace {

constexpr std::array<ItemTransformation, 6> transformations{{
    {"ObjectGround", "referenceHT", "referencePosition", "referenceRotation"},
    {"ObjectKinematicTree", "jointHTs", "jointOffsets", "jointTransformations"},
    {"MarkerBodyRigid", "localHT", "localPosition", "localRotation"},
    {"MarkerKinematicTreeRigid", "localHT", "localPosition", "localRotation"},
    {"MarkerNodeRigid", "localHT", "", "localRotation"},
    {"MarkerSuperElementRigid", "localHT", "offset", "localRotation"},
}};

}  // namespace

std::span<const ItemTransformation> own_item_transformations() { return transformations; }

}  // namespace dalembert
