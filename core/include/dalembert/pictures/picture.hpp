// Pictures without a display: triangles, spheres and lines are drawn into one buffer of samples, several per pixel,
// on one thread, so that the same scene gives the same bytes. Colors and normals are stored per sample and shaded
// once; transparent triangles are shaded when they are drawn, from back to front.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "dalembert/math/large_memory.hpp"
#include "dalembert/pictures/four.hpp"

namespace dalembert {

class Squares;

struct Point {
  float x = 0, y = 0, z = 0;
};

// Red, green, blue and opacity, from 0 to 1.
struct Paint {
  float r = 0, g = 0, b = 0, a = 1;
};

// The camera. Rows of `view` transform a point of the scene to eye coordinates: right, up, and away from the viewer,
// relative to the center of the picture. A unit length has `scale` pixels; with `perspective`, a point that is z
// further away is smaller by 1 + perspective * z.
struct Camera {
  std::array<double, 12> view{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0};
  double scale = 1;
  double perspective = 0;  // 1 / distance of the viewer; 0: parallel
};

struct Light {
  Point direction;  // towards the light, in eye coordinates, a unit vector
  float diffuse = 0, specular = 0;
};

struct Lighting {
  std::vector<Light> lights;
  float ambient = 1;
  float shininess = 32;
};

// Clipping plane: keeps a x + b y + c z + d >= 0, in eye coordinates.
struct Plane {
  float a, b, c, d;
};

struct Mesh {
  std::span<const double> points;    // 3 each
  std::span<const double> normals;  // 3 each, or empty: flat triangles
  std::span<const float> colors;     // 4 each
  std::span<const std::int32_t> triangles;  // 3 points each
  std::span<const std::int32_t> items;  // one number per triangle, for item_at
  bool is_smooth() const { return !normals.empty(); }
};

class Picture {
 public:
  Picture(int width, int height, int samples, const Camera& camera, const Lighting& lighting);
  ~Picture();
  Picture(const Picture&) = delete;
  Picture& operator=(const Picture&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }

  void background(const Paint& top, const Paint& bottom);
  void clip(const Plane& plane);  // for everything drawn from now on

  void triangles(const Mesh& mesh);
  // Centers 3, radii 1, colors 4 each.
  void spheres(std::span<const double> centers, std::span<const double> radii, std::span<const float> colors,
               std::span<const std::int32_t> items);
  // Segments: two points (6 numbers), one color and one item each; `lift` brings them towards the viewer, in lengths of the scene, so that edges
  // win against the faces that they bound.
  void lines(std::span<const double> segments, std::span<const float> colors, double width, double lift,
             std::span<const std::int32_t> items);

  // Light everything and average the samples: 3 bytes per pixel, the upper row first. Nothing is drawn afterwards.
  std::vector<std::uint8_t> develop();
  // The item in the middle of each pixel; -1: background.
  std::vector<std::int32_t> items() const;

 private:
  struct Vertex {
    Point place;  // x, y in samples, z: nearness
    bool inside = true;  // inside all planes, and finite
    std::uint32_t color = 0;
    Four normal{};  // normal in eye coordinates, and 1 / w, which multiplies all members, including the paint
    Four paint{};
    float weight() const { return normal[3]; }
  };
  struct Corner {  // before projection
    Point eye, normal;
    Paint paint;
  };
  using Three = std::array<Vertex, 3>;
  using Corners = std::array<const Vertex*, 3>;
  class Sides;
  class Plan;
  struct Unshaded;
  struct Sheet {  // a transparent triangle, drawn after everything behind it
    Three corners;
    float nearness;
    std::int32_t item;
  };

  struct Surface {  // color and normal, as samples keep them
    std::int32_t color, normal;
    bool operator==(const Surface&) const = default;
  };
  // immediately; one of several; all samples of a pixel, whose mean is kept
  enum class Lit : std::uint8_t { pixel, sample, all_samples };
  struct Waiting {  // a sample, or the first one of a pixel, and which surface it is
    std::size_t sample;
    std::uint32_t surface;
    int column;
    Lit lit;
  };

  struct Ball {
    float x, y, size;  // in samples
    float z, radius;  // in eye coordinates
    std::uint32_t color;
    std::int32_t item;
  };

  // buffers of a deleted picture, reused by the next one: allocating them takes a quarter of the time of a picture
  struct Memory {
    LargeVector<float> depth;
    LargeVector<std::uint32_t> color, normal;
    LargeVector<std::int32_t> item;
    LargeVector<Corner> corners;
    LargeVector<Vertex> vertices;
    LargeVector<std::uint32_t> order;
  };
  void exchange_memory();

  Point to_eye(const double* p) const;
  Point turned(const double* v) const;
  Vertex project(const Corner& corner) const;
  void project(const Mesh& mesh);
  float nearness(float z, float weight) const { return perspective_ > 0 ? weight : -z; }
  bool is_inside(const Point& eye) const;
  std::size_t row_start(int row) const { return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_); }
  bool has_squares() const { return samples_ == 2; }
  // Address of a sample: the four of a pixel are contiguous, upper ones first, if there are four; otherwise samples
  // are stored by rows.
  std::size_t sample(int column, int row) const {
    if (!has_squares()) return row_start(row) + static_cast<std::size_t>(column);
    return row_start(row & ~1) + static_cast<std::size_t>(2 * (column & ~1) + 2 * (row & 1) + (column & 1));
  }
  void begin();
  bool is_beside(const Corners& v) const;
  std::vector<float> farthest_of(const Squares& squares) const;
  void prefetch(const Squares& squares, std::size_t square) const;
  bool is_hidden(const Corners& v, const Squares& squares, const std::vector<float>& farthest) const;
  void clipped(const std::array<Corner, 3>& corners, std::int32_t item);
  void add(const Corners& corners, std::int32_t item);
  template <class Shade>
  void cover(const Corners& v, const Plan& plan, std::int32_t item, Shade&& shade);
  template <class Shade>
  void cover_squares(const Corners& v, const Plan& plan, std::int32_t item, Shade&& shade);
  template <class Shade>
  void shade_pixels(Unshaded& pixels, const Shade& shade);
  std::pair<Four, Four> spans(const Sides& sides, Four rows) const;
  void sphere(const Ball& ball);
  template <class Write>
  void walk(Point a, Point b, float half, Write&& write) const;
  void outline(int pixel_row);
  void outline_samples(int row);
  void outline_squares(int pixel_row);
  template <int Samples>
  bool join(std::size_t first);
  std::uint32_t join_squares(std::size_t first, int count);
  template <int Samples>
  void light(int pixel_row, std::uint8_t* pixels);
  void light_surfaces(std::size_t count);
  template <int Samples>
  std::uint32_t mean(std::size_t first) const;
  template <int Samples>
  std::vector<std::uint8_t> developed();
  void blend(const Sheet& sheet);
  float strength(const Point& normal, float& shine) const;

  int width_, height_, samples_, columns_, rows_;
  float scale_, perspective_;
  std::array<double, 12> view_;
  Lighting lighting_;
  std::vector<Point> halves_;  // half vectors of light and viewer, per light
  std::vector<float> shine_;         // power of the cosine, in a table
  std::vector<Plane> planes_;
  LargeVector<float> depth_;  // nearness of each sample; this and the next three are a few longer than the picture
  LargeVector<std::uint32_t> color_;  // bytes r, g, b, and 255 if it is to be lit
  // x and y of the unit normal towards the viewer, two bytes each; valid for covered samples
  LargeVector<std::uint32_t> normal_;
  LargeVector<std::int32_t> item_;
  LargeVector<Corner> corners_;  // corners of the current mesh
  LargeVector<Vertex> vertices_;
  LargeVector<std::uint32_t> order_;
  bool has_background_ = false;
  std::vector<Surface> surfaces_;  // the different ones of a row of pixels, one after the other
  std::vector<Waiting> waiting_;
  std::vector<Sheet> sheets_;
};

}  // namespace dalembert
