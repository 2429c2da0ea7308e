# Generated from specs/ by codegen/templates/planned_table.py.j2. Do not edit; run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.
"""What the interface has and the package does not have yet."""

from typing import NamedTuple


class Planned(NamedTuple):
    """What it is for, what to do until it is there, and which members are planned if it is not the whole."""

    what: str
    instead: str
    members: tuple[str, ...]


ITEMS = (
    "NodeGenericAE",
)
MODULES: dict[str, Planned] = {
}
FUNCTIONS = {
    "SolverFileData": Planned('files of a solver', '', ()),
    "SolverLocalData": Planned('vectors and matrices of a solver', 'the state of the system is in mbs.systemData, and solvers have GetSystemJacobian and GetSystemMassMatrix', ()),
}
# Names that are left out, NAME.* with all members, and what there is instead.
LEFT_OUT = {
    'demos.DemoSolutionFile': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'demos.demoSolutionDirectory': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'interactive.ConfigureDialogColumns': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'interactive.ShowImage': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'interactive.openDialogs': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'misc.GUI.*': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'misc.keyBindings.*': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'plot.PlotWindowGeometries': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'plot.StorePlotWindowGeometry': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'python -m exudyn dialogs': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'Special.currentRendererSystemContainer': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'VisualizationSettings.dialogs.*': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'VisualizationSettings.general.displayScaleFactor': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'VisualizationSettings.view0.window.*': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'VisualizationSettings.view1.window.*': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'VisualizationSettings.view2.window.*': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'VisualizationSettings.view3.window.*': 'the page in the browser, SC.renderer.Start(); exu.special.userInterface keeps windows from opening',
    'Config.GetDefaults': 'settings in the model, which then has the same results on all machines',
    'Config.GetDictionary': 'settings in the model, which then has the same results on all machines',
    'Config.SetDictionary': 'settings in the model, which then has the same results on all machines',
    'EXUDYN_NO_USER_SETTINGS': 'settings in the model, which then has the same results on all machines',
    'Special.overrideSettings': 'settings in the model, which then has the same results on all machines',
    'misc.overrideSettings.*': 'settings in the model, which then has the same results on all machines',
    'special.overrideSettings': 'settings in the model, which then has the same results on all machines',
    'misc.settingsUtilities.*': 'GetDictionary() of settings; exu.GUI.Edit; the pages of the settings',
    'Special.deprecations': 'old and new names, both without a warning',
    'misc.deprecation.*': 'old and new names, both without a warning',
    'special.deprecations.*': 'old and new names, both without a warning',
    'EXUDYN_IMPORT_VERBOSE': 'dalembert info',
    'EXUDYN_MODULE': 'dalembert info',
    'misc.docmeta.*': 'dalembert info',
    'misc.extensionRegistry.*': 'dalembert info',
    'Renderer.GetGraphicsData': 'mbs.Draw, SC.renderer.RedrawAndSaveImage and the setting exportImages.saveImageFormat, whose text files PlotImage draws',
    'graphics.NGsolveMesh2PointsAndTrigs(triangles6)': 'mbs.Draw, SC.renderer.RedrawAndSaveImage and the setting exportImages.saveImageFormat, whose text files PlotImage draws',
    'FEM.FEMinterface.GetSurfaceTriangles6': 'mbs.Draw, SC.renderer.RedrawAndSaveImage and the setting exportImages.saveImageFormat, whose text files PlotImage draws',
    'plot.PlotImage(circleSegments)': 'mbs.Draw, SC.renderer.RedrawAndSaveImage and the setting exportImages.saveImageFormat, whose text files PlotImage draws',
    'plot.PlotImage(trianglesAsLines)': 'mbs.Draw, SC.renderer.RedrawAndSaveImage and the setting exportImages.saveImageFormat, whose text files PlotImage draws',
    'VisualizationSettings.bodies.shells.*': 'flat triangles, as many as the tiling settings say; normals, contours and frames as the other settings say',
    'VisualizationSettings.connectors.curveTiling': 'flat triangles, as many as the tiling settings say; normals, contours and frames as the other settings say',
    'VisualizationSettings.connectors.drawSimplified': 'flat triangles, as many as the tiling settings say; normals, contours and frames as the other settings say',
    'VisualizationSettings.markers.basisSize': 'flat triangles, as many as the tiling settings say; normals, contours and frames as the other settings say',
    'VisualizationSettings.markers.showBasis': 'flat triangles, as many as the tiling settings say; normals, contours and frames as the other settings say',
    'VisualizationSettings.openGL.advanced.curvedTriangleMaxTiling': 'flat triangles, as many as the tiling settings say; normals, contours and frames as the other settings say',
    'VisualizationSettings.openGL.advanced.curvedTriangleTilingAngle': 'flat triangles, as many as the tiling settings say; normals, contours and frames as the other settings say',
    'misc.resultsMonitor.*': 'dalembert monitor FILE, and resultsMonitor.Monitor',
    'interactive.ConvertImages2Video(videoCodec)': 'H.264; ffmpeg converts to other ones',
    'SpecialExceptions.parameterRangeChecks': 'ranges, which are always checked; exceptions, which a model may write to a file',
    'SpecialExceptions.writeErrorsToLogFile': 'ranges, which are always checked; exceptions, which a model may write to a file',
    'Special.beams': 'the strains of the item, see its page',
    'special.beams': 'the strains of the item, see its page',
    'GeneralContact.keepContactWhilePenetrating': 'events, and the discontinuous iteration, which decide from the state',
    'SolverOutputData.lastRestartWritten': 'the times in the restart file, which has the complete state',
    'SolverOutputData.restartTime': 'the times in the restart file, which has the complete state',
    'AccessFunctionType.JacobianTtimesVector_q': 'mbs.ComputeItem(item), which lists what can be computed',
    'AccessFunctionType.KinematicTree': 'mbs.ComputeItem(item), which lists what can be computed',
    'AccessFunctionType.OwnMarkersOnly': 'mbs.ComputeItem(item), which lists what can be computed',
    'AccessFunctionType.SuperElement': 'mbs.ComputeItem(item), which lists what can be computed',
    'FEM.PostProcessingModesFromStorage': 'SaveToFile and LoadFromFile of FEMinterface, which store them',
    'FEM.PostProcessingModesToStorage': 'SaveToFile and LoadFromFile of FEMinterface, which store them',
    'ObjectConnectorRollingDiscPenalty: HomogeneousTransformation': 'Position, VelocityLocal and ForceLocal of these items; the axes of contact are left-handed',
    'ObjectJointRollingDisc: HomogeneousTransformation': 'Position, VelocityLocal and ForceLocal of these items; the axes of contact are left-handed',
    'MainSystem.CreateCoordinateConstraint(bodyOrNodeList)': 'bodyNumbers or itemNumbers',
    'MainSystem.CreateGenericJoint(bodyOrNodeList)': 'bodyNumbers or itemNumbers',
    'MainSystem.CreatePrismaticJoint(bodyOrNodeList)': 'bodyNumbers or itemNumbers',
    'MainSystem.CreateRevoluteJoint(bodyOrNodeList)': 'bodyNumbers or itemNumbers',
    'MainSystem.CreateSphericalJoint(bodyOrNodeList)': 'bodyNumbers or itemNumbers',
    'MainSystem.CreateTorsionalSpringDamper(bodyOrNodeList)': 'bodyNumbers or itemNumbers',
    'SolverLocalData.*': 'mbs.systemData; GetSystemJacobian and GetSystemMassMatrix of solvers',
    'FEM.scipyInstalled': 'the functions of these modules',
    'FEM.useOldCSRformat': 'the functions of these modules',
    'FEM.warnedCSRtoScipySparseCSR': 'the functions of these modules',
    'FEM.warnedConvertDenseToCompressedRowMatrix': 'the functions of these modules',
    'advancedUtilities.specialExudynTypes': 'the functions of these modules',
    'graphics.graphicsDataNormalsFactor': 'the functions of these modules',
    'graphics.graphicsDataSwitchTriangleOrder': 'the functions of these modules',
    'kinematicTree.dictOfJointRotationMatrixAxis': 'the functions of these modules',
    'kinematicTree.dictOfJointTransformMotionSubspace66': 'the functions of these modules',
    'robotics.roboticsCore.buildFromDictionaryWarned': 'the functions of these modules',
    'robotics.roboticsCore.dictJointType2Axis': 'the functions of these modules',
    'robotics.roboticsCore.dictJointType2HT': 'the functions of these modules',
    'robotics.roboticsCore.dictJointType2coordinate6D': 'the functions of these modules',
    'robotics.roboticsCore.dictJointTypeText2Exudyn': 'the functions of these modules',
    'solver.solverCheckMemoryAllocations': 'the functions of these modules',
    'solver.solverCheckMemoryAllocationsThreshold': 'the functions of these modules',
}
