// Pictures by rays, of the same arrays as those of renderer.cpp.
#include "dalembert/pictures/ray_tracer.hpp"

#include <pybind11/stl.h>

#include <array>
#include <memory>
#include <tuple>
#include <vector>

#include "conversion.hpp"
#include "picture_arrays.hpp"
#include "system_container.hpp"

namespace dalembert {
namespace {

using Rgb = std::array<double, 3>;
Vec3<double> vector_of_rgb(const Rgb& c) { return {c[0], c[1], c[2]}; }

// Specular and emitted colors, shininess, reflectivity, index of refraction.
using RayMaterialRow = std::tuple<Rgb, Rgb, double, double, double>;
// Place or direction, whether it is at infinity; diffuse, specular, shadow, radius; attenuation.
using RayLightRow = std::tuple<Rgb, bool, std::array<double, 4>, Rgb>;

std::unique_ptr<RayTracer> new_tracer(int width, int height, const std::array<double, 12>& view, double scale,
                                      double perspective, const std::vector<RayLightRow>& lights,
                                      const std::vector<RayMaterialRow>& materials, const RayOptions& options) {
  if (width < 1 || height < 1 || width > 32768 || height > 32768)
    throw py::value_error("_RayTracer: sizes: expected 1 to 32768 pixels");
  if (materials.empty()) throw py::value_error("_RayTracer: materials: expected one at least");
  std::vector<RayLight> all_lights;
  for (const auto& [place, at_infinity, n, attenuation] : lights)
    all_lights.push_back({vector_of_rgb(place), at_infinity, n[0], n[1], n[2], n[3], attenuation});
  std::vector<RayMaterial> all_materials;
  for (const auto& [specular, emission, shininess, reflectivity, refraction] : materials)
    all_materials.push_back({vector_of_rgb(specular), vector_of_rgb(emission), shininess, reflectivity, refraction});
  return std::make_unique<RayTracer>(width, height, Camera{view, scale, perspective}, std::move(all_lights),
                                     std::move(all_materials), options);
}

void register_options(py::module_& module) {
  using O = RayOptions;
  const auto color = [](Vec3<double> O::* member) {
    return std::pair([member](const O& o) { return (o.*member).x; },
                     [member](O& o, const Rgb& c) { o.*member = vector_of_rgb(c); });
  };
  py::class_<O> options(module, "_RayOptions", "How far and how often rays go.");
  options.def(py::init<>());
  options.def_readwrite("samples", &O::samples)
      .def_readwrite("threads", &O::threads)
      .def_readwrite("tiles_per_thread", &O::tiles_per_thread);
  options.def_readwrite("reflections", &O::reflections).def_readwrite("transparencies", &O::transparencies);
  options.def_readwrite("light_places", &O::light_places)
      .def_readwrite("lift", &O::lift)
      .def_readwrite("ambient", &O::ambient);
  options.def_readwrite("fog_density", &O::fog_density);
  for (const auto& [name, member] : {std::pair("top", &O::top), std::pair("bottom", &O::bottom),
                                     std::pair("around", &O::around), std::pair("fog", &O::fog)}) {
    const auto [get, set] = color(member);
    options.def_property(name, get, set);
  }
}

}  // namespace

void register_ray_tracer(py::module_& module) {
  register_options(module);
  py::class_<RayTracer> tracer(module, "_RayTracer", "Triangles, spheres and lines, seen by rays of light.");
  tracer.def(py::init(&new_tracer), py::arg("width"), py::arg("height"), py::arg("view"), py::arg("scale"),
             py::arg("perspective"), py::arg("lights"), py::arg("materials"), py::arg("options"));
  tracer.def(
      "clip", [](RayTracer& t, const std::array<float, 4>& c) { t.clip({c[0], c[1], c[2], c[3]}); }, py::arg("plane"),
      "Clip the scene to a x + b y + c z + d >= 0, in eye coordinates.");
  tracer.def(
      "triangles",
      [](RayTracer& t, const Numbers<double>& points, const std::optional<Numbers<double>>& normals,
         const Numbers<float>& colors, const Numbers<std::int32_t>& triangles, const Numbers<std::int32_t>& materials) {
        const Mesh mesh = checked_mesh("_RayTracer", points, normals, colors, triangles);
        const auto numbers = each("_RayTracer", materials, mesh.triangles.size() / 3, 1, "materials");
        for (const std::int32_t i : numbers)
          if (i < 0 || i >= t.materials())
            throw py::index_error("_RayTracer: materials: there is no material " + std::to_string(i));
        t.triangles(mesh, numbers);
      },
      py::arg("points"), py::arg("normals").none(true), py::arg("colors"), py::arg("triangles"), py::arg("materials"),
      "Add a mesh; a material for each triangle.");
  tracer.def(
      "spheres",
      [](RayTracer& t, const Numbers<double>& centers, const Numbers<double>& radii, const Numbers<float>& colors) {
        const auto n = static_cast<std::size_t>(radii.size());
        t.spheres(each("_RayTracer", centers, n, 3, "centers"), all(radii), each("_RayTracer", colors, n, 4, "colors"));
      },
      py::arg("centers"), py::arg("radii"), py::arg("colors"), "Add spheres of the first material.");
  tracer.def(
      "lines",
      [](RayTracer& t, const Numbers<double>& segments, const Numbers<float>& colors, double width) {
        const auto n = static_cast<std::size_t>(segments.size()) / 6;
        t.lines(each("_RayTracer", segments, n, 6, "segments"), each("_RayTracer", colors, n, 4, "colors"), width);
      },
      py::arg("segments"), py::arg("colors"), py::arg("width"), "Add segments of a width in pixels.");
  tracer.def(
      "develop",
      [](RayTracer& t) {
        std::vector<std::uint8_t> bytes;
        {
          const py::gil_scoped_release free;
          bytes = t.develop();
        }
        return py::array_t<std::uint8_t>({t.height(), t.width(), 3}, bytes.data());
      },
      "The picture as an array of bytes, height x width x 3.");
}

}  // namespace dalembert
