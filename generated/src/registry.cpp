// Generated from specs/ by codegen/templates/registry.cpp.j2. Do not edit;
// run `python -m codegen`. tests/codegen/test_freshness.py compares this file with its sources.
#include <array>

#include "dalembert/reflection/own_items.hpp"

namespace dalembert {

extern const ItemType node_generic_ae_type;
extern const ItemType node_generic_data_type;
extern const ItemType node_generic_ode1_type;
extern const ItemType node_generic_ode2_type;
extern const ItemType node_1d_type;
extern const ItemType node_point_type;
extern const ItemType node_point_2d_type;
extern const ItemType node_point_2d_slope1_type;
extern const ItemType node_point_ground_type;
extern const ItemType node_point_slope1_type;
extern const ItemType node_point_slope12_type;
extern const ItemType node_point_slope23_type;
extern const ItemType node_rigid_body_2d_type;
extern const ItemType node_rigid_body_ep_type;
extern const ItemType node_rigid_body_rot_vec_lg_type;
extern const ItemType node_rigid_body_rxyz_type;
extern const ItemType object_generic_ode1_type;
extern const ItemType object_ground_type;
extern const ItemType object_mass_1d_type;
extern const ItemType object_mass_point_type;
extern const ItemType object_mass_point_2d_type;
extern const ItemType object_rigid_body_type;
extern const ItemType object_rigid_body_2d_type;
extern const ItemType object_rotational_mass_1d_type;
extern const ItemType object_ffrf_type;
extern const ItemType object_ffrf_reduced_order_type;
extern const ItemType object_generic_ode2_type;
extern const ItemType object_kinematic_tree_type;
extern const ItemType object_ale_ancf_cable_2d_type;
extern const ItemType object_ancf_beam_type;
extern const ItemType object_ancf_cable_type;
extern const ItemType object_ancf_cable_2d_type;
extern const ItemType object_ancf_thin_plate_type;
extern const ItemType object_beam_geometrically_exact_type;
extern const ItemType object_beam_geometrically_exact_2d_type;
extern const ItemType object_connector_cartesian_spring_damper_type;
extern const ItemType object_connector_coordinate_spring_damper_type;
extern const ItemType object_connector_coordinate_spring_damper_ext_type;
extern const ItemType object_connector_gravity_type;
extern const ItemType object_connector_hydraulic_actuator_simple_type;
extern const ItemType object_connector_law_type;
extern const ItemType object_connector_linear_spring_damper_type;
extern const ItemType object_connector_reeving_system_springs_type;
extern const ItemType object_connector_rigid_body_spring_damper_type;
extern const ItemType object_connector_rolling_disc_penalty_type;
extern const ItemType object_connector_spring_damper_type;
extern const ItemType object_connector_torsional_spring_damper_type;
extern const ItemType object_connector_coordinate_type;
extern const ItemType object_connector_coordinate_vector_type;
extern const ItemType object_connector_distance_type;
extern const ItemType object_contact_circle_cable_2d_type;
extern const ItemType object_contact_convex_roll_type;
extern const ItemType object_contact_coordinate_type;
extern const ItemType object_contact_curve_circles_type;
extern const ItemType object_contact_friction_circle_cable_2d_type;
extern const ItemType object_contact_sphere_sphere_type;
extern const ItemType object_contact_sphere_torus_type;
extern const ItemType object_contact_sphere_triangle_type;
extern const ItemType object_joint_ale_moving_2d_type;
extern const ItemType object_joint_generic_type;
extern const ItemType object_joint_prismatic_2d_type;
extern const ItemType object_joint_prismatic_x_type;
extern const ItemType object_joint_revolute_2d_type;
extern const ItemType object_joint_revolute_z_type;
extern const ItemType object_joint_rolling_disc_type;
extern const ItemType object_joint_sliding_type;
extern const ItemType object_joint_sliding_2d_type;
extern const ItemType object_joint_spherical_type;
extern const ItemType marker_bodies_relative_rotation_coordinate_type;
extern const ItemType marker_bodies_relative_translation_coordinate_type;
extern const ItemType marker_body_beam_shape_type;
extern const ItemType marker_body_cable_2d_coordinates_type;
extern const ItemType marker_body_cable_2d_shape_type;
extern const ItemType marker_body_mass_type;
extern const ItemType marker_body_position_type;
extern const ItemType marker_body_rigid_type;
extern const ItemType marker_kinematic_tree_rigid_type;
extern const ItemType marker_node_coordinate_type;
extern const ItemType marker_node_coordinates_type;
extern const ItemType marker_node_ode1_coordinate_type;
extern const ItemType marker_node_position_type;
extern const ItemType marker_node_rigid_type;
extern const ItemType marker_node_rotation_coordinate_type;
extern const ItemType marker_object_ode2_coordinates_type;
extern const ItemType marker_super_element_position_type;
extern const ItemType marker_super_element_rigid_type;
extern const ItemType load_coordinate_type;
extern const ItemType load_force_vector_type;
extern const ItemType load_mass_proportional_type;
extern const ItemType load_torque_vector_type;
extern const ItemType sensor_body_type;
extern const ItemType sensor_kinematic_tree_type;
extern const ItemType sensor_load_type;
extern const ItemType sensor_marker_type;
extern const ItemType sensor_node_type;
extern const ItemType sensor_object_type;
extern const ItemType sensor_super_element_type;
extern const ItemType sensor_user_function_type;

std::span<const ItemType* const> own_item_types() {
  static constexpr std::array<const ItemType*, 98> types{
      &node_generic_ae_type,
      &node_generic_data_type,
      &node_generic_ode1_type,
      &node_generic_ode2_type,
      &node_1d_type,
      &node_point_type,
      &node_point_2d_type,
      &node_point_2d_slope1_type,
      &node_point_ground_type,
      &node_point_slope1_type,
      &node_point_slope12_type,
      &node_point_slope23_type,
      &node_rigid_body_2d_type,
      &node_rigid_body_ep_type,
      &node_rigid_body_rot_vec_lg_type,
      &node_rigid_body_rxyz_type,
      &object_generic_ode1_type,
      &object_ground_type,
      &object_mass_1d_type,
      &object_mass_point_type,
      &object_mass_point_2d_type,
      &object_rigid_body_type,
      &object_rigid_body_2d_type,
      &object_rotational_mass_1d_type,
      &object_ffrf_type,
      &object_ffrf_reduced_order_type,
      &object_generic_ode2_type,
      &object_kinematic_tree_type,
      &object_ale_ancf_cable_2d_type,
      &object_ancf_beam_type,
      &object_ancf_cable_type,
      &object_ancf_cable_2d_type,
      &object_ancf_thin_plate_type,
      &object_beam_geometrically_exact_type,
      &object_beam_geometrically_exact_2d_type,
      &object_connector_cartesian_spring_damper_type,
      &object_connector_coordinate_spring_damper_type,
      &object_connector_coordinate_spring_damper_ext_type,
      &object_connector_gravity_type,
      &object_connector_hydraulic_actuator_simple_type,
      &object_connector_law_type,
      &object_connector_linear_spring_damper_type,
      &object_connector_reeving_system_springs_type,
      &object_connector_rigid_body_spring_damper_type,
      &object_connector_rolling_disc_penalty_type,
      &object_connector_spring_damper_type,
      &object_connector_torsional_spring_damper_type,
      &object_connector_coordinate_type,
      &object_connector_coordinate_vector_type,
      &object_connector_distance_type,
      &object_contact_circle_cable_2d_type,
      &object_contact_convex_roll_type,
      &object_contact_coordinate_type,
      &object_contact_curve_circles_type,
      &object_contact_friction_circle_cable_2d_type,
      &object_contact_sphere_sphere_type,
      &object_contact_sphere_torus_type,
      &object_contact_sphere_triangle_type,
      &object_joint_ale_moving_2d_type,
      &object_joint_generic_type,
      &object_joint_prismatic_2d_type,
      &object_joint_prismatic_x_type,
      &object_joint_revolute_2d_type,
      &object_joint_revolute_z_type,
      &object_joint_rolling_disc_type,
      &object_joint_sliding_type,
      &object_joint_sliding_2d_type,
      &object_joint_spherical_type,
      &marker_bodies_relative_rotation_coordinate_type,
      &marker_bodies_relative_translation_coordinate_type,
      &marker_body_beam_shape_type,
      &marker_body_cable_2d_coordinates_type,
      &marker_body_cable_2d_shape_type,
      &marker_body_mass_type,
      &marker_body_position_type,
      &marker_body_rigid_type,
      &marker_kinematic_tree_rigid_type,
      &marker_node_coordinate_type,
      &marker_node_coordinates_type,
      &marker_node_ode1_coordinate_type,
      &marker_node_position_type,
      &marker_node_rigid_type,
      &marker_node_rotation_coordinate_type,
      &marker_object_ode2_coordinates_type,
      &marker_super_element_position_type,
      &marker_super_element_rigid_type,
      &load_coordinate_type,
      &load_force_vector_type,
      &load_mass_proportional_type,
      &load_torque_vector_type,
      &sensor_body_type,
      &sensor_kinematic_tree_type,
      &sensor_load_type,
      &sensor_marker_type,
      &sensor_node_type,
      &sensor_object_type,
      &sensor_super_element_type,
      &sensor_user_function_type,
  };
  return types;
}

}  // namespace dalembert
