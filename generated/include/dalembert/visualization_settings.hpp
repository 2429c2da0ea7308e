// Generated from specs/settings/visualization_settings.toml by codegen/templates/settings.hpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#pragma once

#include "dalembert/enums.hpp"
#include "dalembert/reflection/settings.hpp"
#include "dalembert/reflection/storage.hpp"

namespace dalembert {

// camera of a view
struct VSettingsViewCamera {
  Vec<double, 3> cameraPosition = {};
  double clippingPlaneDistance = 0.0;
  Vec<double, 3> clippingPlaneNormal = {};
  bool modelCentricView = true;
  Vec<double, 3> nearFarPlaneOffset = {};
  double perspective = 0.0;
  int trackMarker = -1;
  int trackMarkerMbsNumber = 0;
  Vec<double, 3> trackMarkerOrientation = {};
  Vec<double, 3> trackMarkerPosition = {1.0, 1.0, 1.0};
  bool useRaytracer = false;
};

// contents of a view
struct VSettingsViewScene {
  int drawCoordinateSystem = 2;
  bool drawWorldBasis = false;
  bool facesTransparent = false;
  bool showFaceEdges = false;
  bool showFaces = true;
  bool showLines = true;
  bool showMeshEdges = true;
  bool showMeshFaces = true;
  double worldBasisSize = 1.0;
};

// window of a view
struct VSettingsViewWindow {
  bool alwaysOnTop = false;
  double globalFontSize = 12.0;
  bool lockModelView = false;
  bool maximize = false;
  std::vector<int> renderWindowSize = {1024, 768};
  bool showComputationInfo = true;
  bool showMouseCoordinates = false;
  bool showRenderStateInfo = false;
  bool showWindow = true;
};

// a view of the model
struct VSettingsView {
  VSettingsViewCamera camera{};
  VSettingsViewScene scene{};
  VSettingsViewWindow window{};
};

// one light
struct VSettingsLight {
  double constantAttenuation = 1.0;
  double diffuse = 0.5;
  bool enable = true;
  double lightRadius = 0.1;
  double linearAttenuation = 0.0;
  Vec<double, 4> position = {2.0, 2.0, 10.0, 0.0};
  double quadraticAttenuation = 0.0;
  double shadow = 0.0;
  double specular = 0.5;
  bool useCameraFrame = false;
};

// a material of the ray tracer
struct VSettingsMaterial {
  double alpha = 1.0;
  Vec<double, 3> baseColor = {0.4, 0.4, 0.9};
  Vec<double, 3> emission = {};
  double ior = 1.0;
  std::string name = "default";
  double reflectivity = 0.0;
  double shininess = 32.0;
  Vec<double, 3> specular = {0.6, 0.6, 0.6};
};

// drawing of nodes
struct VSettingsNodes {
  double basisSize = 0.2;
  Vec<double, 4> defaultColor = {0.2, 0.2, 1.0, 1.0};
  double defaultSize = -1.0;
  bool drawNodesAsPoint = true;
  bool show = true;
  bool showBasis = false;
  int showNodalSlopes = 0;
  bool showNumbers = false;
  int tiling = 4;
};

// drawing of beams and cables
struct VSettingsBodiesBeams {
  int axialTiling = 8;
  bool crossSectionFilled = true;
  int crossSectionTiling = 4;
  bool drawVertical = false;
  Vec<double, 4> drawVerticalColor = {0.2, 0.2, 0.2, 1.0};
  double drawVerticalFactor = 1.0;
  bool drawVerticalLines = true;
  double drawVerticalOffset = 0.0;
  bool drawVerticalValues = false;
  bool reducedAxialInterploation = true;
};

// drawing of kinematic trees
struct VSettingsBodiesKinematicTree {
  double frameSize = 0.2;
  bool showCOMframes = false;
  bool showFramesNumbers = false;
  bool showJointFrames = true;
};

// drawing of plates and shells
struct VSettingsBodiesShells {
  bool drawSolid = true;
  double thicknessFactor = 1.0;
};

// drawing of bodies
struct VSettingsBodies {
  Vec<double, 4> defaultColor = {0.3, 0.3, 1.0, 1.0};
  Vec<double, 3> defaultSize = {1.0, 1.0, 1.0};
  double deformationScaleFactor = 1.0;
  bool show = true;
  bool showNumbers = false;
  VSettingsBodiesBeams beams{};
  VSettingsBodiesKinematicTree kinematicTree{};
  VSettingsBodiesShells shells{};
};

// drawing of connectors, joints and constraints
struct VSettingsConnectors {
  double contactPointsDefaultSize = 0.02;
  Vec<double, 4> defaultColor = {0.2, 0.2, 1.0, 1.0};
  double defaultSize = 0.1;
  double jointAxesLength = 0.2;
  double jointAxesRadius = 0.02;
  bool show = true;
  bool showContact = false;
  bool showJointAxes = false;
  bool showNumbers = false;
  int springNumberOfWindings = 8;
};

// drawing of markers
struct VSettingsMarkers {
  Vec<double, 4> defaultColor = {0.1, 0.5, 0.1, 1.0};
  double defaultSize = -1.0;
  bool drawSimplified = true;
  bool show = true;
  bool showNumbers = false;
};

// drawing of loads
struct VSettingsLoads {
  Vec<double, 4> defaultColor = {0.7, 0.1, 0.1, 1.0};
  double defaultRadius = 0.005;
  double defaultSize = 0.2;
  bool drawSimplified = true;
  bool drawWithUserFunction = true;
  bool fixedLoadSize = true;
  double loadSizeFactor = 0.1;
  bool show = true;
  bool showNumbers = false;
};

// traces of sensors in the render window
struct VSettingsSensorsTraces {
  double lineWidth = 2.0;
  std::vector<int> listOfPositionSensors;
  std::vector<int> listOfTriadSensors;
  std::vector<int> listOfVectorSensors;
  int positionsShowEvery = 1;
  int sensorsMbsNumber = 0;
  bool showCurrent = true;
  bool showFuture = false;
  bool showPast = true;
  bool showPositionTrace = false;
  bool showTriads = false;
  bool showVectors = false;
  double timeSpan = 0.0;
  std::vector<double> traceColors = {0.2, 0.2, 0.2, 1.0, 0.8, 0.2, 0.2, 1.0, 0.2, 0.8, 0.2, 1.0, 0.2, 0.2, 0.8, 1.0, 0.2, 0.8, 0.8, 1.0, 0.8, 0.2, 0.8, 1.0, 0.8, 0.4, 0.1, 1.0};
  double triadSize = 0.1;
  int triadsShowEvery = 1;
  double vectorScaling = 0.01;
  int vectorsShowEvery = 1;
};

// drawing of sensors
struct VSettingsSensors {
  Vec<double, 4> defaultColor = {0.6, 0.6, 0.1, 1.0};
  double defaultSize = -1.0;
  bool drawSimplified = true;
  bool show = true;
  bool showNumbers = false;
  VSettingsSensorsTraces traces{};
};

// color scale of contours
struct VSettingsContourAdvanced {
  int colorBarPrecision = 4;
  int colorBarTiling = 12;
  Vec<double, 4> contourColor0 = {0.1, 0.1, 0.9, 1.0};
  Vec<double, 4> contourColor1 = {0.1, 0.9, 0.9, 1.0};
  Vec<double, 4> contourColor2 = {0.1, 0.9, 0.1, 1.0};
  Vec<double, 4> contourColor3 = {0.9, 0.9, 0.1, 1.0};
  Vec<double, 4> contourColor4 = {0.9, 0.1, 0.1, 1.0};
  Vec<double, 4> contourColorMax = {0.9, 0.9, 0.9, 1.0};
  Vec<double, 4> contourColorMin = {0.1, 0.1, 0.1, 1.0};
  bool showColorBar = true;
};

// coloring by an output variable
struct VSettingsContour {
  double alphaTransparency = 1.0;
  bool automaticRange = true;
  double maxValue = 1.0;
  double minValue = 0.0;
  bool nodesColored = true;
  OutputVariableType outputVariable = OutputVariableType::_None;
  int outputVariableComponent = 0;
  bool reduceRange = true;
  bool rigidBodiesColored = true;
  VSettingsContourAdvanced advanced{};
};

// drawing of general contact
struct VSettingsContact {
  Vec<double, 4> colorBoundingBoxes = {0.9, 0.1, 0.1, 1.0};
  Vec<double, 4> colorSearchTree = {0.1, 0.1, 0.9, 1.0};
  Vec<double, 4> colorSpheres = {0.8, 0.5, 0.2, 1.0};
  Vec<double, 4> colorTori = {0.8, 0.2, 0.8, 1.0};
  Vec<double, 4> colorTriangles = {0.5, 0.5, 0.5, 1.0};
  double contactForcesFactor = 0.001;
  double contactPointsDefaultSize = 0.001;
  bool showBoundingBoxes = false;
  bool showContactForces = false;
  bool showContactForcesValues = false;
  bool showSearchTree = false;
  bool showSearchTreeCells = false;
  bool showSpheres = false;
  bool showTori = false;
  bool showTriangles = false;
  int tilingCurves = 8;
  int tilingSpheres = 4;
};

// OpenGL renderer: initial view, lighting and text
struct VSettingsOpenGLAdvanced {
  Vec<double, 4> clippingPlaneColor = {0.7, 0.5, 0.5, 0.0};
  bool depthSorting = false;
  bool enableLighting = true;
  Vec<double, 4> faceNormalsColor = {0.8, 0.2, 0.2, 1.0};
  Vec<double, 3> initialCenterPoint = {};
  double initialMaxSceneSize = 1.0;
  Mat<double, 3, 3> initialModelRotation = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  double initialZoom = 1.0;
  bool lightModelLocalViewer = false;
  bool lightModelTwoSide = false;
  bool lineSmooth = true;
  double polygonOffset = 0.05;
  bool shadeModelSmooth = true;
  double shadowPolygonOffset = 0.1;
  bool showBoundingBox = false;
  bool textLineSmooth = false;
  double textLineWidth = 1.0;
  Vec<double, 4> vertexNormalsColor = {0.8, 0.2, 0.2, 1.0};
};

// OpenGL renderer: faces, lines and material
struct VSettingsOpenGL {
  bool drawFaceNormals = false;
  double drawNormalsLength = 0.1;
  bool drawVertexNormals = false;
  Vec<double, 4> faceEdgesColor = {0.2, 0.2, 0.2, 1.0};
  double faceTransparencyGlobal = 0.4;
  Vec<double, 4> lightModelAmbient = {0.4, 0.4, 0.4, 1.0};
  double lineWidth = 1.0;
  double materialShininess = 32.0;
  Vec<double, 4> materialSpecular = {0.6, 0.6, 0.6, 1.0};
  int multiSampling = 1;
  double zMaxSceneFactor = 2.0;
  VSettingsOpenGLAdvanced advanced{};
  VSettingsLight light0{};
  VSettingsLight light1{.diffuse = 0.25, .position = {2.0, 2.0, -10.0, 0.0}, .specular = 0.25};
  VSettingsLight light2{.diffuse = 0.2, .enable = false, .specular = 0.2};
  VSettingsLight light3{.diffuse = 0.2, .enable = false, .specular = 0.2};
};

// software ray tracer: quality and speed
struct VSettingsRaytracerAdvanced {
  Vec<double, 4> backgroundColorReflections = {0.4, 0.4, 0.4, 1.0};
  int searchTreeFactor = 1;
  int shadowScalingFactor = 3;
  int shadowSmoothingSteps = 3;
  bool showText = true;
  int tilesPerThread = 12;
  double zBiasLines = 0.001;
};

// software ray tracer
struct VSettingsRaytracer {
  Vec<double, 4> globalFogColor = {0.5, 0.5, 0.5, 1.0};
  double globalFogDensity = 0.0;
  int imageSizeFactor = 1;
  bool keepWindowActive = false;
  int lightRadiusVariations = 1;
  int maxReflectionDepth = 2;
  int maxTransparencyDepth = 2;
  int multiSampling = 1;
  int numberOfThreads = 8;
  int verbose = 0;
  VSettingsRaytracerAdvanced advanced{};
  VSettingsMaterial material0{};
  VSettingsMaterial material1{.baseColor = {0.0, 1.0, 0.0}, .name = "matt", .shininess = 5.0, .specular = {0.3, 0.3, 0.3}};
  VSettingsMaterial material2{.baseColor = {0.6, 0.6, 0.6}, .name = "steel", .reflectivity = 0.1, .shininess = 25.0, .specular = {0.3, 0.33, 0.4}};
  VSettingsMaterial material3{.baseColor = {1.0, 0.0, 0.0}, .name = "plastic", .reflectivity = 0.1, .shininess = 20.0, .specular = {0.4, 0.45, 0.45}};
  VSettingsMaterial material4{.baseColor = {0.75, 0.75, 0.75}, .name = "chrome", .reflectivity = 0.25, .shininess = 60.0, .specular = {0.6, 0.62, 0.67}};
  VSettingsMaterial material5{.baseColor = {1.0, 0.5, 0.0}, .name = "shiny", .reflectivity = 0.5, .shininess = 100.0, .specular = {0.7, 0.65, 0.7}};
  VSettingsMaterial material6{.alpha = 0.3, .baseColor = {0.75, 0.75, 0.75}, .ior = 1.05, .name = "transparent", .shininess = 20.0, .specular = {0.4, 0.4, 0.45}};
  VSettingsMaterial material7{.alpha = 0.15, .baseColor = {0.8, 0.8, 0.8}, .ior = 1.5, .name = "glass", .reflectivity = 0.6, .shininess = 50.0, .specular = {0.6, 0.68, 0.63}};
  VSettingsMaterial material8{.baseColor = {0.8, 0.8, 0.8}, .name = "mirror", .reflectivity = 0.8, .shininess = 50.0, .specular = {0.4, 0.4, 0.4}};
  VSettingsMaterial material9{.baseColor = {0.85, 0.85, 0.7}, .emission = {0.8, 0.8, 0.7}, .name = "emission", .shininess = 20.0};
};

// general settings of drawing and window
struct VSettingsGeneral {
  bool autoFitScene = true;
  int axesTiling = 12;
  Vec<double, 4> backgroundColor = {1.0, 1.0, 1.0, 1.0};
  Vec<double, 4> backgroundColorBottom = {0.8, 0.8, 1.0, 1.0};
  double boundingBoxZoomAllFactor = 1.2;
  double boundingBoxZoomAllOffset = 0.01;
  int circleTiling = 16;
  double coordinateSystemSize = 5.0;
  int cylinderTiling = 16;
  double graphicsUpdateInterval = 0.1;
  bool limitWindowToScreenSize = true;
  double linuxDisplayScaleFactor = 1.0;
  double minSceneSize = 0.1;
  double pointSize = 0.01;
  double reallyQuitTimeLimit = 900.0;
  int rendererPrecision = 4;
  int rendererStartupTimeout = 2500;
  std::string renderWindowString = "";
  int showHelpOnStartup = 5;
  bool showSolutionInformation = true;
  bool showSolverInformation = true;
  bool showSolverTime = true;
  int sphereTiling = 6;
  bool textAlwaysInFront = true;
  Vec<double, 4> textColor = {0.0, 0.0, 0.0, 1.0};
  bool textHasBackground = false;
  double textOffsetFactor = 0.005;
  bool threadSafeGraphicsUpdate = true;
  bool useBitmapText = true;
  bool useGradientBackground = false;
  bool useMultiThreadedRendering = true;
  bool useWindowsDisplayScaleFactor = true;
  bool zoomAllUseBoundingBox = true;
};

// highlighting, selection, and speed of keys and mouse
struct VSettingsInteractiveAdvanced {
  Vec<double, 4> highlightColor = {0.8, 0.05, 0.05, 0.75};
  Vec<double, 4> highlightOtherColor = {0.5, 0.5, 0.5, 0.4};
  double joystickScaleRotation = 200.0;
  double joystickScaleTranslation = 6.0;
  double keypressRotationStep = 5.0;
  double keypressTranslationStep = 0.1;
  double mouseMoveRotationFactor = 1.0;
  bool pauseWithSpacebar = true;
  bool selectionHighlights = true;
  bool selectionLeftMouse = true;
  int selectionLeftMouseItemTypes = 31;
  bool selectionRightMouse = true;
  bool selectionRightMouseGraphicsData = false;
  double zoomStepFactor = 1.15;
};

// virtual reality by OpenVR
struct VSettingsInteractiveOpenVR {
  std::string actionManifestFileName = "C:/openVRactionsManifest.json";
  bool enable = false;
  int logLevel = 1;
  bool showCompanionWindow = true;
};

// interaction with the render window
struct VSettingsInteractive {
  bool autoRotateModelView = false;
  Vec<double, 3> autoRotationVelocity = {0.0, 0.0, 1.047198};
  int highlightItemIndex = -1;
  ItemTypeCode highlightItemType = ItemTypeCode::_None;
  int highlightMbsNumber = 0;
  bool ignoreKeys = false;
  bool logMouseCoordinates = true;
  bool useJoystickInput = true;
  VSettingsInteractiveAdvanced advanced{};
  VSettingsInteractiveOpenVR openVR{};
};

// dialogs
struct VSettingsDialogs {
  double alphaTransparency = 0.94;
  bool alwaysTopmost = true;
  double fontScalingMacOS = 1.35;
  bool multiThreadedDialogs = true;
  bool openTreeView = false;
};

// export of images
struct VSettingsExportImages {
  int heightAlignment = 2;
  bool saveImageAsTextCircles = true;
  bool saveImageAsTextLines = true;
  bool saveImageAsTextTexts = false;
  bool saveImageAsTextTriangles = false;
  int saveImageFileCounter = 0;
  std::string saveImageFileName = "images/frame";
  std::string saveImageFormat = "PNG";
  bool saveImageSingleFile = false;
  int saveImageTimeOut = 5000;
  int widthAlignment = 4;
};

// settings of the renderer
struct VisualizationSettings {
  VSettingsNodes nodes{};
  VSettingsBodies bodies{};
  VSettingsConnectors connectors{};
  VSettingsMarkers markers{};
  VSettingsLoads loads{};
  VSettingsSensors sensors{};
  VSettingsContour contour{};
  VSettingsContact contact{};
  VSettingsView view0{};
  VSettingsView view1{};
  VSettingsView view2{};
  VSettingsView view3{};
  VSettingsOpenGL openGL{};
  VSettingsRaytracer raytracer{};
  VSettingsGeneral general{};
  VSettingsInteractive interactive{};
  VSettingsDialogs dialogs{};
  VSettingsExportImages exportImages{};
};

// Rows of VisualizationSettings and of all structures in it.
const SettingsGroup& visualization_settings_group();

}  // namespace dalembert
