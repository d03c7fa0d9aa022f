"""Create the tables of the catalogue and of saved projects.

Revision ID: 20261121_1
Revises:
Create Date: 2026-11-21 01:11:07.044614
"""

import sqlalchemy as sa
from alembic import op

revision = "20261121_1"
down_revision = None
branch_labels = None
depends_on = None


def upgrade() -> None:
    op.create_table(
        "catalog_edition",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("maker", sa.String(length=80), nullable=False, comment="Maker whose products the edition describes"),
        sa.Column("maker_slug", sa.String(length=80), nullable=False, comment="The maker in a product's id"),
        sa.Column(
            "slug", sa.String(length=80), nullable=False, comment="The edition in a product's id: name of its folder"
        ),
        sa.Column(
            "document", sa.String(length=400), nullable=False, comment="Title of the document the values were read from"
        ),
        sa.Column("publisher", sa.String(length=400), nullable=True, comment="Who published the document"),
        sa.Column("edition", sa.String(length=80), nullable=True, comment="Edition or revision as printed"),
        sa.Column(
            "date", sa.String(length=10), nullable=True, comment="Date of the edition: YYYY, YYYY-MM or YYYY-MM-DD"
        ),
        sa.Column("url", sa.String(length=500), nullable=True, comment="Where the document can be had"),
        sa.Column("retrieved", sa.String(length=10), nullable=True, comment="Date on which the values were read"),
        sa.Column("licence", sa.String(length=200), nullable=True, comment="Licence of the data, where known"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What else a reader of the source must know"),
        sa.Column("checksum", sa.String(length=64), nullable=False, comment="SHA-256 of the files of the edition"),
        sa.Column("loaded_at", sa.DateTime(timezone=True), nullable=False, comment="When the rows were last written"),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_catalog_edition")),
        sa.UniqueConstraint("maker_slug", "slug", name=op.f("uq_catalog_edition_maker_slug_slug")),
    )
    op.create_table(
        "project",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column(
            "view_token_hash", sa.String(length=64), nullable=False, comment="SHA-256 of the token that may read"
        ),
        sa.Column(
            "edit_token_hash", sa.String(length=64), nullable=False, comment="SHA-256 of the token that may write"
        ),
        sa.Column("title", sa.String(length=200), nullable=False, comment="Title as of the newest revision"),
        sa.Column(
            "version", sa.Integer(), nullable=False, comment="Number of the newest revision; a save must name it"
        ),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("updated_at", sa.DateTime(timezone=True), nullable=False),
        sa.Column("deleted_at", sa.DateTime(timezone=True), nullable=True, comment="NULL: not deleted"),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_project")),
        sa.UniqueConstraint("edit_token_hash", name=op.f("uq_project_edit_token_hash")),
        sa.UniqueConstraint("view_token_hash", name=op.f("uq_project_view_token_hash")),
    )
    op.create_table(
        "ball_screw",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the row was read from"),
        sa.Column(
            "slug",
            sa.String(length=160),
            nullable=False,
            comment="The product in its id: order code in small letters and digits",
        ),
        sa.Column("manufacturer", sa.String(length=80), nullable=False, comment="Manufacturer"),
        sa.Column("series", sa.String(length=80), nullable=True, comment="Series"),
        sa.Column("model", sa.String(length=80), nullable=False, comment="Order code as printed"),
        sa.Column("nominal_diameter_mm", sa.Float(precision=53), nullable=False, comment="Nominal diameter [mm]"),
        sa.Column("ball_pitch_diameter_mm", sa.Float(precision=53), nullable=True, comment="Ball pitch diameter [mm]"),
        sa.Column("root_diameter_mm", sa.Float(precision=53), nullable=True, comment="Core of the screw [mm]"),
        sa.Column("lead_mm", sa.Float(precision=53), nullable=False, comment="Travel per turn [mm]"),
        sa.Column(
            "dynamic_load_n", sa.Float(precision=53), nullable=True, comment="Basic dynamic axial load rating [N]"
        ),
        sa.Column("static_load_n", sa.Float(precision=53), nullable=True, comment="Basic static axial load rating [N]"),
        sa.Column(
            "dn_max_mmrpm",
            sa.Float(precision=53),
            nullable=True,
            comment="Highest product of nominal diameter and speed [mm rpm]",
        ),
        sa.Column("max_speed_m_min", sa.Float(precision=53), nullable=True, comment="Maximum speed [m/min]"),
        sa.Column("axial_play_mm", sa.Float(precision=53), nullable=True, comment="Axial play [mm]"),
        sa.Column("nut_mass_kg", sa.Float(precision=53), nullable=True, comment="Mass of the nut [kg]"),
        sa.Column("source_page", sa.String(length=80), nullable=True, comment="Page or chapter of the source"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What the source says beside the numbers"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_ball_screw_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_ball_screw")),
        sa.UniqueConstraint("edition_id", "slug", name=op.f("uq_ball_screw_edition_id_slug")),
    )
    with op.batch_alter_table("ball_screw", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_ball_screw_manufacturer"), ["manufacturer"], unique=False)

    op.create_table(
        "braking_resistor",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the row was read from"),
        sa.Column(
            "slug",
            sa.String(length=160),
            nullable=False,
            comment="The product in its id: order code in small letters and digits",
        ),
        sa.Column("manufacturer", sa.String(length=80), nullable=False, comment="Manufacturer"),
        sa.Column("series", sa.String(length=80), nullable=True, comment="Series"),
        sa.Column("model", sa.String(length=80), nullable=False, comment="Order code as printed"),
        sa.Column("resistance_ohm", sa.Float(precision=53), nullable=False, comment="Resistance [ohm]"),
        sa.Column("power_100_kw", sa.Float(precision=53), nullable=True, comment="Continuous power [kW]"),
        sa.Column("power_50_kw", sa.Float(precision=53), nullable=True, comment="At 50 % duty [kW]"),
        sa.Column("power_40_kw", sa.Float(precision=53), nullable=True, comment="At 40 % duty [kW]"),
        sa.Column("power_25_kw", sa.Float(precision=53), nullable=True, comment="At 25 % duty [kW]"),
        sa.Column("power_15_kw", sa.Float(precision=53), nullable=True, comment="At 15 % duty [kW]"),
        sa.Column("power_12_kw", sa.Float(precision=53), nullable=True, comment="At 12 % duty [kW]"),
        sa.Column("power_10_kw", sa.Float(precision=53), nullable=True, comment="At 10 % duty [kW]"),
        sa.Column("power_6_kw", sa.Float(precision=53), nullable=True, comment="At 6 % duty [kW]"),
        sa.Column(
            "duty_cycle_time_s",
            sa.Float(precision=53),
            nullable=True,
            comment="Longest cycle over which the duty may be counted [s]",
        ),
        sa.Column("peak_power_kw", sa.Float(precision=53), nullable=True, comment="Peak power [kW]"),
        sa.Column(
            "pulse_energy_kj",
            sa.Float(precision=53),
            nullable=True,
            comment="Energy that a single braking may bring [kJ]",
        ),
        sa.Column("mass_kg", sa.Float(precision=53), nullable=True, comment="Mass [kg]"),
        sa.Column("source_page", sa.String(length=80), nullable=True, comment="Page or chapter of the source"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What the source says beside the numbers"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_braking_resistor_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_braking_resistor")),
        sa.UniqueConstraint("edition_id", "slug", name=op.f("uq_braking_resistor_edition_id_slug")),
    )
    with op.batch_alter_table("braking_resistor", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_braking_resistor_manufacturer"), ["manufacturer"], unique=False)

    op.create_table(
        "gear_unit",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the row was read from"),
        sa.Column(
            "slug",
            sa.String(length=160),
            nullable=False,
            comment="The product in its id: order code in small letters and digits",
        ),
        sa.Column("manufacturer", sa.String(length=80), nullable=False, comment="Manufacturer"),
        sa.Column("series", sa.String(length=80), nullable=True, comment="Series"),
        sa.Column("model", sa.String(length=80), nullable=False, comment="Order code as printed"),
        sa.Column("kind", sa.String(length=16), nullable=True, comment="Kind"),
        sa.Column("stages", sa.Integer(), nullable=True, comment="Stages"),
        sa.Column("ratio", sa.Float(precision=53), nullable=True, comment="Input by output speed [1]"),
        sa.Column(
            "max_output_torque_nm",
            sa.Float(precision=53),
            nullable=True,
            comment="Permitted torque at the output [N m]",
        ),
        sa.Column(
            "torque_basis",
            sa.String(length=16),
            nullable=True,
            comment="The limit of the gear unit's size, or the torque of one geared motor at the stated service factor",
        ),
        sa.Column(
            "service_factor",
            sa.Float(precision=53),
            nullable=True,
            comment="Service factor at which the torque is stated [1]",
        ),
        sa.Column(
            "reference_input_speed_rpm",
            sa.Float(precision=53),
            nullable=True,
            comment="Input speed at which the torque is stated [rpm]",
        ),
        sa.Column("max_input_speed_rpm", sa.Float(precision=53), nullable=True, comment="Maximum input speed [rpm]"),
        sa.Column("efficiency", sa.Float(precision=53), nullable=True, comment="Efficiency [1]"),
        sa.Column(
            "permissible_overhung_load_n",
            sa.Float(precision=53),
            nullable=True,
            comment="Permitted radial force at the output shaft [N]",
        ),
        sa.Column("inertia_kgm2", sa.Float(precision=53), nullable=True, comment="Referred to the input shaft [kg m2]"),
        sa.Column("mass_kg", sa.Float(precision=53), nullable=True, comment="Mass [kg]"),
        sa.Column("source_page", sa.String(length=80), nullable=True, comment="Page or chapter of the source"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What the source says beside the numbers"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_gear_unit_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_gear_unit")),
        sa.UniqueConstraint("edition_id", "slug", name=op.f("uq_gear_unit_edition_id_slug")),
    )
    with op.batch_alter_table("gear_unit", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_gear_unit_manufacturer"), ["manufacturer"], unique=False)

    op.create_table(
        "induction_motor",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the row was read from"),
        sa.Column(
            "slug",
            sa.String(length=160),
            nullable=False,
            comment="The product in its id: order code in small letters and digits",
        ),
        sa.Column("manufacturer", sa.String(length=80), nullable=False, comment="Manufacturer"),
        sa.Column("series", sa.String(length=80), nullable=True, comment="Series"),
        sa.Column("model", sa.String(length=80), nullable=False, comment="Order code as printed"),
        sa.Column(
            "variant",
            sa.String(length=40),
            nullable=True,
            comment="Tells apart motors that the source prints under one order code",
        ),
        sa.Column("frame_size_mm", sa.Float(precision=53), nullable=True, comment="Shaft height (IEC 60072) [mm]"),
        sa.Column("rotor_inertia_kgm2", sa.Float(precision=53), nullable=True, comment="Rotor without brake [kg m2]"),
        sa.Column(
            "rotor_inertia_with_brake_kgm2", sa.Float(precision=53), nullable=True, comment="Rotor with brake [kg m2]"
        ),
        sa.Column("mass_kg", sa.Float(precision=53), nullable=True, comment="Mass [kg]"),
        sa.Column("source_page", sa.String(length=80), nullable=True, comment="Page or chapter of the source"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What the source says beside the numbers"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_induction_motor_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_induction_motor")),
        sa.UniqueConstraint("edition_id", "slug", name=op.f("uq_induction_motor_edition_id_slug")),
    )
    with op.batch_alter_table("induction_motor", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_induction_motor_manufacturer"), ["manufacturer"], unique=False)

    op.create_table(
        "inverter",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the row was read from"),
        sa.Column(
            "slug",
            sa.String(length=160),
            nullable=False,
            comment="The product in its id: order code in small letters and digits",
        ),
        sa.Column("manufacturer", sa.String(length=80), nullable=False, comment="Manufacturer"),
        sa.Column("series", sa.String(length=80), nullable=True, comment="Series"),
        sa.Column("model", sa.String(length=80), nullable=False, comment="Order code as printed"),
        sa.Column("supply_voltage_min_v", sa.Float(precision=53), nullable=True, comment="Lowest supply voltage [V]"),
        sa.Column("supply_voltage_max_v", sa.Float(precision=53), nullable=True, comment="Highest supply voltage [V]"),
        sa.Column("phases", sa.String(length=8), nullable=True, comment="Phases of the supply"),
        sa.Column(
            "motor_power_kw", sa.Float(precision=53), nullable=True, comment="Rated power of the motor to be fed [kW]"
        ),
        sa.Column("rated_current_a", sa.Float(precision=53), nullable=True, comment="Output current, rms [A]"),
        sa.Column(
            "overload_current_a",
            sa.Float(precision=53),
            nullable=True,
            comment="Output current for the overload time [A]",
        ),
        sa.Column("overload_time_s", sa.Float(precision=53), nullable=True, comment="Overload time [s]"),
        sa.Column(
            "min_braking_resistance_ohm",
            sa.Float(precision=53),
            nullable=True,
            comment="Lowest braking resistance [ohm]",
        ),
        sa.Column("source_page", sa.String(length=80), nullable=True, comment="Page or chapter of the source"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What the source says beside the numbers"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_inverter_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_inverter")),
        sa.UniqueConstraint("edition_id", "slug", name=op.f("uq_inverter_edition_id_slug")),
    )
    with op.batch_alter_table("inverter", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_inverter_manufacturer"), ["manufacturer"], unique=False)

    op.create_table(
        "motor_brake",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the row was read from"),
        sa.Column(
            "slug",
            sa.String(length=160),
            nullable=False,
            comment="The product in its id: order code in small letters and digits",
        ),
        sa.Column("manufacturer", sa.String(length=80), nullable=False, comment="Manufacturer"),
        sa.Column("series", sa.String(length=80), nullable=True, comment="Series"),
        sa.Column("model", sa.String(length=80), nullable=False, comment="Order code as printed"),
        sa.Column(
            "fits_motor", sa.String(length=200), nullable=True, comment="Frame sizes or motors, separated by semicolons"
        ),
        sa.Column(
            "brake_torque_nm",
            sa.Float(precision=53),
            nullable=False,
            comment="Brake torque, the highest where it is adjustable [N m]",
        ),
        sa.Column(
            "min_brake_torque_nm",
            sa.Float(precision=53),
            nullable=True,
            comment="Lowest setting of an adjustable brake [N m]",
        ),
        sa.Column("inertia_kgm2", sa.Float(precision=53), nullable=True, comment="Inertia [kg m2]"),
        sa.Column(
            "work_until_adjustment_mj",
            sa.Float(precision=53),
            nullable=True,
            comment="Friction work until the air gap must be set [MJ]",
        ),
        sa.Column(
            "max_work_per_operation_j",
            sa.Float(precision=53),
            nullable=True,
            comment="Permitted friction work of one brake application [J]",
        ),
        sa.Column("release_time_ms", sa.Float(precision=53), nullable=True, comment="Release time [ms]"),
        sa.Column(
            "application_time_ac_ms", sa.Float(precision=53), nullable=True, comment="Switched off on the AC side [ms]"
        ),
        sa.Column(
            "application_time_dc_ms",
            sa.Float(precision=53),
            nullable=True,
            comment="Switched off on the AC and DC side [ms]",
        ),
        sa.Column("source_page", sa.String(length=80), nullable=True, comment="Page or chapter of the source"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What the source says beside the numbers"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_motor_brake_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_motor_brake")),
        sa.UniqueConstraint("edition_id", "slug", name=op.f("uq_motor_brake_edition_id_slug")),
    )
    with op.batch_alter_table("motor_brake", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_motor_brake_manufacturer"), ["manufacturer"], unique=False)

    op.create_table(
        "project_revision",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("project_id", sa.Integer(), nullable=False),
        sa.Column("number", sa.Integer(), nullable=False, comment="1 for the first save, counted within the project"),
        sa.Column("document", sa.JSON(), nullable=False, comment="The whole project as it is exported"),
        sa.Column(
            "engine_version", sa.String(length=40), nullable=False, comment="Version that calculated the stored results"
        ),
        sa.Column("catalogue_editions", sa.JSON(), nullable=False, comment="Editions in use: key and checksum of each"),
        sa.Column("comment", sa.String(length=500), nullable=True, comment="What the user wrote about the save"),
        sa.Column("created_at", sa.DateTime(timezone=True), nullable=False),
        sa.ForeignKeyConstraint(
            ["project_id"], ["project.id"], name=op.f("fk_project_revision_project_id_project"), ondelete="CASCADE"
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_project_revision")),
        sa.UniqueConstraint("project_id", "number", name=op.f("uq_project_revision_project_id_number")),
    )
    op.create_table(
        "servo_drive",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the row was read from"),
        sa.Column(
            "slug",
            sa.String(length=160),
            nullable=False,
            comment="The product in its id: order code in small letters and digits",
        ),
        sa.Column("manufacturer", sa.String(length=80), nullable=False, comment="Manufacturer"),
        sa.Column("series", sa.String(length=80), nullable=True, comment="Series"),
        sa.Column("model", sa.String(length=80), nullable=False, comment="Order code as printed"),
        sa.Column(
            "supply",
            sa.String(length=2),
            nullable=True,
            comment="Whether the voltage is that of the AC mains or of the DC bus",
        ),
        sa.Column("supply_voltage_min_v", sa.Float(precision=53), nullable=True, comment="Lowest supply voltage [V]"),
        sa.Column("supply_voltage_max_v", sa.Float(precision=53), nullable=True, comment="Highest supply voltage [V]"),
        sa.Column("phases", sa.String(length=8), nullable=True, comment="Phases of the supply"),
        sa.Column("continuous_current_a", sa.Float(precision=53), nullable=True, comment="Output current, rms [A]"),
        sa.Column(
            "peak_current_a", sa.Float(precision=53), nullable=True, comment="Output current for a short time, rms [A]"
        ),
        sa.Column(
            "peak_time_s", sa.Float(precision=53), nullable=True, comment="How long the peak current may flow [s]"
        ),
        sa.Column(
            "motor_power_kw", sa.Float(precision=53), nullable=True, comment="Rated power of the motor to be fed [kW]"
        ),
        sa.Column("source_page", sa.String(length=80), nullable=True, comment="Page or chapter of the source"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What the source says beside the numbers"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_servo_drive_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_servo_drive")),
        sa.UniqueConstraint("edition_id", "slug", name=op.f("uq_servo_drive_edition_id_slug")),
    )
    with op.batch_alter_table("servo_drive", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_servo_drive_manufacturer"), ["manufacturer"], unique=False)

    op.create_table(
        "servo_gear_unit",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the row was read from"),
        sa.Column(
            "slug",
            sa.String(length=160),
            nullable=False,
            comment="The product in its id: order code in small letters and digits",
        ),
        sa.Column("manufacturer", sa.String(length=80), nullable=False, comment="Manufacturer"),
        sa.Column("series", sa.String(length=80), nullable=True, comment="Series"),
        sa.Column("model", sa.String(length=80), nullable=False, comment="Order code as printed"),
        sa.Column("kind", sa.String(length=16), nullable=True, comment="Kind"),
        sa.Column("stages", sa.Integer(), nullable=True, comment="Stages"),
        sa.Column("ratio", sa.Float(precision=53), nullable=True, comment="Input by output speed [1]"),
        sa.Column("nominal_torque_nm", sa.Float(precision=53), nullable=True, comment="Continuous output torque [N m]"),
        sa.Column(
            "acceleration_torque_nm",
            sa.Float(precision=53),
            nullable=True,
            comment="Output torque in cyclic operation [N m]",
        ),
        sa.Column(
            "emergency_torque_nm",
            sa.Float(precision=53),
            nullable=True,
            comment="Output torque in rare emergencies [N m]",
        ),
        sa.Column(
            "nominal_input_speed_rpm", sa.Float(precision=53), nullable=True, comment="Permitted mean input speed [rpm]"
        ),
        sa.Column("max_input_speed_rpm", sa.Float(precision=53), nullable=True, comment="Maximum input speed [rpm]"),
        sa.Column("efficiency", sa.Float(precision=53), nullable=True, comment="At full load [1]"),
        sa.Column(
            "backlash_arcmin",
            sa.Float(precision=53),
            nullable=True,
            comment="Torsional backlash at the output [arcmin]",
        ),
        sa.Column(
            "torsional_stiffness_nm_arcmin", sa.Float(precision=53), nullable=True, comment="At the output [N m/arcmin]"
        ),
        sa.Column(
            "inertia_kgcm2", sa.Float(precision=53), nullable=True, comment="Referred to the input shaft [kg cm2]"
        ),
        sa.Column(
            "max_radial_force_n", sa.Float(precision=53), nullable=True, comment="Permitted at the output shaft [N]"
        ),
        sa.Column(
            "max_axial_force_n", sa.Float(precision=53), nullable=True, comment="Permitted at the output shaft [N]"
        ),
        sa.Column("mass_kg", sa.Float(precision=53), nullable=True, comment="Mass [kg]"),
        sa.Column("source_page", sa.String(length=80), nullable=True, comment="Page or chapter of the source"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What the source says beside the numbers"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_servo_gear_unit_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_servo_gear_unit")),
        sa.UniqueConstraint("edition_id", "slug", name=op.f("uq_servo_gear_unit_edition_id_slug")),
    )
    with op.batch_alter_table("servo_gear_unit", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_servo_gear_unit_manufacturer"), ["manufacturer"], unique=False)

    op.create_table(
        "servo_motor",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the row was read from"),
        sa.Column(
            "slug",
            sa.String(length=160),
            nullable=False,
            comment="The product in its id: order code in small letters and digits",
        ),
        sa.Column("manufacturer", sa.String(length=80), nullable=False, comment="Manufacturer"),
        sa.Column("series", sa.String(length=80), nullable=True, comment="Series"),
        sa.Column("model", sa.String(length=80), nullable=False, comment="Order code as printed"),
        sa.Column(
            "kind",
            sa.String(length=12),
            nullable=False,
            comment="Synchronous, asynchronous, torque motor, or brushless DC (block commutation)",
        ),
        sa.Column("cooling", sa.String(length=12), nullable=True, comment="Cooling"),
        sa.Column(
            "supply",
            sa.String(length=2),
            nullable=True,
            comment="Whether the voltage is that of the AC mains or of the DC bus",
        ),
        sa.Column("supply_voltage_v", sa.Float(precision=53), nullable=True, comment="Supply voltage [V]"),
        sa.Column("rated_speed_rpm", sa.Float(precision=53), nullable=True, comment="Rated speed [rpm]"),
        sa.Column(
            "max_speed_rpm",
            sa.Float(precision=53),
            nullable=True,
            comment="Highest speed, mechanical or by voltage [rpm]",
        ),
        sa.Column(
            "stall_torque_nm", sa.Float(precision=53), nullable=True, comment="Continuous torque at standstill [N m]"
        ),
        sa.Column(
            "rated_torque_nm", sa.Float(precision=53), nullable=True, comment="Continuous torque at rated speed [N m]"
        ),
        sa.Column("peak_torque_nm", sa.Float(precision=53), nullable=True, comment="Peak torque [N m]"),
        sa.Column("stall_current_a", sa.Float(precision=53), nullable=True, comment="Current at stall torque, rms [A]"),
        sa.Column("rated_current_a", sa.Float(precision=53), nullable=True, comment="Current at rated torque, rms [A]"),
        sa.Column("peak_current_a", sa.Float(precision=53), nullable=True, comment="Current at peak torque, rms [A]"),
        sa.Column("rated_power_kw", sa.Float(precision=53), nullable=True, comment="Rated power [kW]"),
        sa.Column("rotor_inertia_kgcm2", sa.Float(precision=53), nullable=True, comment="Rotor without brake [kg cm2]"),
        sa.Column(
            "rotor_inertia_with_brake_kgcm2",
            sa.Float(precision=53),
            nullable=True,
            comment="Rotor with holding brake [kg cm2]",
        ),
        sa.Column(
            "brake_torque_nm",
            sa.Float(precision=53),
            nullable=True,
            comment="Holding torque of the built-in brake [N m]",
        ),
        sa.Column("mass_kg", sa.Float(precision=53), nullable=True, comment="Mass [kg]"),
        sa.Column("flange_size_mm", sa.Float(precision=53), nullable=True, comment="Flange size [mm]"),
        sa.Column(
            "torque_constant_nm_a", sa.Float(precision=53), nullable=True, comment="Torque per ampere rms [N m/A]"
        ),
        sa.Column(
            "voltage_constant_vs_rad",
            sa.Float(precision=53),
            nullable=True,
            comment="Voltage by speed, as the source defines it [V s/rad]",
        ),
        sa.Column("winding_resistance_ohm", sa.Float(precision=53), nullable=True, comment="Winding resistance [ohm]"),
        sa.Column("winding_inductance_mh", sa.Float(precision=53), nullable=True, comment="Winding inductance [mH]"),
        sa.Column("pole_pairs", sa.Integer(), nullable=True, comment="Pole pairs"),
        sa.Column("source_page", sa.String(length=80), nullable=True, comment="Page or chapter of the source"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What the source says beside the numbers"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_servo_motor_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_servo_motor")),
        sa.UniqueConstraint("edition_id", "slug", name=op.f("uq_servo_motor_edition_id_slug")),
    )
    with op.batch_alter_table("servo_motor", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_servo_motor_manufacturer"), ["manufacturer"], unique=False)

    op.create_table(
        "standard_table",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the table was read from"),
        sa.Column("key", sa.String(length=80), nullable=False, comment="Name of the table: that of its file"),
        sa.Column("title", sa.String(length=200), nullable=False, comment="What the table gives, for the reader"),
        sa.Column("unit", sa.String(length=40), nullable=True, comment="Unit of all values, where they share one"),
        sa.Column("note", sa.String(length=1000), nullable=True, comment="What else a reader must know"),
        sa.Column("payload", sa.JSON(), nullable=False, comment="The values"),
        sa.Column("source", sa.String(length=800), nullable=False, comment="Where the values were read"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_standard_table_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_standard_table")),
        sa.UniqueConstraint("edition_id", "key", name=op.f("uq_standard_table_edition_id_key")),
    )
    with op.batch_alter_table("standard_table", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_standard_table_key"), ["key"], unique=False)

    op.create_table(
        "timing_belt",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("edition_id", sa.Integer(), nullable=False, comment="Edition the row was read from"),
        sa.Column(
            "slug",
            sa.String(length=160),
            nullable=False,
            comment="The product in its id: order code in small letters and digits",
        ),
        sa.Column("manufacturer", sa.String(length=80), nullable=False, comment="Manufacturer"),
        sa.Column("series", sa.String(length=80), nullable=True, comment="Series"),
        sa.Column("model", sa.String(length=80), nullable=False, comment="Order code as printed"),
        sa.Column("pitch_mm", sa.Float(precision=53), nullable=True, comment="Pitch [mm]"),
        sa.Column("width_mm", sa.Float(precision=53), nullable=False, comment="Width [mm]"),
        sa.Column(
            "permissible_tensile_force_n",
            sa.Float(precision=53),
            nullable=True,
            comment="Permitted force in the belt [N]",
        ),
        sa.Column("mass_per_length_kg_m", sa.Float(precision=53), nullable=True, comment="Mass per length [kg/m]"),
        sa.Column("source_page", sa.String(length=80), nullable=True, comment="Page or chapter of the source"),
        sa.Column("note", sa.String(length=500), nullable=True, comment="What the source says beside the numbers"),
        sa.ForeignKeyConstraint(
            ["edition_id"],
            ["catalog_edition.id"],
            name=op.f("fk_timing_belt_edition_id_catalog_edition"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_timing_belt")),
        sa.UniqueConstraint("edition_id", "slug", name=op.f("uq_timing_belt_edition_id_slug")),
    )
    with op.batch_alter_table("timing_belt", schema=None) as batch_op:
        batch_op.create_index(batch_op.f("ix_timing_belt_manufacturer"), ["manufacturer"], unique=False)

    op.create_table(
        "induction_motor_operating_point",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("motor_id", sa.Integer(), nullable=False, comment="Motor the point belongs to"),
        sa.Column("position", sa.Integer(), nullable=False, comment="1 for the first point as printed, 2 for the next"),
        sa.Column(
            "winding",
            sa.String(length=4),
            nullable=True,
            comment="Low-speed or high-speed winding of a pole-changing motor",
        ),
        sa.Column("poles", sa.Integer(), nullable=False, comment="Number of poles (twice the pole pairs)"),
        sa.Column("efficiency_class", sa.String(length=4), nullable=True, comment="Efficiency class (IEC 60034-30-1)"),
        sa.Column("rated_power_kw", sa.Float(precision=53), nullable=False, comment="Rated power [kW]"),
        sa.Column("voltage_v", sa.Float(precision=53), nullable=True, comment="Voltage [V]"),
        sa.Column("frequency_hz", sa.Float(precision=53), nullable=False, comment="Frequency [Hz]"),
        sa.Column("rated_speed_rpm", sa.Float(precision=53), nullable=True, comment="Rated speed [rpm]"),
        sa.Column("rated_torque_nm", sa.Float(precision=53), nullable=True, comment="Rated torque [N m]"),
        sa.Column("rated_current_a", sa.Float(precision=53), nullable=True, comment="Rated current [A]"),
        sa.Column("power_factor", sa.Float(precision=53), nullable=True, comment="Power factor [1]"),
        sa.Column(
            "efficiency_100_percent", sa.Float(precision=53), nullable=True, comment="Efficiency at rated load [%]"
        ),
        sa.Column(
            "efficiency_75_percent",
            sa.Float(precision=53),
            nullable=True,
            comment="Efficiency at three quarters of the rated load [%]",
        ),
        sa.Column(
            "efficiency_50_percent",
            sa.Float(precision=53),
            nullable=True,
            comment="Efficiency at half the rated load [%]",
        ),
        sa.Column(
            "starting_torque_ratio",
            sa.Float(precision=53),
            nullable=True,
            comment="Locked-rotor torque by rated torque [1]",
        ),
        sa.Column(
            "run_up_torque_ratio",
            sa.Float(precision=53),
            nullable=True,
            comment="Mean run-up torque by rated torque [1]",
        ),
        sa.Column("run_up_torque_nm", sa.Float(precision=53), nullable=True, comment="Mean run-up torque [N m]"),
        sa.Column(
            "breakdown_torque_ratio",
            sa.Float(precision=53),
            nullable=True,
            comment="Breakdown torque by rated torque [1]",
        ),
        sa.Column(
            "starting_current_ratio",
            sa.Float(precision=53),
            nullable=True,
            comment="Locked-rotor current by rated current [1]",
        ),
        sa.Column(
            "no_load_starting_frequency_per_h",
            sa.Float(precision=53),
            nullable=True,
            comment="Permitted starts per hour, no load [1/h]",
        ),
        sa.ForeignKeyConstraint(
            ["motor_id"],
            ["induction_motor.id"],
            name=op.f("fk_induction_motor_operating_point_motor_id_induction_motor"),
            ondelete="CASCADE",
        ),
        sa.PrimaryKeyConstraint("id", name=op.f("pk_induction_motor_operating_point")),
        sa.UniqueConstraint("motor_id", "position", name=op.f("uq_induction_motor_operating_point_motor_id_position")),
    )


def downgrade() -> None:
    op.drop_table("induction_motor_operating_point")
    with op.batch_alter_table("timing_belt", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_timing_belt_manufacturer"))

    op.drop_table("timing_belt")
    with op.batch_alter_table("standard_table", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_standard_table_key"))

    op.drop_table("standard_table")
    with op.batch_alter_table("servo_motor", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_servo_motor_manufacturer"))

    op.drop_table("servo_motor")
    with op.batch_alter_table("servo_gear_unit", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_servo_gear_unit_manufacturer"))

    op.drop_table("servo_gear_unit")
    with op.batch_alter_table("servo_drive", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_servo_drive_manufacturer"))

    op.drop_table("servo_drive")
    op.drop_table("project_revision")
    with op.batch_alter_table("motor_brake", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_motor_brake_manufacturer"))

    op.drop_table("motor_brake")
    with op.batch_alter_table("inverter", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_inverter_manufacturer"))

    op.drop_table("inverter")
    with op.batch_alter_table("induction_motor", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_induction_motor_manufacturer"))

    op.drop_table("induction_motor")
    with op.batch_alter_table("gear_unit", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_gear_unit_manufacturer"))

    op.drop_table("gear_unit")
    with op.batch_alter_table("braking_resistor", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_braking_resistor_manufacturer"))

    op.drop_table("braking_resistor")
    with op.batch_alter_table("ball_screw", schema=None) as batch_op:
        batch_op.drop_index(batch_op.f("ix_ball_screw_manufacturer"))

    op.drop_table("ball_screw")
    op.drop_table("project")
    op.drop_table("catalog_edition")
