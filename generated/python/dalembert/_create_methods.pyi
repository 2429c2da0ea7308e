# Generated from specs/ and python/dalembert/create by codegen/templates/create_methods.pyi.j2. Do not edit;
# run `python -m codegen`.
# tests/codegen/test_freshness.py compares this file with its sources.

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy.typing as npt

from dalembert import _item_handles as handles
from dalembert._checks import FloatArray
from dalembert._core import MarkerIndex, NodeType, ObjectIndex
from dalembert._geometry.inertia import RigidBodyInertia, TreeLink
from dalembert._model.handle import LoadHandle, ObjectHandle, SensorHandle
from dalembert.create._arguments import Connected, Matrix, UserFunction, Vector
from dalembert.create._signals import Signal
from dalembert.create.drives import Kind
from dalembert.create.lines import Support
from dalembert.FEM import FEMinterface

class CreateMethods:
    def create_beam(
        self,
        name: str = ...,
        start: Vector = ...,
        end: Vector = ...,
        number_of_elements: int = ...,
        width: float | None = ...,
        height: float | None = ...,
        diameter: float | None = ...,
        section: Any = ...,
        youngs_modulus: float = ...,
        poissons_ratio: float = ...,
        density: float = ...,
        gravity: Vector = ...,
        supports: Sequence[Support] = ...,
        color: Vector | str = ...,
        show: bool = ...,
    ) -> dict[str, Any]:
        """Add a straight beam of geometrically exact elements between two points (m): bending, shear, torsion, tension."""
    def create_belt(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        positions: Sequence[Vector] = ...,
        radii: Vector = ...,
        axis: Vector | str = ...,
        carrier_number: ObjectIndex | int | str = ...,
        stiffness: float = ...,
        damping: float = ...,
        pretension: float = ...,
        diameter: float = ...,
        show: bool = ...,
        color: Vector | str = ...,
    ) -> list[ObjectHandle]:
        """Add a massless elastic belt that runs around pulleys without slip, as a toothed belt or a chain does."""
    def create_box(
        self,
        name: str = ...,
        size: Vector = ...,
        density: float | None = ...,
        mass: float | None = ...,
        reference_position: Vector = ...,
        reference_rotation_matrix: FloatArray = ...,
        initial_velocity: Vector = ...,
        initial_angular_velocity: Vector = ...,
        gravity: Vector = ...,
        color: Vector | str = ...,
        show: bool = ...,
        create_2d: bool = ...,
    ) -> handles.ObjectRigidBody:
        """Add a homogeneous box, a rigid body, and its weight if there is gravity; return the handle."""
    def create_cable(
        self,
        name: str = ...,
        start: Vector = ...,
        end: Vector = ...,
        number_of_elements: int = ...,
        diameter: float = ...,
        youngs_modulus: float = ...,
        density: float = ...,
        axial_stiffness: float | None = ...,
        bending_stiffness: float | None = ...,
        mass_per_length: float | None = ...,
        axial_damping: float = ...,
        bending_damping: float = ...,
        gravity: Vector = ...,
        supports: Sequence[Support] = ...,
        color: Vector | str = ...,
        show: bool = ...,
    ) -> dict[str, Any]:
        """Add a straight cable or thin rod of ANCF elements between two points (m), without torsion."""
    def create_cartesian_spring_damper(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        local_position0: Vector = ...,
        local_position1: Vector = ...,
        stiffness: Vector = ...,
        damping: Vector = ...,
        offset: Vector = ...,
        spring_force_user_function: UserFunction = ...,
        show: bool = ...,
        draw_size: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectConnectorCartesianSpringDamper:
        """Add a spring-damper along the global axes between points of bodies, nodes or markers; return its handle."""
    def create_coordinate_constraint(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        coordinates: Sequence[int | str | None] = ...,
        offset: float = ...,
        factor_value1: float = ...,
        velocity_level: bool = ...,
        offset_user_function: UserFunction = ...,
        offset_user_function_t: UserFunction = ...,
        show: bool = ...,
        draw_size: float = ...,
        color: Vector | str = ...,
        *,
        factor1: float = ...,
    ) -> handles.ObjectConnectorCoordinate:
        """Constrain a coordinate of one body to that of another, or to ground; return the constraint's handle."""
    def create_cylinder(
        self,
        name: str = ...,
        radius: float = ...,
        length: float = ...,
        axis: Vector | str = ...,
        inner_radius: float = ...,
        density: float | None = ...,
        mass: float | None = ...,
        reference_position: Vector = ...,
        reference_rotation_matrix: FloatArray = ...,
        initial_velocity: Vector = ...,
        initial_angular_velocity: Vector = ...,
        gravity: Vector = ...,
        color: Vector | str = ...,
        show: bool = ...,
        create_2d: bool = ...,
    ) -> handles.ObjectRigidBody:
        """Add a homogeneous cylinder or tube, a rigid body, and its weight if there is gravity; return the handle."""
    def create_cylindrical_joint(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        axis: Vector | str = ...,
        use_global_frame: bool = ...,
        show: bool = ...,
        axes_radius: float = ...,
        axes_length: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectJointGeneric:
        """Let two bodies or markers move along an axis and rotate about it, and nothing else; return the handle."""
    def create_distance_constraint(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        local_position0: Vector = ...,
        local_position1: Vector = ...,
        distance: float | None = ...,
        show: bool = ...,
        draw_size: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectConnectorDistance:
        """Keep the distance (m) of two points of bodies, nodes or markers constant; return the constraint's handle."""
    def create_distance_sensor(
        self,
        general_contact_index: int,
        position_or_marker: Any,
        dir_sensor: Any,
        min_distance: float = ...,
        max_distance: float = ...,
        cylinder_radius: float = ...,
        selected_type_index: Any = ...,
        store_internal: bool = ...,
        file_name: str = ...,
        measure_velocity: bool = ...,
        add_graphics_object: bool = ...,
        draw_displaced: bool = ...,
        color: list[float] = ...,
    ) -> handles.SensorUserFunction:
        """Add a sensor for the distance (m) from a point along a direction to contact geometry; return its handle."""
    def create_distance_sensor_geometry(
        self,
        mesh_points: npt.ArrayLike,
        mesh_trigs: npt.ArrayLike,
        rigid_body_marker_index: Any,
        search_tree_cell_size: list[int] = ...,
    ) -> int:
        """Add triangles on a rigid marker as geometry for distance sensors; return the number of the GeneralContact."""
    def create_ffrf_reduced_order_object(
        self,
        name: str | None,
        fem_interface: FEMinterface,
        reference_position: Vector = ...,
        initial_velocity: Vector = ...,
        reference_rotation_matrix: Matrix = ...,
        initial_angular_velocity: Vector = ...,
        mass_proportional_damping: float = ...,
        stiffness_proportional_damping: float = ...,
        gravity: Vector = ...,
        color: Vector | str = ...,
        super_element_rigid_markers_offsets: Any = ...,
        show_markers: bool = ...,
        verbose: bool = ...,
    ) -> dict[str, Any]:
        """Add a flexible body with the modes of a mesh, and a rigid marker on each node set of type 'boundary'."""
    def create_fixed_joint(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector | None = ...,
        use_global_frame: bool = ...,
        show: bool = ...,
        axes_radius: float = ...,
        axes_length: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectJointGeneric:
        """Connect two bodies or markers rigidly, as they are in the reference configuration; return the handle."""
    def create_force(
        self,
        name: str = ...,
        body_number: ObjectIndex | MarkerIndex | int | str | None = ...,
        load_vector: Vector = ...,
        local_position: Vector = ...,
        body_fixed: bool = ...,
        load_vector_user_function: UserFunction = ...,
        show: bool = ...,
    ) -> handles.LoadForceVector:
        """Add a force (N) at a local position (m) of a body, or at a marker; return its handle."""
    def create_force_from_table(
        self,
        name: str = ...,
        body_number: Connected | None = ...,
        table: Signal | None = ...,
        direction: Vector = ...,
        local_position: Vector = ...,
        body_fixed: bool = ...,
        smooth: bool = ...,
        show: bool = ...,
    ) -> handles.LoadForceVector:
        """Add a force (N) in a direction, whose magnitude is given over time, at a point of a body; return its handle."""
    def create_generic_joint(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        rotation_matrix_axes: Matrix = ...,
        constrained_axes: Sequence[int] = ...,
        use_global_frame: bool = ...,
        offset_user_function: UserFunction = ...,
        offset_user_function_t: UserFunction = ...,
        show: bool = ...,
        axes_radius: float = ...,
        axes_length: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectJointGeneric:
        """Add a joint with freely chosen constrained directions between two bodies or markers; return its handle."""
    def create_ground(
        self,
        name: str = ...,
        reference_position: Vector = ...,
        reference_rotation_matrix: Matrix = ...,
        graphics_data_list: list[dict[str, Any]] = ...,
        graphics_data_user_function: UserFunction = ...,
        show: bool = ...,
        reference_ht: Any = ...,
    ) -> handles.ObjectGround:
        """Add a ground object and return its handle."""
    def create_hydraulic_cylinder(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        local_position0: Vector = ...,
        local_position1: Vector = ...,
        piston_diameter: float = ...,
        rod_diameter: float = ...,
        stroke_length: float = ...,
        offset_length: float | None = ...,
        system_pressure: float = ...,
        tank_pressure: float = ...,
        initial_force: float = ...,
        nominal_flow: float = ...,
        oil_bulk_modulus: float = ...,
        hose_volume: float = ...,
        actuator_damping: float = ...,
        use_chamber_volume_change: bool = ...,
        show: bool = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectConnectorHydraulicActuatorSimple:
        """Add a double-acting hydraulic cylinder between points of two bodies or markers, with the pressures in it."""
    def create_joint_stops(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        axis: Vector | str = ...,
        lower: float | None = ...,
        upper: float | None = ...,
        stiffness: float = ...,
        damping: float = ...,
        kind: Kind = ...,
        use_global_frame: bool = ...,
        show: bool = ...,
    ) -> handles.ObjectConnectorTorsionalSpringDamper:
        """Limit the angle (rad) or displacement (m) of the second body relative to the first one; return the handle."""
    def create_kinematic_tree(
        self,
        name: str = ...,
        list_of_tree_links: Sequence[TreeLink] = ...,
        reference_coordinates: Vector | None = ...,
        initial_coordinates: Vector | None = ...,
        initial_coordinates_t: Vector | None = ...,
        gravity: Vector = ...,
        base_offset: Vector = ...,
        link_forces: Any = ...,
        link_torques: Any = ...,
        joint_force_vector: Vector | None = ...,
        joint_position_offset_vector: Vector | None = ...,
        joint_velocity_offset_vector: Vector | None = ...,
        force_user_function: UserFunction = ...,
        joint_radius: float = ...,
        joint_width: float = ...,
        colors: Any | str = ...,
        colors_joints: Any | str = ...,
        base_graphics_data_list: list[dict[str, Any]] | None = ...,
        link_roundness: float = ...,
        show: bool = ...,
    ) -> handles.ObjectKinematicTree:
        """Add a kinematic tree with its node and return its handle."""
    def create_linear_spring_damper(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        axis: Vector | str = ...,
        stiffness: float = ...,
        damping: float = ...,
        offset: float = ...,
        velocity_offset: float = ...,
        force: float = ...,
        use_global_frame: bool = ...,
        spring_force_user_function: UserFunction = ...,
        show: bool = ...,
        draw_size: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectConnectorLinearSpringDamper:
        """Add a spring-damper along an axis that is fixed to the first of two bodies or markers; return its handle."""
    def create_mass_point(
        self,
        name: str = ...,
        reference_position: Vector = ...,
        initial_displacement: Vector = ...,
        initial_velocity: Vector = ...,
        physics_mass: float = ...,
        gravity: Vector = ...,
        graphics_data_list: list[Any] = ...,
        draw_size: float = ...,
        color: Vector | str = ...,
        show: bool = ...,
        create_2d: bool = ...,
        *,
        mass: float = ...,
    ) -> handles.ObjectMassPoint:
        """Add a mass point with its node, and its weight if there is gravity; return the body's handle."""
    def create_motor(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        axis: Vector | str = ...,
        torque: Signal | None = ...,
        speed: Signal | None = ...,
        angle: Signal | None = ...,
        ramp: float = ...,
        smooth: bool = ...,
        stiffness: float = ...,
        damping: float = ...,
        maximum_torque: float | None = ...,
        use_global_frame: bool = ...,
        show: bool = ...,
    ) -> handles.ObjectConnectorTorsionalSpringDamper:
        """Add a motor between a stator, the first body, and a rotor; return its handle."""
    def create_pid_controller(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        axis: Vector | str = ...,
        set_point: Signal = ...,
        p: float = ...,
        i: float = ...,
        d: float = ...,
        limit: float | None = ...,
        kind: Kind = ...,
        ramp: float = ...,
        smooth: bool = ...,
        use_global_frame: bool = ...,
        show: bool = ...,
    ) -> handles.ObjectConnectorLaw:
        """Add a PID controller that drives the second body relative to the first one, about or along an axis."""
    def create_prescribed_motion(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        axis: Vector | str = ...,
        motion: Signal = ...,
        kind: Kind = ...,
        smooth: bool = ...,
        ramp: float = ...,
        use_global_frame: bool = ...,
        show: bool = ...,
    ) -> handles.ObjectJointGeneric:
        """Prescribe a displacement (m) along an axis, or an angle (rad) about it, between two bodies, by a constraint."""
    def create_prismatic_joint(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        axis: Vector | str = ...,
        use_global_frame: bool = ...,
        show: bool = ...,
        axis_radius: float = ...,
        axis_length: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectJointPrismaticX:
        """Add a slider between two bodies or markers and return its handle."""
    def create_revolute_joint(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        axis: Vector | str = ...,
        use_global_frame: bool = ...,
        show: bool = ...,
        axis_radius: float = ...,
        axis_length: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectJointRevoluteZ:
        """Add a hinge between two bodies or markers and return its handle."""
    def create_rigid_body(
        self,
        name: str = ...,
        reference_position: Vector = ...,
        reference_rotation_matrix: FloatArray = ...,
        initial_velocity: Vector = ...,
        initial_angular_velocity: Vector = ...,
        initial_displacement: Vector | None = ...,
        initial_rotation_matrix: FloatArray | None = ...,
        inertia: RigidBodyInertia | None = ...,
        gravity: Vector = ...,
        node_type: NodeType | str = ...,
        graphics_data_list: list[Any] = ...,
        graphics_data_user_function: Any = ...,
        draw_size: float = ...,
        color: Vector | str = ...,
        show: bool = ...,
        create_2d: bool = ...,
        reference_ht: Any = ...,
        initial_ht: Any = ...,
    ) -> handles.ObjectRigidBody:
        """Add a rigid body with its node, and its weight if there is gravity; return the body's handle."""
    def create_rigid_body_spring_damper(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        local_position0: Vector = ...,
        local_position1: Vector = ...,
        stiffness: Matrix = ...,
        damping: Matrix = ...,
        offset: Vector = ...,
        rotation_matrix_joint: Matrix = ...,
        use_global_frame: bool = ...,
        intrinsic_formulation: bool = ...,
        spring_force_torque_user_function: UserFunction = ...,
        post_newton_step_user_function: UserFunction = ...,
        show: bool = ...,
        draw_size: float = ...,
        color: Vector | str = ...,
        *,
        use_intrinsic_formulation: bool = ...,
    ) -> handles.ObjectConnectorRigidBodySpringDamper:
        """Add a spring-damper in six directions (three translations, three rotations); return its handle."""
    def create_robot(
        self,
        file_name: str | Path,
        name: str = ...,
        base_ht: npt.ArrayLike | None = ...,
        gravity: npt.ArrayLike | None = ...,
        reference_configuration: npt.ArrayLike | None = ...,
        packages: Any = ...,
        graphics: bool = ...,
        base_marker: Any = ...,
        force_user_function: Callable[..., Any] | int = ...,
        limit_stiffness: float = ...,
        limit_damping: float = ...,
        keyframe: str = ...,
        contacts: bool = ...,
    ) -> dict[str, Any]:
        """Add the robot of a URDF or MJCF file; return a dict with robot, the Robot, and the items that were added."""
    def create_rolling_disc(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        axis_position: Vector | str = ...,
        axis_vector: Vector | str = ...,
        disc_radius: float = ...,
        plane_position: Vector = ...,
        plane_normal: Vector | str = ...,
        constrained_axes: Sequence[int] = ...,
        active_connector: bool = ...,
        show: bool = ...,
        disc_width: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectJointRollingDisc:
        """Let a disc, fixed to the second body, roll without slip on a plane of the first body; return the handle."""
    def create_rolling_disc_penalty(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        axis_position: Vector | str = ...,
        axis_vector: Vector | str = ...,
        disc_radius: float = ...,
        plane_position: Vector = ...,
        plane_normal: Vector | str = ...,
        contact_stiffness: float = ...,
        contact_damping: float = ...,
        dry_friction: Vector = ...,
        dry_friction_angle: float = ...,
        dry_friction_proportional_zone: float = ...,
        viscous_friction: Vector = ...,
        rolling_friction_viscous: float = ...,
        use_linear_proportional_zone: bool = ...,
        active_connector: bool = ...,
        show: bool = ...,
        disc_width: float = ...,
        color: Vector | str = ...,
        *,
        rolling_viscous_friction: float = ...,
    ) -> handles.ObjectConnectorRollingDiscPenalty:
        """Let a disc, fixed to the second body, roll with contact and friction forces on a plane of the first body."""
    def create_rope(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        positions: Sequence[Vector] = ...,
        radii: Vector = ...,
        axis: Vector | str = ...,
        stiffness: float = ...,
        damping: float = ...,
        length: float | None = ...,
        diameter: float = ...,
        show: bool = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectConnectorReevingSystemSprings:
        """Add a massless elastic rope between points of two bodies, which runs without friction over pulleys between them."""
    def create_sphere(
        self,
        name: str = ...,
        radius: float = ...,
        density: float | None = ...,
        mass: float | None = ...,
        reference_position: Vector = ...,
        reference_rotation_matrix: FloatArray = ...,
        initial_velocity: Vector = ...,
        initial_angular_velocity: Vector = ...,
        gravity: Vector = ...,
        color: Vector | str = ...,
        show: bool = ...,
        create_2d: bool = ...,
    ) -> handles.ObjectRigidBody:
        """Add a homogeneous sphere, a rigid body, and its weight if there is gravity; return the handle."""
    def create_sphere_quad_contact(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        local_position0: Vector = ...,
        radius_sphere: float = ...,
        quad_points: Sequence[Vector] = ...,
        include_edges: int = ...,
        dynamic_friction: float = ...,
        friction_proportional_zone: float = ...,
        contact_stiffness: float = ...,
        contact_damping: float = ...,
        contact_stiffness_exponent: float = ...,
        restitution_coefficient: float = ...,
        minimum_impact_velocity: float = ...,
        impact_model: int = ...,
        data_initial_coordinates: Vector = ...,
        active_connector: bool = ...,
        local_position1: Vector = ...,
        show: bool = ...,
        color: Vector | str = ...,
        limit_damping: bool = ...,
        *,
        sphere_radius: float = ...,
    ) -> dict[str, ObjectHandle]:
        """Let a sphere on the first body touch a quadrangle on the second one, by two triangles."""
    def create_sphere_sphere_contact(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        local_position0: Vector = ...,
        local_position1: Vector = ...,
        spheres_radii: Vector = ...,
        is_hollow_sphere1: bool = ...,
        dynamic_friction: float = ...,
        friction_proportional_zone: float = ...,
        contact_stiffness: float = ...,
        contact_damping: float = ...,
        contact_stiffness_exponent: float = ...,
        constant_pull_off_force: float = ...,
        contact_plasticity_ratio: float = ...,
        adhesion_coefficient: float = ...,
        adhesion_exponent: float = ...,
        restitution_coefficient: float = ...,
        minimum_impact_velocity: float = ...,
        impact_model: int = ...,
        data_initial_coordinates: Vector = ...,
        active_connector: bool = ...,
        show: bool = ...,
        color: Vector | str = ...,
        limit_damping: bool = ...,
    ) -> handles.ObjectContactSphereSphere:
        """Add contact between two spheres around points of bodies or nodes; return the handle of the contact."""
    def create_sphere_triangle_contact(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        local_position0: Vector = ...,
        radius_sphere: float = ...,
        triangle_points: Sequence[Vector] = ...,
        include_edges: int = ...,
        dynamic_friction: float = ...,
        friction_proportional_zone: float = ...,
        contact_stiffness: float = ...,
        contact_damping: float = ...,
        contact_stiffness_exponent: float = ...,
        restitution_coefficient: float = ...,
        minimum_impact_velocity: float = ...,
        impact_model: int = ...,
        data_initial_coordinates: Vector = ...,
        active_connector: bool = ...,
        local_position1: Vector = ...,
        show: bool = ...,
        color: Vector | str = ...,
        limit_damping: bool = ...,
        *,
        sphere_radius: float = ...,
    ) -> handles.ObjectContactSphereTriangle:
        """Add contact between a sphere on the first body and a triangle on the second one; return its handle."""
    def create_spherical_joint(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        constrained_axes: Sequence[int] = ...,
        use_global_frame: bool = ...,
        show: bool = ...,
        joint_radius: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectJointSpherical:
        """Add a ball joint between two bodies or markers and return its handle."""
    def create_spring_damper(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        local_position0: Vector = ...,
        local_position1: Vector = ...,
        reference_length: float | None = ...,
        stiffness: float = ...,
        damping: float = ...,
        force: float = ...,
        velocity_offset: float = ...,
        spring_force_user_function: UserFunction = ...,
        show: bool = ...,
        draw_size: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectConnectorSpringDamper:
        """Add a spring-damper along the line between two points of bodies, nodes or markers; return its handle."""
    def create_torque(
        self,
        name: str = ...,
        body_number: ObjectIndex | MarkerIndex | int | str | None = ...,
        load_vector: Vector = ...,
        local_position: Vector = ...,
        body_fixed: bool = ...,
        load_vector_user_function: UserFunction = ...,
        show: bool = ...,
    ) -> handles.LoadTorqueVector:
        """Add a torque (Nm) at a body, or at a marker; return its handle."""
    def create_torque_from_table(
        self,
        name: str = ...,
        body_number: Connected | None = ...,
        table: Signal | None = ...,
        direction: Vector = ...,
        body_fixed: bool = ...,
        smooth: bool = ...,
        show: bool = ...,
    ) -> handles.LoadTorqueVector:
        """Add a torque (Nm) about a direction, whose magnitude is given over time, on a body; return its handle."""
    def create_torsional_spring_damper(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        axis: Vector | str = ...,
        stiffness: float = ...,
        damping: float = ...,
        offset: float = ...,
        velocity_offset: float = ...,
        torque: float = ...,
        use_global_frame: bool = ...,
        spring_torque_user_function: UserFunction = ...,
        unlimited_rotations: bool = ...,
        show: bool = ...,
        draw_size: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectConnectorTorsionalSpringDamper:
        """Add a torsional spring-damper about an axis between two bodies or markers; return its handle."""
    def create_universal_joint(
        self,
        name: str = ...,
        body_numbers: Sequence[Connected | None] = ...,
        position: Vector = ...,
        axis0: Vector | str = ...,
        axis1: Vector | str = ...,
        use_global_frame: bool = ...,
        show: bool = ...,
        axes_radius: float = ...,
        axes_length: float = ...,
        color: Vector | str = ...,
    ) -> handles.ObjectJointGeneric:
        """Connect two bodies or markers by the cross of a universal (Cardan) joint; return the handle."""
