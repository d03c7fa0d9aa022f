"""All tables; importing this package makes them known to ``Base.metadata``."""

from app.db.models.ball_screw import BallScrew
from app.db.models.braking_resistor import BrakingResistor
from app.db.models.catalog_edition import CatalogEdition
from app.db.models.gear_unit import GearUnit
from app.db.models.induction_motor import InductionMotor
from app.db.models.induction_motor_operating_point import InductionMotorOperatingPoint
from app.db.models.inverter import Inverter
from app.db.models.motor_brake import MotorBrake
from app.db.models.product import ProductColumns
from app.db.models.project import Project
from app.db.models.project_revision import ProjectRevision
from app.db.models.servo_drive import ServoDrive
from app.db.models.servo_gear_unit import ServoGearUnit
from app.db.models.servo_motor import ServoMotor
from app.db.models.standard_table import StandardTable
from app.db.models.timing_belt import TimingBelt

__all__ = [
    "BallScrew",
    "BrakingResistor",
    "CatalogEdition",
    "GearUnit",
    "InductionMotor",
    "InductionMotorOperatingPoint",
    "Inverter",
    "MotorBrake",
    "ProductColumns",
    "Project",
    "ProjectRevision",
    "ServoDrive",
    "ServoGearUnit",
    "ServoMotor",
    "StandardTable",
    "TimingBelt",
]
