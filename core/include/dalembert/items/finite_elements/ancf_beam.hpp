// ObjectANCFBeam, specs/finite_elements/ancf_beam.toml
#pragma once

#include "dalembert/contracts/strain_points.hpp"
#include "dalembert/finite_elements/ancf_beam_parameters.hpp"
#include "dalembert/items/nodes/slopes.hpp"

namespace dalembert {

struct ObjectANCFBeam : NoDoubt {
  using Parameters = ObjectANCFBeamParameters;
  static constexpr int size = 18, node_size = 9;
  static constexpr bool constant_mass = true, constant_jacobian = false, oriented = true;
  using Axes = AxesOfSection;

  static void check(const Parameters& p, const ItemLabel& item) { check_element_length(p.physicsLength, item); }

  // Masses per direction: of the axis, of both slopes, and their coupling.
  struct SectionMass {
    double axis = 0, slope_y = 0, slope_z = 0, between = 0;
    bool operator==(const SectionMass&) const = default;
  };
  struct Constants {
    double length = 1;
    Mat<double, 6, 6> stiffness, damping;
    Mat3<double> section_stiffness, section_damping;
    SectionMass mass;
    bool operator==(const Constants&) const = default;
  };
  static Constants constants(const Parameters& p) {
    const BeamSection& s = p.sectionData;
    const double axial = s.stiffnessMatrix(0, 0), shear = s.stiffnessMatrix(1, 1) + s.stiffnessMatrix(2, 2);
    const auto against_deformation = [&](const Vec3<double>& f) {
      return Mat3<double>{axial * f[0], 0, 0, 0, axial * f[1], 0, 0, 0, shear * f[2]};
    };
    const double l = p.physicsLength;
    return {l,
            s.stiffnessMatrix,
            s.dampingMatrix,
            against_deformation(p.crossSectionPenaltyFactor),
            against_deformation(p.crossSectionDamping),
            {l * s.massPerLength, l * s.inertia(2, 2), l * s.inertia(1, 1), -l * s.inertia(1, 2)}};
  }
  static bool calls(const Parameters&) { return false; }
  static bool damped(const Constants& k) {
    return k.damping != Mat<double, 6, 6>{} || k.section_damping != Mat3<double>{};
  }
  static double along(const Constants& k, const Vec3<double>& local) { return 0.5 + local[0] / k.length; }

  // The chord (r1 - r0) / L, and both slopes at both nodes.
  struct Map : NoLieRotations {
    static constexpr int dimension = 3, vectors = 5, size = 18;
    static constexpr bool linear = true, derives = true;

    template <class S>
    static Vectors<S, 3, 5> local(const Constants& k, const Coordinates<S, size>& x) {
      return of_vector(k, x.q);
    }
    template <class S>
    static Vectors<S, 3, 5> local_rate(const Constants& k, const Coordinates<S, size>& x) {
      return of_vector(k, x.v);
    }
    template <class S>
    static Vec<S, size> pull_back(const Constants& k, const Coordinates<S, size>&, const Vectors<S, 3, 5>& g) {
      return vector_of<size>([&](int i) { return share(i / 3, k.length) * g[vector(i / 3)][i % 3]; });
    }
    template <class T>
    static Mat<T, size, size> tangent(const Constants& k, const Coordinates<T, size>&, const Vectors<T, 3, 5>&,
                                      const Mat<T, 15, 15>& m, const Mat<T, 15, 15>&, const Weights&) {
      return matrix_of<size, size>([&](int i, int j) {
        return (share(i / 3, k.length) * share(j / 3, k.length)) *
               m(3 * vector(i / 3) + i % 3, 3 * vector(j / 3) + j % 3);
      });
    }

   private:
    // Vectors r, r_y, r_z at the first node, then at the second.
    static constexpr int vector(int i) { return i % 3 == 0 ? 0 : i < 3 ? i : i - 1; }
    static constexpr double share(int i, double length) { return i == 0 ? -1 / length : i == 3 ? 1 / length : 1.0; }
    template <class S>
    static Vectors<S, 3, 5> of_vector(const Constants& k, const Vec<S, size>& q) {
      const auto part = [&](int i) { return segment<3>(q, 3 * i); };
      return {(1 / k.length) * (part(3) - part(0)), part(1), part(2), part(4), part(5)};
    }
  };

  // Strains and curvatures in section axes, from r', r_y, r_z, L r_y', L r_z'.
  struct Bending {
    static constexpr int fields = 5, strains = 6, stresses = 6;
    using Shape = ShapeNumbers<5, 5>;
    static constexpr bool uses(int field, int vector) {
      return field == 0 ? vector == 0 : vector > 0 && vector % 2 == field % 2;
    }
    static constexpr Shape shape(double xi) {
      return {{{1, 0, 0, 0, 0}, {0, 1 - xi, 0, xi, 0}, {0, 0, 1 - xi, 0, xi}, {0, -1, 0, 1, 0}, {0, 0, -1, 0, 1}}};
    }
    static const auto& points(const Constants&) {
      static constexpr StrainPoints<Shape> middle = tabulated<Shape>(gauss_1, &Bending::shape);
      return middle;
    }
    static const auto& stiffness(const Constants& k) { return k.stiffness; }
    static const auto& damping(const Constants& k) { return k.damping; }
    static Vec<double, 6> stress_free(const Parameters&, const Vec<double, 6>& of_reference) { return of_reference; }

    template <class S>
    static Vec<S, 6> strain(const Constants& k, const Vectors<S, 3, 5>& at) {
      const auto frame = Axes::frame(at[1], at[2]);
      const Mat3<S> rotation = Axes::rotation(frame);
      return joined(transposed_times(rotation, at[0]),
                    transposed_times(rotation, Vec3<S>((1 / k.length) * Axes::spin(frame, at[3], at[4]))));
    }
    // The moment acts on the frame along the axis, and so on slopes and their derivatives; so does the force, which
    // rotates with it.
    template <class S>
    static Vectors<S, 3, 5> pull_back(const Constants& k, const Vectors<S, 3, 5>& at, const Vec<S, 6>& stress) {
      const auto frame = Axes::frame(at[1], at[2]);
      const Mat3<S> rotation = Axes::rotation(frame);
      const Vec3<S> force = rotation * segment<3>(stress, 0),
                    moment = (1 / k.length) * (rotation * segment<3>(stress, 3));
      const auto turn = Axes::pull_back(frame, cross(force, at[0])), bend = Axes::pull_back(frame, moment),
                 bend_rate = Axes::pull_back_rate(frame, moment, at[3], at[4]);
      return {force, turn[0] + bend_rate[0], turn[1] + bend_rate[1], bend[0], bend[1]};
    }
  };
  // Deformation of the section: (r_y r_y - 1) / 2, (r_z r_z - 1) / 2 and r_y r_z / 2, at the nodes.
  struct Thickness {
    static constexpr int fields = 2, strains = 3, stresses = 3;
    using Shape = ShapeNumbers<2, 5>;
    static constexpr bool uses(int field, int vector) { return Bending::uses(field + 1, vector); }
    static constexpr Shape shape(double xi) { return {{{0, 1 - xi, 0, xi, 0}, {0, 0, 1 - xi, 0, xi}}}; }
    static const auto& points(const Constants&) {
      static constexpr StrainPoints<Shape> ends = tabulated<Shape>(lobatto_2, &Thickness::shape);
      return ends;
    }
    static const auto& stiffness(const Constants& k) { return k.section_stiffness; }
    static const auto& damping(const Constants& k) { return k.section_damping; }
    static Vec3<double> stress_free(const Parameters&, const Vec3<double>& of_reference) { return of_reference; }
    template <class S>
    static Vec3<S> strain(const Constants&, const Vectors<S, 3, 2>& at) {
      return {0.5 * (dot(at[0], at[0]) - 1.0), 0.5 * (dot(at[1], at[1]) - 1.0), 0.5 * dot(at[0], at[1])};
    }
    template <class S>
    static Vectors<S, 3, 2> pull_back(const Constants&, const Vectors<S, 3, 2>& at, const Vec3<S>& stress) {
      const S between = 0.5 * stress[2];
      return {stress[0] * at[0] + between * at[1], stress[1] * at[1] + between * at[0]};
    }
  };
  using Families = std::tuple<Bending, Thickness>;
  using CallingFamilies = Families;

  template <class S>
  static Vec<S, size> inertia(const Constants& k, const Coordinates<S, size>& x) {
    return vector_of<size>([&](int row) {
      S sum(0.0);
      for (int j = 0; j < 6; ++j)
        if (const double m = mass(k.mass, row / 3, j); m != 0) sum += m * x.a[3 * j + row % 3];
      return sum;
    });
  }
  template <class T>
  static void add_inertia_tangent(const Constants& k, const Coordinates<T, size>&, const Weights& w,
                                  Mat<T, size, size>& m) {
    for (int i = 0; i < size; ++i)
      for (int j = i % 3; j < size; j += 3) m(i, j) = m(i, j) + w.a * mass(k.mass, i / 3, j / 3);
  }
  template <class S>
  static Vec<S, size> mass_load(const Parameters& p, const Coordinates<S, size>&, const Vec3<S>& g) {
    const double half = 0.5 * p.physicsLength * p.sectionData.massPerLength;
    return vector_of<size>([&](int i) { return i % 9 < 3 ? S(half * g[i % 3]) : S(0); });
  }

  // Linear in the local position; the frame is that of the slopes.
  template <class S>
  static Motion<S> motion(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local) {
    const double xi = 0.5 + local[0] / p.physicsLength;
    const auto at = [&](const Vec<S, size>& q, int first) {
      return (1 - xi) * segment<3>(q, first) + xi * segment<3>(q, 9 + first);
    };
    const auto all = [&](int first) { return std::array{at(x.q, first), at(x.v, first), at(x.a, first)}; };
    const auto axis = all(0), slope_y = all(3), slope_z = all(6);
    const auto point = [&](int i) { return axis[i] + local[1] * slope_y[i] + local[2] * slope_z[i]; };
    Motion<S> m{.position = point(0), .velocity = point(1), .acceleration = point(2)};
    turn_with_slopes<Axes>(m, slope_y, slope_z);
    return m;
  }
  template <class S>
  static Vec<S, size> pull_back(const Parameters& p, const Coordinates<S, size>& x, const Vec3<double>& local,
                                const Vec3<S>& force, const Vec3<S>& moment) {
    const double xi = 0.5 + local[0] / p.physicsLength;
    const auto slope = [&](int first) { return (1 - xi) * segment<3>(x.q, first) + xi * segment<3>(x.q, 9 + first); };
    const auto couple = Axes::pull_back(Axes::frame(slope(3), slope(6)), moment);
    const Vectors<S, 3, 3> on{force, local[1] * force + couple[0], local[2] * force + couple[1]};
    return vector_of<size>([&](int i) { return (i < 9 ? 1 - xi : xi) * on[i / 3 % 3][i % 3]; });
  }

  template <class Section>
  static bool output(const Section&, std::vector<double>&) {
    return false;  // all of them follow from the motion
  }

 private:
  // Mass between vectors i and j of r, r_y, r_z at both nodes, which are linear along the axis.
  static double mass(const SectionMass& m, int i, int j) {
    const int a = i % 3, b = j % 3;
    const double share = i / 3 == j / 3 ? 1. / 3 : 1. / 6;
    if (a != b) return a > 0 && b > 0 ? share * m.between : 0;
    return share * (a == 0 ? m.axis : a == 1 ? m.slope_y : m.slope_z);
  }
};

}  // namespace dalembert
