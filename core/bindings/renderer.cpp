// What scripts with graphics call. There is no renderer in this package: one notice per process says so.
#include <pybind11/stl.h>

#include "conversion.hpp"
#include "system_container.hpp"

namespace dalembert {
namespace {

using Container = py::class_<SystemContainer, std::shared_ptr<SystemContainer>>;

void notice_once() {
  static bool told = false;
  if (told) return;
  told = true;
  py::print("dalembert: there is no renderer; calls of SC.renderer do nothing.");
}

py::dict default_state() {
  const py::module_ numpy = py::module_::import("numpy");
  const py::object zeros3 = numpy.attr("zeros")(3), zeros2 = numpy.attr("zeros")(2);
  py::dict state;
  state["viewEnabled"] = false;
  state["windowOpen"] = false;
  state["centerPoint"] = zeros3;
  state["rotationCenterPoint"] = numpy.attr("zeros")(3);
  state["maxSceneSize"] = 1.0;
  state["zoom"] = 1.0;
  state["currentWindowSize"] = numpy.attr("array")(std::vector<int>{1024, 768});
  state["displayScaling"] = 1.0;
  state["modelRotation"] = numpy.attr("eye")(3);
  state["projectionMatrix"] = numpy.attr("eye")(4);
  state["mouseCoordinates"] = zeros2;
  state["openGLcoordinates"] = numpy.attr("zeros")(2);
  return state;
}

py::dict get_state(const Renderer& renderer) {
  py::dict state = default_state();
  for (const auto& [key, value] : renderer.state) state[key] = value;
  return state;
}

void set_state(Renderer& renderer, const py::dict& state) {
  for (const auto& [key, value] : state) renderer.state[key] = value;
}

// Accepts everything, gives `result`.
template <class Result>
auto nothing(Result result) {
  return [result](Renderer&, const py::args&, const py::kwargs&) { return result; };
}
auto nothing() {
  return [](Renderer&, const py::args&, const py::kwargs&) {};
}

}  // namespace

void register_renderer(py::module_& module) {
  py::class_<Renderer, std::shared_ptr<Renderer>> renderer(module, "Renderer", "Stands where a renderer would be; nothing is drawn.");
  renderer.def("Start", [](Renderer&, int) { notice_once(); return false; }, py::arg("verbose") = 0, "Returns False: nothing is shown.");
  for (const char* name : {"Stop", "EnableView", "DisableView", "ZoomAll", "SetModelView", "RedrawAndSaveImage", "SendRedrawSignal"})
    renderer.def(name, nothing(), "Does nothing.");
  for (const char* name : {"IsActive", "Attach", "Detach", "DoIdleTasks"})
    renderer.def(name, nothing(false), "Returns False: nothing is shown.");
  renderer.def("GetRenderCount", nothing(0), "0: nothing was drawn.");
  renderer.def("RedrawAndGetImage", [](Renderer&, const py::args&, const py::kwargs&) {
    notice_once();
    return py::module_::import("numpy").attr("zeros")(std::vector<int>{768, 1024, 3}, "uint8");
  }, "A black image.");
  renderer.def("GetState", [](const Renderer& r, int) { return get_state(r); }, py::arg("viewID") = 0, "The view, as SetState left it.");
  renderer.def("SetState", [](Renderer& r, const py::dict& state, bool, int) { set_state(r, state); }, py::arg("renderState"),
               py::arg("waitForRendererFullStartup") = true, py::arg("viewID") = 0, "Keep a view for GetState.");
  renderer.def("ResetState", [](Renderer& r) { r.state = py::dict(); }, "Forget the view.");
  renderer.def("GetMouseCoordinates", [](Renderer&, bool, int) { return std::vector<double>{0, 0}; },
               py::arg("useOpenGLcoordinates") = false, py::arg("viewID") = 0, "Zeros.");
  renderer.def("GetItemSelection", [](Renderer&, bool, int) { return py::make_tuple(-1, -1, -1, 0.0); },
               py::arg("resetSelection") = true, py::arg("viewID") = 0, "No selection.");
  renderer.def_property(
      "materials",
      [](Renderer& r) {
        if (!r.materials) r.materials = core_module().attr("GraphicsMaterialList")();  // ten objects, for few scripts
        return r.materials;
      },
      [](Renderer& r, const py::object& materials) { r.materials = materials; });
}

void register_renderer_shortcuts(Container& container) {
  container.def("GetRenderState", [](const SystemContainer& c) { return get_state(*c.renderer); }, "Earlier name of SC.renderer.GetState.");
  container.def("SetRenderState", [](SystemContainer& c, const py::dict& state) { set_state(*c.renderer, state); }, py::arg("renderState"),
                "Earlier name of SC.renderer.SetState.");
  for (const char* name : {"AttachToRenderEngine", "DetachFromRenderEngine", "WaitForRenderEngineStopFlag", "RedrawAndSaveImage",
                           "RenderEngineZoomAll", "SendRedrawSignal"})
    container.def(name, [](SystemContainer&, const py::args&, const py::kwargs&) { return false; }, "Does nothing: there is no renderer.");
  container.def("GetCurrentMouseCoordinates", [](SystemContainer&, bool) { return std::vector<double>{0, 0}; },
                py::arg("useOpenGLcoordinates") = false, "Zeros.");
}

}  // namespace dalembert
