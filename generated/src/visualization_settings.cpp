// Generated from specs/settings/visualization_settings.toml by codegen/templates/settings.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include "dalembert/visualization_settings.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace dalembert {
namespace {

constexpr std::array<Row, 11> VSettingsViewCamera_rows{{
    {.name = "cameraPosition", .storage = Storage::vector3, .offset = offsetof(VSettingsViewCamera, cameraPosition), .role = Role::parameter, .unit = "m"},
    {.name = "clippingPlaneDistance", .storage = Storage::real, .offset = offsetof(VSettingsViewCamera, clippingPlaneDistance), .role = Role::parameter, .unit = "m"},
    {.name = "clippingPlaneNormal", .storage = Storage::vector3, .offset = offsetof(VSettingsViewCamera, clippingPlaneNormal), .role = Role::parameter, .unit = "1"},
    {.name = "modelCentricView", .storage = Storage::boolean, .offset = offsetof(VSettingsViewCamera, modelCentricView), .role = Role::parameter},
    {.name = "nearFarPlaneOffset", .storage = Storage::vector3, .offset = offsetof(VSettingsViewCamera, nearFarPlaneOffset), .role = Role::parameter, .unit = "various"},
    {.name = "perspective", .storage = Storage::real, .offset = offsetof(VSettingsViewCamera, perspective), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "trackMarker", .storage = Storage::integer, .offset = offsetof(VSettingsViewCamera, trackMarker), .role = Role::parameter},
    {.name = "trackMarkerMbsNumber", .storage = Storage::integer, .offset = offsetof(VSettingsViewCamera, trackMarkerMbsNumber), .role = Role::parameter, .check = Check::non_negative},
    {.name = "trackMarkerOrientation", .storage = Storage::vector3, .offset = offsetof(VSettingsViewCamera, trackMarkerOrientation), .role = Role::parameter, .unit = "1"},
    {.name = "trackMarkerPosition", .storage = Storage::vector3, .offset = offsetof(VSettingsViewCamera, trackMarkerPosition), .role = Role::parameter, .unit = "1"},
    {.name = "useRaytracer", .storage = Storage::boolean, .offset = offsetof(VSettingsViewCamera, useRaytracer), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 8> VSettingsViewCamera_rules{{
    {.name = "cameraPosition", .no_effect = "the view follows from its center, rotation and zoom"},
    {.name = "modelCentricView", .no_effect = "views always turn about their center"},
    {.name = "nearFarPlaneOffset", .no_effect = "nothing is too near or too far away to be drawn"},
    {.name = "trackMarker", .no_effect_on_pages = "pages look from where their readers want"},
    {.name = "trackMarkerMbsNumber", .no_effect_on_pages = "pages look from where their readers want"},
    {.name = "trackMarkerOrientation", .no_effect_on_pages = "pages look from where their readers want"},
    {.name = "trackMarkerPosition", .no_effect_on_pages = "pages look from where their readers want"},
    {.name = "useRaytracer", .no_effect_on_pages = "pages have no rays"},
}};
constexpr SettingsGroup VSettingsViewCamera_group{"VSettingsViewCamera", VSettingsViewCamera_rows, {}, VSettingsViewCamera_rules};

constexpr std::array<Row, 9> VSettingsViewScene_rows{{
    {.name = "drawCoordinateSystem", .storage = Storage::integer, .offset = offsetof(VSettingsViewScene, drawCoordinateSystem), .role = Role::parameter, .check = Check::non_negative},
    {.name = "drawWorldBasis", .storage = Storage::boolean, .offset = offsetof(VSettingsViewScene, drawWorldBasis), .role = Role::parameter},
    {.name = "facesTransparent", .storage = Storage::boolean, .offset = offsetof(VSettingsViewScene, facesTransparent), .role = Role::parameter},
    {.name = "showFaceEdges", .storage = Storage::boolean, .offset = offsetof(VSettingsViewScene, showFaceEdges), .role = Role::parameter},
    {.name = "showFaces", .storage = Storage::boolean, .offset = offsetof(VSettingsViewScene, showFaces), .role = Role::parameter},
    {.name = "showLines", .storage = Storage::boolean, .offset = offsetof(VSettingsViewScene, showLines), .role = Role::parameter},
    {.name = "showMeshEdges", .storage = Storage::boolean, .offset = offsetof(VSettingsViewScene, showMeshEdges), .role = Role::parameter},
    {.name = "showMeshFaces", .storage = Storage::boolean, .offset = offsetof(VSettingsViewScene, showMeshFaces), .role = Role::parameter},
    {.name = "worldBasisSize", .storage = Storage::real, .offset = offsetof(VSettingsViewScene, worldBasisSize), .role = Role::parameter, .check = Check::positive, .unit = "m"},
}};
constexpr std::array<SettingRule, 6> VSettingsViewScene_rules{{
    {.name = "drawCoordinateSystem", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "drawWorldBasis", .no_effect = "that of view0 is for all views", .only_in = "view0"},
    {.name = "showLines", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "showMeshEdges", .no_effect = "that of view0 is for all views", .only_in = "view0"},
    {.name = "showMeshFaces", .no_effect = "that of view0 is for all views", .only_in = "view0"},
    {.name = "worldBasisSize", .no_effect = "that of view0 is for all views", .only_in = "view0"},
}};
constexpr SettingsGroup VSettingsViewScene_group{"VSettingsViewScene", VSettingsViewScene_rows, {}, VSettingsViewScene_rules};

constexpr std::array<Row, 9> VSettingsViewWindow_rows{{
    {.name = "alwaysOnTop", .storage = Storage::boolean, .offset = offsetof(VSettingsViewWindow, alwaysOnTop), .role = Role::parameter},
    {.name = "globalFontSize", .storage = Storage::real, .offset = offsetof(VSettingsViewWindow, globalFontSize), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "lockModelView", .storage = Storage::boolean, .offset = offsetof(VSettingsViewWindow, lockModelView), .role = Role::parameter},
    {.name = "maximize", .storage = Storage::boolean, .offset = offsetof(VSettingsViewWindow, maximize), .role = Role::parameter},
    {.name = "renderWindowSize", .storage = Storage::integers, .offset = offsetof(VSettingsViewWindow, renderWindowSize), .role = Role::parameter, .size = 2},
    {.name = "showComputationInfo", .storage = Storage::boolean, .offset = offsetof(VSettingsViewWindow, showComputationInfo), .role = Role::parameter},
    {.name = "showMouseCoordinates", .storage = Storage::boolean, .offset = offsetof(VSettingsViewWindow, showMouseCoordinates), .role = Role::parameter},
    {.name = "showRenderStateInfo", .storage = Storage::boolean, .offset = offsetof(VSettingsViewWindow, showRenderStateInfo), .role = Role::parameter},
    {.name = "showWindow", .storage = Storage::boolean, .offset = offsetof(VSettingsViewWindow, showWindow), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 8> VSettingsViewWindow_rules{{
    {.name = "alwaysOnTop", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "globalFontSize", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "lockModelView", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "maximize", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "showComputationInfo", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "showMouseCoordinates", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "showRenderStateInfo", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "showWindow", .no_effect = "pages are in windows of the browser, with its mouse"},
}};
constexpr SettingsGroup VSettingsViewWindow_group{"VSettingsViewWindow", VSettingsViewWindow_rows, {}, VSettingsViewWindow_rules};

constexpr std::array<Row, 0> VSettingsView_rows{{
}};
constexpr std::array<SettingsChild, 3> VSettingsView_children{{
    {"camera", &VSettingsViewCamera_group, offsetof(VSettingsView, camera)},
    {"scene", &VSettingsViewScene_group, offsetof(VSettingsView, scene)},
    {"window", &VSettingsViewWindow_group, offsetof(VSettingsView, window)},
}};
constexpr SettingsGroup VSettingsView_group{"VSettingsView", VSettingsView_rows, VSettingsView_children};

constexpr std::array<Row, 10> VSettingsLight_rows{{
    {.name = "constantAttenuation", .storage = Storage::real, .offset = offsetof(VSettingsLight, constantAttenuation), .role = Role::parameter, .unit = "1"},
    {.name = "diffuse", .storage = Storage::real, .offset = offsetof(VSettingsLight, diffuse), .role = Role::parameter, .unit = "1"},
    {.name = "enable", .storage = Storage::boolean, .offset = offsetof(VSettingsLight, enable), .role = Role::parameter},
    {.name = "lightRadius", .storage = Storage::real, .offset = offsetof(VSettingsLight, lightRadius), .role = Role::parameter, .unit = "m"},
    {.name = "linearAttenuation", .storage = Storage::real, .offset = offsetof(VSettingsLight, linearAttenuation), .role = Role::parameter, .unit = "1/m"},
    {.name = "position", .storage = Storage::vector4, .offset = offsetof(VSettingsLight, position), .role = Role::parameter, .unit = "m"},
    {.name = "quadraticAttenuation", .storage = Storage::real, .offset = offsetof(VSettingsLight, quadraticAttenuation), .role = Role::parameter, .unit = "1/m^2"},
    {.name = "shadow", .storage = Storage::real, .offset = offsetof(VSettingsLight, shadow), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "specular", .storage = Storage::real, .offset = offsetof(VSettingsLight, specular), .role = Role::parameter, .unit = "1"},
    {.name = "useCameraFrame", .storage = Storage::boolean, .offset = offsetof(VSettingsLight, useCameraFrame), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 10> VSettingsLight_rules{{
    {.name = "constantAttenuation", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "diffuse", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "enable", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "lightRadius", .no_effect_on_pages = "pages have lights, lines and words of their own", .no_effect_without_rays = "only the ray tracer has it, see view0.camera.useRaytracer"},
    {.name = "linearAttenuation", .no_effect_on_pages = "pages have lights, lines and words of their own", .no_effect_without_rays = "only the ray tracer has it, see view0.camera.useRaytracer"},
    {.name = "position", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "quadraticAttenuation", .no_effect_on_pages = "pages have lights, lines and words of their own", .no_effect_without_rays = "only the ray tracer has it, see view0.camera.useRaytracer"},
    {.name = "shadow", .no_effect_on_pages = "pages have lights, lines and words of their own", .no_effect_without_rays = "only the ray tracer has it, see view0.camera.useRaytracer"},
    {.name = "specular", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "useCameraFrame", .no_effect_on_pages = "pages have lights, lines and words of their own", .no_effect_without_rays = "only the ray tracer has it, see view0.camera.useRaytracer"},
}};
constexpr SettingsGroup VSettingsLight_group{"VSettingsLight", VSettingsLight_rows, {}, VSettingsLight_rules};

constexpr std::array<Row, 8> VSettingsMaterial_rows{{
    {.name = "alpha", .storage = Storage::real, .offset = offsetof(VSettingsMaterial, alpha), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "baseColor", .storage = Storage::vector3, .offset = offsetof(VSettingsMaterial, baseColor), .role = Role::parameter, .unit = "1"},
    {.name = "emission", .storage = Storage::vector3, .offset = offsetof(VSettingsMaterial, emission), .role = Role::parameter, .unit = "1"},
    {.name = "ior", .storage = Storage::real, .offset = offsetof(VSettingsMaterial, ior), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "name", .storage = Storage::text, .offset = offsetof(VSettingsMaterial, name), .role = Role::parameter},
    {.name = "reflectivity", .storage = Storage::real, .offset = offsetof(VSettingsMaterial, reflectivity), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "shininess", .storage = Storage::real, .offset = offsetof(VSettingsMaterial, shininess), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "specular", .storage = Storage::vector3, .offset = offsetof(VSettingsMaterial, specular), .role = Role::parameter, .unit = "1"},
}};
constexpr std::array<SettingRule, 1> VSettingsMaterial_rules{{
    {.name = "name", .no_effect = "materials are known by their numbers"},
}};
constexpr SettingsGroup VSettingsMaterial_group{"VSettingsMaterial", VSettingsMaterial_rows, {}, VSettingsMaterial_rules};

constexpr std::array<Row, 9> VSettingsNodes_rows{{
    {.name = "basisSize", .storage = Storage::real, .offset = offsetof(VSettingsNodes, basisSize), .role = Role::parameter, .unit = "m"},
    {.name = "defaultColor", .storage = Storage::vector4, .offset = offsetof(VSettingsNodes, defaultColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "defaultSize", .storage = Storage::real, .offset = offsetof(VSettingsNodes, defaultSize), .role = Role::parameter, .unit = "m"},
    {.name = "drawNodesAsPoint", .storage = Storage::boolean, .offset = offsetof(VSettingsNodes, drawNodesAsPoint), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(VSettingsNodes, show), .role = Role::parameter},
    {.name = "showBasis", .storage = Storage::boolean, .offset = offsetof(VSettingsNodes, showBasis), .role = Role::parameter},
    {.name = "showNodalSlopes", .storage = Storage::integer, .offset = offsetof(VSettingsNodes, showNodalSlopes), .role = Role::parameter, .check = Check::non_negative},
    {.name = "showNumbers", .storage = Storage::boolean, .offset = offsetof(VSettingsNodes, showNumbers), .role = Role::parameter},
    {.name = "tiling", .storage = Storage::integer, .offset = offsetof(VSettingsNodes, tiling), .role = Role::parameter, .check = Check::positive},
}};
constexpr std::array<SettingRule, 2> VSettingsNodes_rules{{
    {.name = "drawNodesAsPoint", .no_effect = "nodes are balls"},
    {.name = "tiling", .no_effect = "spheres are round"},
}};
constexpr SettingsGroup VSettingsNodes_group{"VSettingsNodes", VSettingsNodes_rows, {}, VSettingsNodes_rules};

constexpr std::array<Row, 10> VSettingsBodiesBeams_rows{{
    {.name = "axialTiling", .storage = Storage::integer, .offset = offsetof(VSettingsBodiesBeams, axialTiling), .role = Role::parameter, .check = Check::positive},
    {.name = "crossSectionFilled", .storage = Storage::boolean, .offset = offsetof(VSettingsBodiesBeams, crossSectionFilled), .role = Role::parameter},
    {.name = "crossSectionTiling", .storage = Storage::integer, .offset = offsetof(VSettingsBodiesBeams, crossSectionTiling), .role = Role::parameter, .check = Check::positive},
    {.name = "drawVertical", .storage = Storage::boolean, .offset = offsetof(VSettingsBodiesBeams, drawVertical), .role = Role::parameter},
    {.name = "drawVerticalColor", .storage = Storage::vector4, .offset = offsetof(VSettingsBodiesBeams, drawVerticalColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "drawVerticalFactor", .storage = Storage::real, .offset = offsetof(VSettingsBodiesBeams, drawVerticalFactor), .role = Role::parameter, .check = Check::non_negative, .unit = "various"},
    {.name = "drawVerticalLines", .storage = Storage::boolean, .offset = offsetof(VSettingsBodiesBeams, drawVerticalLines), .role = Role::parameter},
    {.name = "drawVerticalOffset", .storage = Storage::real, .offset = offsetof(VSettingsBodiesBeams, drawVerticalOffset), .role = Role::parameter, .unit = "various"},
    {.name = "drawVerticalValues", .storage = Storage::boolean, .offset = offsetof(VSettingsBodiesBeams, drawVerticalValues), .role = Role::parameter},
    {.name = "reducedAxialInterploation", .storage = Storage::boolean, .offset = offsetof(VSettingsBodiesBeams, reducedAxialInterploation), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 2> VSettingsBodiesBeams_rules{{
    {.name = "crossSectionFilled", .no_effect = "cross sections are solid"},
    {.name = "reducedAxialInterploation", .no_effect = "numbers along a beam are those of its points"},
}};
constexpr SettingsGroup VSettingsBodiesBeams_group{"VSettingsBodiesBeams", VSettingsBodiesBeams_rows, {}, VSettingsBodiesBeams_rules};

constexpr std::array<Row, 4> VSettingsBodiesKinematicTree_rows{{
    {.name = "frameSize", .storage = Storage::real, .offset = offsetof(VSettingsBodiesKinematicTree, frameSize), .role = Role::parameter, .unit = "m"},
    {.name = "showCOMframes", .storage = Storage::boolean, .offset = offsetof(VSettingsBodiesKinematicTree, showCOMframes), .role = Role::parameter},
    {.name = "showFramesNumbers", .storage = Storage::boolean, .offset = offsetof(VSettingsBodiesKinematicTree, showFramesNumbers), .role = Role::parameter},
    {.name = "showJointFrames", .storage = Storage::boolean, .offset = offsetof(VSettingsBodiesKinematicTree, showJointFrames), .role = Role::parameter},
}};
constexpr SettingsGroup VSettingsBodiesKinematicTree_group{"VSettingsBodiesKinematicTree", VSettingsBodiesKinematicTree_rows, {}};

constexpr std::array<Row, 2> VSettingsBodiesShells_rows{{
    {.name = "drawSolid", .storage = Storage::boolean, .offset = offsetof(VSettingsBodiesShells, drawSolid), .role = Role::parameter},
    {.name = "thicknessFactor", .storage = Storage::real, .offset = offsetof(VSettingsBodiesShells, thicknessFactor), .role = Role::parameter, .check = Check::positive, .unit = "1"},
}};
constexpr SettingsGroup VSettingsBodiesShells_group{"VSettingsBodiesShells", VSettingsBodiesShells_rows, {}};

constexpr std::array<Row, 5> VSettingsBodies_rows{{
    {.name = "defaultColor", .storage = Storage::vector4, .offset = offsetof(VSettingsBodies, defaultColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "defaultSize", .storage = Storage::vector3, .offset = offsetof(VSettingsBodies, defaultSize), .role = Role::parameter, .unit = "m"},
    {.name = "deformationScaleFactor", .storage = Storage::real, .offset = offsetof(VSettingsBodies, deformationScaleFactor), .role = Role::parameter, .unit = "1"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(VSettingsBodies, show), .role = Role::parameter},
    {.name = "showNumbers", .storage = Storage::boolean, .offset = offsetof(VSettingsBodies, showNumbers), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 1> VSettingsBodies_rules{{
    {.name = "defaultSize", .no_effect = "bodies without shapes are drawn as large as their markers say"},
}};
constexpr std::array<SettingsChild, 3> VSettingsBodies_children{{
    {"beams", &VSettingsBodiesBeams_group, offsetof(VSettingsBodies, beams)},
    {"kinematicTree", &VSettingsBodiesKinematicTree_group, offsetof(VSettingsBodies, kinematicTree)},
    {"shells", &VSettingsBodiesShells_group, offsetof(VSettingsBodies, shells)},
}};
constexpr SettingsGroup VSettingsBodies_group{"VSettingsBodies", VSettingsBodies_rows, VSettingsBodies_children, VSettingsBodies_rules};

constexpr std::array<Row, 10> VSettingsConnectors_rows{{
    {.name = "contactPointsDefaultSize", .storage = Storage::real, .offset = offsetof(VSettingsConnectors, contactPointsDefaultSize), .role = Role::parameter, .unit = "m"},
    {.name = "defaultColor", .storage = Storage::vector4, .offset = offsetof(VSettingsConnectors, defaultColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "defaultSize", .storage = Storage::real, .offset = offsetof(VSettingsConnectors, defaultSize), .role = Role::parameter, .unit = "m"},
    {.name = "jointAxesLength", .storage = Storage::real, .offset = offsetof(VSettingsConnectors, jointAxesLength), .role = Role::parameter, .unit = "m"},
    {.name = "jointAxesRadius", .storage = Storage::real, .offset = offsetof(VSettingsConnectors, jointAxesRadius), .role = Role::parameter, .unit = "m"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(VSettingsConnectors, show), .role = Role::parameter},
    {.name = "showContact", .storage = Storage::boolean, .offset = offsetof(VSettingsConnectors, showContact), .role = Role::parameter},
    {.name = "showJointAxes", .storage = Storage::boolean, .offset = offsetof(VSettingsConnectors, showJointAxes), .role = Role::parameter},
    {.name = "showNumbers", .storage = Storage::boolean, .offset = offsetof(VSettingsConnectors, showNumbers), .role = Role::parameter},
    {.name = "springNumberOfWindings", .storage = Storage::integer, .offset = offsetof(VSettingsConnectors, springNumberOfWindings), .role = Role::parameter, .check = Check::positive},
}};
constexpr std::array<SettingRule, 3> VSettingsConnectors_rules{{
    {.name = "contactPointsDefaultSize", .no_effect = "contacts are drawn as the shapes that touch"},
    {.name = "jointAxesRadius", .no_effect = "the axes of frames have the proportions of all frames"},
    {.name = "showContact", .no_effect = "contacts are drawn as the shapes that touch"},
}};
constexpr SettingsGroup VSettingsConnectors_group{"VSettingsConnectors", VSettingsConnectors_rows, {}, VSettingsConnectors_rules};

constexpr std::array<Row, 5> VSettingsMarkers_rows{{
    {.name = "defaultColor", .storage = Storage::vector4, .offset = offsetof(VSettingsMarkers, defaultColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "defaultSize", .storage = Storage::real, .offset = offsetof(VSettingsMarkers, defaultSize), .role = Role::parameter, .unit = "m"},
    {.name = "drawSimplified", .storage = Storage::boolean, .offset = offsetof(VSettingsMarkers, drawSimplified), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(VSettingsMarkers, show), .role = Role::parameter},
    {.name = "showNumbers", .storage = Storage::boolean, .offset = offsetof(VSettingsMarkers, showNumbers), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 1> VSettingsMarkers_rules{{
    {.name = "drawSimplified", .no_effect = "markers are cubes"},
}};
constexpr SettingsGroup VSettingsMarkers_group{"VSettingsMarkers", VSettingsMarkers_rows, {}, VSettingsMarkers_rules};

constexpr std::array<Row, 9> VSettingsLoads_rows{{
    {.name = "defaultColor", .storage = Storage::vector4, .offset = offsetof(VSettingsLoads, defaultColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "defaultRadius", .storage = Storage::real, .offset = offsetof(VSettingsLoads, defaultRadius), .role = Role::parameter, .unit = "m"},
    {.name = "defaultSize", .storage = Storage::real, .offset = offsetof(VSettingsLoads, defaultSize), .role = Role::parameter, .unit = "m"},
    {.name = "drawSimplified", .storage = Storage::boolean, .offset = offsetof(VSettingsLoads, drawSimplified), .role = Role::parameter},
    {.name = "drawWithUserFunction", .storage = Storage::boolean, .offset = offsetof(VSettingsLoads, drawWithUserFunction), .role = Role::parameter},
    {.name = "fixedLoadSize", .storage = Storage::boolean, .offset = offsetof(VSettingsLoads, fixedLoadSize), .role = Role::parameter},
    {.name = "loadSizeFactor", .storage = Storage::real, .offset = offsetof(VSettingsLoads, loadSizeFactor), .role = Role::parameter, .unit = "various"},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(VSettingsLoads, show), .role = Role::parameter},
    {.name = "showNumbers", .storage = Storage::boolean, .offset = offsetof(VSettingsLoads, showNumbers), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 2> VSettingsLoads_rules{{
    {.name = "drawSimplified", .no_effect = "loads are arrows"},
    {.name = "drawWithUserFunction", .no_effect = "loads are drawn as they are given"},
}};
constexpr SettingsGroup VSettingsLoads_group{"VSettingsLoads", VSettingsLoads_rows, {}, VSettingsLoads_rules};

constexpr std::array<Row, 18> VSettingsSensorsTraces_rows{{
    {.name = "lineWidth", .storage = Storage::real, .offset = offsetof(VSettingsSensorsTraces, lineWidth), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "listOfPositionSensors", .storage = Storage::integers, .offset = offsetof(VSettingsSensorsTraces, listOfPositionSensors), .role = Role::parameter},
    {.name = "listOfTriadSensors", .storage = Storage::integers, .offset = offsetof(VSettingsSensorsTraces, listOfTriadSensors), .role = Role::parameter},
    {.name = "listOfVectorSensors", .storage = Storage::integers, .offset = offsetof(VSettingsSensorsTraces, listOfVectorSensors), .role = Role::parameter},
    {.name = "positionsShowEvery", .storage = Storage::integer, .offset = offsetof(VSettingsSensorsTraces, positionsShowEvery), .role = Role::parameter, .check = Check::positive},
    {.name = "sensorsMbsNumber", .storage = Storage::integer, .offset = offsetof(VSettingsSensorsTraces, sensorsMbsNumber), .role = Role::parameter, .check = Check::non_negative},
    {.name = "showCurrent", .storage = Storage::boolean, .offset = offsetof(VSettingsSensorsTraces, showCurrent), .role = Role::parameter},
    {.name = "showFuture", .storage = Storage::boolean, .offset = offsetof(VSettingsSensorsTraces, showFuture), .role = Role::parameter},
    {.name = "showPast", .storage = Storage::boolean, .offset = offsetof(VSettingsSensorsTraces, showPast), .role = Role::parameter},
    {.name = "showPositionTrace", .storage = Storage::boolean, .offset = offsetof(VSettingsSensorsTraces, showPositionTrace), .role = Role::parameter},
    {.name = "showTriads", .storage = Storage::boolean, .offset = offsetof(VSettingsSensorsTraces, showTriads), .role = Role::parameter},
    {.name = "showVectors", .storage = Storage::boolean, .offset = offsetof(VSettingsSensorsTraces, showVectors), .role = Role::parameter},
    {.name = "timeSpan", .storage = Storage::real, .offset = offsetof(VSettingsSensorsTraces, timeSpan), .role = Role::parameter, .check = Check::non_negative, .unit = "s"},
    {.name = "traceColors", .storage = Storage::vector, .offset = offsetof(VSettingsSensorsTraces, traceColors), .role = Role::parameter, .unit = "1"},
    {.name = "triadSize", .storage = Storage::real, .offset = offsetof(VSettingsSensorsTraces, triadSize), .role = Role::parameter, .unit = "m"},
    {.name = "triadsShowEvery", .storage = Storage::integer, .offset = offsetof(VSettingsSensorsTraces, triadsShowEvery), .role = Role::parameter, .check = Check::positive},
    {.name = "vectorScaling", .storage = Storage::real, .offset = offsetof(VSettingsSensorsTraces, vectorScaling), .role = Role::parameter, .unit = "various"},
    {.name = "vectorsShowEvery", .storage = Storage::integer, .offset = offsetof(VSettingsSensorsTraces, vectorsShowEvery), .role = Role::parameter, .check = Check::positive},
}};
constexpr std::array<SettingRule, 1> VSettingsSensorsTraces_rules{{
    {.name = "lineWidth", .no_effect_on_pages = "pages have lights, lines and words of their own"},
}};
constexpr SettingsGroup VSettingsSensorsTraces_group{"VSettingsSensorsTraces", VSettingsSensorsTraces_rows, {}, VSettingsSensorsTraces_rules};

constexpr std::array<Row, 5> VSettingsSensors_rows{{
    {.name = "defaultColor", .storage = Storage::vector4, .offset = offsetof(VSettingsSensors, defaultColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "defaultSize", .storage = Storage::real, .offset = offsetof(VSettingsSensors, defaultSize), .role = Role::parameter, .unit = "m"},
    {.name = "drawSimplified", .storage = Storage::boolean, .offset = offsetof(VSettingsSensors, drawSimplified), .role = Role::parameter},
    {.name = "show", .storage = Storage::boolean, .offset = offsetof(VSettingsSensors, show), .role = Role::parameter},
    {.name = "showNumbers", .storage = Storage::boolean, .offset = offsetof(VSettingsSensors, showNumbers), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 1> VSettingsSensors_rules{{
    {.name = "drawSimplified", .no_effect = "sensors are cubes"},
}};
constexpr std::array<SettingsChild, 1> VSettingsSensors_children{{
    {"traces", &VSettingsSensorsTraces_group, offsetof(VSettingsSensors, traces)},
}};
constexpr SettingsGroup VSettingsSensors_group{"VSettingsSensors", VSettingsSensors_rows, VSettingsSensors_children, VSettingsSensors_rules};

constexpr std::array<Row, 10> VSettingsContourAdvanced_rows{{
    {.name = "colorBarPrecision", .storage = Storage::integer, .offset = offsetof(VSettingsContourAdvanced, colorBarPrecision), .role = Role::parameter, .check = Check::positive},
    {.name = "colorBarTiling", .storage = Storage::integer, .offset = offsetof(VSettingsContourAdvanced, colorBarTiling), .role = Role::parameter, .check = Check::positive},
    {.name = "contourColor0", .storage = Storage::vector4, .offset = offsetof(VSettingsContourAdvanced, contourColor0), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "contourColor1", .storage = Storage::vector4, .offset = offsetof(VSettingsContourAdvanced, contourColor1), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "contourColor2", .storage = Storage::vector4, .offset = offsetof(VSettingsContourAdvanced, contourColor2), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "contourColor3", .storage = Storage::vector4, .offset = offsetof(VSettingsContourAdvanced, contourColor3), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "contourColor4", .storage = Storage::vector4, .offset = offsetof(VSettingsContourAdvanced, contourColor4), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "contourColorMax", .storage = Storage::vector4, .offset = offsetof(VSettingsContourAdvanced, contourColorMax), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "contourColorMin", .storage = Storage::vector4, .offset = offsetof(VSettingsContourAdvanced, contourColorMin), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "showColorBar", .storage = Storage::boolean, .offset = offsetof(VSettingsContourAdvanced, showColorBar), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 2> VSettingsContourAdvanced_rules{{
    {.name = "colorBarPrecision", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "colorBarTiling", .no_effect_on_pages = "pages have lights, lines and words of their own"},
}};
constexpr SettingsGroup VSettingsContourAdvanced_group{"VSettingsContourAdvanced", VSettingsContourAdvanced_rows, {}, VSettingsContourAdvanced_rules};

constexpr std::array<Row, 9> VSettingsContour_rows{{
    {.name = "alphaTransparency", .storage = Storage::real, .offset = offsetof(VSettingsContour, alphaTransparency), .role = Role::parameter, .unit = "1"},
    {.name = "automaticRange", .storage = Storage::boolean, .offset = offsetof(VSettingsContour, automaticRange), .role = Role::parameter},
    {.name = "maxValue", .storage = Storage::real, .offset = offsetof(VSettingsContour, maxValue), .role = Role::parameter, .unit = "various"},
    {.name = "minValue", .storage = Storage::real, .offset = offsetof(VSettingsContour, minValue), .role = Role::parameter, .unit = "various"},
    {.name = "nodesColored", .storage = Storage::boolean, .offset = offsetof(VSettingsContour, nodesColored), .role = Role::parameter},
    {.name = "outputVariable", .storage = Storage::output_variable, .offset = offsetof(VSettingsContour, outputVariable), .role = Role::parameter},
    {.name = "outputVariableComponent", .storage = Storage::integer, .offset = offsetof(VSettingsContour, outputVariableComponent), .role = Role::parameter},
    {.name = "reduceRange", .storage = Storage::boolean, .offset = offsetof(VSettingsContour, reduceRange), .role = Role::parameter},
    {.name = "rigidBodiesColored", .storage = Storage::boolean, .offset = offsetof(VSettingsContour, rigidBodiesColored), .role = Role::parameter},
}};
constexpr std::array<SettingsChild, 1> VSettingsContour_children{{
    {"advanced", &VSettingsContourAdvanced_group, offsetof(VSettingsContour, advanced)},
}};
constexpr SettingsGroup VSettingsContour_group{"VSettingsContour", VSettingsContour_rows, VSettingsContour_children};

constexpr std::array<Row, 17> VSettingsContact_rows{{
    {.name = "colorBoundingBoxes", .storage = Storage::vector4, .offset = offsetof(VSettingsContact, colorBoundingBoxes), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "colorSearchTree", .storage = Storage::vector4, .offset = offsetof(VSettingsContact, colorSearchTree), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "colorSpheres", .storage = Storage::vector4, .offset = offsetof(VSettingsContact, colorSpheres), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "colorTori", .storage = Storage::vector4, .offset = offsetof(VSettingsContact, colorTori), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "colorTriangles", .storage = Storage::vector4, .offset = offsetof(VSettingsContact, colorTriangles), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "contactForcesFactor", .storage = Storage::real, .offset = offsetof(VSettingsContact, contactForcesFactor), .role = Role::parameter, .unit = "m/N"},
    {.name = "contactPointsDefaultSize", .storage = Storage::real, .offset = offsetof(VSettingsContact, contactPointsDefaultSize), .role = Role::parameter, .unit = "m"},
    {.name = "showBoundingBoxes", .storage = Storage::boolean, .offset = offsetof(VSettingsContact, showBoundingBoxes), .role = Role::parameter},
    {.name = "showContactForces", .storage = Storage::boolean, .offset = offsetof(VSettingsContact, showContactForces), .role = Role::parameter},
    {.name = "showContactForcesValues", .storage = Storage::boolean, .offset = offsetof(VSettingsContact, showContactForcesValues), .role = Role::parameter},
    {.name = "showSearchTree", .storage = Storage::boolean, .offset = offsetof(VSettingsContact, showSearchTree), .role = Role::parameter},
    {.name = "showSearchTreeCells", .storage = Storage::boolean, .offset = offsetof(VSettingsContact, showSearchTreeCells), .role = Role::parameter},
    {.name = "showSpheres", .storage = Storage::boolean, .offset = offsetof(VSettingsContact, showSpheres), .role = Role::parameter},
    {.name = "showTori", .storage = Storage::boolean, .offset = offsetof(VSettingsContact, showTori), .role = Role::parameter},
    {.name = "showTriangles", .storage = Storage::boolean, .offset = offsetof(VSettingsContact, showTriangles), .role = Role::parameter},
    {.name = "tilingCurves", .storage = Storage::integer, .offset = offsetof(VSettingsContact, tilingCurves), .role = Role::parameter, .check = Check::positive},
    {.name = "tilingSpheres", .storage = Storage::integer, .offset = offsetof(VSettingsContact, tilingSpheres), .role = Role::parameter, .check = Check::positive},
}};
constexpr std::array<SettingRule, 4> VSettingsContact_rules{{
    {.name = "colorTori", .no_effect = "general contact has no tori"},
    {.name = "showTori", .no_effect = "general contact has no tori"},
    {.name = "tilingCurves", .no_effect = "general contact has no curves of its own"},
    {.name = "tilingSpheres", .no_effect = "spheres are round"},
}};
constexpr SettingsGroup VSettingsContact_group{"VSettingsContact", VSettingsContact_rows, {}, VSettingsContact_rules};

constexpr std::array<Row, 18> VSettingsOpenGLAdvanced_rows{{
    {.name = "clippingPlaneColor", .storage = Storage::vector4, .offset = offsetof(VSettingsOpenGLAdvanced, clippingPlaneColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "depthSorting", .storage = Storage::boolean, .offset = offsetof(VSettingsOpenGLAdvanced, depthSorting), .role = Role::parameter},
    {.name = "enableLighting", .storage = Storage::boolean, .offset = offsetof(VSettingsOpenGLAdvanced, enableLighting), .role = Role::parameter},
    {.name = "faceNormalsColor", .storage = Storage::vector4, .offset = offsetof(VSettingsOpenGLAdvanced, faceNormalsColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "initialCenterPoint", .storage = Storage::vector3, .offset = offsetof(VSettingsOpenGLAdvanced, initialCenterPoint), .role = Role::parameter, .unit = "m"},
    {.name = "initialMaxSceneSize", .storage = Storage::real, .offset = offsetof(VSettingsOpenGLAdvanced, initialMaxSceneSize), .role = Role::parameter, .check = Check::positive, .unit = "m"},
    {.name = "initialModelRotation", .storage = Storage::matrix3, .offset = offsetof(VSettingsOpenGLAdvanced, initialModelRotation), .role = Role::parameter, .unit = "1"},
    {.name = "initialZoom", .storage = Storage::real, .offset = offsetof(VSettingsOpenGLAdvanced, initialZoom), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "lightModelLocalViewer", .storage = Storage::boolean, .offset = offsetof(VSettingsOpenGLAdvanced, lightModelLocalViewer), .role = Role::parameter},
    {.name = "lightModelTwoSide", .storage = Storage::boolean, .offset = offsetof(VSettingsOpenGLAdvanced, lightModelTwoSide), .role = Role::parameter},
    {.name = "lineSmooth", .storage = Storage::boolean, .offset = offsetof(VSettingsOpenGLAdvanced, lineSmooth), .role = Role::parameter},
    {.name = "polygonOffset", .storage = Storage::real, .offset = offsetof(VSettingsOpenGLAdvanced, polygonOffset), .role = Role::parameter, .unit = "1"},
    {.name = "shadeModelSmooth", .storage = Storage::boolean, .offset = offsetof(VSettingsOpenGLAdvanced, shadeModelSmooth), .role = Role::parameter},
    {.name = "shadowPolygonOffset", .storage = Storage::real, .offset = offsetof(VSettingsOpenGLAdvanced, shadowPolygonOffset), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "showBoundingBox", .storage = Storage::boolean, .offset = offsetof(VSettingsOpenGLAdvanced, showBoundingBox), .role = Role::parameter},
    {.name = "textLineSmooth", .storage = Storage::boolean, .offset = offsetof(VSettingsOpenGLAdvanced, textLineSmooth), .role = Role::parameter},
    {.name = "textLineWidth", .storage = Storage::real, .offset = offsetof(VSettingsOpenGLAdvanced, textLineWidth), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "vertexNormalsColor", .storage = Storage::vector4, .offset = offsetof(VSettingsOpenGLAdvanced, vertexNormalsColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
}};
constexpr std::array<SettingRule, 13> VSettingsOpenGLAdvanced_rules{{
    {.name = "clippingPlaneColor", .no_effect = "cut faces are not closed"},
    {.name = "depthSorting", .no_effect = "transparent faces are always sorted"},
    {.name = "enableLighting", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "initialMaxSceneSize", .no_effect = "the size is found from what is drawn"},
    {.name = "initialZoom", .lower = 0.0, .lower_open = true, .words = "greater than 0"},
    {.name = "lightModelLocalViewer", .no_effect = "highlights are those of a viewer far away"},
    {.name = "lightModelTwoSide", .no_effect = "both sides of faces are always lit"},
    {.name = "lineSmooth", .no_effect = "lines are always smooth"},
    {.name = "polygonOffset", .no_effect = "lines on faces are seen anyway"},
    {.name = "shadeModelSmooth", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "shadowPolygonOffset", .no_effect = "there are no shadows"},
    {.name = "textLineSmooth", .no_effect = "texts are drawn with a font of outlines"},
    {.name = "textLineWidth", .no_effect = "texts are drawn with a font of outlines"},
}};
constexpr SettingsGroup VSettingsOpenGLAdvanced_group{"VSettingsOpenGLAdvanced", VSettingsOpenGLAdvanced_rows, {}, VSettingsOpenGLAdvanced_rules};

constexpr std::array<Row, 11> VSettingsOpenGL_rows{{
    {.name = "drawFaceNormals", .storage = Storage::boolean, .offset = offsetof(VSettingsOpenGL, drawFaceNormals), .role = Role::parameter},
    {.name = "drawNormalsLength", .storage = Storage::real, .offset = offsetof(VSettingsOpenGL, drawNormalsLength), .role = Role::parameter, .check = Check::positive, .unit = "m"},
    {.name = "drawVertexNormals", .storage = Storage::boolean, .offset = offsetof(VSettingsOpenGL, drawVertexNormals), .role = Role::parameter},
    {.name = "faceEdgesColor", .storage = Storage::vector4, .offset = offsetof(VSettingsOpenGL, faceEdgesColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "faceTransparencyGlobal", .storage = Storage::real, .offset = offsetof(VSettingsOpenGL, faceTransparencyGlobal), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "lightModelAmbient", .storage = Storage::vector4, .offset = offsetof(VSettingsOpenGL, lightModelAmbient), .role = Role::parameter, .unit = "1"},
    {.name = "lineWidth", .storage = Storage::real, .offset = offsetof(VSettingsOpenGL, lineWidth), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "materialShininess", .storage = Storage::real, .offset = offsetof(VSettingsOpenGL, materialShininess), .role = Role::parameter, .unit = "1"},
    {.name = "materialSpecular", .storage = Storage::vector4, .offset = offsetof(VSettingsOpenGL, materialSpecular), .role = Role::parameter, .unit = "1"},
    {.name = "multiSampling", .storage = Storage::integer, .offset = offsetof(VSettingsOpenGL, multiSampling), .role = Role::parameter, .check = Check::positive},
    {.name = "zMaxSceneFactor", .storage = Storage::real, .offset = offsetof(VSettingsOpenGL, zMaxSceneFactor), .role = Role::parameter, .check = Check::positive, .unit = "1"},
}};
constexpr std::array<SettingRule, 7> VSettingsOpenGL_rules{{
    {.name = "faceEdgesColor", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "lightModelAmbient", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "lineWidth", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "materialShininess", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "materialSpecular", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "multiSampling", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "zMaxSceneFactor", .no_effect = "nothing is too far away to be drawn"},
}};
constexpr std::array<SettingsChild, 5> VSettingsOpenGL_children{{
    {"advanced", &VSettingsOpenGLAdvanced_group, offsetof(VSettingsOpenGL, advanced)},
    {"light0", &VSettingsLight_group, offsetof(VSettingsOpenGL, light0)},
    {"light1", &VSettingsLight_group, offsetof(VSettingsOpenGL, light1)},
    {"light2", &VSettingsLight_group, offsetof(VSettingsOpenGL, light2)},
    {"light3", &VSettingsLight_group, offsetof(VSettingsOpenGL, light3)},
}};
constexpr SettingsGroup VSettingsOpenGL_group{"VSettingsOpenGL", VSettingsOpenGL_rows, VSettingsOpenGL_children, VSettingsOpenGL_rules};

constexpr std::array<Row, 7> VSettingsRaytracerAdvanced_rows{{
    {.name = "backgroundColorReflections", .storage = Storage::vector4, .offset = offsetof(VSettingsRaytracerAdvanced, backgroundColorReflections), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "searchTreeFactor", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracerAdvanced, searchTreeFactor), .role = Role::parameter, .check = Check::positive},
    {.name = "shadowScalingFactor", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracerAdvanced, shadowScalingFactor), .role = Role::parameter, .check = Check::non_negative},
    {.name = "shadowSmoothingSteps", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracerAdvanced, shadowSmoothingSteps), .role = Role::parameter, .check = Check::non_negative},
    {.name = "showText", .storage = Storage::boolean, .offset = offsetof(VSettingsRaytracerAdvanced, showText), .role = Role::parameter},
    {.name = "tilesPerThread", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracerAdvanced, tilesPerThread), .role = Role::parameter, .check = Check::positive},
    {.name = "zBiasLines", .storage = Storage::real, .offset = offsetof(VSettingsRaytracerAdvanced, zBiasLines), .role = Role::parameter, .unit = "1"},
}};
constexpr std::array<SettingRule, 3> VSettingsRaytracerAdvanced_rules{{
    {.name = "searchTreeFactor", .no_effect = "the tree follows from the shapes"},
    {.name = "shadowScalingFactor", .no_effect = "shadows are sampled as the image is"},
    {.name = "shadowSmoothingSteps", .no_effect = "shadows are sampled as the image is"},
}};
constexpr SettingsGroup VSettingsRaytracerAdvanced_group{"VSettingsRaytracerAdvanced", VSettingsRaytracerAdvanced_rows, {}, VSettingsRaytracerAdvanced_rules};

constexpr std::array<Row, 10> VSettingsRaytracer_rows{{
    {.name = "globalFogColor", .storage = Storage::vector4, .offset = offsetof(VSettingsRaytracer, globalFogColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "globalFogDensity", .storage = Storage::real, .offset = offsetof(VSettingsRaytracer, globalFogDensity), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "imageSizeFactor", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracer, imageSizeFactor), .role = Role::parameter, .check = Check::positive},
    {.name = "keepWindowActive", .storage = Storage::boolean, .offset = offsetof(VSettingsRaytracer, keepWindowActive), .role = Role::parameter},
    {.name = "lightRadiusVariations", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracer, lightRadiusVariations), .role = Role::parameter, .check = Check::positive},
    {.name = "maxReflectionDepth", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracer, maxReflectionDepth), .role = Role::parameter, .check = Check::non_negative},
    {.name = "maxTransparencyDepth", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracer, maxTransparencyDepth), .role = Role::parameter, .check = Check::non_negative},
    {.name = "multiSampling", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracer, multiSampling), .role = Role::parameter, .check = Check::positive},
    {.name = "numberOfThreads", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracer, numberOfThreads), .role = Role::parameter, .check = Check::positive},
    {.name = "verbose", .storage = Storage::integer, .offset = offsetof(VSettingsRaytracer, verbose), .role = Role::parameter, .check = Check::non_negative},
}};
constexpr std::array<SettingRule, 1> VSettingsRaytracer_rules{{
    {.name = "keepWindowActive", .no_effect = "images are made at once, and no window waits for them"},
}};
constexpr std::array<SettingsChild, 11> VSettingsRaytracer_children{{
    {"advanced", &VSettingsRaytracerAdvanced_group, offsetof(VSettingsRaytracer, advanced)},
    {"material0", &VSettingsMaterial_group, offsetof(VSettingsRaytracer, material0)},
    {"material1", &VSettingsMaterial_group, offsetof(VSettingsRaytracer, material1)},
    {"material2", &VSettingsMaterial_group, offsetof(VSettingsRaytracer, material2)},
    {"material3", &VSettingsMaterial_group, offsetof(VSettingsRaytracer, material3)},
    {"material4", &VSettingsMaterial_group, offsetof(VSettingsRaytracer, material4)},
    {"material5", &VSettingsMaterial_group, offsetof(VSettingsRaytracer, material5)},
    {"material6", &VSettingsMaterial_group, offsetof(VSettingsRaytracer, material6)},
    {"material7", &VSettingsMaterial_group, offsetof(VSettingsRaytracer, material7)},
    {"material8", &VSettingsMaterial_group, offsetof(VSettingsRaytracer, material8)},
    {"material9", &VSettingsMaterial_group, offsetof(VSettingsRaytracer, material9)},
}};
constexpr SettingsGroup VSettingsRaytracer_group{"VSettingsRaytracer", VSettingsRaytracer_rows, VSettingsRaytracer_children, VSettingsRaytracer_rules};

constexpr std::array<Row, 33> VSettingsGeneral_rows{{
    {.name = "autoFitScene", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, autoFitScene), .role = Role::parameter},
    {.name = "axesTiling", .storage = Storage::integer, .offset = offsetof(VSettingsGeneral, axesTiling), .role = Role::parameter, .check = Check::positive},
    {.name = "backgroundColor", .storage = Storage::vector4, .offset = offsetof(VSettingsGeneral, backgroundColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "backgroundColorBottom", .storage = Storage::vector4, .offset = offsetof(VSettingsGeneral, backgroundColorBottom), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "boundingBoxZoomAllFactor", .storage = Storage::real, .offset = offsetof(VSettingsGeneral, boundingBoxZoomAllFactor), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "boundingBoxZoomAllOffset", .storage = Storage::real, .offset = offsetof(VSettingsGeneral, boundingBoxZoomAllOffset), .role = Role::parameter, .check = Check::non_negative, .unit = "m"},
    {.name = "circleTiling", .storage = Storage::integer, .offset = offsetof(VSettingsGeneral, circleTiling), .role = Role::parameter, .check = Check::positive},
    {.name = "coordinateSystemSize", .storage = Storage::real, .offset = offsetof(VSettingsGeneral, coordinateSystemSize), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "cylinderTiling", .storage = Storage::integer, .offset = offsetof(VSettingsGeneral, cylinderTiling), .role = Role::parameter, .check = Check::positive},
    {.name = "graphicsUpdateInterval", .storage = Storage::real, .offset = offsetof(VSettingsGeneral, graphicsUpdateInterval), .role = Role::parameter, .check = Check::non_negative, .unit = "s"},
    {.name = "limitWindowToScreenSize", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, limitWindowToScreenSize), .role = Role::parameter},
    {.name = "linuxDisplayScaleFactor", .storage = Storage::real, .offset = offsetof(VSettingsGeneral, linuxDisplayScaleFactor), .role = Role::parameter, .check = Check::positive, .unit = "1"},
    {.name = "minSceneSize", .storage = Storage::real, .offset = offsetof(VSettingsGeneral, minSceneSize), .role = Role::parameter, .check = Check::positive, .unit = "m"},
    {.name = "pointSize", .storage = Storage::real, .offset = offsetof(VSettingsGeneral, pointSize), .role = Role::parameter, .check = Check::positive, .unit = "m"},
    {.name = "reallyQuitTimeLimit", .storage = Storage::real, .offset = offsetof(VSettingsGeneral, reallyQuitTimeLimit), .role = Role::parameter, .check = Check::non_negative, .unit = "s"},
    {.name = "rendererPrecision", .storage = Storage::integer, .offset = offsetof(VSettingsGeneral, rendererPrecision), .role = Role::parameter, .check = Check::positive},
    {.name = "rendererStartupTimeout", .storage = Storage::integer, .offset = offsetof(VSettingsGeneral, rendererStartupTimeout), .role = Role::parameter, .check = Check::positive},
    {.name = "renderWindowString", .storage = Storage::text, .offset = offsetof(VSettingsGeneral, renderWindowString), .role = Role::parameter},
    {.name = "showHelpOnStartup", .storage = Storage::integer, .offset = offsetof(VSettingsGeneral, showHelpOnStartup), .role = Role::parameter, .check = Check::non_negative},
    {.name = "showSolutionInformation", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, showSolutionInformation), .role = Role::parameter},
    {.name = "showSolverInformation", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, showSolverInformation), .role = Role::parameter},
    {.name = "showSolverTime", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, showSolverTime), .role = Role::parameter},
    {.name = "sphereTiling", .storage = Storage::integer, .offset = offsetof(VSettingsGeneral, sphereTiling), .role = Role::parameter, .check = Check::positive},
    {.name = "textAlwaysInFront", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, textAlwaysInFront), .role = Role::parameter},
    {.name = "textColor", .storage = Storage::vector4, .offset = offsetof(VSettingsGeneral, textColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "textHasBackground", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, textHasBackground), .role = Role::parameter},
    {.name = "textOffsetFactor", .storage = Storage::real, .offset = offsetof(VSettingsGeneral, textOffsetFactor), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "threadSafeGraphicsUpdate", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, threadSafeGraphicsUpdate), .role = Role::parameter},
    {.name = "useBitmapText", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, useBitmapText), .role = Role::parameter},
    {.name = "useGradientBackground", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, useGradientBackground), .role = Role::parameter},
    {.name = "useMultiThreadedRendering", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, useMultiThreadedRendering), .role = Role::parameter},
    {.name = "useWindowsDisplayScaleFactor", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, useWindowsDisplayScaleFactor), .role = Role::parameter},
    {.name = "zoomAllUseBoundingBox", .storage = Storage::boolean, .offset = offsetof(VSettingsGeneral, zoomAllUseBoundingBox), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 26> VSettingsGeneral_rules{{
    {.name = "backgroundColorBottom", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "boundingBoxZoomAllOffset", .no_effect = "the space around a system is a part of its size"},
    {.name = "circleTiling", .no_effect = "circles have 32 segments"},
    {.name = "coordinateSystemSize", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "limitWindowToScreenSize", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "linuxDisplayScaleFactor", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "minSceneSize", .no_effect = "sizes are parts of the system, however small it is"},
    {.name = "pointSize", .no_effect = "nodes are balls, in proportion to the scene"},
    {.name = "reallyQuitTimeLimit", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "rendererPrecision", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "rendererStartupTimeout", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "renderWindowString", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "showHelpOnStartup", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "showSolutionInformation", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "showSolverInformation", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "showSolverTime", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "sphereTiling", .no_effect = "spheres are round"},
    {.name = "textAlwaysInFront", .no_effect = "texts are always in front"},
    {.name = "textHasBackground", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "textOffsetFactor", .no_effect = "texts stand beside their points, by pixels"},
    {.name = "threadSafeGraphicsUpdate", .no_effect = "pictures always use a copy of the state"},
    {.name = "useBitmapText", .no_effect = "texts are drawn with a font of outlines"},
    {.name = "useGradientBackground", .no_effect_on_pages = "pages have lights, lines and words of their own"},
    {.name = "useMultiThreadedRendering", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "useWindowsDisplayScaleFactor", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "zoomAllUseBoundingBox", .no_effect = "zooming to all always uses the box around everything"},
}};
constexpr SettingsGroup VSettingsGeneral_group{"VSettingsGeneral", VSettingsGeneral_rows, {}, VSettingsGeneral_rules};

constexpr std::array<Row, 14> VSettingsInteractiveAdvanced_rows{{
    {.name = "highlightColor", .storage = Storage::vector4, .offset = offsetof(VSettingsInteractiveAdvanced, highlightColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "highlightOtherColor", .storage = Storage::vector4, .offset = offsetof(VSettingsInteractiveAdvanced, highlightOtherColor), .role = Role::parameter, .check = Check::color, .unit = "1"},
    {.name = "joystickScaleRotation", .storage = Storage::real, .offset = offsetof(VSettingsInteractiveAdvanced, joystickScaleRotation), .role = Role::parameter, .unit = "1"},
    {.name = "joystickScaleTranslation", .storage = Storage::real, .offset = offsetof(VSettingsInteractiveAdvanced, joystickScaleTranslation), .role = Role::parameter, .unit = "1"},
    {.name = "keypressRotationStep", .storage = Storage::real, .offset = offsetof(VSettingsInteractiveAdvanced, keypressRotationStep), .role = Role::parameter, .unit = "deg"},
    {.name = "keypressTranslationStep", .storage = Storage::real, .offset = offsetof(VSettingsInteractiveAdvanced, keypressTranslationStep), .role = Role::parameter, .unit = "1"},
    {.name = "mouseMoveRotationFactor", .storage = Storage::real, .offset = offsetof(VSettingsInteractiveAdvanced, mouseMoveRotationFactor), .role = Role::parameter, .unit = "deg"},
    {.name = "pauseWithSpacebar", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractiveAdvanced, pauseWithSpacebar), .role = Role::parameter},
    {.name = "selectionHighlights", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractiveAdvanced, selectionHighlights), .role = Role::parameter},
    {.name = "selectionLeftMouse", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractiveAdvanced, selectionLeftMouse), .role = Role::parameter},
    {.name = "selectionLeftMouseItemTypes", .storage = Storage::integer, .offset = offsetof(VSettingsInteractiveAdvanced, selectionLeftMouseItemTypes), .role = Role::parameter, .check = Check::non_negative},
    {.name = "selectionRightMouse", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractiveAdvanced, selectionRightMouse), .role = Role::parameter},
    {.name = "selectionRightMouseGraphicsData", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractiveAdvanced, selectionRightMouseGraphicsData), .role = Role::parameter},
    {.name = "zoomStepFactor", .storage = Storage::real, .offset = offsetof(VSettingsInteractiveAdvanced, zoomStepFactor), .role = Role::parameter, .unit = "1"},
}};
constexpr std::array<SettingRule, 4> VSettingsInteractiveAdvanced_rules{{
    {.name = "joystickScaleRotation", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "joystickScaleTranslation", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "mouseMoveRotationFactor", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "selectionRightMouse", .no_effect = "a click with either button shows the same"},
}};
constexpr SettingsGroup VSettingsInteractiveAdvanced_group{"VSettingsInteractiveAdvanced", VSettingsInteractiveAdvanced_rows, {}, VSettingsInteractiveAdvanced_rules};

constexpr std::array<Row, 4> VSettingsInteractiveOpenVR_rows{{
    {.name = "actionManifestFileName", .storage = Storage::text, .offset = offsetof(VSettingsInteractiveOpenVR, actionManifestFileName), .role = Role::parameter},
    {.name = "enable", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractiveOpenVR, enable), .role = Role::parameter},
    {.name = "logLevel", .storage = Storage::integer, .offset = offsetof(VSettingsInteractiveOpenVR, logLevel), .role = Role::parameter},
    {.name = "showCompanionWindow", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractiveOpenVR, showCompanionWindow), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 4> VSettingsInteractiveOpenVR_rules{{
    {.name = "actionManifestFileName", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "enable", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "logLevel", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "showCompanionWindow", .no_effect = "pages are in windows of the browser, with its mouse"},
}};
constexpr SettingsGroup VSettingsInteractiveOpenVR_group{"VSettingsInteractiveOpenVR", VSettingsInteractiveOpenVR_rows, {}, VSettingsInteractiveOpenVR_rules};

constexpr std::array<Row, 8> VSettingsInteractive_rows{{
    {.name = "autoRotateModelView", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractive, autoRotateModelView), .role = Role::parameter},
    {.name = "autoRotationVelocity", .storage = Storage::vector3, .offset = offsetof(VSettingsInteractive, autoRotationVelocity), .role = Role::parameter, .unit = "rad/s"},
    {.name = "highlightItemIndex", .storage = Storage::integer, .offset = offsetof(VSettingsInteractive, highlightItemIndex), .role = Role::parameter},
    {.name = "highlightItemType", .storage = Storage::enumeration, .offset = offsetof(VSettingsInteractive, highlightItemType), .role = Role::parameter, .enumeration = 5},
    {.name = "highlightMbsNumber", .storage = Storage::integer, .offset = offsetof(VSettingsInteractive, highlightMbsNumber), .role = Role::parameter, .check = Check::non_negative},
    {.name = "ignoreKeys", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractive, ignoreKeys), .role = Role::parameter},
    {.name = "logMouseCoordinates", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractive, logMouseCoordinates), .role = Role::parameter},
    {.name = "useJoystickInput", .storage = Storage::boolean, .offset = offsetof(VSettingsInteractive, useJoystickInput), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 4> VSettingsInteractive_rules{{
    {.name = "autoRotateModelView", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "autoRotationVelocity", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "logMouseCoordinates", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "useJoystickInput", .no_effect = "pages are in windows of the browser, with its mouse"},
}};
constexpr std::array<SettingsChild, 2> VSettingsInteractive_children{{
    {"advanced", &VSettingsInteractiveAdvanced_group, offsetof(VSettingsInteractive, advanced)},
    {"openVR", &VSettingsInteractiveOpenVR_group, offsetof(VSettingsInteractive, openVR)},
}};
constexpr SettingsGroup VSettingsInteractive_group{"VSettingsInteractive", VSettingsInteractive_rows, VSettingsInteractive_children, VSettingsInteractive_rules};

constexpr std::array<Row, 5> VSettingsDialogs_rows{{
    {.name = "alphaTransparency", .storage = Storage::real, .offset = offsetof(VSettingsDialogs, alphaTransparency), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "alwaysTopmost", .storage = Storage::boolean, .offset = offsetof(VSettingsDialogs, alwaysTopmost), .role = Role::parameter},
    {.name = "fontScalingMacOS", .storage = Storage::real, .offset = offsetof(VSettingsDialogs, fontScalingMacOS), .role = Role::parameter, .check = Check::non_negative, .unit = "1"},
    {.name = "multiThreadedDialogs", .storage = Storage::boolean, .offset = offsetof(VSettingsDialogs, multiThreadedDialogs), .role = Role::parameter},
    {.name = "openTreeView", .storage = Storage::boolean, .offset = offsetof(VSettingsDialogs, openTreeView), .role = Role::parameter},
}};
constexpr std::array<SettingRule, 5> VSettingsDialogs_rules{{
    {.name = "alphaTransparency", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "alwaysTopmost", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "fontScalingMacOS", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "multiThreadedDialogs", .no_effect = "pages are in windows of the browser, with its mouse"},
    {.name = "openTreeView", .no_effect = "pages are in windows of the browser, with its mouse"},
}};
constexpr SettingsGroup VSettingsDialogs_group{"VSettingsDialogs", VSettingsDialogs_rows, {}, VSettingsDialogs_rules};

constexpr std::array<Row, 11> VSettingsExportImages_rows{{
    {.name = "heightAlignment", .storage = Storage::integer, .offset = offsetof(VSettingsExportImages, heightAlignment), .role = Role::parameter, .check = Check::positive},
    {.name = "saveImageAsTextCircles", .storage = Storage::boolean, .offset = offsetof(VSettingsExportImages, saveImageAsTextCircles), .role = Role::parameter},
    {.name = "saveImageAsTextLines", .storage = Storage::boolean, .offset = offsetof(VSettingsExportImages, saveImageAsTextLines), .role = Role::parameter},
    {.name = "saveImageAsTextTexts", .storage = Storage::boolean, .offset = offsetof(VSettingsExportImages, saveImageAsTextTexts), .role = Role::parameter},
    {.name = "saveImageAsTextTriangles", .storage = Storage::boolean, .offset = offsetof(VSettingsExportImages, saveImageAsTextTriangles), .role = Role::parameter},
    {.name = "saveImageFileCounter", .storage = Storage::integer, .offset = offsetof(VSettingsExportImages, saveImageFileCounter), .role = Role::parameter, .check = Check::non_negative},
    {.name = "saveImageFileName", .storage = Storage::text, .offset = offsetof(VSettingsExportImages, saveImageFileName), .role = Role::parameter},
    {.name = "saveImageFormat", .storage = Storage::text, .offset = offsetof(VSettingsExportImages, saveImageFormat), .role = Role::parameter},
    {.name = "saveImageSingleFile", .storage = Storage::boolean, .offset = offsetof(VSettingsExportImages, saveImageSingleFile), .role = Role::parameter},
    {.name = "saveImageTimeOut", .storage = Storage::integer, .offset = offsetof(VSettingsExportImages, saveImageTimeOut), .role = Role::parameter, .check = Check::positive},
    {.name = "widthAlignment", .storage = Storage::integer, .offset = offsetof(VSettingsExportImages, widthAlignment), .role = Role::parameter, .check = Check::positive},
}};
constexpr std::array<SettingRule, 5> VSettingsExportImages_rules{{
    {.name = "saveImageAsTextCircles", .no_effect = "images are saved as PNG"},
    {.name = "saveImageAsTextLines", .no_effect = "images are saved as PNG"},
    {.name = "saveImageAsTextTexts", .no_effect = "images are saved as PNG"},
    {.name = "saveImageAsTextTriangles", .no_effect = "images are saved as PNG"},
    {.name = "saveImageTimeOut", .no_effect = "pages are in windows of the browser, with its mouse"},
}};
constexpr SettingsGroup VSettingsExportImages_group{"VSettingsExportImages", VSettingsExportImages_rows, {}, VSettingsExportImages_rules};

constexpr std::array<Row, 0> VisualizationSettings_rows{{
}};
constexpr std::array<SettingsChild, 18> VisualizationSettings_children{{
    {"nodes", &VSettingsNodes_group, offsetof(VisualizationSettings, nodes)},
    {"bodies", &VSettingsBodies_group, offsetof(VisualizationSettings, bodies)},
    {"connectors", &VSettingsConnectors_group, offsetof(VisualizationSettings, connectors)},
    {"markers", &VSettingsMarkers_group, offsetof(VisualizationSettings, markers)},
    {"loads", &VSettingsLoads_group, offsetof(VisualizationSettings, loads)},
    {"sensors", &VSettingsSensors_group, offsetof(VisualizationSettings, sensors)},
    {"contour", &VSettingsContour_group, offsetof(VisualizationSettings, contour)},
    {"contact", &VSettingsContact_group, offsetof(VisualizationSettings, contact)},
    {"view0", &VSettingsView_group, offsetof(VisualizationSettings, view0)},
    {"view1", &VSettingsView_group, offsetof(VisualizationSettings, view1)},
    {"view2", &VSettingsView_group, offsetof(VisualizationSettings, view2)},
    {"view3", &VSettingsView_group, offsetof(VisualizationSettings, view3)},
    {"openGL", &VSettingsOpenGL_group, offsetof(VisualizationSettings, openGL)},
    {"raytracer", &VSettingsRaytracer_group, offsetof(VisualizationSettings, raytracer)},
    {"general", &VSettingsGeneral_group, offsetof(VisualizationSettings, general)},
    {"interactive", &VSettingsInteractive_group, offsetof(VisualizationSettings, interactive)},
    {"dialogs", &VSettingsDialogs_group, offsetof(VisualizationSettings, dialogs)},
    {"exportImages", &VSettingsExportImages_group, offsetof(VisualizationSettings, exportImages)},
}};
constexpr SettingsGroup VisualizationSettings_group{"VisualizationSettings", VisualizationSettings_rows, VisualizationSettings_children};

}  // namespace

const SettingsGroup& visualization_settings_group() { return VisualizationSettings_group; }

}  // namespace dalembert
