// SC.renderer, whose methods are written in Python (_pictures/renderer.py), and the pictures that it makes.
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <optional>
#include <tuple>

#include "conversion.hpp"
#include "picture_arrays.hpp"
#include "system_container.hpp"

namespace dalembert {
namespace {

using LightRow = std::tuple<std::array<float, 3>, float, float>;

std::unique_ptr<Picture> new_picture(int width, int height, int samples, const std::array<double, 12>& view,
                                     double scale, double perspective, const std::vector<LightRow>& lights,
                                     float ambient, float shininess) {
  if (width < 1 || height < 1 || samples < 1 || samples > 8 || width * samples > 32768 || height * samples > 32768)
    throw py::value_error("_Picture: sizes: expected 1 to 32768 samples in each direction, 1 to 8 for each pixel");
  Lighting lighting{{}, ambient, shininess};
  for (const auto& [d, diffuse, specular] : lights) lighting.lights.push_back({{d[0], d[1], d[2]}, diffuse, specular});
  return std::make_unique<Picture>(width, height, samples, Camera{view, scale, perspective}, lighting);
}

void draw_triangles(Picture& picture, const Numbers<double>& points, const std::optional<Numbers<double>>& normals,
                    const Numbers<float>& colors, const Numbers<std::int32_t>& triangles,
                    const Numbers<std::int32_t>& items) {
  Mesh mesh = checked_mesh("_Picture", points, normals, colors, triangles);
  mesh.items = each("_Picture", items, mesh.triangles.size() / 3, 1, "items");
  const py::gil_scoped_release free;
  picture.triangles(mesh);
}

void draw_spheres(Picture& picture, const Numbers<double>& centers, const Numbers<double>& radii,
                  const Numbers<float>& colors, const Numbers<std::int32_t>& items) {
  const auto n = static_cast<std::size_t>(radii.size());
  const auto c = each("_Picture", centers, n, 3, "centers");
  const auto paints = each("_Picture", colors, n, 4, "colors");
  const auto numbers = each("_Picture", items, n, 1, "items");
  const py::gil_scoped_release free;
  picture.spheres(c, all(radii), paints, numbers);
}

void draw_lines(Picture& picture, const Numbers<double>& segments, const Numbers<float>& colors, double width,
                double lift, const Numbers<std::int32_t>& items) {
  const auto n = static_cast<std::size_t>(segments.size()) / 6;
  const auto s = each("_Picture", segments, n, 6, "segments");
  const auto paints = each("_Picture", colors, n, 4, "colors");
  const auto numbers = each("_Picture", items, n, 1, "items");
  const py::gil_scoped_release free;
  picture.lines(s, paints, width, lift, numbers);
}

void register_picture(py::module_& module) {
  py::class_<Picture> picture(module, "_Picture", "Triangles, spheres and lines, drawn without a display.");
  picture.def(py::init(&new_picture), py::arg("width"), py::arg("height"), py::arg("samples"), py::arg("view"),
              py::arg("scale"), py::arg("perspective"), py::arg("lights"), py::arg("ambient"), py::arg("shininess"));
  const auto paint = [](const std::array<float, 4>& c) { return Paint{c[0], c[1], c[2], c[3]}; };
  picture.def(
      "background",
      [paint](Picture& p, const std::array<float, 4>& top, const std::array<float, 4>& bottom) {
        p.background(paint(top), paint(bottom));
      },
      py::arg("top"), py::arg("bottom"), "Fill the picture, before anything is drawn.");
  picture.def(
      "clip", [](Picture& p, const std::array<float, 4>& c) { p.clip({c[0], c[1], c[2], c[3]}); }, py::arg("plane"),
      "Draw from now on only where a x + b y + c z + d >= 0, in eye coordinates.");
  picture.def("triangles", &draw_triangles, py::arg("points"), py::arg("normals").none(true), py::arg("colors"),
              py::arg("triangles"), py::arg("items"), "Draw a mesh.");
  picture.def("spheres", &draw_spheres, py::arg("centers"), py::arg("radii"), py::arg("colors"), py::arg("items"),
              "Draw spheres.");
  picture.def("lines", &draw_lines, py::arg("segments"), py::arg("colors"), py::arg("width"), py::arg("lift"),
              py::arg("items"), "Draw segments of a width in pixels.");
  picture.def(
      "develop",
      [](Picture& p) {
        std::vector<std::uint8_t> bytes;
        {
          const py::gil_scoped_release free;
          bytes = p.develop();
        }
        return py::array_t<std::uint8_t>({p.height(), p.width(), 3}, bytes.data());
      },
      "The picture as an array of bytes, height x width x 3.");
  picture.def(
      "items", [](const Picture& p) { return py::array_t<std::int32_t>({p.height(), p.width()}, p.items().data()); },
      "The number of the item in each pixel; -1: background.");
}

}  // namespace

void register_renderer(py::module_& module) {
  py::class_<Renderer, std::shared_ptr<Renderer>> renderer(module, "Renderer",
                                                           "Makes pictures of the systems of a container.");
  renderer.def_readwrite("_state", &Renderer::state);
  renderer.def_property_readonly(
      "_container", [](const Renderer& r) { return r.container.lock(); },
      "The SystemContainer, or None if it is gone.");
  renderer.def_property(
      "materials",
      [](Renderer& r) {
        if (!r.materials) r.materials = core_module().attr("GraphicsMaterialList")();  // ten objects, for few scripts
        return r.materials;
      },
      [](Renderer& r, const py::object& materials) { r.materials = materials; });
  register_picture(module);
}

}  // namespace dalembert
